//! What every oracle has to do, whatever its method: checks that its own tests run before any other method is asked.
//!
//! They hold an oracle against the contract and its answers against each other, and say nothing about whether they are right.

use alloc::{format, string::String, vec::Vec};
use core::fmt;

use crate::{Case, Decline, Ending, History, Horizon, Limit, Model, Normalisation, Oracle, Slenderness};

/// A rule of the contract.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Rule {
    /// A name can be told from others in a list: it is not empty, and has no comma, blank or control character in it.
    Name,
    /// Intervals are positive and finite, claims are numbers, the list is as long as the ending says.
    Form,
    /// The velocity has the sign of the flight that follows: `i_n = (-1)^{n+1}` (Eq. 70).
    SignAlternates,
    /// The times are the sums of the intervals (Eq. 42), within [`TIME_IS_SUM`] and what is claimed.
    TimeIsSum,
    /// The same question has the same answer to the last bit, whether it was announced or not.
    SameAgain,
    /// Who is asked for fewer impacts lists the first of them, within what both answers claim.
    FewerAreFirst,
    /// No impact comes after the time up to which a history was to be followed.
    Horizon,
    /// The linear model takes no notice of a slenderness, and the nonlinear one declines a case without.
    Slenderness,
    /// A block does not rock where the excitation stays below its threshold, or just reaches it.
    Threshold,
    /// Sensitivities and slenderness shifts are of the impacts that are listed, one for each.
    Derivatives,
}

/// How an oracle breaks a rule.
#[derive(Debug, Clone, PartialEq)]
pub struct Breach {
    /// Which rule.
    pub rule: Rule,
    /// At which impact; 0 if the whole answer does.
    pub impact: usize,
    /// How, with the numbers.
    pub how: String,
}

impl fmt::Display for Breach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rule, impact, how } = self;
        if *impact == 0 { write!(f, "{rule:?}: {how}") } else { write!(f, "{rule:?} at impact {impact}: {how}") }
    }
}

fn breach(rule: Rule, impact: usize, how: String) -> Result<(), Breach> {
    Err(Breach { rule, impact, how })
}

/// How far a time may be off the sum of the intervals, in units in the last place of the time: both are rounded, and so is their difference; and a method
/// may add intervals in plain doubles.
pub const TIME_IS_SUM: f64 = 4.0;

/// The rules that an answer to a case has to keep by itself: those of its form, the signs and the sums. A sequence that is lost keeps them too, as far as it goes.
///
/// # Errors
/// The first breach.
pub fn check_history(case: &Case, history: &History) -> Result<(), Breach> {
    check_told(case, history, Times::AreSums)
}

/// How an oracle gets its times ([`Oracle::times`]).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Times {
    /// It adds its intervals up: the times are off their sums by roundings only, whatever else is claimed for them.
    AreSums,
    /// They may come from elsewhere, as from a clock, or have been printed to fewer digits: each may be off by what is claimed for it.
    AreClaimed,
}

/// The same, where the times are got in this way.
///
/// # Errors
/// The first breach.
pub fn check_told(case: &Case, history: &History, times: Times) -> Result<(), Breach> {
    let (listed, ending) = (history.impacts.len(), history.ending);
    if listed > case.max_impacts() {
        return breach(Rule::Form, 0, format!("{listed} impacts listed, {} asked", case.max_impacts()));
    }
    let is_empty_wrongly = ending == Ending::AtRest && listed == 0;
    if is_empty_wrongly || ending == Ending::NeverRocks && listed > 0 {
        return breach(Rule::Form, 0, format!("{ending} with {listed} impacts"));
    }
    let is_short = ending == Ending::LimitReached(Limit::Impacts) && listed < case.max_impacts();
    if is_short || ending == Ending::LimitReached(Limit::Time) && case.horizon() == Horizon::HalfPeriod {
        return breach(
            Rule::Form,
            0,
            format!("{ending}, but the case does not have that limit after {listed} impacts"),
        );
    }
    let (mut before, mut unsure) = (0.0, 0.0);
    for (n, impact) in (1..).zip(&history.impacts) {
        let claims = [impact.uncertainty.time, impact.uncertainty.interval, impact.uncertainty.velocity];
        if claims.iter().any(|claim| claim.is_nan() || *claim < 0.0) {
            return breach(Rule::Form, n, format!("a claim is not a number of its kind: {claims:?}"));
        }
        if !(impact.interval > 0.0 && impact.interval.is_finite() && impact.time.is_finite()) {
            return breach(Rule::Form, n, format!("time {:?}, interval {:?}", impact.time, impact.interval));
        }
        let sign = if n % 2 == 1 { 1.0 } else { -1.0 };
        if impact.velocity.is_nan() || impact.velocity * sign <= 0.0 {
            return breach(Rule::SignAlternates, n, format!("velocity {:?}, expected sign {sign:+}", impact.velocity));
        }
        let of_times = match times {
            Times::AreSums => 0.0,
            Times::AreClaimed => unsure + impact.uncertainty.time,
        };
        let of_interval = impact.uncertainty.interval * impact.interval;
        let allowed = TIME_IS_SUM * f64::EPSILON * impact.time + of_interval + of_times;
        let off = (impact.time - before - impact.interval).abs();
        if off.is_nan() || off > allowed {
            return breach(Rule::TimeIsSum, n, format!("off by {off:.3e}, allowed {allowed:.3e}"));
        }
        (before, unsure) = (impact.time, impact.uncertainty.time);
    }
    Ok(())
}

/// All rules, on these cases and on others that are made from them: with fewer impacts, a shorter time, another slenderness, no excitation. A case that the
/// oracle declines is passed over; one that it is to decline is asked too.
///
/// # Errors
/// Each breach, with its case: the first one of each question.
pub fn check(oracle: &dyn Oracle, cases: &[Case]) -> Result<(), Vec<(Case, Breach)>> {
    let mut found = Vec::new();
    let rules = [again, fewer, horizon, slenderness, threshold, derivatives];
    for case in cases {
        let results = rules.iter().map(|rule| rule(oracle, case));
        found.extend(results.chain([name(oracle)]).filter_map(Result::err).map(|breach| (*case, breach)));
    }
    if found.is_empty() { Ok(()) } else { Err(found) }
}

fn name(oracle: &dyn Oracle) -> Result<(), Breach> {
    let name = oracle.name();
    if name.is_empty()
        || name.contains(|character: char| character == ',' || character.is_whitespace() || character.is_control())
    {
        return breach(Rule::Name, 0, format!("{name:?}"));
    }
    Ok(())
}

fn again(oracle: &dyn Oracle, case: &Case) -> Result<(), Breach> {
    let first = oracle.history(case);
    oracle.prepare(&[*case]);
    let second = oracle.history(case);
    if let Ok(history) = &first {
        check_history(case, history)?;
    }
    same("asked again", first, second)
}

/// Two answers that have to be the same to the last bit, NaN being like itself.
fn same(how: &str, first: Result<History, Decline>, second: Result<History, Decline>) -> Result<(), Breach> {
    let (first, second) = (format!("{first:?}"), format!("{second:?}"));
    if first == second {
        return Ok(());
    }
    let place = first.bytes().zip(second.bytes()).take_while(|(one, other)| one == other).count();
    let from = |text: &str| -> String { text.chars().skip(place.saturating_sub(20)).take(60).collect() };
    breach(Rule::SameAgain, 0, format!("{how}: ..{}.. became ..{}..", from(&first), from(&second)))
}

fn fewer(oracle: &dyn Oracle, case: &Case) -> Result<(), Breach> {
    let Ok(history) = oracle.history(case) else { return Ok(()) };
    let fewer = history.impacts.len().div_ceil(2);
    let Ok(asked) = case.with_max_impacts(fewer) else { return Ok(()) };
    let Ok(short) = oracle.history(&asked) else { return Ok(()) };
    check_history(&asked, &short)?;
    for (n, (long, short)) in (1..).zip(history.impacts.iter().zip(&short.impacts)) {
        let (off, allowed) =
            ((long.interval - short.interval).abs(), long.uncertainty.interval + short.uncertainty.interval);
        if off.is_nan() || off > (allowed + f64::EPSILON) * long.interval {
            let how = format!("interval {:?} of {fewer} impacts, {:?} of more", short.interval, long.interval);
            return breach(Rule::FewerAreFirst, n, how);
        }
    }
    Ok(())
}

fn horizon(oracle: &dyn Oracle, case: &Case) -> Result<(), Breach> {
    let Ok(history) = oracle.history(case) else { return Ok(()) };
    let Some(middle) = history.impacts.get(history.impacts.len() / 2) else { return Ok(()) };
    let before = middle.time - 0.5 * middle.interval;
    let Ok(asked) = case.with_horizon(Horizon::Until(before)) else { return Ok(()) };
    let Ok(short) = oracle.history(&asked) else { return Ok(()) };
    check_history(&asked, &short)?;
    match (1..).zip(&short.impacts).find(|(_, impact)| impact.time - impact.uncertainty.time > before) {
        Some((n, late)) => breach(Rule::Horizon, n, format!("time {:?}, to be followed until {before:?}", late.time)),
        None => Ok(()),
    }
}

fn slenderness(oracle: &dyn Oracle, case: &Case) -> Result<(), Breach> {
    let Ok(bare) = without_slenderness(case) else { return Ok(()) };
    match (oracle.model(), oracle.history(&bare)) {
        (Model::Nonlinear, Ok(_)) => breach(Rule::Slenderness, 0, String::from("a history of a case without one")),
        (Model::Nonlinear, Err(_)) => Ok(()),
        (Model::Linear, answer) => {
            let Ok(stout) = Slenderness::new(0.5, Normalisation::Threshold) else { return Ok(()) };
            same("with a slenderness", answer, oracle.history(&bare.with_slenderness(stout)))
                .map_err(|breach| Breach { rule: Rule::Slenderness, ..breach })
        }
    }
}

fn threshold(oracle: &dyn Oracle, case: &Case) -> Result<(), Breach> {
    for epsilon in [0.0, -0.5] {
        let Ok(below) = Case::from_epsilon(epsilon, case.omega(), case.eta()) else { continue };
        // The slender normalisation has another threshold.
        let alpha = case.slenderness().and_then(|of| Slenderness::new(of.alpha(), Normalisation::Threshold).ok());
        let below = alpha.map_or(below, |alpha| below.with_slenderness(alpha));
        let Ok(history) = oracle.history(&below) else { continue };
        if history.ending != Ending::NeverRocks || !history.impacts.is_empty() {
            let how = format!("a = {:?}: {}, {} impacts", below.amplitude(), history.ending, history.impacts.len());
            return breach(Rule::Threshold, 0, how);
        }
    }
    Ok(())
}

fn derivatives(oracle: &dyn Oracle, case: &Case) -> Result<(), Breach> {
    let Ok(history) = oracle.history(case) else { return Ok(()) };
    let listed = history.impacts.len();
    let lengths = [
        ("sensitivities", oracle.sensitivities(case).map(|of| of.len())),
        ("slenderness shifts", oracle.slenderness_shifts(case).map(|of| of.len())),
    ];
    match lengths.into_iter().find(|(_, length)| length.is_some_and(|length| length != listed)) {
        Some((what, Some(length))) => breach(Rule::Derivatives, 0, format!("{length} {what}, {listed} impacts")),
        _ => Ok(()),
    }
}

fn without_slenderness(case: &Case) -> Result<Case, crate::Invalid> {
    Case::from_epsilon(case.epsilon(), case.omega(), case.eta())?
        .with_max_impacts(case.max_impacts())?
        .with_horizon(case.horizon())
}
