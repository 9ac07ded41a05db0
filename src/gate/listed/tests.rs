//! The list of a case that is right, and the same with each mistake in turn. The truth is a stepper's here: who proves it does not matter.

use super::*;
use crate::{measure::asking::ask, panel};

const TOLERANCE: f64 = 1e-3;

fn case(a: f64) -> Case {
    Case::from_amplitude(a, 2.0, 0.92).unwrap()
}

fn listed(time: f64, velocity: f64) -> Listed {
    let written = |value: f64| Written::new(&value.to_string(), value);
    Listed { time: written(time), velocity: Some(written(velocity)) }
}

/// The first impacts of a case.
fn list(case: &Case, impacts: usize) -> Vec<Listed> {
    let history = panel::stepper().history(&case.with_max_impacts(impacts).unwrap()).unwrap();
    history.impacts.iter().map(|impact| listed(impact.time, impact.velocity)).collect()
}

fn judged(case: &Case, list: &[Listed]) -> Judged {
    let asked = case_for(case, list).unwrap();
    let proven = ask(panel::judges()[0].as_ref(), &asked).into_observed().unwrap();
    judge(&asked, &proven, list, TOLERANCE)
}

/// What is wrong first with the list of 30 impacts that `change` was done to.
fn wrong(change: impl FnOnce(&mut Vec<Listed>)) -> (usize, &'static str, Option<Hint>) {
    let case = case(1.03);
    let mut list = list(&case, 30);
    change(&mut list);
    let judged = judged(&case, &list);
    let wrong = judged.first_wrong.unwrap();
    assert_eq!(judged.right, wrong.n - 1, "{judged:?}");
    (wrong.n, wrong.kind(), judged.hint)
}

fn each(list: &mut [Listed], change: impl Fn(f64, f64) -> (f64, f64)) {
    for impact in list {
        let (time, velocity) = change(impact.time.value, impact.velocity.unwrap().value);
        *impact = listed(time, velocity);
    }
}

#[test]
fn a_list_that_is_right_is_right_to_all_its_digits() {
    for a in [1.03, 1.2] {
        let case = case(a);
        let list = list(&case, 30);
        let judged = judged(&case, &list);
        assert_eq!((judged.right, judged.first_wrong, judged.hint), (list.len(), None, None), "{judged:?}");
        let Digits { time, interval, velocity } = judged.digits;
        assert!(time.unwrap() > 14.0 && interval.unwrap() > 12.0 && velocity.unwrap() > 12.0, "{:?}", judged.digits);
        assert_eq!(judged.rest.is_some(), a == 1.03);
    }
}

#[test]
fn each_mistake_is_called_what_it_is_where_it_is() {
    let moved = |n: usize, share: f64| {
        move |list: &mut Vec<Listed>| {
            let interval = list[n].time.value - list[n - 1].time.value;
            list[n] = listed(list[n].time.value + share * interval, list[n].velocity.unwrap().value);
        }
    };
    assert_eq!(wrong(moved(6, 0.01)), (7, "late", None));
    assert_eq!(wrong(moved(6, -0.01)), (7, "early", None));
    let removed = list(&case(1.03), 5)[4];
    assert_eq!(wrong(|list| list.retain(|impact| *impact != removed)), (5, "missed", None));
    assert_eq!(wrong(|list| drop(list.drain(4..7))), (5, "missed", None));
    assert_eq!(wrong(|list| list.insert(4, list[3])), (5, "repeated", None));
    let between = |list: &mut Vec<Listed>| list.insert(4, listed(0.5 * (list[3].time.value + list[4].time.value), 0.1));
    assert_eq!(wrong(between), (5, "extra", None));
    assert_eq!(wrong(|list| list[8] = listed(0.1, 0.1)), (9, "time-falls", None));
    assert_eq!(wrong(|list| list[8] = listed(1.3, 0.1)), (9, "after-rest", None));
    let turned = |list: &mut Vec<Listed>| list[8] = listed(list[8].time.value, -list[8].velocity.unwrap().value);
    assert_eq!(wrong(turned), (9, "side", None));
    let slower = |list: &mut Vec<Listed>| list[8] = listed(list[8].time.value, 0.99 * list[8].velocity.unwrap().value);
    assert_eq!(wrong(slower), (9, "velocity", None));
}

#[test]
fn what_would_explain_the_whole_list_is_said() {
    let case = case(1.03);
    let zero = (1.0_f64 / 1.03).asin() / 2.0;
    let (n, kind, hint) = wrong(|list| each(list, |time, velocity| (time + zero, velocity)));
    assert!(
        (n, kind) == (1, "late") && matches!(hint, Some(Hint::FromZero(by)) if (by - zero).abs() < 1e-12),
        "{hint:?}"
    );
    let (_, _, hint) = wrong(|list| each(list, |time, velocity| (time + 0.1, velocity)));
    assert!(matches!(hint, Some(Hint::Shifted(by)) if (by - 0.1).abs() < 1e-12), "{hint:?}");
    let (_, _, hint) = wrong(|list| each(list, |time, velocity| (0.25 * time, velocity)));
    assert!(matches!(hint, Some(Hint::Scaled(by)) if (by - 0.25).abs() < 1e-12), "{hint:?}");
    assert_eq!(
        wrong(|list| each(list, |time, velocity| (time, velocity / 0.92))),
        (1, "velocity", Some(Hint::BeforeImpact))
    );
    // Speeds without signs, and a block that starts to the other side, are no mistakes.
    for side in [|velocity: f64| velocity.abs(), |velocity: f64| -velocity] {
        let mut list = list(&case, 30);
        each(&mut list, |time, velocity| (time, side(velocity)));
        assert_eq!(judged(&case, &list).first_wrong, None);
    }
}

#[test]
fn digits_that_were_not_written_are_no_mistakes() {
    let case = case(1.03);
    let rounded = list(&case, 240).into_iter().map(|impact| {
        let text = format!("{:.6}", impact.time.value);
        Listed { time: Written::new(&text, text.parse().unwrap()), velocity: None }
    });
    let judged = judged(&case, &rounded.collect::<Vec<_>>());
    assert_eq!(judged.first_wrong, None);
    assert_eq!(judged.right + judged.unresolved, 240);
    assert!(judged.right > 50 && judged.unresolved > 20, "{judged:?}");
}

#[test]
fn what_comes_after_the_end_is_wrong_or_not_judged() {
    let complete = case(1.03);
    let mut beyond = list(&complete, 20);
    beyond.extend([listed(2.0, 0.0), listed(2.1, 0.01)]);
    let judged_beyond = judged(&complete, &beyond);
    assert_eq!((judged_beyond.right, judged_beyond.later, judged_beyond.first_wrong), (20, 2, None));
    let incomplete = case(1.2);
    let mut more = list(&incomplete, 20);
    let last = more.last().unwrap().time.value;
    more.push(listed(last + 1e-3, 0.1));
    assert_eq!(judged(&incomplete, &more).first_wrong.unwrap().what, What::TooMany);
    assert_eq!(judged(&case(0.9), &list(&complete, 3)).first_wrong.unwrap().what, What::NeverRocks);
}

#[test]
fn the_last_digit_is_that_which_was_written() {
    for (text, resolution) in [("1.25", 5e-3), ("3", 0.5), ("1.25e-3", 5e-6), ("12.5E2", 5.0)] {
        let written = Written::new(text, text.parse().unwrap());
        assert!((written.resolution / resolution - 1.0).abs() < 1e-12, "{text}: {written:?}");
    }
    assert_eq!(
        Written::new("0.12345678901234567890123", 0.12345678901234568).resolution,
        0.5 * f64::EPSILON * 0.12345678901234568
    );
}
