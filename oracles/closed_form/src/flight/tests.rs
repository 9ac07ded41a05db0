//! Each step of a flight against a formula of its own: the guess, Newton's method, the proof that a root is the first, and what is handed on.

use super::*;
use crate::{flow::Flow, twofold::Twofold};
use approx::assert_relative_eq;
use proptest::prelude::*;

/// A flight of this case that starts at the phase `phase` of the excitation.
fn takeoff(epsilon: f64, omega: f64, phase: f64, sign: f64, speed: f64) -> Takeoff<'static> {
    let excitation: &Excitation = Box::leak(Box::new(Excitation::new(epsilon, omega)));
    let flow: &Flow<f64> = Box::leak(Box::new(Flow::new(omega)));
    let time = Twofold { high: phase / omega, low: 0.0 };
    let forcing = excitation.forcing(sign, excitation.half_phase(time));
    Takeoff { excitation, flow, time, sign, speed, forcing, guess: None, horizon: 100.0 }
}

/// A flight with a forcing that need not be that of its excitation.
fn driven(epsilon: f64, omega: f64, speed: f64, [acceleration, jerk, snap]: [f64; 3]) -> Takeoff<'static> {
    let forcing = Forcing { acceleration, jerk, snap, rounding: (7.0, 11.0) };
    Takeoff { forcing, ..takeoff(epsilon, omega, 0.0, 1.0, speed) }
}

/// A flight that, followed through the base, crosses it down, up and down again, all within reach of the series; and how long these take.
fn thrice() -> (Takeoff<'static>, [f64; 3]) {
    let takeoff = takeoff(0.0514, 1.768, -0.3442, -1.0, 0.00904);
    let around = [0.282, 0.980, 1.372].map(|phase| phase / 1.768);
    let roots = around.map(|around: f64| {
        let (mut low, mut high) = (0.97 * around, 1.03 * around);
        let rises = eq_6(&takeoff, low)[0] < 0.0;
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if (eq_6(&takeoff, middle)[0] < 0.0) == rises { low = middle } else { high = middle }
        }
        low
    });
    (takeoff, roots)
}

/// `u`, `u'` and `u''` by Eq. 6 in local time, which is good to rounding where `s` is of order 1.
pub(crate) fn eq_6(takeoff: &Takeoff, s: f64) -> [f64; 3] {
    let Forcing { acceleration, jerk, snap, .. } = takeoff.forcing;
    let omega = takeoff.excitation.omega;
    // the forcing -1 - i f(s) = m + c cos(ωs) + d sin(ωs)
    let (c, d) = (-snap / (omega * omega), jerk / omega);
    let (mean, scale) = (acceleration - c, 1.0 / (1.0 + omega * omega));
    let (sin, cos) = (omega * s).sin_cos();
    let (growing, rising) = (mean + scale * c, takeoff.speed + scale * omega * d);
    let rotation = -mean - scale * (c * cos + d * sin) + growing * s.cosh() + rising * s.sinh();
    let velocity = scale * omega * (c * sin - d * cos) + growing * s.sinh() + rising * s.cosh();
    [rotation, velocity, rotation + mean + c * cos + d * sin]
}

/// The root of `v + b s/2 + (v + j) s²/6 + (b + k) s³/24`, the first terms of `u/s`, next to that of a parabola.
fn root_of_four_terms(takeoff: &Takeoff) -> f64 {
    let (v, Forcing { acceleration: b, jerk: j, snap: k, .. }) = (takeoff.speed, takeoff.forcing);
    let mut s = -2.0 * v / b;
    for _ in 0..50 {
        let value = v + s * (b / 2.0 + s * ((v + j) / 6.0 + s * (b + k) / 24.0));
        let slope = b / 2.0 + s * ((v + j) / 3.0 + s * (b + k) / 8.0);
        s -= value / slope;
    }
    s
}

mod guesses {
    use super::*;

    /// With `b = -2` and `v = 3` the parabola is 3 long, and `j`, `k` are chosen for the corrections to be `e` and `d`.
    fn corrected(e: f64, d: f64) -> Takeoff<'static> {
        driven(0.03, 2.0, 3.0, [-2.0, 2.0 * e - 3.0, 2.0 + d / 0.375])
    }

    /// What is left out is `42 e⁵ + 84 d e³ + 28 d² e + 12 d³` and smaller: each term of the guess is needed to come as near as this.
    #[test]
    fn the_guess_of_a_short_flight_is_right_to_the_order_of_its_terms() {
        for (e, d, near) in [
            (1e-2, 0.0, 5e-9),
            (-1e-2, 0.0, 5e-9),
            (0.0, 1e-3, 1.5e-8),
            (0.0, -1e-3, 1.5e-8),
            (1e-2, 1e-4, 2e-8),
            (-1e-2, 1e-4, 2e-8),
            (0.15, 0.0, 6e-3),
        ] {
            let takeoff = Takeoff { guess: Some(7.0), ..corrected(e, d) };
            assert_relative_eq!(takeoff.first_guess(), root_of_four_terms(&takeoff), max_relative = near);
        }
    }

    #[test]
    fn where_the_corrections_are_large_the_last_flight_of_the_same_sign_is_the_guess() {
        for takeoff in [corrected(0.21, 0.0), corrected(-0.21, 0.0), driven(0.03, 2.0, 3.0, [2.0, -3.0, -2.0])] {
            assert_eq!(Takeoff { guess: Some(7.0), ..takeoff }.first_guess(), 7.0);
            assert_eq!(takeoff.first_guess(), -2.0 * takeoff.speed / takeoff.forcing.acceleration);
        }
    }

    /// `j s³/6 + k s⁴/24 = 0`.
    #[test]
    fn the_guess_of_the_first_flight_is_eq_31() {
        assert_eq!(driven(0.03, 2.0, 0.0, [0.0, 0.5, -8.0]).first_guess(), 0.25);
    }
}

mod newton {
    use super::*;

    #[test]
    fn a_step_leaves_the_cube_of_what_was_missing() {
        let takeoff = takeoff(0.03, 2.0, 0.4, 1.0, 0.5);
        let root = takeoff.newton(takeoff.first_guess()).map_or(f64::NAN, |landing| landing.interval);
        for off in [-1e-2, -1e-3, 1e-3, 1e-2] {
            let s = root * (1.0 + off);
            let next = s * (1.0 + halley(&takeoff.flow.after_impact(s, takeoff.speed, &takeoff.forcing)));
            assert!((next / root - 1.0).abs() < 0.2 * off.abs().powi(3) + 1e-15, "{off}: {:e}", next / root - 1.0);
        }
    }

    #[test]
    fn there_is_no_root_where_the_series_do_not_reach_or_a_root_is_crossed_upwards() {
        let (takeoff, [first, upwards, third]) = thrice();
        for guess in [0.0, -0.1, f64::NAN, 1.01 * takeoff.flow.longest(), upwards, 1.001 * upwards, 0.999 * upwards] {
            assert!(takeoff.newton(guess).is_none(), "{guess}");
        }
        for root in [first, third] {
            for guess in [0.99 * root, 1.01 * root] {
                let landing = takeoff.newton(guess);
                assert_relative_eq!(landing.map_or(f64::NAN, |landing| landing.interval), root, max_relative = 1e-11);
            }
        }
    }

    #[test]
    fn the_whole_reach_of_the_series_is_tried() {
        // Of a parabola of its length the guess is the root itself.
        let longest = Flow::new(2.0).longest();
        let takeoff = takeoff(0.03, 2.0, 0.4, 1.0, 0.5);
        assert!(takeoff.newton(longest).is_some_and(|landing| landing.interval < longest));
    }

    /// Wherever the last step started, the loss is that of the root, to rounding and to the `1e-18` of the speed that may be left out; and
    /// what is left out is in the rounding error.
    #[test]
    fn the_loss_is_that_of_the_root_itself() {
        for speed in [1e-6, 1e-4, 1e-2, 0.1, 0.5] {
            let takeoff = takeoff(0.03, 2.0, 0.4, 1.0, speed);
            let root = takeoff.newton(takeoff.first_guess()).map_or(f64::NAN, |landing| landing.interval);
            let at_root = takeoff.flow.after_impact(root, speed, &takeoff.forcing);
            for off in [1e-4, 1e-5, 5e-7, 1e-7, 2e-8, 5e-9, 5e-10, -1e-4, -1e-5, -5e-7, -1e-7, -2e-8, -5e-9, -5e-10] {
                let Some(landing) = takeoff.newton(root * (1.0 + off)) else { panic!("{speed} {off}") };
                assert_relative_eq!(landing.interval, root, max_relative = 4e-16);
                let allowed = 1e-15 * at_root.loss.abs() + 1e-18 * speed;
                assert!(
                    (landing.loss - at_root.loss).abs() <= allowed,
                    "{speed} {off}: {:e}",
                    landing.loss - at_root.loss
                );
                let summed = takeoff.landing(root, at_root.loss, 0.0, at_root.bend).rounding.1;
                let left_out = (landing.rounding.1 - summed) * UNIT;
                assert!((-1e-15 * summed * UNIT..=1e-18 * speed).contains(&left_out), "{speed} {off}: {left_out:e}");
            }
        }
    }

    /// A march that ends a little off is sharpened; where Newton's method goes elsewhere, what the march found is kept.
    #[test]
    fn only_the_same_root_is_sharpened() {
        let (takeoff, [first, ..]) = thrice();
        let found = |interval: f64| {
            let landing = takeoff.newton(first).map(|landing| takeoff.sharpened(Landing { interval, ..landing }));
            landing.map_or(f64::NAN, |landing| landing.interval)
        };
        for near in [first * (1.0 + 9e-7), first * (1.0 - 9e-7)] {
            assert_relative_eq!(found(near), first, max_relative = 1e-11);
        }
        for far in [first * (1.0 + 1.1e-6), first * (1.0 - 1.1e-6), 0.99 * first] {
            assert_eq!(found(far), far);
        }
    }
}

mod proof {
    use super::*;

    /// Whether the root at `s` is the first; `sinh` and `cosh` are free to choose.
    fn is_first(takeoff: &Takeoff, s: f64, by_speed: (f64, f64)) -> bool {
        takeoff.is_first(&Landing { by_speed, ..takeoff.landing(s, 0.0, 0.0, 0.0) })
    }

    /// `u'' < 0` as long as `b + s (v + rise) < 0`, and no further. The snap is positive: there is no other proof.
    #[test]
    fn concave_flights_are_proven_to_the_last_bit() {
        for (epsilon, omega, s, [acceleration, jerk], exact) in [
            // rise = j + ω² a s = 0.25 + 4 · 1.5 · 0.125 = 1, below ωa = 3
            (0.5, 2.0, 0.125, [-1.0, 0.25], 7.0),
            // a falling forcing may rise by the drift only, 0.75
            (0.5, 2.0, 0.125, [-1.0, -5.0], 7.25),
            // rise = ωa = 3, below j + ω² a s = 2 + 1.5
            (0.5, 2.0, 0.25, [-1.0, 2.0], 1.0),
        ] {
            let proven =
                |speed: f64| is_first(&driven(epsilon, omega, speed, [acceleration, jerk, 1.0]), s, (1e9, 1e9));
            assert!(proven(exact - 1e-9), "{jerk}");
            assert!(!proven(exact), "{jerk}");
            assert!(!proven(exact + 1e-9), "{jerk}");
        }
    }

    /// `u'''' < 0` as long as `v sinh s + ε (cosh s - 1) - ω² + drive < 0`, and no further. Here `sinh s = 0.5`, and `cosh s` is what makes
    /// the numbers exact; `b >= 0` at the start leaves no other proof.
    #[test]
    fn flights_of_falling_curvature_are_proven_to_the_last_bit() {
        for (omega, s, cosh, [acceleration, jerk], exact) in [
            // fall = j + ω² a s = 0.25 + 0.75, the lowest b = -0.125, drive = 3 · 0.125; v/2 + 1 - 4 + 0.375 = 0
            (2.0, 0.125, 3.0, [0.0, -0.25], 5.25),
            // no fall but the drift, 0.75: drive = 3 · 0.09375
            (2.0, 0.125, 3.0, [0.0, 0.5], 5.4375),
            // fall = ωa = 3: drive = 3 · 0.75
            (2.0, 0.25, 3.0, [0.0, -2.0], 1.5),
            // b is never below -1 - a: drive = 3 · 2.5
            (2.0, 2.0, -8.0, [0.0, -2.0], 2.0),
            // b stays positive: there is no drive
            (2.0, 0.125, 3.0, [1.0, -0.25], 6.0),
            // slower than the block: drive = (1 - ω²) ε = 0.375
            (0.5, 0.125, 0.0, [0.0, -0.25], 0.75),
        ] {
            let proven = |speed: f64, snap: f64| {
                is_first(&driven(0.5, omega, speed, [acceleration, jerk, snap]), s, (0.5, cosh))
            };
            assert!(proven(exact - 1e-9, -1.0), "{omega} {s} {jerk}");
            assert!(!proven(exact, -1.0), "{omega} {s} {jerk}");
            assert!(!proven(exact + 1e-9, -1.0), "{omega} {s} {jerk}");
            assert!(!proven(exact - 1e-9, 0.0) && !proven(exact - 1e-9, 1.0), "{omega} {s} {jerk}");
        }
    }

    /// `u'' < 0 < u'''` at the start leaves room for three sign changes.
    #[test]
    fn falling_curvature_proves_nothing_where_the_signs_change_thrice() {
        for (acceleration, rate, proven) in
            [(-0.125, 1.0, false), (-0.125, 0.0, true), (-0.125, -1.0, true), (0.0, 1.0, true), (0.125, 1.0, true)]
        {
            let takeoff = driven(0.5, 2.0, 1.0, [acceleration, rate - 1.0, -1.0]);
            assert_eq!(is_first(&takeoff, 0.25, (0.5, 2.0)), proven, "b = {acceleration}, u''' = {rate}");
        }
    }

    /// The root that is not the first is never taken for it, whatever Newton's method starts from.
    #[test]
    fn a_flight_ends_at_the_first_of_three_roots() {
        let (takeoff, [first, _, third]) = thrice();
        let later = takeoff.newton(third);
        assert!(later.is_some_and(|landing| !takeoff.is_first(&landing)));
        let Outcome::Landing(landing) = (Takeoff { guess: Some(third), ..takeoff }).fly() else { panic!("no impact") };
        assert_relative_eq!(landing.interval, first, max_relative = 1e-11);
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 4000, ..ProptestConfig::default() })]

        /// Around the turn of the forcing flights have up to three roots. The guess must not decide which one is taken.
        #[test]
        fn a_flight_ends_at_the_same_impact_from_every_guess(
            epsilon in -2.5..-0.3f64, omega in 0.5..6.0f64, before in 0.0..0.6f64, speed in -5.0..-1.5f64, guess in 0.0..1.0f64,
        ) {
            let (epsilon, speed) = (10f64.powf(epsilon), 10f64.powf(speed));
            let takeoff = takeoff(epsilon, omega, -before, -1.0, speed);
            let guess = Some(guess * takeoff.flow.longest());
            match ((Takeoff { guess, ..takeoff }).fly(), march::fly(takeoff)) {
                (Outcome::Landing(one), Outcome::Landing(other)) => {
                    // At a grazing impact both resolve the square of what is missing.
                    let grazing = 1e-9 * (1.0 + 1e-3 / other.velocity.abs());
                    prop_assert!((one.interval - other.interval).abs() <= grazing * other.interval.max(1e-6));
                }
                (Outcome::Aloft, Outcome::Aloft) | (Outcome::Overturned, Outcome::Overturned) => {}
                _ => prop_assert!(false, "different ends"),
            }
        }
    }

    #[test]
    fn an_impact_beyond_the_horizon_is_not_one() {
        let takeoff = takeoff(0.03, 2.0, 0.4, 1.0, 0.1);
        let Outcome::Landing(Landing { interval, .. }) = takeoff.fly() else { panic!("no impact") };
        for (horizon, lands) in [(1.001 * interval, true), (interval, true), (0.5 * interval, false)] {
            assert_eq!(matches!((Takeoff { horizon, ..takeoff }).fly(), Outcome::Landing(_)), lands, "{horizon}");
        }
    }
}

mod handed_on {
    use super::*;

    /// Numbers that are exact, and what follows from them by hand.
    #[test]
    fn what_is_known_at_the_impact() {
        let takeoff = driven(0.5, 2.0, 3.0, [-4.0, -2.0, 5.0]);
        let landing = takeoff.landing(0.5, 1.0, 13.0 * UNIT, 0.25);
        assert_eq!((landing.interval, landing.loss, landing.velocity), (0.5, 1.0, -2.0));
        assert_eq!((landing.off_parabola, landing.acceleration), (0.5, 0.5 - 8.0));
        let (by_speed, by_time) = takeoff.derivatives(0.5, -2.0, -7.5);
        assert_eq!((landing.by_speed, landing.by_time), (by_speed, by_time));
        // 3 + 0.5 · 4/2 = 4 of the parabola; thrice 0.25 (3 + 2 + 0.125 · 9)/6 of the rest; 0.5 · 7/2 and 11 · 0.25/6 of the forcing
        assert_relative_eq!(
            landing.rounding.0,
            4.0 + 3.0 * 0.25 * 6.125 / 6.0 + 1.75 + 2.75 / 6.0,
            max_relative = 1e-15
        );
        // 1.5 times 0.25 (3 + 2 + 0.25 · 9)/6; 0.125 · 7/12 and 11 · 0.25/6 of the forcing; and what was left out
        assert_relative_eq!(
            landing.rounding.1,
            1.5 * 0.25 * 7.25 / 6.0 + 0.875 / 12.0 + 2.75 / 6.0 + 13.0,
            max_relative = 1e-15
        );
    }

    /// By the time of the start, a flight from rest that is driven by the rate of the forcing, `j cos ωs + k sin(ωs)/ω`.
    fn by_time(omega: f64, jerk: f64, snap: f64, s: f64) -> (f64, f64) {
        let (sin, cos) = (omega * s).sin_cos();
        let scale = 1.0 / (1.0 + omega * omega);
        (
            scale * (jerk * (s.cosh() - cos) + snap * (s.sinh() - sin / omega)),
            scale * (jerk * (s.sinh() + omega * sin) + snap * (s.cosh() - cos)),
        )
    }

    /// Long flights by the functions themselves, short ones by two terms, which at `max(1, ω) s = 1/4` leave out some 1e-5.
    #[test]
    fn the_derivatives_are_those_of_eq_6() {
        for omega in [0.3, 1.0, 3.0, 8.0f64] {
            for (jerk, snap) in [(0.4, 0.0), (0.0, -1.3), (0.4, 0.9)] {
                let takeoff = driven(0.5, omega, 0.7, [-0.6, jerk, snap]);
                for (x, near) in [(0.2499, 4e-5), (0.1, 1e-6), (0.251, 1e-11), (0.9, 1e-12), (2.0, 1e-13), (8.0, 1e-13)]
                {
                    let s = x / omega.max(1.0);
                    let [_, velocity, acceleration] = eq_6(&takeoff, s);
                    let ((sinh, cosh), (tilt, turn)) = takeoff.derivatives(s, velocity, acceleration);
                    assert_relative_eq!(sinh, s.sinh(), max_relative = 5e-3 * near);
                    assert_relative_eq!(cosh, s.cosh(), max_relative = 1e-3 * near);
                    let expected = by_time(omega, jerk, snap, s);
                    assert_relative_eq!(tilt, expected.0, max_relative = near);
                    assert_relative_eq!(turn, expected.1, max_relative = near);
                }
            }
        }
    }

    /// Where the functions themselves would cancel to nothing.
    #[test]
    fn the_derivatives_of_a_tiny_flight_keep_their_digits() {
        let takeoff = driven(0.5, 8.0, 0.7, [-0.6, 0.4, 0.9]);
        for s in [1e-3, 1e-7, 1e-60] {
            let ((sinh, cosh), (tilt, turn)) = takeoff.derivatives(s, f64::NAN, f64::NAN);
            assert_relative_eq!(sinh, s, max_relative = 2e-7);
            assert_relative_eq!(cosh, 1.0, max_relative = 6e-7);
            assert_relative_eq!(tilt, 0.2 * s * s + 0.15 * s * s * s, max_relative = 1e-5);
            assert_relative_eq!(turn, 0.4 * s + 0.45 * s * s, max_relative = 2e-5);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, max_global_rejects: 100_000, ..ProptestConfig::default() })]

        /// Newton's root, where it is certified, is the one that the march cannot pass; and what it says of it is the same.
        #[test]
        fn newton_and_the_march_follow_the_same_flight(
            epsilon in 1e-3..1.0f64, omega in 0.3..8.0f64, phase in 0.0..1.0f64, exponent in -3.0..0.0f64, side in any::<bool>(),
        ) {
            let sign = if side { 1.0 } else { -1.0 };
            let takeoff = takeoff(epsilon, omega, 2.0 * core::f64::consts::PI * phase, sign, 10f64.powf(exponent));
            let newton = takeoff.newton(takeoff.first_guess()).filter(|landing| takeoff.is_first(landing));
            prop_assume!(newton.is_some());
            let (Some(newton), Outcome::Landing(march)) = (newton, march::fly(takeoff)) else {
                return Err(TestCaseError::fail("the march finds no impact"));
            };
            // Both resolve u to about 1e-16, so the time as far as the impact is not a grazing one.
            let slowness = 1.0 / newton.velocity.abs();
            prop_assert!((newton.interval - march.interval).abs() <= 1e-15 * (2.0 + slowness) * newton.interval.max(1.0));
            let tolerance = 1e-15 * (4.0 + newton.acceleration.abs() * slowness) * 4.0;
            prop_assert!((newton.velocity - march.velocity).abs() <= tolerance);
            // Only bounds on errors are made of this one; it is that of one Newton step before the impact.
            prop_assert!((newton.acceleration - march.acceleration).abs() <= 1e-5 * (1.0 + omega));
        }
    }
}
