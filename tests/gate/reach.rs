//! The generators hit what they should. A generator that silently stopped reaching a regime would leave the gate green and blind.

use chattercheck::{
    cases::generate::{Generator, Named},
    gate::{
        partition::{Partition, cost_of_case},
        run,
    },
    measure::critical,
    panel,
};
use contract::{Case, Ending, Horizon, Normalisation, Oracle};

fn stepper() -> Box<dyn Oracle> {
    panel::default().swap_remove(0)
}

fn cases(generator: Generator) -> Vec<Named> {
    generator.cases(1, 2000, stepper().as_ref())
}

/// How a case ends for the closed form, and its shortest interval.
fn outcome(case: &Case) -> (Ending, f64) {
    ending_after(case, case.max_impacts())
}

/// The same with another limit of impacts: next to `a_cr` it takes many until the outcome is clear.
fn ending_after(case: &Case, impacts: usize) -> (Ending, f64) {
    let history = stepper().history(&case.with_max_impacts(impacts).unwrap()).unwrap();
    (history.ending, history.impacts.last().map_or(f64::INFINITY, |last| last.interval))
}

fn count(cases: &[Named], holds: impl Fn(&Case) -> bool) -> usize {
    cases.iter().filter(|named| holds(&named.case)).count()
}

/// Distance to the threshold as a share of `a_cr - 1`, by the fit of Eq. 77.
fn share(case: &Case) -> f64 {
    case.epsilon() / (critical::eq77(case.eta()) - 1.0)
}

#[test]
fn random_cases_reach_every_regime() {
    let cases = cases(Generator::Random);
    assert_eq!(cases.len(), 2000);
    let reaches = |what: &str, least: usize, holds: &dyn Fn(&Case) -> bool| {
        let found = count(&cases, holds);
        assert!(found >= least, "{what}: {found} of 2000 cases, at least {least} expected");
    };
    reaches("near the threshold", 100, &|case| share(case) < 1e-3);
    reaches("the middle", 700, &|case| (0.1..0.9).contains(&share(case)));
    reaches("near a_cr, below", 100, &|case| (0.9..1.0).contains(&share(case)));
    reaches("above a_cr", 100, &|case| share(case) > 1.02);
    reaches("low restitution", 300, &|case| case.eta() < 0.7);
    reaches("high restitution", 150, &|case| case.eta() > 0.96);
    reaches("slow excitation", 40, &|case| case.omega() < 0.5);
    reaches("fast excitation", 40, &|case| case.omega() > 8.0);
    reaches("slender blocks", 400, &|case| case.slenderness().unwrap().alpha() < 0.05);
    reaches("stocky blocks", 400, &|case| case.slenderness().unwrap().alpha() > 0.2);
    // One of eight is from far outside, where a fault that shows there only has nowhere else to be seen.
    reaches("restitution below 0.5", 100, &|case| case.eta() < 0.5);
    reaches("restitution below 0.1", 25, &|case| case.eta() < 0.1);
    reaches("restitution above 0.99", 25, &|case| case.eta() > 0.99);
    reaches("restitution above 0.999", 10, &|case| case.eta() > 0.999);
    reaches("very slow excitation", 80, &|case| case.omega() < 0.1);
    reaches("very fast excitation", 80, &|case| case.omega() > 20.0);
    reaches("below 0.5 and very fast", 20, &|case| case.eta() < 0.5 && case.omega() > 20.0);
    reaches("amplitudes of 1.1 and more", 20, &|case| case.epsilon() > 0.1);
    reaches("amplitudes within 1e-6 of the threshold", 30, &|case| case.epsilon() < 1e-6);
    reaches("very stocky blocks", 40, &|case| case.slenderness().unwrap().alpha() > 0.5);
    let distinct = |of: fn(&Case) -> f64| {
        let mut values: Vec<u64> = cases.iter().map(|named| of(&named.case).to_bits()).collect();
        values.sort_unstable();
        values.dedup();
        values.len()
    };
    assert!(distinct(Case::eta) > 1900, "restitutions repeat: {} distinct", distinct(Case::eta));
    assert!(distinct(Case::omega) > 1900, "frequencies repeat: {} distinct", distinct(Case::omega));
    assert!(distinct(Case::epsilon) > 1900, "amplitudes repeat: {} distinct", distinct(Case::epsilon));
    for (low, high) in [(0.5, 0.6), (0.6, 0.7), (0.7, 0.8), (0.8, 0.9), (0.9, 0.96), (0.96, 0.99)] {
        reaches(&format!("restitution in {low}..{high}"), 100, &|case| (low..high).contains(&case.eta()));
    }
    for octave in -1..3 {
        let (low, high) = (2.0_f64.powi(octave), 2.0_f64.powi(octave + 1));
        reaches(&format!("frequency in {low}..{high}"), 200, &|case| (low..high).contains(&case.omega()));
    }
    let usual = |case: &Case| (-5.3 / case.eta().ln()).ceil().clamp(40.0, 600.0) as usize;
    reaches("as deep as the tail needs", 1500, &|case| case.max_impacts() >= usual(case));
    reaches("twice as deep as the tail needs", 60, &|case| case.max_impacts() >= 2 * usual(case));
    let endings: Vec<_> = cases.iter().map(|named| outcome(&named.case)).collect();
    let complete = endings.iter().filter(|(ending, _)| *ending == Ending::AtRest).count();
    let incomplete = endings.iter().filter(|(ending, _)| *ending == Ending::Incomplete).count();
    assert!(complete > 1000 && incomplete > 150, "{complete} complete, {incomplete} incomplete");
    let deep = endings.iter().filter(|(_, interval)| *interval < 1e-15).count();
    assert!(deep > 20, "{deep} cases with intervals below 1e-15");
}

#[test]
fn edge_cases_walk_to_both_ends_of_the_range() {
    let cases = cases(Generator::Edge);
    let places: Vec<(f64, f64)> = vec![(2.0, 0.92), (0.5, 0.92), (8.0, 0.92), (2.0, 0.5), (2.0, 0.75), (2.0, 0.97)];
    for (omega, eta) in places {
        let (below, above) = critical::bracket(stepper().as_ref(), omega, eta).unwrap().expect("a critical amplitude");
        assert_eq!(below.next_up(), above, "the bracket is two neighbouring doubles");
        let here: Vec<f64> = cases
            .iter()
            .filter(|named| named.case.omega() == omega && named.case.eta() == eta)
            .map(|named| named.case.epsilon())
            .collect();
        assert!(
            here.contains(&below) && here.contains(&above),
            "the walk reaches a_cr at omega = {omega}, eta = {eta}"
        );
        assert!(here.iter().filter(|epsilon| (*epsilon / below - 1.0).abs() < 1e-11).count() >= 8);
        assert!(here.iter().any(|epsilon| *epsilon > 0.0 && *epsilon <= 1e-12), "the walk reaches the threshold");
        for step in [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-12] {
            for (side, from, sign) in [("below", below, -1.0), ("above", above, 1.0)] {
                let there = here.iter().any(|epsilon| ((epsilon / from - 1.0) * sign / step - 1.0).abs() < 1e-3);
                assert!(there, "no step {step:e} {side} a_cr at omega = {omega}, eta = {eta}");
            }
        }
    }
    for (omega, eta) in [(2.0, 0.92), (0.7, 0.85)] {
        let (below, above) = critical::bracket(stepper().as_ref(), omega, eta).unwrap().expect("a critical amplitude");
        let rungs: Vec<&Named> = cases
            .iter()
            .filter(|named| named.name.contains("alpha=") && named.case.omega() == omega && named.case.eta() == eta)
            .collect();
        assert_eq!(rungs.len(), 20, "the ladder at omega = {omega}, eta = {eta}");
        for exponent in 3..=12 {
            let rung = 10.0_f64.powi(-exponent);
            for (distance, ending) in [(below - rung, Ending::AtRest), (above + rung, Ending::Incomplete)] {
                let there = rungs.iter().find(|named| (named.case.epsilon() - distance).abs() < 1e-3 * rung);
                let case = there.expect("a rung").case;
                assert_eq!(ending_after(&case, 20_000).0, ending, "{rung:e} from a_cr at omega = {omega}, eta = {eta}");
            }
        }
    }
    let reaches = |least: usize, holds: &dyn Fn(&Case) -> bool| assert!(count(&cases, holds) >= least);
    reaches(5, &|case| case.eta() >= 0.99);
    reaches(5, &|case| case.eta() <= 0.5);
    reaches(5, &|case| case.omega() <= 0.1);
    reaches(5, &|case| case.omega() >= 20.0);
    reaches(4, &|case| case.epsilon() <= 0.0);
    let endings: Vec<Ending> = cases.iter().map(|named| ending_after(&named.case, 20_000).0).collect();
    let of = |wanted: Ending| endings.iter().filter(|ending| **ending == wanted).count();
    let counts = [Ending::AtRest, Ending::Incomplete, Ending::NeverRocks].map(of);
    assert!(counts[0] > 100 && counts[1] > 80 && counts[2] >= 4, "{counts:?}");
}

#[test]
fn spaced_cases_fill_the_grid_up_to_the_critical_amplitude() {
    let cases = cases(Generator::Spaced);
    assert_eq!(cases.len(), 150);
    let distinct = |of: &dyn Fn(&Case) -> f64| {
        let values = cases.iter().map(|named| format!("{:.6}", of(&named.case)));
        values.collect::<std::collections::BTreeSet<_>>().len()
    };
    let counts = [
        distinct(&|case| case.eta()),
        distinct(&|case| case.omega()),
        distinct(&share),
        distinct(&|case| case.slenderness().unwrap().alpha()),
    ];
    assert_eq!(counts, [5, 5, 6, 6], "distinct restitutions, frequencies, shares of a_cr - 1, and slendernesses");
    // But for the strongest excitations, where the fit of a_cr that the grid is made with may lie above a_cr.
    let goes_on = |case: &Case| matches!(ending_after(case, 2000).0, Ending::Incomplete | Ending::Overturned);
    assert_eq!(count(&cases, |case| ending_after(case, 2000).0 == Ending::AtRest), 150 - count(&cases, goes_on));
    assert_eq!(count(&cases, |case| share(case) < 0.5 && goes_on(case)), 0);
    assert!(count(&cases, goes_on) < 15);
}

#[test]
fn listed_cases_have_every_kind_of_ending_and_both_normalisations() {
    let cases = cases(Generator::List);
    for ending in [Ending::AtRest, Ending::Incomplete, Ending::NeverRocks, Ending::Overturned] {
        assert!(cases.iter().any(|named| outcome(&named.case).0 == ending), "no listed case is {ending}");
    }
    let slender = |case: &Case| case.slenderness().is_some_and(|s| s.normalisation() == Normalisation::Slender);
    assert!(count(&cases, slender) >= 1);
    assert!(count(&cases, |case| case.horizon() != Horizon::HalfPeriod) >= 2);
    assert!(count(&cases, |case| outcome(case).1 < 1e-19) >= 1, "no listed case goes down to 1e-20");
}

#[test]
fn the_same_seed_gives_the_same_cases_and_another_seed_others() {
    let of = |seed| Generator::Random.cases(seed, 50, stepper().as_ref());
    assert_eq!(of(7), of(7));
    assert_ne!(of(7), of(8));
    // Every byte of a seed counts.
    let first = |seed| format!("{:?}", Generator::Random.cases(seed, 1, stepper().as_ref())[0].case);
    let seeds = (0..8).map(|byte| 7 + (1 << (8 * byte)));
    assert_eq!(seeds.chain([7]).map(first).collect::<std::collections::HashSet<_>>().len(), 9);
    // A longer run begins with the cases of a shorter one.
    assert_eq!(of(7)[..20], Generator::Random.cases(7, 20, stepper().as_ref())[..]);
}

#[test]
fn partitions_are_disjoint_and_complete() {
    let whole = run::cases(&run::Selection { cases: 30, seed: 3 }, stepper().as_ref());
    let costs: Vec<f64> = whole.iter().map(|named| cost_of_case(named, false)).collect();
    let part = |part| Partition { part, parts: 3 }.of(whole.clone(), &costs);
    let mut parts: Vec<Named> = (1..=3).flat_map(part).collect();
    assert_eq!(parts.len(), whole.len());
    parts.sort_by_key(|named| whole.iter().position(|other| other == named));
    assert_eq!(parts, whole);
}
