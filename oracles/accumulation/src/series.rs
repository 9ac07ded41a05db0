//! The time that is left after an impact, as a power series in the speed.
//!
//! `R(v, t)`, how long it takes from an impact at `t` that the block leaves to one side with the speed `v` until infinitely many have followed, solves
//! `R(v, t) = T + R'(η w, t + T)`, with `T` and `w` of the first flight and `R'` that of the other side. With `R = Σ r_n(t) v^n`, the coefficients of `v^n` are
//! `r_n = K_n + η^n r_n'`, where `K_n` has lower orders and their derivatives by the time only. So `r_n = (K_n + η^n K_n')/(1 - η^(2n))`.

use crate::{
    flight::Flight,
    pair::Pair,
    polynomial::{Polynomial, Row, add_product, differentiate},
};

/// `r_n` now, for `n = 0, 1, .., degree`, on both sides. The flight is known to that degree.
pub fn coefficients<const M: usize>(flight: &Flight<M>, eta: f64, degree: usize) -> Row<M> {
    let mut found = [Pair::ZERO; M];
    // T, to which what follows is added order by order; what is known of v^n once all lower orders are there is K_n.
    let mut sums = Polynomial::ZERO;
    for m in 1..=degree {
        add_scaled_row(&mut sums, m, degree, flight.row(1, m - 1));
    }
    // (w/v)^n
    let mut gain = Polynomial::power(0);
    let log = (eta - 1.0).ln_1p();
    for (n, slot) in (0..=degree).zip(&mut found).skip(1) {
        let left = degree - n;
        gain = Polynomial::product(&gain, &flight.gain, left);
        let exponent = n as f64 * log;
        let (power, over) = (exponent.exp(), -1.0 / (2.0 * exponent).exp_m1());
        let mut other = [Pair::ZERO; M];
        for (other, own) in other.iter_mut().zip(sums.row(n)) {
            let coefficient = (*own + own.swapped() * power) * over;
            *other = coefficient.swapped() * power;
        }
        if let (Some(own), Some(of_other)) = (sums.row(n).first(), other.first()) {
            *slot = *own + *of_other;
        }
        add_later(&mut sums, flight, &gain, other, (n, degree));
    }
    found
}

/// Adds `r(d + T) w^n` to the powers of `v` above the n-th, for one coefficient `r` of the other side, times `η^n`.
fn add_later<const M: usize>(
    sums: &mut Polynomial<M>,
    flight: &Flight<M>,
    gain: &Polynomial<M>,
    mut derivative: Row<M>,
    (n, degree): (usize, usize),
) {
    let left = degree - n;
    let mut shifted = Polynomial::ZERO;
    for k in 0..=left {
        for m in k..=left {
            add_product(shifted.row_mut(m, left - m + 1), &derivative, flight.row(k, m - k));
        }
        differentiate(&mut derivative, k);
    }
    for m in 1..=left {
        Polynomial::add_row_of_product(sums.row_mut(n + m, left - m + 1), m, gain, &shifted);
    }
}

fn add_scaled_row<const M: usize>(sums: &mut Polynomial<M>, m: usize, degree: usize, row: &[Pair]) {
    sums.row_mut(m, degree - m + 1).iter_mut().zip(row).for_each(|(sum, term)| *sum += *term);
}
