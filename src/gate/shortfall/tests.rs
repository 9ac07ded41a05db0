//! What turns a run red, each by itself, and what does not because the run is small.

use super::*;
use crate::{
    gate::{expected::Met, tally::Tally},
    panel,
};

fn pair(compared: usize) -> Pair {
    Pair { compared, impacts: 10 * compared, chattering_times: compared, ..Pair::default() }
}

fn judged_by(run: &Run) -> Vec<Shortfall> {
    shortfalls(run, &panel::roles()).0
}

/// A whole run of so many cases in which nothing is wrong.
fn run(cases: usize) -> Run {
    let oracles = vec!["one".to_owned(), "two".to_owned()];
    let identity = Identity { cases, hash: 7 };
    let mut tally = Tally { examined: identity, ..Tally::default() };
    tally.answered.extend(oracles.iter().map(|oracle| (oracle.clone(), cases)));
    let mut run = Run::of(oracles.clone(), 0, identity, tally, Some(Vec::new()), Vec::new());
    let mut pair = Pair { oracles: [oracles[0].clone(), oracles[1].clone()], ..pair(cases) };
    let figure = crate::gate::compare::Figure { impact: 1, difference: 0.5, allowed: 1.0 };
    let worst = crate::gate::counting::WorstFigure { figure, share: 0.5, case: String::new() };
    pair.worst.insert(Observable::Interval, worst);
    run.pairs = vec![pair];
    run
}

#[test]
fn a_run_in_which_nothing_is_wrong_falls_short_of_nothing() {
    for cases in [1, 19, 20, 99, 100, 5000] {
        assert_eq!(judged_by(&run(cases)), [], "{cases} cases");
    }
    assert!(shortfalls(&run(5), &panel::roles()).1.len() >= 2, "what a small run can't judge is listed");
    assert!(shortfalls(&run(500), &panel::roles()).1.is_empty());
}

#[test]
fn each_shortfall_is_found_where_there_are_cases_enough() {
    type Change = fn(&mut Run);
    for (enough, change, kind) in [
        (1, (|run| run.tally.examined.cases -= 1) as Change, "unaccounted"),
        (1, |run| run.tally.examined.hash ^= 1, "unaccounted"),
        (1, |run| run.oracles.truncate(1), "alone"),
        (20, |run| _ = run.tally.answered.remove("two"), "silent"),
        (100, |run| _ = run.tally.declines.insert("two".to_owned(), [("why".to_owned(), 50)].into()), "declined"),
        (20, |run| run.pairs[0].impacts = 0, "no-impact"),
        (20, |run| run.pairs[0].chattering_times = 0, "no-chattering-time"),
        (20, |run| run.pairs[0].vacuous = run.pairs[0].impacts, "in-name-only"),
        (100, |run| run.pairs[0].vacuous_times = run.pairs[0].chattering_times * 4 / 5, "in-name-only"),
        (100, |run| run.pairs[0].worst.values_mut().for_each(|worst| worst.share = 0.009), "unused"),
        (20, |run| run.pairs[0].too_close = run.pairs[0].compared * 2 / 3, "too-close"),
        (20, |run| (run.tally.to_judge, run.tally.judged) = (20, 18), "unjudged"),
        (1, |run| _ = run.tally.known.insert(0, Met { cases: 1000, largest: 0.0 }), "no-longer-diverges"),
    ] {
        let mut red = run(enough);
        change(&mut red);
        let found = judged_by(&red);
        let kinds: Vec<String> = found
            .iter()
            .filter_map(|shortfall| Some(serde_json::to_value(shortfall).ok()?["kind"].as_str()?.to_owned()))
            .collect();
        assert!(kinds.iter().any(|found| found == kind), "{kind} is not found in {enough} cases: {kinds:?}");
        if enough > 1 {
            let mut small = run(enough - 1);
            change(&mut small);
            let asked = small.tally.to_judge;
            (small.tally.to_judge, small.tally.judged) = (asked.min(19), 0);
            assert_eq!(judged_by(&small), [], "{kind} in {} cases", enough - 1);
        }
    }
}

/// What the panel says that an oracle may decline is the limit, and of few cases the ten that prove nothing.
#[test]
fn an_oracle_may_decline_its_share_and_no_more() {
    let may_decline = |oracle: &str| if oracle == "two" { 0.25 } else { 0.0 };
    let roles = Roles { series: "none", may_decline: &may_decline, ..panel::roles() };
    let declining = |oracle: &str, cases: usize, declined: usize| {
        let mut run = run(cases);
        run.tally
            .declines
            .insert(oracle.to_owned(), [("one reason".to_owned(), 2), ("two".to_owned(), declined - 2)].into());
        shortfalls(&run, &roles).0.len()
    };
    assert_eq!((declining("two", 200, 50), declining("two", 200, 51)), (0, 1));
    assert_eq!((declining("one", 200, 10), declining("one", 200, 11)), (0, 1));
}

/// A run of a few chosen cases has to have compared something, and to have run what it was given.
#[test]
fn a_few_chosen_cases_only_have_to_have_compared_something() {
    let chosen = |vacuous: usize| {
        let mut run = run(1);
        run.whole = false;
        run.pairs[0].vacuous = vacuous;
        judged_by(&run)
    };
    assert_eq!((chosen(0), chosen(10)), (vec![], vec![Shortfall::NothingCompared]));
}

/// An engine of which it is declared that it never says "at rest" is held to all else.
#[test]
fn no_chattering_time_is_wanted_of_what_is_declared_to_have_none() {
    let roles = Roles { never_rests: &|oracle| oracle == "two", ..panel::roles() };
    let short = |change: fn(&mut Pair)| {
        let mut run = run(20);
        run.pairs[0].chattering_times = 0;
        change(&mut run.pairs[0]);
        (shortfalls(&run, &roles).0.len(), judged_by(&run).len())
    };
    assert_eq!(short(|_| ()), (0, 1));
    assert_eq!(short(|pair| pair.vacuous = pair.impacts), (1, 1));
    assert_eq!(short(|pair| pair.impacts = 0), (1, 1));
}
