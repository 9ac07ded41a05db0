//! Free rocking on still ground, `u'' = u - 1`, in closed form.
//!
//! With `w = 1 - u`, `w'' = w`: the energy `w² - w'²` is kept, and `w + w'` grows as `e^s`. The block lands where `w = 1`, with the speed
//! `sqrt(u'² + u(2 - u))`, if `w + w'` is positive, `u + u' < 1`; otherwise it never does.

use contract::{Arrival, Estimate};

/// The flight from the rotation `u >= 0` with the velocity `v`, both away from the base.
pub(crate) fn fly((u, v): (f64, f64), horizon: f64) -> Arrival {
    let toward = 1.0 - (u + v);
    if toward <= 0.0 {
        return Arrival::Overturned { after: 0.0 };
    }
    let speed = (v * v + u * (2.0 - u)).sqrt();
    // e^s = (1 + speed)/(1 - u - v). What this has above 1 is a sum of positive numbers once v < 0 no longer cancels.
    let sum = if v >= 0.0 { speed + v } else { u * (2.0 - u) / (speed - v) };
    let interval = ((sum + u) / toward).ln_1p();
    if interval <= horizon {
        return Arrival::Impact { interval, speed };
    }
    let (rotation, velocity) = motion((u, v), horizon);
    Arrival::Aloft { rotation, velocity }
}

/// The rotation and the velocity a time `s` later: `u + v sinh s - (1 - u)(cosh s - 1)`.
pub(crate) fn motion((u, v): (f64, f64), s: f64) -> (f64, f64) {
    let half = (0.5 * s).sinh();
    let (sinh, cosh_less_one) = (s.sinh(), 2.0 * half * half);
    (u + (v * sinh - (1.0 - u) * cosh_less_one), v + (v * cosh_less_one - (1.0 - u) * sinh))
}

/// How many flights are summed one by one at the most, and how many terms of the series are: of the two only one is needed unless the block both
/// comes next to the balance and hardly loses any speed.
const MOST_FLIGHTS: f64 = 2e5;
const MOST_TERMS: u32 = 1_000_000;
/// Up to which speed the series is short.
const SLOW: f64 = 0.5;
/// What rounding leaves of the sum, relative.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// How long infinitely many flights take that start with the speeds `v, ηv, η²v, ...`: `2 Σ artanh(η^k v)`, from 0 on; `None` where the block would pass the
/// balance, `v >= 1`.
///
/// The fast ones are summed one by one, and those that are left by powers of `v`: `2 Σ v^m/(m (1 - η^m))` over the odd `m`.
pub(crate) fn time_to_rest(v: f64, eta: f64) -> Option<Estimate> {
    if !(0.0..1.0).contains(&v) {
        return None;
    }
    let rate = eta.ln();
    let mut flight = 0.0;
    let mut sum = 0.0;
    let mut slow = v;
    while slow > SLOW && flight < MOST_FLIGHTS {
        sum += 2.0 * slow.atanh();
        flight += 1.0;
        slow = v * (rate * flight).exp();
    }
    let (mut power, mut m) = (slow, 1.0);
    for _ in 0..MOST_TERMS {
        let term = 2.0 * power / (m * -(m * rate).exp_m1());
        sum += term;
        // The terms fall faster than those of the geometric series with this ratio.
        if term <= 0.5 * f64::EPSILON * (1.0 - slow * slow) * sum {
            return Some(Estimate { value: sum, uncertainty: (ROUNDING + 0.5 * f64::EPSILON * flight.sqrt()) * sum });
        }
        power *= slow * slow;
        m += 2.0;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    fn landing(start: (f64, f64)) -> (f64, f64) {
        match fly(start, f64::INFINITY) {
            Arrival::Impact { interval, speed } => (interval, speed),
            other => panic!("{start:?}: {other:?}"),
        }
    }

    proptest! {
        /// What lands is at the base and has not lost any energy, wherever it started.
        #[test]
        fn a_free_flight_lands_on_the_base_with_the_energy_it_had(u in 0.0..0.999f64, share in -3.0..0.999f64) {
            let start = (u, share * (1.0 - u));
            prop_assume!(u > 0.0 || share > 0.0);
            let (interval, speed) = landing(start);
            let (rotation, velocity) = motion(start, interval);
            let size = (1.0 + start.1.abs()) * interval.cosh();
            prop_assert!(rotation.abs() <= 4e-15 * size, "{rotation}");
            prop_assert!((velocity + speed).abs() <= 4e-15 * size, "{velocity} {speed}");
        }

        /// Two stretches are one of both lengths, and the motion obeys u'' = u - 1.
        #[test]
        fn the_motion_is_that_of_the_equation(u in 0.0..1.5f64, v in -1.0..1.0f64, s in 0.0..2.0f64, t in 0.0..2.0f64) {
            let (one, two) = (motion(motion((u, v), s), t), motion((u, v), s + t));
            prop_assert!((one.0 - two.0).abs() < 1e-13 && (one.1 - two.1).abs() < 1e-13);
            let d = 1e-4;
            let second = (motion((u, v), s + d).1 - motion((u, v), s - d).1) / (2.0 * d);
            prop_assert!((second - (two_at((u, v), s) - 1.0)).abs() < 1e-5);
        }
    }

    fn two_at(start: (f64, f64), s: f64) -> f64 {
        motion(start, s).0
    }

    /// Housner (1963): released at rest from `u`, a block takes `acosh(1/(1 - u))` to land.
    #[test]
    fn a_quarter_period_is_that_of_housner() {
        for u in [1e-9, 1e-3, 0.1, 0.5, 0.9, 0.999] {
            let expected = (1.0_f64 / (1.0 - u)).acosh();
            assert_relative_eq!(landing((u, 0.0)).0, expected, max_relative = if u < 1e-6 { 1e-7 } else { 1e-12 });
        }
    }

    /// `s = 2 artanh v`, to the last digits of the smallest flight; `2v` where that is all there is.
    #[test]
    fn a_flight_from_the_base_lands_with_the_speed_it_left_with() {
        for v in [1e-300, 1e-20, 1e-3, 0.3, 0.9] {
            let (interval, speed) = landing((0.0, v));
            assert_relative_eq!(interval, 2.0 * f64::atanh(v), max_relative = 4e-16);
            assert_relative_eq!(speed, v, max_relative = 1e-15);
        }
    }

    /// Against the flights themselves, one after another, as long as they count; and the sums of nothing and next to nothing.
    #[test]
    fn the_sum_of_free_rocking_is_that_of_its_flights() {
        for (v, eta) in [(0.2, 0.5), (0.9, 0.92), (0.999_999, 0.8), (0.7, 0.999), (0.3, 0.05)] {
            let (mut speed, mut sum): (f64, f64) = (v, 0.0);
            while speed > 1e-18 * v {
                sum += landing((0.0, speed)).0;
                speed *= eta;
            }
            let closed = time_to_rest(v, eta).unwrap();
            assert!((closed.value - sum).abs() <= 2e-13 * sum, "{v} {eta}: {closed:?} {sum}");
            assert!(closed.uncertainty < 1e-13 * sum);
        }
        assert_relative_eq!(time_to_rest(1e-300, 0.9).unwrap().value, 2e-299, max_relative = 1e-14);
        assert_eq!(time_to_rest(0.0, 0.9).unwrap().value, 0.0);
        assert!(time_to_rest(1.0, 0.9).is_none() && time_to_rest(f64::NAN, 0.9).is_none());
    }

    #[allow(clippy::excessive_precision)] // as they came
    const REFERENCES: [(f64, f64, f64); 10] = [
        (0.5, 0.9999, 10306.581315187809695),
        (0.99, 0.9999, 24042.958681436239370),
        (0.9, 0.999999, 2051878.3484443742619),
        (0.001, 0.99999999, 200000.02121727848693),
        // Where rounding happens to add up.
        (0.5827740342239768, 0.9674262507836526, 37.393561660250110508),
        (0.44572077107433594, 0.9983202063626548, 543.35711397169863848),
        (0.9999999998839831, 0.9989771036721206, 2429.7999427153512412),
        (0.8277715820472364, 0.5871505208127415, 4.8264519166287109895),
        (0.6353820935630572, 0.9615966141534568, 34.933177938720457746),
        (0.999999999996212, 0.9943887029264491, 461.62216420271028359),
    ];

    /// Calculated once with 40 digits: `2 Σ artanh(η^k v)`.
    #[test]
    fn hardly_damped_rocking_is_summed_to_the_last_digits() {
        for (v, eta, expected) in REFERENCES {
            let closed = time_to_rest(v, eta).unwrap();
            assert!((closed.value - expected).abs() <= closed.uncertainty, "{v} {eta}: {closed:?}");
            assert!(closed.uncertainty < 1e-12 * expected);
        }
        // Next to the balance with hardly any loss there is no short way.
        assert!(time_to_rest(1.0 - 1e-9, 1.0 - 1e-12).is_none());
    }

    #[test]
    fn past_the_balance_nothing_returns() {
        assert_eq!(fly((1.0, 0.0), 1.0), Arrival::Overturned { after: 0.0 });
        assert_eq!(fly((0.4, 0.6), 1.0), Arrival::Overturned { after: 0.0 });
        assert!(matches!(fly((1.5, -0.51), 1e3), Arrival::Impact { .. }));
        assert!(
            matches!(fly((0.5, 0.2), 1e-3), Arrival::Aloft { rotation, velocity } if rotation > 0.5 && velocity < 0.2)
        );
    }
}
