use astro_float::BigFloat;
use contract::Case;

use crate::arithmetic::Arithmetic;
use crate::follow::LongImpact;

/// The limit of `τ_2, τ_4, τ_6, ...` by extrapolation: their errors are in `η^2, η^4, η^6, ...` for each pair of flights, because the map
/// from impact to impact is analytic in the velocity; so column `k` of a Romberg table with the ratio `η^(2k)` removes one order.
/// `None` without impacts.
pub(crate) fn limit(ar: &Arithmetic, case: &Case, impacts: &[LongImpact]) -> Option<BigFloat> {
    let eta = ar.number(case.eta());
    let ratio = ar.mul(&eta, &eta);
    let one = ar.number(1.0);
    let mut column: Vec<BigFloat> = impacts.iter().skip(1).step_by(2).map(|impact| impact.time.clone()).collect();
    let mut power = ratio.clone();
    while column.len() > 1 {
        let weight = ar.div(&power, &ar.sub(&one, &power));
        column = column
            .iter()
            .zip(column.iter().skip(1))
            .map(|(earlier, later)| ar.add(later, &ar.mul(&weight, &ar.sub(later, earlier))))
            .collect();
        power = ar.mul(&power, &ratio);
    }
    column.pop()
}

/// How many decimals the table of `pairs` sums may lose: its weights grow by up to `(1 + q^k)/(1 - q^k)` in column `k`.
pub(crate) fn decimals_lost(eta: f64, pairs: usize) -> f64 {
    let mut power = 1.0;
    let mut lost = 0.0;
    for _ in 0..pairs {
        power *= eta * eta;
        lost += ((1.0 + power) / (1.0 - power)).log10();
    }
    lost
}
