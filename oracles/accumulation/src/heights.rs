//! The height of a flight by powers of the time since it began, on either side.
//!
//! A flight that begins at the time `t + d` with the speed `v` is `u(s) = Σ a_k s^k`, with `a_0 = 0`, `a_1 = v`, and
//! `(k+1)(k+2) a_(k+2)` the coefficient of `s^k` of `Σ_p u^p (x_p + y_p G(t + d + s))`: polynomials in `v` and `d`.

use crate::{
    equation::Equation,
    pair::Pair,
    polynomial::{Polynomial, Row, add_product, add_scaled, differentiate},
};

/// The pull and the equation of motion in the units of a sequence: its first speed `v`, a time `θ`, and the distance `v θ`.
#[derive(Debug, Clone, Copy)]
pub struct Scaled<const M: usize> {
    /// The coefficients of the pull `G` by powers of the time.
    pub pull: Row<M>,
    /// Those of the equation.
    pub equation: Equation,
}

/// The `a_k`.
pub struct Heights<const M: usize> {
    by_time: [Polynomial<M>; M],
    /// No power of `v` above this is in them.
    pub speeds: usize,
}

impl<const M: usize> Heights<M> {
    /// `a_k` to the total degree `degree + 1 - k`.
    pub fn new(Scaled { pull, equation }: &Scaled<M>, degree: usize) -> Self {
        let pulls = shifted(pull);
        let coefficients = |p: usize| {
            let of = |of: &[f64]| of.get(p).copied().unwrap_or(0.0);
            (of(&equation.free), of(&equation.pulled))
        };
        // `u` is of the second order in the speed, `u^p` of twice the p-th.
        let highest = equation.degree().min(degree / 2);
        let mut heights = [const { Polynomial::ZERO }; M];
        set(&mut heights, 1, Polynomial::power(1));
        // u², u³, ...
        let mut products = vec![[const { Polynomial::ZERO }; M]; highest.saturating_sub(1)];
        for k in 0..degree {
            let left = degree - 1 - k;
            let mut second = Polynomial::ZERO;
            add_scaled(second.row_mut(0, left + 1), coefficients(0).1, at(&pulls, k));
            add_force(&mut second, &heights, &pulls, (k, left), coefficients(1));
            for p in 2..=highest {
                let (lower, upper) = products.split_at_mut(p - 2);
                let Some(product) = upper.first_mut() else { break };
                set(product, k, convolution(&heights, lower.last().unwrap_or(&heights), k, left));
                add_force(&mut second, product, &pulls, (k, left), coefficients(p));
            }
            set(&mut heights, k + 2, second.scaled(1.0 / ((k + 1) * (k + 2)) as f64));
        }
        Self { by_time: heights, speeds: if highest > 1 { M } else { 1 } }
    }

    /// The coefficients of `v^m` of `a_k`.
    pub fn row(&self, k: usize, m: usize) -> &[Pair] {
        self.by_time.get(k).map_or(&[], |of| of.row(m))
    }
}

/// `G^(k)/k!`, for `k = 0, 1, ...`, each by powers of `d`.
fn shifted<const M: usize>(pull: &Row<M>) -> [Row<M>; M] {
    let mut pulls = [[Pair::ZERO; M]; M];
    let mut derivative = *pull;
    for (k, slot) in pulls.iter_mut().enumerate() {
        *slot = derivative;
        differentiate(&mut derivative, k);
    }
    pulls
}

fn at<const M: usize>(rows: &[Row<M>; M], k: usize) -> &[Pair] {
    rows.get(k).map_or(&[], Row::as_slice)
}

fn set<const M: usize>(polynomials: &mut [Polynomial<M>; M], k: usize, new: Polynomial<M>) {
    if let Some(slot) = polynomials.get_mut(k) {
        *slot = new;
    }
}

/// The coefficient of `s^k` of the product of two, of which the first has no constant.
fn convolution<const M: usize>(
    one: &[Polynomial<M>; M],
    other: &[Polynomial<M>; M],
    k: usize,
    degree: usize,
) -> Polynomial<M> {
    let mut sum = Polynomial::ZERO;
    for (one, other) in one.iter().skip(1).take(k).zip(other.iter().take(k).rev()) {
        sum.add_product(one, other, degree);
    }
    sum
}

/// Adds the coefficient of `s^k` of `u^p (x + y G)`, to the total degree `left`.
fn add_force<const M: usize>(
    sum: &mut Polynomial<M>,
    power: &[Polynomial<M>; M],
    pulls: &[Row<M>; M],
    (k, left): (usize, usize),
    (free, pulled): (f64, f64),
) {
    for m in 0..=left {
        let sum = sum.row_mut(m, left - m + 1);
        if free != 0.0
            && let Some(power) = power.get(k)
        {
            add_scaled(sum, free, power.row(m));
        }
        if pulled != 0.0 {
            for (power, pull) in power.iter().take(k + 1).zip(pulls.iter().take(k + 1).rev()) {
                add_product(sum, &pull.map(|pull| pull * pulled), power.row(m));
            }
        }
    }
}
