//! One flight on either side as a power series: how long it lasts, and how fast it lands.
//!
//! It ends where `u(T)/T = 0`. With `T = v t` that is `-a_2 t = 1 + Σ_{k>=3} a_k v^(k-2) t^(k-1)`, solved power by power of `v`: what stands on the right has a power
//! less. It lands with `w = -u'(T)`; less twice `u(T)/T`, which is 0, that is `w/v = 1 - Σ_{k>=3} (k-2) a_k v^(k-2) t^(k-1)`, with no difference of what is nearly equal.

use crate::{
    heights::{Heights, Scaled},
    pair::Pair,
    polynomial::{Polynomial, Row, add_product, add_scaled, reciprocal},
};

/// How long a flight lasts, and how fast it lands.
pub struct Flight<const M: usize> {
    /// `t^k`, for `k = 0, 1, ...`, where `v t` is how long it lasts.
    powers: [Polynomial<M>; M],
    /// `w/v`.
    pub gain: Polynomial<M>,
}

impl<const M: usize> Flight<M> {
    /// `v t` and `w` to the total degree `degree`, which is below `M - 1`.
    pub fn new(scaled: &Scaled<M>, degree: usize) -> Self {
        let heights = Heights::new(scaled, degree);
        let mut flight = Self { powers: [const { Polynomial::ZERO }; M], gain: Polynomial::power(0) };
        if let Some(zeroth) = flight.powers.first_mut() {
            *zeroth = Polynomial::power(0);
        }
        let fall: Row<M> = reciprocal(heights.row(2, 0), degree).map(|fall: Pair| fall * -1.0);
        for m in 0..degree {
            let len = degree - m;
            let mut right = [Pair::ZERO; M];
            if let (0, Some(first)) = (m, right.first_mut()) {
                *first = Pair::ONE;
            }
            for k in 3..=m + 2 {
                let part = flight.part(&heights, k, m, len);
                add_scaled(&mut right, 1.0, &part);
                add_scaled(flight.gain.row_mut(m, len), -((k - 2) as f64), &part);
            }
            if let Some(time) = flight.powers.get_mut(1) {
                add_product(time.row_mut(m, len), &fall, &right);
            }
            for j in 2..=len {
                let (lower, upper) = flight.powers.split_at_mut(j);
                if let ([_, time, ..], Some(before), Some(power)) = (&*lower, lower.last(), upper.first_mut()) {
                    Polynomial::add_row_of_product(power.row_mut(m, len + 1 - j), m, time, before);
                }
            }
        }
        flight
    }

    /// The coefficients of `v^m` of `t^k`.
    pub fn row(&self, k: usize, m: usize) -> &[Pair] {
        self.powers.get(k).map_or(&[], |power| power.row(m))
    }

    /// The coefficients of `v^m` of `a_k v^(k-2) t^(k-1)`, so many.
    fn part(&self, heights: &Heights<M>, k: usize, m: usize, len: usize) -> Row<M> {
        let mut part = [Pair::ZERO; M];
        let left = m + 2 - k;
        if let Some(sum) = part.get_mut(..len) {
            for l in 0..=left.min(heights.speeds) {
                add_product(sum, heights.row(k, l), self.row(k - 1, left - l));
            }
        }
        part
    }
}
