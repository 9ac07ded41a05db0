//! Each law at its border: what just obeys it, and what just breaks it.

use super::*;
use crate::panel;
use contract::{Impact, Limit, Loss, Slenderness, Uncertainty};
use proptest::prelude::*;

fn case() -> Result<Case, contract::Invalid> {
    Case::from_epsilon(0.02, 2.0, 0.9)?.with_max_impacts(4)
}

/// Four impacts that obey every law of form, in numbers that are exact.
fn well_formed() -> History {
    let of = |time: f64, interval: f64, velocity: f64| {
        let uncertainty = Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
        Impact { time, interval, velocity, uncertainty }
    };
    let impacts = vec![of(1.0, 1.0, 0.5), of(1.5, 0.5, -0.25), of(1.75, 0.25, 0.125), of(1.875, 0.125, -0.0625)];
    History { impacts, ending: Ending::AtRest, chattering_time: None }
}

/// The law that is broken, and where, after this change.
fn broken(change: impl Fn(&mut History)) -> Result<Option<(Law, usize)>, contract::Invalid> {
    let mut history = well_formed();
    change(&mut history);
    Ok(form(&case()?, &history, Times::AreSums).map(|breach| (breach.law, breach.impact)))
}

#[test]
fn the_laws_of_form_hold_up_to_their_borders_and_no_further() -> Result<(), contract::Invalid> {
    let ulps = 4.0 * f64::EPSILON;
    assert_eq!(broken(|_| ())?, None);
    assert_eq!(broken(|h| h.ending = Ending::Lost(Loss::Stalled))?, Some((Law::NotLost, 5)));
    assert_eq!(broken(|h| h.impacts.push(h.impacts[3]))?, Some((Law::Form, 0)));
    assert_eq!(broken(|h| h.impacts.clear())?, Some((Law::Form, 0)));
    assert_eq!(broken(|h| h.ending = Ending::NeverRocks)?, Some((Law::Form, 0)));
    let none = |ending: Ending| broken(move |h| (h.ending, h.impacts) = (ending, Vec::new()));
    for ending in [Ending::NeverRocks, Ending::Incomplete, Ending::Overturned] {
        assert_eq!(none(ending)?, None);
    }
    // Limits that the case does not have, or has not reached: it is followed for half a period, and 4 impacts are asked for.
    for limit in [Limit::Time, Limit::Impacts] {
        assert_eq!(none(Ending::LimitReached(limit))?, Some((Law::Form, 0)));
    }
    assert_eq!(broken(|h| h.ending = Ending::LimitReached(Limit::Impacts))?, None);
    for (change, broken_by) in
        [(0.0, false), (1e-300, false), (f64::INFINITY, false), (-1e-300, true), (f64::NAN, true)]
    {
        let expected = broken_by.then_some((Law::Form, 2));
        assert_eq!(broken(|h| h.impacts[1].uncertainty.time = change)?, expected, "{change}");
        assert_eq!(broken(|h| h.impacts[1].uncertainty.interval = change)?, expected, "{change}");
        assert_eq!(broken(|h| h.impacts[1].uncertainty.velocity = change)?, expected, "{change}");
    }
    for interval in [0.0, -0.5, f64::NAN, f64::INFINITY] {
        assert_eq!(broken(|h| h.impacts[1].interval = interval)?, Some((Law::Form, 2)), "{interval}");
    }
    assert_eq!(broken(|h| h.impacts[1].time = f64::INFINITY)?, Some((Law::Form, 2)));
    for (n, velocity) in [(0, -0.5), (0, 0.0), (0, f64::NAN), (1, 0.25), (1, 0.0), (2, -1.0), (3, 1.0)] {
        assert_eq!(broken(|h| h.impacts[n].velocity = velocity)?, Some((Law::SignAlternates, n + 1)), "{velocity}");
    }
    // Of the last impact at 1.875: four units in the last place of the time, and what is claimed for the interval.
    for (off, claim, obeyed) in [
        (ulps * 1.75, 0.0, true),
        (-ulps * 1.75, 0.0, true),
        (ulps * 2.25, 0.0, false),
        (-ulps * 2.25, 0.0, false),
        (0.0625, 0.5, true),
        (-0.0625, 0.5, true),
        (0.07, 0.5, false),
        (0.13, 1.0, false),
    ] {
        let found = broken(|h| {
            h.impacts[3].time += off;
            h.impacts[3].uncertainty.interval = claim;
        })?;
        assert_eq!(found, (!obeyed).then_some((Law::TimeIsSum, 4)), "{off:e} {claim}");
    }
    Ok(())
}

/// Only where the forcing at the base is that of the case's amplitude, and rest is reached in the first half period.
#[test]
fn where_the_forcing_is_known() -> Result<(), contract::Invalid> {
    let case = case()?;
    let of = |normalisation| Slenderness::new(0.2, normalisation).map(|slenderness| case.with_slenderness(slenderness));
    let (threshold, slender) = (of(Normalisation::Threshold)?, of(Normalisation::Slender)?);
    let history = well_formed();
    for (case, model, known) in [
        (case, Model::Linear, true),
        (case, Model::Nonlinear, true),
        (threshold, Model::Linear, true),
        (threshold, Model::Nonlinear, true),
        (slender, Model::Linear, true),
        (slender, Model::Nonlinear, false),
        (case.with_horizon(Horizon::Until(1.0))?, Model::Linear, false),
    ] {
        assert_eq!(forcing_is_known(&case, model, &history), known);
        let rocking = History { ending: Ending::Incomplete, ..history.clone() };
        assert!(!forcing_is_known(&case, model, &rocking));
    }
    Ok(())
}

fn observed(case: &Case) -> Option<Observed> {
    Some(Observed::new(case, panel::default().swap_remove(0).history(case).ok()?))
}

/// `x`, the relative change of the forcing over two flights, by the formula of the excitation itself.
fn relative_change(case: &Case, observed: &Observed, n: usize) -> f64 {
    let impacts = &observed.history.impacts;
    let start = if n == 3 { 0.0 } else { impacts[n - 4].time };
    let phase = case.omega() * start + (1.0 / case.amplitude()).asin();
    let (force, rate) = (case.amplitude() * phase.sin(), case.omega() * case.amplitude() * phase.cos());
    let largest = (rate / (1.0 + force)).abs().max((rate / (1.0 - force)).abs());
    largest * (impacts[n - 3].interval + impacts[n - 2].interval)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// What is left of the ratio once the law is taken out is of the second order, with a coefficient near 1: no term of the first order is
    /// missing, on either side of the base. The law is applied wherever `x <= 0.02`, and allows `3 x²` beyond what is claimed.
    #[test]
    fn the_ratio_law_leaves_the_second_order(epsilon in 1e-3..0.03f64, omega in 0.5..6.0f64, eta in 0.5..0.9f64) {
        let Ok(case) = Case::from_epsilon(epsilon, omega, eta).and_then(|case| case.with_max_impacts(60)) else {
            return Err(TestCaseError::fail("no case"));
        };
        let Some(observed) = observed(&case) else { return Err(TestCaseError::fail("no history")) };
        prop_assume!(observed.history.ending == Ending::AtRest);
        let mut applied = 0;
        for n in 4..=observed.history.impacts.len() {
            let change = relative_change(&case, &observed, n);
            let figure = interval_ratio(&case, &observed, n);
            prop_assert!(figure.is_some() == (change <= 0.02) || (change - 0.02).abs() < 1e-8, "impact {n}: {change}");
            let (Some(figure), Some(ratio)) = (figure, observed.at(Observable::IntervalRatio, n)) else { continue };
            applied += 1;
            prop_assert!((figure.allowed - 3.0 * change * change - ratio.uncertainty - 2.0 * f64::EPSILON).abs() <= 1e-8 * figure.allowed);
            prop_assert!(figure.impact == n && figure.difference <= 1.3 * change * change + ratio.uncertainty, "impact {n}: {figure:?}, x = {change}");
        }
        prop_assert!(applied > 5, "{applied}");
        // At initiation the forcing balances the block: there is no pull to change.
        prop_assert!(interval_ratio(&case, &observed, 3).is_none() && interval_ratio(&case, &observed, 2).is_none());
    }
}

/// The worst ratio is kept, and the first that is too far off ends the search.
#[test]
fn the_worst_ratio_and_the_first_breach_are_found() -> Result<(), contract::Invalid> {
    let case = Case::from_epsilon(0.02, 2.0, 0.8)?.with_max_impacts(200)?;
    let Some(mut observed) = observed(&case) else { panic!("no history") };
    let good = check(&case, Model::Linear, &observed, Times::AreSums);
    let figures = |observed: &Observed| -> Vec<Figure> {
        (3..=observed.history.impacts.len()).filter_map(|n| interval_ratio(&case, observed, n)).collect()
    };
    let worst = figures(&observed).iter().map(Figure::share).fold(0.0, f64::max);
    assert!(good.breach.is_none() && good.ratio.is_some_and(|ratio| ratio.share() == worst && worst > 0.0));
    // Longer by a thousandth, so deep that the sum of the times does not show it.
    for n in [150, 160] {
        observed.history.impacts[n - 1].interval *= 1.0 + 1e-3;
    }
    let bad = check(&case, Model::Linear, &observed, Times::AreSums);
    assert!(bad.breach.is_some_and(|breach| breach.law == Law::IntervalRatio && breach.impact == 150));
    assert!(bad.ratio.is_some_and(|ratio| ratio.impact == 150 && ratio.share() > 1.0));
    assert!(check(&case.with_horizon(Horizon::Until(9.0))?, Model::Linear, &observed, Times::AreSums).breach.is_none());
    Ok(())
}

/// Times that an engine prints to few digits are no sums to the last bit; they are off by no more than is granted for them, twice.
#[test]
fn times_that_are_no_sums_are_allowed_what_is_claimed_for_them() -> Result<(), contract::Invalid> {
    let broken = |times: Times, off: f64| -> Result<Option<Law>, contract::Invalid> {
        let mut history = well_formed();
        history.impacts.iter_mut().for_each(|impact| impact.uncertainty.time = 1e-6);
        history.impacts[2].time += off;
        Ok(form(&case()?, &history, times).map(|breach| breach.law))
    };
    assert_eq!(broken(Times::AreClaimed, 1.9e-6)?, None);
    assert_eq!(broken(Times::AreClaimed, 2.1e-6)?, Some(Law::TimeIsSum));
    assert_eq!(broken(Times::AreSums, 1.9e-6)?, Some(Law::TimeIsSum));
    Ok(())
}

/// The end of the time is part of the question. Half a period of this case is 1.57.
#[test]
fn no_impact_comes_after_the_time_that_was_asked_for() -> Result<(), contract::Invalid> {
    let case = case()?;
    let late = |case: &Case, unsure: f64| {
        let mut history = well_formed();
        history.impacts.iter_mut().for_each(|impact| impact.uncertainty.time = unsure);
        in_time(case, &history).map(|breach| (breach.law, breach.impact))
    };
    assert_eq!(late(&case, 0.0), Some((Law::InTime, 3)));
    assert_eq!(late(&case, 0.2), Some((Law::InTime, 4)));
    assert_eq!(late(&case, 0.31), None);
    assert_eq!(late(&case.with_horizon(Horizon::Until(1.875))?, 0.0), None);
    assert_eq!(late(&case.with_horizon(Horizon::Until(1.874))?, 0.0), Some((Law::InTime, 4)));
    Ok(())
}
