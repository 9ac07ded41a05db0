//! The amplitude in multiples of the threshold of Eq. 1, at which the block really begins to rock.

use contract::{Case, Normalisation};

/// `a - 1` in multiples of `g tan α`, and how far it may be off by rounding, relative.
///
/// Under the slender normalisation the amplitude is `a α/tan α` such multiples, and `a - 1` is `ε α/tan α - (1 - α/tan α)`: next to the threshold nearly
/// all of it cancels.
pub fn excess(case: &Case) -> (f64, f64) {
    match case.slenderness() {
        Some(of) if of.normalisation() == Normalisation::Slender => {
            let lost = one_less_x_cot_x(of.alpha());
            let excess = case.epsilon() * (1.0 - lost) - lost;
            (excess, 4.0 * f64::EPSILON * (1.0 + lost / excess.abs()))
        }
        _ => (case.epsilon(), 0.0),
    }
}

/// `1 - x cot x` for `0 < x < π/2`, with nothing cancelling: `(sin x - x cos x)/sin x`, the numerator by its series
/// `Σ (-1)^(k+1) 2k x^(2k+1)/(2k+1)!`.
fn one_less_x_cot_x(x: f64) -> f64 {
    // Relative to x³/3, so that nothing underflows.
    let (mut term, mut sum) = (1.0, 0.0);
    for k in 1..=14_u32 {
        sum += term;
        let (k2, next) = (f64::from(2 * k), f64::from(k + 1) / f64::from(k));
        term *= -next * x * x / ((k2 + 2.0) * (k2 + 3.0));
    }
    let sinc = if x < 1e-8 { 1.0 } else { x.sin() / x };
    x * x / 3.0 * sum / sinc
}

#[cfg(test)]
mod tests {
    use super::*;
    use contract::Slenderness;

    #[test]
    fn what_is_lost_is_the_quotient_less_one() {
        for x in [1e-3, 0.1, 0.5, 1.0, 1.5, 1.57] {
            let direct: f64 = 1.0 - x / f64::tan(x);
            assert!((one_less_x_cot_x(x) - direct).abs() < 4e-16, "{x}");
        }
        // x²/3 + x⁴/45 + 2x⁶/945
        let x: f64 = 0.01;
        let series = x * x / 3.0 + x.powi(4) / 45.0 + 2.0 * x.powi(6) / 945.0;
        assert!((one_less_x_cot_x(x) / series - 1.0).abs() < 1e-15);
        assert_eq!(one_less_x_cot_x(1e-300), 0.0);
    }

    #[test]
    fn next_to_the_threshold_little_is_known() {
        let case = |epsilon: f64, normalisation| {
            let slenderness = Slenderness::new(0.1, normalisation).unwrap();
            Case::from_epsilon(epsilon, 2.0, 0.9).unwrap().with_slenderness(slenderness)
        };
        assert_eq!(excess(&case(0.003, Normalisation::Threshold)), (0.003, 0.0));
        // One part in 1e15 above it: half of the digit that is left is not known.
        let (excess_of, off) = excess(&case(0.003346720854506602, Normalisation::Slender));
        assert!(excess_of.abs() < 1e-14 && off > 1e-4, "{excess_of:e} {off:e}");
        let (excess_of, off) = excess(&case(0.03, Normalisation::Slender));
        assert!((excess_of - (1.03 * 0.1 / 0.1_f64.tan() - 1.0)).abs() < 1e-15 && off < 1.2e-15);
    }
}
