//! The comparison in numbers that are exact: differences, allowances, and which endings go together.

use super::*;
use crate::{measure::asking::ask, panel};
use contract::{Estimate, History, Horizon, Impact, Model, Normalisation, Sensitivity, Slenderness, Uncertainty};

fn case() -> Case {
    let case = Case::from_epsilon(0.5, 2.0, 0.5).and_then(|case| case.with_horizon(Horizon::Until(4.0)));
    case.unwrap_or_else(|invalid| panic!("{invalid}"))
}

fn impact(time: f64, interval: f64, velocity: f64, claim: f64) -> Impact {
    Impact { time, interval, velocity, uncertainty: Uncertainty { time: claim, interval: claim, velocity: claim } }
}

/// Three impacts, every claim `claim`, and the chattering time 2 with the same.
fn observed(claim: f64) -> Observed {
    let impacts = vec![impact(1.0, 1.0, 0.5, claim), impact(1.5, 0.5, -0.25, claim), impact(1.75, 0.25, 0.125, claim)];
    let history = History { impacts, ending: Ending::AtRest, chattering_time: None };
    Observed { history, chattering_time: Some(Estimate { value: 2.0, uncertainty: claim }) }
}

fn none() -> Conditioning {
    Conditioning::default()
}

fn compared(first: &Observed, second: &Observed) -> Comparison {
    compare(&case(), first, second, Slack { conditioning: &none(), gap: None })
}

#[test]
fn the_share_of_an_allowance() {
    let share = |difference: f64, allowed: f64| Figure { impact: 1, difference, allowed }.share();
    assert_eq!((share(1.0, 4.0), share(4.0, 1.0), share(0.0, 0.0), share(1.0, 0.0)), (0.25, 4.0, 0.0, f64::INFINITY));
    assert_eq!((share(f64::NAN, 1.0), share(1.0, f64::NAN)), (f64::INFINITY, f64::INFINITY));
    let allowed = |difference: f64| Figure { impact: 1, difference, allowed: 1.0 }.is_allowed();
    assert_eq!([allowed(0.5), allowed(1.0), allowed(1.1), allowed(f64::NAN)], [true, true, false, false]);
}

/// Half of the value is wide already, with whatever is not a number.
#[test]
fn an_allowance_of_more_than_half_of_the_value_compares_nothing() {
    assert_eq!([is_wide(1.0, 2.0), is_wide(1.1, 2.0), is_wide(f64::NAN, 2.0)], [false, true, true]);
}

/// A difference of the sum of the two claims is allowed, and no more; in the scale of each observable.
#[test]
fn every_observable_is_compared_in_its_own_scale() {
    let (first, claim) = (observed(1.0 / 64.0), 1.0 / 32.0);
    type Change = fn(&mut Impact, f64);
    for (observable, n, change, by) in [
        (Observable::Interval, 2, (|i, by| i.interval += by) as Change, claim * 0.5 / (1.0 - claim)),
        (Observable::Velocity, 2, |i, by| i.velocity -= by, claim * 0.25 / (1.0 - claim)),
        (Observable::ImpactTime, 3, |i, by| i.time += by, claim),
        (Observable::ImpactTime, 3, |i, by| i.time -= by, claim),
    ] {
        let with = |share: f64| {
            let mut second = first.clone();
            change(&mut second.history.impacts[n - 1], share * by);
            compared(&first, &second)
        };
        assert_eq!(with(0.999).agreement, Agreement::Agree, "{observable}");
        let share = with(0.999).worst[&observable].share();
        assert!((share - 0.999).abs() < 1e-3 && share < 1.0, "{observable}: {share}");
        let Agreement::Disagree(found) = with(1.001).agreement else { panic!("{observable} is not compared") };
        assert_eq!((found.observable, found.figure.impact, found.poisoned), (observable, n, 3 - n));
        assert_eq!(with(1.001).impacts, n);
    }
    // The ratio has the claims of two intervals, and there are two ratios.
    let figure = compared(&first, &first).worst[&Observable::IntervalRatio];
    assert_eq!((figure.impact, figure.difference, figure.allowed), (3, 0.0, 4.0 / 64.0));
    // Of the chattering time, once the impacts agree.
    for (off, agrees) in [(claim, true), (-claim, true), (1.01 * claim, false), (-1.01 * claim, false)] {
        let mut second = first.clone();
        second.chattering_time = Some(Estimate { value: 2.0 + off, uncertainty: 1.0 / 64.0 });
        let comparison = compared(&first, &second);
        assert_eq!(comparison.agreement == Agreement::Agree, agrees, "{off}");
        let figure = comparison.worst[&Observable::ChatteringTime];
        assert!((figure.difference - off.abs()).abs() < 1e-15 && figure.allowed == claim, "{figure:?}");
    }
}

/// The worst figure of each observable is kept, whichever impact it is of.
#[test]
fn the_worst_figure_is_kept() {
    let first = observed(1.0 / 64.0);
    for worst in [1, 2, 3] {
        let mut second = first.clone();
        for (n, impact) in (1..).zip(&mut second.history.impacts) {
            impact.time += if n == worst { 1.0 / 64.0 } else { 1.0 / 128.0 };
        }
        let figure = compared(&first, &second).worst[&Observable::ImpactTime];
        assert_eq!((figure.impact, figure.share()), (worst, 0.5));
    }
}

/// Times are wide against the time of the impact, all else against 1; `vacuous` counts impacts, not observables.
#[test]
fn impacts_that_are_compared_in_name_only_are_counted() {
    for (claim, vacuous, timed) in [(0.1, 0, true), (0.2, 1, true), (0.3, 3, true), (0.6, 3, false)] {
        let comparison = compared(&observed(claim), &observed(claim));
        assert_eq!(
            (comparison.impacts, comparison.vacuous, comparison.chattering_time),
            (3, vacuous, Some(timed)),
            "{claim}"
        );
    }
    let mut early = observed(0.0);
    for impact in &mut early.history.impacts {
        impact.uncertainty.time = 0.3;
    }
    // 0.6 is more than half of 1, and less than half of 1.5 and of 1.75.
    assert_eq!(compared(&early, &early).vacuous, 1);
    let mut unclosed = observed(0.0);
    unclosed.chattering_time = None;
    assert_eq!(compared(&unclosed, &observed(0.0)).chattering_time, None);
}

/// What rounding the parameters does, and the gap between the models, in one sum.
#[test]
fn slack_is_a_rounding_of_the_parameters_and_the_gap() {
    let case = Case::from_epsilon(0.02, 2.0, 0.9).unwrap_or_else(|invalid| panic!("{invalid}"));
    let block = Slenderness::new(0.2, Normalisation::Threshold).unwrap_or_else(|invalid| panic!("{invalid}"));
    let case = case.with_slenderness(block);
    let stepper = panel::default().swap_remove(0);
    let Some(observed) = ask(stepper.as_ref(), &case).into_observed() else { panic!("declined") };
    let Some(conditioning) = Conditioning::by(stepper.as_ref(), &case, &observed) else { panic!("no derivatives") };
    let Ok(Some(gap)) = ModelGap::new(stepper.as_ref(), &case, &observed) else { panic!("no gap") };
    for observable in [Observable::Interval, Observable::ImpactTime, Observable::ChatteringTime] {
        let rounding = conditioning.at(observable, 7) / 2f64.powi(53);
        assert!(rounding > 0.0);
        assert_eq!(Slack { conditioning: &conditioning, gap: None }.at(observable, 7), rounding);
        let both = Slack { conditioning: &conditioning, gap: Some(&gap) }.at(observable, 7);
        assert_eq!(both, rounding + gap.at(observable, 7));
        assert_eq!(Slack { conditioning: &none(), gap: Some(&gap) }.at(observable, 7), gap.at(observable, 7));
    }
    // Velocities of the nonlinear model are scaled, nothing else is.
    let slack = Slack { conditioning: &none(), gap: Some(&gap) };
    let mut nonlinear = observed.clone();
    for impact in &mut nonlinear.history.impacts {
        impact.velocity *= 0.2f64.sin() / 0.2;
    }
    let comparison = compare(&case, &observed, &nonlinear, slack);
    assert_eq!(comparison.agreement, Agreement::Agree);
    assert!(comparison.worst[&Observable::Velocity].difference < 1e-15);
    assert_eq!(stepper.model(), Model::Linear);
}

/// The conditioning of one derivative is allowed as `2⁻⁵³` of the parameter.
#[test]
fn a_derivative_is_allowed_a_rounding_of_its_parameter() {
    let of = Sensitivity { time: [2f64.powi(50), 0.0, 0.0], interval: [0.0; 3], velocity: [0.0; 3] };
    let first = observed(0.0);
    let conditioning = Conditioning::new(&case(), &first, &[of, of, of]);
    // 0.5 · 2^50 / 2^53
    assert_eq!(Slack { conditioning: &conditioning, gap: None }.at(Observable::ImpactTime, 2), 1.0 / 16.0);
}

/// Lists of these lengths that end like this, every claim 1/64, the last impacts of the longer at `late` from the horizon at 4.
fn ended(first: (Ending, usize), second: (Ending, usize), late: f64) -> Agreement {
    let of = |(ending, count): (Ending, usize)| {
        let impacts = (0..count).map(|n| {
            let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
            impact(4.0 - late - (3.0 - n as f64) / 1024.0, 1e-60, sign, 1.0 / 64.0)
        });
        let history = History { impacts: impacts.collect(), ending, chattering_time: None };
        Observed { history, chattering_time: None }
    };
    match compared(&of(first), &of(second)).agreement {
        Agreement::Disagree(found) => {
            assert_eq!((found.observable, found.figure.impact), (Observable::Ending, first.1.min(second.1) + 1));
            assert_eq!((found.figure.difference, found.figure.allowed), (f64::INFINITY, 0.0));
            let is_alike = kind(first.0) == kind(second.0);
            let said = |(ending, count): (Ending, usize)| {
                if is_alike {
                    format!("{count} impacts listed, {ending}")
                } else {
                    format!("{ending} after {count} impacts")
                }
            };
            assert_eq!(found.values, [said(first), said(second)]);
            Agreement::Disagree(found)
        }
        agreement => agreement,
    }
}

#[test]
fn which_endings_go_together() {
    use contract::Loss;
    let (rest, time, impacts) =
        (Ending::AtRest, Ending::LimitReached(Limit::Time), Ending::LimitReached(Limit::Impacts));
    let (incomplete, over, never) = (Ending::Incomplete, Ending::Overturned, Ending::NeverRocks);
    let lost = Ending::Lost(Loss::Stalled);
    let is = |agreement: Agreement| match agreement {
        Agreement::Agree => 'a',
        Agreement::TooClose => 'c',
        Agreement::Disagree(_) => 'd',
    };
    // Far from the horizon, and with the third impact, at 4 - late, within what the claims allow of it.
    for (first, second, far, near) in [
        ((rest, 3), (rest, 3), 'a', 'a'),
        ((incomplete, 3), (time, 3), 'a', 'a'),
        ((incomplete, 3), (over, 3), 'a', 'a'),
        ((rest, 3), (incomplete, 3), 'd', 'c'),
        ((rest, 3), (over, 3), 'd', 'c'),
        ((rest, 3), (impacts, 3), 'a', 'a'),
        ((rest, 3), (lost, 3), 'a', 'a'),
        ((rest, 3), (never, 3), 'd', 'd'),
        ((never, 0), (never, 0), 'a', 'a'),
        ((never, 0), (incomplete, 0), 'd', 'd'),
        ((incomplete, 0), (rest, 0), 'd', 'd'),
        // One list is longer. That of rest ends above 1e-100 here.
        ((rest, 2), (rest, 3), 'd', 'd'),
        ((incomplete, 2), (incomplete, 3), 'd', 'a'),
        ((over, 2), (incomplete, 3), 'd', 'a'),
        ((incomplete, 2), (rest, 3), 'd', 'c'),
        ((time, 0), (time, 3), 'd', 'a'),
        ((lost, 2), (rest, 3), 'a', 'a'),
        ((impacts, 2), (rest, 3), 'd', 'd'),
        ((rest, 3), (lost, 2), 'a', 'a'),
        ((rest, 2), (incomplete, 3), 'd', 'd'),
    ] {
        assert_eq!(is(ended(first, second, 1.0)), far, "{first:?} {second:?}, far");
        assert_eq!(is(ended(second, first, 1.0)), far, "{second:?} {first:?}, far");
        assert_eq!(is(ended(first, second, 1.0 / 128.0)), near, "{first:?} {second:?}, near");
        assert_eq!(is(ended(second, first, 1.0 / 128.0)), near, "{second:?} {first:?}, near");
    }
    // What is left of the time may be as long as both claims, and no longer: the extra impact's and that of the last of the other list.
    for (late, agreement) in [(1.0 / 32.0 - 2.0 / 1024.0, 'a'), (1.0 / 32.0, 'a'), (1.0 / 32.0 + 1e-9, 'd')] {
        assert_eq!(is(ended((incomplete, 2), (incomplete, 3), late - 1.0 / 1024.0)), agreement, "{late}");
        assert_eq!(
            is(ended((rest, 3), (incomplete, 3), late - 1.0 / 1024.0)),
            if agreement == 'a' { 'c' } else { 'd' }
        );
    }
    // Without an impact before it only its own claim counts: the first of three is 3/1024 before 4 - late.
    for (late, agreement) in [(1.0 / 64.0, 'a'), (1.0 / 64.0 + 1e-9, 'd')] {
        assert_eq!(is(ended((incomplete, 0), (incomplete, 1), late - 3.0 / 1024.0)), agreement, "{late}");
    }
}

/// Below 1e-100 a list of rest may end earlier than another.
#[test]
fn a_list_of_rest_may_end_where_nothing_is_left_to_resolve() {
    for (interval, explained) in [(0.99e-100, true), (1.01e-100, false)] {
        let mut longer = observed(1.0);
        longer.history.impacts[1].interval = interval;
        let mut shorter = longer.clone();
        shorter.history.impacts.truncate(2);
        assert_eq!(compared(&longer, &shorter).agreement == Agreement::Agree, explained, "{interval:e}");
    }
}

#[test]
fn the_end_of_the_time_is_half_a_period_unless_it_is_given() {
    assert_eq!(horizon(&case()), 4.0);
    let half = Case::from_epsilon(0.5, 2.0, 0.5).map(|case| horizon(&case));
    assert_eq!(half, Ok(std::f64::consts::FRAC_PI_2));
}

/// Values of opposite sign differ by their sum, not by the difference of their sizes; at the very least where the sizes are equal.
#[test]
fn a_sign_is_a_difference() {
    let first = observed(1.0 / 64.0);
    let mut turned = first.clone();
    turned.history.impacts[1].velocity = 0.25;
    let Agreement::Disagree(found) = compared(&first, &turned).agreement else { panic!("a turned velocity agrees") };
    assert_eq!((found.observable, found.figure.impact, found.figure.difference), (Observable::Velocity, 2, 2.0));
    let mut before = first.clone();
    before.history.impacts[0].time = -1.0;
    let Agreement::Disagree(found) = compared(&first, &before).agreement else { panic!("a time before zero agrees") };
    assert_eq!((found.observable, found.figure.impact, found.figure.difference), (Observable::ImpactTime, 1, 2.0));
    let mut negative = first.clone();
    negative.chattering_time = Some(Estimate { value: -2.0, uncertainty: 1.0 / 64.0 });
    let Agreement::Disagree(found) = compared(&first, &negative).agreement else { panic!("a negative time agrees") };
    assert_eq!((found.observable, found.figure.difference), (Observable::ChatteringTime, 4.0));
}

/// An impact that one list has and the other has not is near to the end of the time, on either side of it; far behind the end there is none.
#[test]
fn an_impact_far_behind_the_end_is_one_too_many() {
    let (short, long) = ((Ending::Incomplete, 2), (Ending::LimitReached(Limit::Impacts), 3));
    for (late, is_too_many) in [(1.0 / 128.0, false), (-1.0 / 128.0, false), (1.0, true), (-1.0, true)] {
        assert_eq!(matches!(ended(short, long, late), Agreement::Disagree(_)), is_too_many, "{late}");
    }
}
