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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::double;

    /// Errors in `η²` and `η⁴` for each pair are removed by two columns; what is at the odd impacts does not matter.
    #[test]
    fn two_columns_remove_two_orders() {
        let ar = Arithmetic::new(256).unwrap();
        let case = Case::from_amplitude(1.03, 2.0, 0.9).unwrap();
        let at = |time: f64| LongImpact { time: ar.number(time), interval: ar.number(1.0), velocity: ar.number(1.0) };
        let q = 0.9_f64 * 0.9;
        let times = (0..3).flat_map(|k| [at(f64::from(k)), at(1.25 - 0.5 * q.powi(k) + 0.125 * q.powi(2 * k))]);
        let impacts: Vec<LongImpact> = times.collect();
        let limit_of = |count| limit(&ar, &case, impacts.get(..count).unwrap()).map(|limit| double(&limit));
        assert!((limit_of(6).unwrap() - 1.25).abs() < 1e-13, "{:?}", limit_of(6));
        assert!((limit_of(4).unwrap() - 1.25).abs() > 1e-3, "one column removes one order only");
        assert_eq!(limit_of(3), Some(0.875));
        assert_eq!(limit_of(1), None);
    }

    #[test]
    fn the_decimals_lost_are_those_of_the_weights() {
        // (1 + 1/4)/(1 - 1/4) and (1 + 1/16)/(1 - 1/16)
        assert!((decimals_lost(0.5, 2) - (5.0_f64 / 3.0 * 17.0 / 15.0).log10()).abs() < 1e-15);
        assert_eq!(decimals_lost(0.5, 0), 0.0);
    }
}
