//! Pieces whose remainder is large on purpose: with it they contain what far more digits find, without it they do not.

use super::{FirstRoot, Motion, Piece};
use crate::{
    bounds::Bounds,
    digits::Digits,
    equation::Start,
    excitation::{Excitation, HalfPhase},
    ground::Ground,
    interval::Interval,
    pull::{Pull, Side},
};

type Coarse = Digits<256>;
type Fine = Digits<512>;

/// Flights of all kinds: `epsilon`, `omega`, `alpha`, the time and the speed of the start.
const FLIGHTS: [(f64, f64, Option<f64>, f64, f64); 6] = [
    (0.03, 2.0, None, 0.0, 0.0),
    (0.03, 2.0, None, 0.6, 0.01),
    (0.2, 1.0, None, 0.3, 0.2),
    (0.03, 2.0, Some(0.2), 0.0, 0.0),
    (0.05, 3.0, Some(0.5), 0.4, 0.03),
    (1.0, 0.5, Some(0.1), 5.0, 0.3),
];

fn block<F: crate::directed::Directed>(epsilon: f64, omega: f64, alpha: Option<f64>) -> (Excitation<F>, Motion<F>) {
    let excitation = Excitation::new(&Interval::exactly(epsilon), omega);
    let motion = Motion::new(&excitation.amplitude, omega, alpha);
    (excitation, motion)
}

/// Every pull that there is.
fn any<F: crate::directed::Directed>(excitation: &Excitation<F>) -> Pull<f64> {
    excitation.any_pull(&HalfPhase::start(), Side::Plus, 1.0)
}

fn start<F: crate::directed::Directed>(excitation: &Excitation<F>, time: f64, speed: f64) -> Start<F> {
    let phase = excitation.later(&HalfPhase::start(), &Interval::exactly(time));
    let side = if time > 0.0 { Side::Plus } else { Side::Minus };
    Start { distance: Interval::zero(), velocity: Interval::exactly(speed), pull: excitation.pull(&phase, side) }
}

/// The piece of a flight with a remainder of about a part in a million, and the same in twice the digits.
fn pieces((epsilon, omega, alpha, time, speed): (f64, f64, Option<f64>, f64, f64)) -> (Piece<Coarse>, Piece<Fine>) {
    let deflation = if speed > 0.0 { 1 } else { 3 };
    let (excitation, motion) = block::<Fine>(epsilon, omega, alpha);
    let fine = motion.piece(&start(&excitation, time, speed), &|_| any(&excitation), deflation, 0.4).unwrap();
    let (excitation, motion) = block::<Coarse>(epsilon, omega, alpha);
    let start = start(&excitation, time, speed);
    let mut coefficients = motion.equation.coefficients(&start);
    let leading = {
        while coefficients.motion.len() < deflation + 3 {
            coefficients.extend();
        }
        coefficients.motion[deflation].middle()
    };
    let (degree, remainder) = motion.degree(&start, any(&excitation), deflation, fine.length, 1e-6 * leading).unwrap();
    while coefficients.motion.len() < degree {
        coefficients.extend();
    }
    let mut coefficients = coefficients.motion.split_off(deflation);
    coefficients.truncate(degree - deflation);
    (Piece { coefficients, remainder, deflation, length: fine.length }, fine)
}

fn contains(coarse: &Interval<Coarse>, fine: &Interval<Fine>) -> bool {
    Bounds::new(coarse).unwrap().contain(&Bounds::new(fine).unwrap())
}

#[test]
fn a_piece_contains_the_motion_and_without_its_remainder_it_does_not() {
    for flight in FLIGHTS {
        let (coarse, fine) = pieces(flight);
        let dropped = Piece { coefficients: coarse.coefficients.clone(), remainder: 0.0, ..coarse };
        let mut caught = 0;
        for step in 1..=100 {
            // Interior moments, not evenly spaced, and the end.
            let s = if step == 100 { fine.length } else { fine.length * f64::from(step * step % 101) / 101.0 };
            let (at, fine_at) = (Interval::exactly(s), Interval::exactly(s));
            assert!(contains(&coarse.deflated(&at), &fine.deflated(&fine_at)), "{flight:?} {s}");
            assert!(contains(&coarse.slope(&at), &fine.slope(&fine_at)), "{flight:?} {s}");
            // A cell around it contains it as well.
            let cell = Interval::between(0.9 * s, s);
            assert!(
                contains(&coarse.deflated(&cell), &fine.deflated(&fine_at))
                    && contains(&coarse.slope(&cell), &fine.slope(&fine_at))
            );
            let missed = [
                !contains(&dropped.deflated(&at), &fine.deflated(&fine_at)),
                !contains(&dropped.slope(&at), &fine.slope(&fine_at)),
            ];
            caught += usize::from(missed == [true, true]);
        }
        assert!(caught > 95, "{flight:?}: the dropped remainder was noticed at {caught} of 100 moments");
        let (distance, velocity) = coarse.at(&Interval::exactly(coarse.length));
        let (fine_distance, fine_velocity) = fine.at(&Interval::exactly(fine.length));
        assert!(contains(&distance, &fine_distance) && contains(&velocity, &fine_velocity));
    }
}

#[test]
fn the_impact_is_contained_and_without_the_remainder_it_is_not() {
    let mut landings = 0;
    for flight in FLIGHTS {
        let (coarse, fine) = pieces(flight);
        let dropped = Piece { coefficients: coarse.coefficients.clone(), remainder: 0.0, ..coarse };
        let (FirstRoot::In(left, right), FirstRoot::In(from, to)) = (coarse.search(), fine.search()) else { continue };
        landings += 1;
        let (root, truth) = (coarse.narrow(left, right), fine.narrow(from, to));
        assert!(contains(&root, &truth) && contains(&coarse.velocity_at_root(&root), &fine.velocity_at_root(&truth)));
        assert!(!contains(&dropped.narrow(left, right), &truth), "{flight:?}: the dropped remainder was not noticed");
    }
    assert!(landings >= 2);
}

/// The bounds on what a piece can meet hold on all of it.
#[test]
fn no_motion_leaves_its_reach() {
    for flight in FLIGHTS {
        let (epsilon, omega, alpha, time, speed) = flight;
        let (excitation, motion) = block::<f64>(epsilon, omega, alpha);
        let (_, fine) = pieces(flight);
        let reach = motion.reach(&start(&excitation, time, speed), any(&excitation), fine.length);
        let (distance, velocity) = fine.at(&Interval::exactly(fine.length));
        assert!(
            distance.magnitude() <= reach.distance.magnitude() && velocity.magnitude() <= reach.velocity.magnitude()
        );
    }
    // `cosh h` and `sinh h` themselves, for a motion that only grows.
    let (excitation, motion) = block::<f64>(1e-9, 2.0, None);
    for h in [1e-9, 1e-3, 0.1, 0.5, 1.0, 1.5, 2.0_f64] {
        let at = Start {
            distance: Interval::exactly(1.0),
            velocity: Interval::exactly(0.5),
            ..start(&excitation, 0.0, 0.0)
        };
        let reach = motion.reach(&at, any(&excitation), h);
        let drive = motion.drive;
        let distance = h.cosh() + 0.5 * h.sinh() + drive * (h.cosh() - 1.0);
        let velocity = h.sinh() + 0.5 * h.cosh() + drive * h.sinh();
        assert!(reach.distance.upper >= distance && reach.velocity.upper >= velocity);
        // Nor do they ask for much more, which would cost terms.
        let room = if h <= 0.1 { 1.01 } else { 2.2 };
        assert!(reach.distance.upper <= room * distance && reach.velocity.upper <= room * velocity, "{h}");
    }
}

#[test]
fn every_piece_is_made_with_a_remainder_that_bounds_the_next_coefficient() {
    for (epsilon, omega, alpha, time, speed) in FLIGHTS {
        let (excitation, motion) = block::<Coarse>(epsilon, omega, alpha);
        let start = start(&excitation, time, speed);
        let deflation = if speed > 0.0 { 1 } else { 3 };
        let piece = motion.piece(&start, &|_| any(&excitation), deflation, 0.4).unwrap();
        let degree = piece.coefficients.len() + deflation;
        let mut coefficients = motion.equation.coefficients(&start);
        while coefficients.motion.len() <= degree {
            coefficients.extend();
        }
        assert!(piece.remainder >= coefficients.motion[degree].magnitude() && piece.remainder > 0.0);
    }
}

#[test]
fn of_several_roots_the_first_is_found() {
    // x = s (s - p)(s - q)(c - s)/(p q c): down through p, up through q, down again at c.
    for (p, q) in [(0.05, 0.06), (0.02, 0.5), (0.1, 0.9), (0.3, 0.31), (0.7, 0.75)] {
        let c = 1.5;
        let exactly = Interval::<Coarse>::exactly;
        let coefficients = [p * q * c, -(p * q + c * (p + q)), c + p + q, -1.0].map(exactly).to_vec();
        let piece = Piece { coefficients, remainder: 1e-30, deflation: 1, length: 2.0 };
        let FirstRoot::In(left, right) = piece.first_root() else { panic!("no root of {p}, {q} is found") };
        assert!(left < p && p < right && right < q, "{left} {right} for {p}, {q}");
        assert!((piece.narrow(left, right).middle() - p).abs() < 1e-12);
        let grazing = Piece { length: 0.9 * p, ..piece };
        assert!(matches!(grazing.first_root(), FirstRoot::None));
    }
}

#[test]
fn the_bound_on_the_hyperbolic_cosine_is_above_it() {
    for k in 0..=2000 {
        let h = 1e-3 * f64::from(k);
        let bound = super::cosh_above(&Interval::exactly(h).squared()).upper;
        assert!(bound >= h.cosh() && bound < 1.08 * h.cosh(), "{h}: {bound} {}", h.cosh());
    }
}
