//! No state of a parallelogram lands outside of the next one.

use super::*;
use crate::{digits::Digits, known::Known};

type Fine = Digits<256>;

/// How far along each side of a parallelogram a state is, from its time and its speed.
fn along_sides(of: &Parallelogram<f64>, time: &Interval<Fine>, speed: &Interval<Fine>) -> Pair<Fine> {
    let [time_unit, speed_unit] = of.units.map(Interval::exactly);
    let beside = [&(time - &of.time.convert()) / &time_unit, &(speed - &of.speed.convert()) / &speed_unit];
    apply(&convert(&against(of.direction)), &beside)
}

/// Wide parallelograms, of which the corners, the middles of the sides and the point fly alone, in more digits: all land within the next one, and not all
/// land within one that is a little smaller.
#[test]
fn what_is_inside_lands_inside() {
    for (epsilon, omega, eta) in [(0.03, 2.0, 0.92), (0.05, 0.7, 0.6), (0.01, 8.0, 0.97), (0.06, 3.0, 0.8)] {
        let coarse = Excitation::<f64>::new(&Interval::exactly(epsilon), omega);
        let coarse_motion = Motion::new(&coarse.amplitude, omega, None);
        let coarse_scene = Scene::new(&coarse_motion, &coarse, (omega, eta));
        let excitation = Excitation::<Fine>::new(&Interval::exactly(epsilon), omega);
        let motion = Motion::new(&excitation.amplitude, omega, None);
        let mut known = Known::<f64>::initiation();
        let (mut side, mut outside) = (Side::Minus, 0);
        for impact in 0..16 {
            let Flown::Landed(_, next) = known.fly(&coarse_scene, side, &Interval::exactly(10.0)) else {
                panic!("{epsilon} {omega} {eta}: not landed at {impact}");
            };
            side = side.other();
            known = next;
            let Known::Together(states) = &mut known else { panic!("a slender block is followed together") };
            // The rounding of doubles alone is too little to see by.
            states.reach = [1e-6, 3e-7].map(Interval::within);
            states.beside = beside(states.units, states.direction, &states.reach);
            let Flown::Landed(interval, next) = states.fly(&coarse_scene, side, &Interval::exactly(10.0)) else {
                panic!("{epsilon} {omega} {eta}: not landed after {impact}");
            };
            let smaller = next.reach.each_ref().map(|reach| {
                let half = 0.8 * reach.magnitude();
                Interval::<Fine>::within(half)
            });
            let time = states.time.convert::<Fine>().centre();
            let speed = states.speed.convert::<Fine>();
            for (one, other) in [(0, 0), (1, 1), (1, -1), (-1, 1), (-1, -1), (1, 0), (0, 1), (-1, 0), (0, -1)] {
                let [a, b] = [1e-6 * f64::from(one), 3e-7 * f64::from(other)].map(Interval::exactly);
                let [later, faster] = apply(&convert::<Fine>(&along(states.direction)), &[a, b]);
                let [time_unit, speed_unit] = states.units.map(Interval::exactly);
                let start = &time + &(&time_unit * &later);
                let from = From::Impact(&speed + &(&speed_unit * &faster));
                let moment = excitation.later(&HalfPhase::start(), &start);
                let takeoff = Takeoff { moment, side, from, horizon: Interval::exactly(10.0) };
                let Outcome::Landing { interval: lasted, speed: landed, .. } = motion.fly(&excitation, takeoff) else {
                    panic!("the state at {one}, {other} does not land");
                };
                // What is not known of the time of the point, in the units of the next one.
                let width = states.time.width() / next.units[0];
                // A tenth of the smaller reach: more would hide what is outside.
                assert!(width < 3e-8, "the time of the point is not known: {width:e}");
                let place = along_sides(&next, &(&start + &lasted), &(&Interval::exactly(eta) * &landed));
                for (place, reach) in place.iter().zip(&next.reach) {
                    let (place, reach) = (place.middle(), [reach.lower - 2.0 * width, reach.upper + 2.0 * width]);
                    assert!(reach[0] <= place && place <= reach[1], "{epsilon} {eta} {impact}: {place:e} {reach:?}");
                }
                let every = interval.convert::<Fine>();
                assert!(lasted.lower >= every.lower && lasted.upper <= every.upper, "{epsilon} {eta} {impact}");
                outside += usize::from(
                    place
                        .iter()
                        .zip(&smaller)
                        .any(|(place, smaller)| place.upper > smaller.upper || place.lower < smaller.lower),
                );
            }
        }
        assert!(outside > 16, "{epsilon} {omega} {eta}: a smaller parallelogram would do: {outside}");
    }
}

/// By two flights a little apart, in many digits.
#[test]
fn derivatives_are_differences() {
    let (epsilon, omega) = (0.03, 2.0);
    let excitation = Excitation::<Fine>::new(&Interval::exactly(epsilon), omega);
    let motion = Motion::new(&excitation.amplitude, omega, None);
    for (start, v, side) in
        [(0.6, 0.02, Side::Plus), (0.9, 0.1, Side::Minus), (1.3, 0.01, Side::Plus), (0.7, 1e-7, Side::Minus)]
    {
        let flight = |start: &Interval<Fine>, v: &Interval<Fine>| {
            let moment = excitation.later(&HalfPhase::start(), start);
            let takeoff = Takeoff { moment, side, from: From::Impact(v.clone()), horizon: Interval::exactly(9.0) };
            let Outcome::Landing { interval, speed, .. } = motion.fly(&excitation, takeoff) else {
                panic!("{start:?}")
            };
            [interval, speed]
        };
        let point = |x: f64| Interval::<Fine>::exactly(x);
        let step = point(1e-20 * v);
        let [here, later, faster] = [
            flight(&point(start), &point(v)),
            flight(&(&point(start) + &step), &point(v)),
            flight(&point(start), &(&point(v) + &step)),
        ];
        let difference = |there: &Pair<Fine>, what: usize| (&(&there[what] - &here[what]) / &step).middle();
        let phase = excitation.later(&HalfPhase::start(), &point(start));
        let Ok(found) = together::<Fine, (), Fine>(&motion, &excitation, side, (phase, point(v), point(9.0))) else {
            panic!("{start}: no flight");
        };
        let [[by_time, by_speed], [faster_by_time, faster_by_speed]] = found.derivatives();
        let expected = [
            (by_time, difference(&later, 0)),
            (by_speed, difference(&faster, 0)),
            (faster_by_time, difference(&later, 1)),
            (faster_by_speed, difference(&faster, 1)),
        ];
        for (bounds, difference) in expected {
            let off = 1e-12 * difference.abs();
            assert!(
                bounds.lower - off <= difference && difference <= bounds.upper + off,
                "{start}: {bounds:?} {difference}"
            );
            assert!(bounds.width() < 1e-12 * (1.0 + difference.abs()), "{start}: {bounds:?}");
        }
    }
}
