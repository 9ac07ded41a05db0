//! That no step of the march passes a root, that no step is shorter than it has to be, and what the march hands on.

use super::*;
use crate::flight::tests::eq_6;
use crate::{UNIT, flow::Flow, forcing::Excitation};
use approx::assert_relative_eq;
use proptest::prelude::*;

fn takeoff(epsilon: f64, omega: f64, phase: f64, sign: f64, speed: f64) -> Takeoff<'static> {
    let excitation: &Excitation = Box::leak(Box::new(Excitation::new(epsilon, omega)));
    let flow: &Flow<f64> = Box::leak(Box::new(Flow::new(omega)));
    let time = Twofold { high: phase / omega, low: 0.0 };
    let forcing = excitation.forcing(sign, excitation.half_phase(time));
    Takeoff { excitation, flow, time, sign, speed, forcing, guess: None, horizon: 100.0 }
}

/// The first positive root of `u + v d + m d²/2`, by the formula of school where it does not cancel; none is infinite.
fn first_root(u: f64, v: f64, m: f64) -> f64 {
    let square = v * v - 2.0 * m * u;
    let roots = [(-v - square.sqrt()) / m, (-v + square.sqrt()) / m];
    roots.into_iter().filter(|root| *root > 0.0).fold(f64::INFINITY, f64::min)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// With a forcing that does not fall the step is to the root of the parabola itself.
    #[test]
    fn a_step_under_a_steady_forcing_ends_at_the_root(u in 0.1..2.0f64, v in -2.0..2.0f64, m in -2.0..2.0f64, longest in 0.1..4.0f64) {
        prop_assume!(m.abs() > 0.01);
        let expected = first_root(u, v, m).min(longest);
        let step = safe_step((u, v), m, longest, |_| 0.0);
        prop_assert!((step - expected).abs() <= 1e-12 * expected / m.abs(), "{step} {expected}");
    }

    /// With one that falls, to the root of the parabola that is as low as the forcing can get within the length of the first.
    #[test]
    fn a_step_under_a_falling_forcing_ends_before_the_root(
        u in 0.1..2.0f64, v in -2.0..2.0f64, m in -2.0..2.0f64, longest in 0.1..4.0f64, fall in 0.1..2.0f64,
    ) {
        let length = first_root(u, v, m).min(longest);
        let lowest = m - length * fall * (1.0 + length);
        prop_assume!(m.abs() > 0.01 && lowest.abs() > 0.01);
        let expected = first_root(u, v, lowest).min(length);
        let step = safe_step((u, v), m, longest, |length| fall * (1.0 + length));
        prop_assert!((step - expected).abs() <= 1e-12 * expected / (m.abs() * lowest.abs()), "{step} {expected}");
        prop_assert!(step > 0.0);
    }
}

/// The corners of the parabola: at rest on the base, leaving it, touching it, and without a root.
#[test]
fn the_steps_of_special_parabolas() {
    let step = |state: (f64, f64), m: f64| safe_step(state, m, 10.0, |_| 0.0);
    assert_eq!(step((0.0, 1.0), -0.5), 4.0); // off the base and back
    assert_eq!(step((0.0, 0.0), -1.0), 0.0); // on the base and held down
    assert_eq!(step((0.0, 0.0), 1.0), 10.0); // on the base and pulled up
    assert_eq!(step((0.0, 0.0), 0.0), 10.0);
    assert_eq!(step((1.0, -1.0), 0.0), 1.0); // a straight line down
    assert_eq!(step((1.0, 1.0), 0.0), 10.0); // and up
    assert_eq!(step((0.5, -1.0), 1.0), 1.0); // touches the base
    assert_eq!(step((0.5, -1.0), 1.001), 10.0); // passes over it
    assert_eq!(step((0.5, 0.0), -1.0), 1.0); // falls from the top
}

/// Numbers that are exact, and what follows from them by hand.
#[test]
fn what_is_handed_on_at_the_end_of_a_march() {
    let takeoff = takeoff(0.3, 2.0, 0.4, 1.0, 3.0);
    let landing = land(&takeoff, 0.5, (1e-17, -2.0), -7.0, 1.5);
    assert_eq!((landing.interval, landing.velocity, landing.loss), (0.5, -2.0, 1.0));
    assert_eq!((landing.acceleration, landing.off_parabola), (-7.0, -7.0 + 8.0));
    assert_eq!((landing.by_speed, landing.by_time), takeoff.derivatives(0.5, -2.0, -7.0));
    assert_relative_eq!(landing.rounding.1, 4.0 * 1.5 * 0.5f64.cosh(), max_relative = 1e-15);
    assert_relative_eq!(landing.rounding.0, landing.rounding.1 / 0.5, max_relative = 1e-15);
    // What grazes the base does not land upwards.
    let grazing = land(&takeoff, 0.5, (0.0, 1e-9), -7.0, 1.5);
    assert_eq!((grazing.velocity, grazing.loss), (0.0, 3.0));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// From rest at initiation, and from any impact, to the first root of Eq. 6; with an error that it states.
    #[test]
    fn a_march_ends_at_the_first_root_of_eq_6(
        epsilon in 0.03..1.0f64, omega in 0.3..6.0f64, phase in 0.0..6.0f64, speed in 0.05..1.0f64, side in any::<bool>(), rest in any::<bool>(),
    ) {
        let takeoff =
            if rest { takeoff(epsilon, omega, 0.0, -1.0, 0.0) } else { takeoff(epsilon, omega, phase, if side { 1.0 } else { -1.0 }, speed) };
        if let Outcome::Landing(landing) = fly(takeoff) {
            let s = landing.interval;
            prop_assume!(s < 6.0);
            let error = 2e-14 * s.cosh();
            let [rotation, velocity, _] = eq_6(&takeoff, s);
            prop_assert!(rotation.abs() <= error, "u = {rotation:e}");
            prop_assert!((velocity - landing.velocity).abs() <= error * (1.0 + landing.acceleration.abs() / landing.velocity.abs().max(1e-3)));
            let largest = (1..=400).map(|k| eq_6(&takeoff, s * f64::from(k) / 400.0)).fold(speed * f64::from(!rest), |largest, [u, rate, _]| {
                largest.max(u.abs() + rate.abs())
            });
            for k in 1..400 {
                prop_assert!(eq_6(&takeoff, s * f64::from(k) / 400.0)[0] > -error);
            }
            // The error is of the largest |u| + |u'| that a step ended at, the last one at the least.
            let stated = landing.rounding.1 / (4.0 * s.cosh());
            prop_assert!(stated <= 1.001 * largest + 1e-12 && stated >= 0.999 * landing.velocity.abs(), "{stated} {largest}");
            prop_assert!(UNIT * landing.rounding.1 >= 0.1 * rotation.abs() || rotation.abs() < 1e-15 * s.cosh());
        }
    }
}

/// A march to a horizon before its impact ends in the air; one past the point of no return is not followed to its horizon.
#[test]
fn a_march_ends_at_its_horizon_or_where_no_return_is_possible() {
    let takeoff = takeoff(0.3, 2.0, 0.4, 1.0, 0.9);
    let Outcome::Landing(Landing { interval, .. }) = fly(takeoff) else { panic!("no impact") };
    assert!(matches!(fly(Takeoff { horizon: 0.9 * interval, ..takeoff }), Outcome::Aloft));
    assert!(matches!(fly(Takeoff { horizon: 0.0, ..takeoff }), Outcome::Aloft));
    // u + u' = v > 1 + a = 2.3 at once
    assert!(matches!(fly(Takeoff { speed: 2.301, horizon: 0.0, ..takeoff }), Outcome::Overturned));
    assert!(matches!(fly(Takeoff { speed: 2.299, horizon: 0.0, ..takeoff }), Outcome::Aloft));
}
