use contract::{Case, Ending, Estimate, History, Impact, Uncertainty};

use super::*;
use crate::{
    cases::generate::Generator,
    gate::compare::{Disagreement, Figure},
};

fn observed(intervals: &[f64], ending: Ending) -> Observed {
    let uncertainty = Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
    let impact = |interval: &f64| Impact { time: 0.0, interval: *interval, velocity: 0.0, uncertainty };
    let history = History { impacts: intervals.iter().map(impact).collect(), ending, chattering_time: None };
    Observed { history, chattering_time: Some(Estimate { value: 2.0, uncertainty: 0.0 }) }
}

/// A case so far from the critical amplitude, relative.
fn named(name: &str, distance: f64) -> Named {
    let critical = crate::measure::critical::interpolated(2.0, 0.92).unwrap();
    let case = Case::from_epsilon(critical * (1.0 + distance), 2.0, 0.92).unwrap();
    Named { generator: Generator::List, name: name.to_owned(), case }
}

fn wrong(observable: Observable, impact: usize) -> Finding {
    let figure = Figure { impact, difference: 1.0, allowed: 0.0 };
    let disagreement = Disagreement { observable, figure, values: [String::new(), String::new()], poisoned: 0 };
    Finding::Refuted { oracle: "mine".to_owned(), judge: "judge".to_owned(), disagreement, granted: false }
}

fn profile(answer: &Observed, truth: &Observed, findings: &[Finding], named: &Named) -> Profile {
    Held { answer, truth, is_proven: true, model: Model::Linear, findings }.profile(named)
}

/// Ranges double: 1, 2, 3 and 4, 5 to 8. Impacts before the first that is wrong are right; the others have their errors all the same.
#[test]
fn errors_are_counted_by_depth() {
    let truth = observed(&[1.0, 0.5, 0.2, 0.1, 0.05, 0.01], Ending::AtRest);
    let answer = observed(&[1.0, 0.5, 0.2 * (1.0 + 1e-12), 0.2, 0.05], Ending::AtRest);
    let found = [wrong(Observable::Interval, 4)];
    let profile = profile(&answer, &truth, &found, &named("one", -0.5));
    let rows = profile.depth.iter().map(|depth| (depth.from, depth.to, depth.right, depth.lacking));
    assert_eq!(rows.collect::<Vec<_>>(), [(1, 1, 1, 0), (2, 2, 1, 0), (3, 4, 1, 0), (5, 8, 0, 1)]);
    let worst: Vec<f64> = profile.depth.iter().map(|depth| depth.intervals.worst).collect();
    assert_eq!((worst[0], worst[2], worst[3]), (0.0, 1.0, 0.0));
    assert_eq!(profile.deepest, Some(Deepest { impact: 3, case: "list/one".to_owned() }));
    assert_eq!(profile.smallest.map(|smallest| (smallest.interval, smallest.impact)), Some((0.2, 3)));
    assert_eq!((profile.right, profile.wrong, profile.proven, profile.stepped), (0, 1, 1, 0));
}

/// Next to the critical amplitude an answer may be that of the other side; from afar it is wrong in other ways.
#[test]
fn the_side_and_the_distance_of_what_is_wrong_are_told() {
    let [rests, rocks] = [Ending::AtRest, Ending::Incomplete].map(|ending| observed(&[1.0], ending));
    let ending = [wrong(Observable::Ending, 2)];
    let mut all = profile(&rests, &rests, &[], &named("a", -1e-3));
    all.add(profile(&rests, &rests, &[], &named("b", -3e-6)));
    all.add(profile(&rocks, &rests, &ending, &named("c", -1e-7)));
    all.add(profile(&rests, &rests, &[wrong(Observable::Interval, 1)], &named("d", -0.1)));
    all.add(profile(&rocks, &rocks, &[], &named("e", 1e-5)));
    let below = &all.sides.below;
    assert_eq!((below.right, below.wrong, below.turned), (2, 2, 1));
    let near = |value: Option<f64>, expected: f64| (value.unwrap() / expected - 1.0).abs() < 1e-3;
    assert!(near(below.nearest_right, 3e-6) && near(below.farthest_wrong, 0.1) && near(below.farthest_turned, 1e-7));
    assert_eq!((all.sides.above.right, all.sides.above.wrong), (1, 0));
    let said = &all.endings["at-rest"];
    assert_eq!((said.right, said.wrong, said.open, said.says["incomplete"]), (3, 1, 0, 1));
}

/// What is counted in shares is what is counted at once, in whichever order.
#[test]
fn profiles_add_up_in_any_order() {
    let truth = observed(&[1.0, 0.5, 0.2, 0.1], Ending::AtRest);
    let parts: Vec<Profile> = (1..5)
        .map(|length| {
            let answer = observed(&[1.0, 0.5, 0.2, 0.1][..length], Ending::AtRest);
            profile(&answer, &truth, &[], &named(&length.to_string(), -0.1 * length as f64))
        })
        .collect();
    let sum = |order: &[usize]| {
        let mut sum = Profile::default();
        order.iter().for_each(|place| sum.add(parts[*place].clone()));
        sum
    };
    assert_eq!(sum(&[0, 1, 2, 3]), sum(&[3, 1, 0, 2]));
    let text = serde_json::to_string(&sum(&[0, 1, 2, 3])).unwrap();
    assert_eq!(serde_json::from_str::<Profile>(&text).unwrap(), sum(&[0, 1, 2, 3]));
}
