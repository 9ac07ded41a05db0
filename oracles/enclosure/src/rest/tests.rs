//! The bounds on the acceleration hold at every time of the window and at every height that a flight reaches.

use super::{flights, time_left};
use crate::{
    equation::Start,
    excitation::{Excitation, HalfPhase},
    ground::Ground,
    interval::Interval,
    piece::Motion,
    pull::Side,
};

fn block(epsilon: f64, omega: f64, alpha: Option<f64>) -> (Excitation<f64>, Motion<f64>) {
    let excitation = Excitation::new(&Interval::exactly(epsilon), omega);
    let motion = Motion::new(&excitation.amplitude, omega, alpha);
    (excitation, motion)
}

/// In slow shaking, and in shaking that is fast and strong: what the forcing's slope changes by goes as `aω²`, and neither factor stands for it alone.
#[test]
fn no_acceleration_in_the_window_is_beyond_its_bounds() {
    check(0.05, 2.0, [0.2, 0.25], 60);
    check(2.0, 8.0, [2e-3, 0.05], 20);
}

fn check(epsilon: f64, omega: f64, [speed, window]: [f64; 2], least_windows: usize) {
    let mut found = 0;
    for alpha in [None, Some(0.3), Some(0.8)] {
        let (excitation, motion) = block(epsilon, omega, alpha);
        // From the start to past the greatest excitation, where its slope vanishes and only its bend tells how it goes on.
        for n in 0..=30 {
            let phase = excitation.later(&HalfPhase::start(), &Interval::exactly(0.1 / omega * f64::from(n)));
            for side in [Side::Plus, Side::Minus] {
                let pull = excitation.pull(&phase, side);
                let pulls = excitation.window(&phase, side, &pull, &Interval::exactly(window)).unwrap();
                let Some(bounds) = flights(&motion, &pulls, &Interval::exactly(speed), 0.5) else { continue };
                found += 1;
                for t in 0..=10 {
                    let at = excitation.later(&phase, &Interval::exactly(window * f64::from(t) / 10.0));
                    for x in 0..=10 {
                        let height = 0.5 * speed * speed / bounds.acceleration.upper * f64::from(x) / 10.0;
                        let start = Start {
                            distance: Interval::exactly(height),
                            velocity: Interval::zero(),
                            pull: excitation.pull(&at, side),
                        };
                        let towards = -2.0 * motion.equation.coefficients(&start).extend().middle();
                        let (least, most) = (bounds.acceleration.lower, bounds.acceleration.upper);
                        assert!(
                            (least..=most).contains(&towards),
                            "{alpha:?} {n} {side:?}: {towards} not in {least} to {most}"
                        );
                    }
                }
            }
        }
    }
    assert!(found > least_windows, "{found} windows");
}

/// The bounds hold in the window, so the time that is left has to be inside it, by the sums of the geometric series in doubles: 1.5 times what it
/// would be if nothing changed. It is refused where it would be longer, and not long before.
#[test]
fn what_is_left_is_inside_the_window() {
    let (mut nearly_full, mut refused) = (0, 0);
    for eta in [0.05, 0.5, 0.8, 0.92] {
        for omega in [0.3, 2.0, 20.0] {
            let (excitation, motion) = block(0.03, omega, None);
            for n in 1..=30 {
                let phase = excitation.later(&HalfPhase::start(), &Interval::exactly(0.1 / omega * f64::from(n)));
                let [ours, others] = [Side::Plus, Side::Minus].map(|side| excitation.pull(&phase, side).value.middle());
                for k in 0..60 {
                    let speed = 0.5 * 0.8_f64.powi(k);
                    let speed_now = Interval::exactly(speed);
                    let left = time_left(&motion, &excitation, &phase, Side::Plus, &speed_now, eta);
                    let steady = 2.0 * speed * (1.0 / ours + eta / others) / (1.0 - eta * eta);
                    match left {
                        Some(left) => {
                            assert!(left.upper <= 1.5 * steady * (1.0 + 1e-12), "{eta} {omega} {n} {speed}");
                            assert!(left.lower <= steady && steady <= left.upper, "{eta} {omega} {n} {speed}");
                            nearly_full += usize::from(left.upper > 1.2 * steady);
                        }
                        None => refused += 1,
                    }
                }
            }
        }
    }
    assert!(nearly_full > 50 && refused > 500, "{nearly_full} {refused}");
}
