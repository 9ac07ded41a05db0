//! When it must not be trusted it says so, with the numbers.

use accumulation::Accumulation;
use contract::{Body, Case, Closure, Decline, Departure, Motion, Oracle};

use super::{impact, series, sines};

fn why(motion: &Motion, departure: &Departure) -> Decline {
    series(8, 0.8, None, motion).time_left(departure).unwrap_err()
}

#[test]
fn where_nothing_accumulates_it_declines() {
    let motion = sines(&[(1.5, 2.0, 0.0)]);
    let above = why(&motion, &impact(1.0, 0.785, 0.01));
    assert!(
        matches!(above, Decline::OutOfRange { field: "ground acceleration", value, .. } if value > 1.49),
        "{above}"
    );
    let at_rest = why(&motion, &impact(1.0, 0.1, 0.0));
    assert!(matches!(at_rest, Decline::OutOfRange { field: "velocity", .. }), "{at_rest}");
    let in_the_air = why(&motion, &Departure { rotation: 0.1, ..impact(1.0, 0.1, 0.01) });
    assert!(matches!(in_the_air, Decline::Unsupported { .. }), "{in_the_air}");
    for departure in [impact(1.0, f64::NAN, 0.01), impact(1.0, f64::INFINITY, 0.01), impact(1.0, 0.1, f64::NAN)] {
        assert!(matches!(why(&motion, &departure), Decline::OutOfRange { .. }), "{departure:?}");
    }
}

#[test]
fn next_to_the_initiation_the_terms_do_not_fall() {
    let motion = sines(&[(1.03, 2.0, (1.0_f64 / 1.03).asin())]);
    let early = why(&motion, &impact(1.0, 0.35, 0.01)).to_string();
    assert!(early.contains("term 2 is") && early.contains("tau = 0.35"), "{early}");
    // Free rocking of a block that is thrown over by its speed.
    let over = why(&sines(&[(0.0, 1.0, 0.0)]), &impact(1.0, 0.35, 1.5)).to_string();
    assert!(over.contains("do not fall"), "{over}");
}

#[test]
fn it_does_not_look_beyond_where_the_motion_changes() {
    // What is left is 0.0203, and the line ends at 0.5.
    let record = Motion::record(0.5, 1.0, vec![0.3, -0.1, 0.2]).unwrap();
    assert!(series(8, 0.8, None, &record).time_left(&impact(1.0, 0.4, 0.002)).is_ok());
    for time in [0.485, 0.499] {
        let said = why(&record, &impact(1.0, time, 0.002)).to_string();
        assert!(said.contains("changes at 0.5"), "{said}");
    }
    assert!(series(8, 0.8, None, &record).bounds(&impact(1.0, 0.485, 0.002)).is_err());
    // After the motion the ground is at rest.
    assert!(series(8, 0.8, None, &record).time_left(&impact(1.0, 2.0, 0.05)).is_ok());
}

#[test]
fn it_has_no_impacts_and_no_order_beyond_its_room() {
    let case = Case::from_amplitude(1.03, 2.0, 0.92).unwrap();
    assert!(Accumulation::default().history(&case).is_err());
    assert!([0, 17].iter().all(|order| Accumulation::default().with_order(*order).is_err()));
    let motion = sines(&[(0.5, 2.0, 0.0)]);
    let closure = Accumulation::default().closure_on(&Body::new(0.8, None).unwrap(), &motion).unwrap();
    assert!(closure.time_left(&impact(1.0, 0.2, 0.001)).is_ok());
}
