//! Section 4: the semi-analytical approximation.

use contract::{Case, Impact, Model, Oracle as _};

use super::{Measured, Measurement, verdict::rounded};
use crate::{
    measure::zeno,
    studies::{
        diagnose::truth::proven,
        paper::{Error, missing, observed, phase},
    },
};

pub(super) const ALL: &[Measurement] = &[
    ("eq-66", constant_acceleration),
    ("eq-67", interval_of_a_flight),
    ("eq-68", speed_of_landing),
    ("eq-71", speeds_fall_as_eta),
    ("eq-73-fig-3a", || ratios(1.01, 5.0, 0.92)),
    ("eq-73-fig-3b", || ratios(1.03, 2.0, 0.86)),
    ("eq-74", intervals_fall_as_eta_squared),
    ("eq-75", closing),
    ("eq-75-everywhere", closing_near_critical),
];

const A: f64 = 1.03;
const OMEGA: f64 = 2.0;
const ETA: f64 = 0.92;
/// The impact after which the paper closes the sum.
const N: usize = 60;

/// The impacts of Fig. 2, proven: the first is impact 1.
fn impacts(many: usize) -> Result<Vec<Impact>, Error> {
    let case = Case::from_amplitude(A, OMEGA, ETA)?.with_max_impacts(many)?;
    Ok(enclosure::Enclosure::new(Model::Linear).history(&case)?.impacts)
}

/// `δ`, the excitation over `g α`, at a time.
fn excitation(time: f64) -> f64 {
    A * (OMEGA * time + phase(A)).sin()
}

fn constant_acceleration() -> Result<Measured, Error> {
    let time = proven(A - 1.0, OMEGA, ETA).ok_or_else(|| missing("tau_ch of Fig. 2"))?;
    let impacts = impacts(100)?;
    let change = |n: usize| {
        let impact = impacts.get(n - 1).ok_or_else(|| missing(format!("impact {n}")))?;
        Ok::<_, Error>((excitation(impact.time) - excitation(time)).abs() / (1.0 - excitation(time).abs()))
    };
    let found = format!(
        "from impact n to rest δ changes by {} of 1 − |δ| for n = 20, {} for 60, {} for 100",
        rounded(change(20)?),
        rounded(change(N)?),
        rounded(change(100)?)
    );
    Ok(Measured::new(change(N)?, found))
}

/// With which power of the speed a part of a flight is off that is to be 1: from the flights with the sign of the first, deep in the sequence.
fn power_of_the_speed(off: impl Fn(&Impact, &Impact) -> f64) -> Result<f64, Error> {
    let impacts = impacts(182)?;
    let at = |n: usize| {
        let (this, next) = impacts.get(n - 1).zip(impacts.get(n)).ok_or_else(|| missing(format!("impact {n}")))?;
        Ok::<_, Error>((off(this, next).abs().ln(), this.velocity.abs().ln()))
    };
    let (early, late) = (at(140)?, at(180)?);
    Ok((late.0 - early.0) / (late.1 - early.1))
}

fn interval_of_a_flight() -> Result<Measured, Error> {
    let power = power_of_the_speed(|this, next| {
        let printed = 2.0 * this.velocity / (this.velocity.signum() + excitation(this.time));
        next.interval / printed - 1.0
    })?;
    let found = format!("its relative error falls as the speed to the power {power:.3}");
    Ok(Measured::new((power - 1.0).abs(), found))
}

fn speed_of_landing() -> Result<Measured, Error> {
    let power = power_of_the_speed(|this, next| next.velocity / ETA / this.velocity + 1.0)?;
    let found =
        format!("its relative error falls as the speed to the power {power:.3}: of first order, as the paper says");
    Ok(Measured::new((power - 1.0).abs(), found))
}

/// What `η^(j-n)` is off by from `n` to ever later `j`, for what falls by `η` from one impact to the next.
fn drift(of_impact: &[f64], n: usize) -> Result<f64, Error> {
    const LATER: usize = 200;
    let (this, later) =
        of_impact.get(n).zip(of_impact.get(n + LATER)).ok_or_else(|| missing(format!("impact {}", n + LATER)))?;
    Ok((ETA.powi(LATER as i32) * this / later - 1.0).abs())
}

fn drifts(of_impact: &[f64]) -> Result<Measured, Error> {
    let percent = |n| Ok::<_, Error>(rounded(100.0 * drift(of_impact, n)?));
    let (early, at, late) = (percent(20)?, percent(N)?, percent(100)?);
    let found =
        format!("for ever later impacts it is off by {early} % counted from n = 20, {at} % from 60, {late} % from 100");
    Ok(Measured::new(drift(of_impact, N)?, found))
}

fn speeds_fall_as_eta() -> Result<Measured, Error> {
    let speeds: Vec<f64> = impacts(300)?.iter().map(|impact| impact.velocity.abs()).collect();
    // The first one listed is that after impact 1.
    drifts(&[&[0.0], speeds.as_slice()].concat())
}

fn intervals_fall_as_eta_squared() -> Result<Measured, Error> {
    // The first one listed is that of flight 0.
    drifts(&impacts(301)?.iter().map(|impact| impact.interval).collect::<Vec<_>>())
}

fn ratios(a: f64, omega: f64, eta: f64) -> Result<Measured, Error> {
    let impacts = observed(a, omega, eta, 200)?.history.impacts;
    let pairs = impacts.iter().zip(impacts.iter().skip(2));
    let off: Vec<f64> = pairs.map(|(this, next)| (next.interval / this.interval / (eta * eta) - 1.0).abs()).collect();
    let from = |bound: f64| off.iter().rposition(|off| *off > bound).map_or(0, |last| last + 1);
    let at = off.iter().skip(N).fold(0.0_f64, |most, off| most.max(*off));
    let found = format!(
        "within 1 % of η² from n = {} on, within 0.1 % from {}, within 0.01 % from {}; {} % from n = 60 on",
        from(1e-2),
        from(1e-3),
        from(1e-4),
        rounded(100.0 * at)
    );
    Ok(Measured::new(at, found))
}

/// The relative error of Eq. 75 after `n` impacts.
fn error_of_closing(epsilon: f64, n: usize) -> Result<f64, Error> {
    let case = Case::from_epsilon(epsilon, OMEGA, ETA)?.with_max_impacts(n + 2)?;
    let history = enclosure::Enclosure::new(Model::Linear).history(&case)?;
    let closed = zeno::eq75(&history, ETA).ok_or_else(|| missing("Eq. 75"))?;
    let exact = proven(epsilon, OMEGA, ETA).ok_or_else(|| missing(format!("tau_ch at epsilon = {epsilon}")))?;
    Ok((closed / exact - 1.0).abs())
}

fn closing() -> Result<Measured, Error> {
    let mut found = String::from("τ_ch of Fig. 2 by Eq. 75 is off by");
    for (n, end) in [(10, ","), (20, ","), (40, ","), (60, " and"), (100, "")] {
        found += &format!(" {} % after {n}{end}", rounded(100.0 * error_of_closing(A - 1.0, n)?));
    }
    found += " impacts";
    Ok(Measured::new(error_of_closing(A - 1.0, N)?, found))
}

fn closing_near_critical() -> Result<Measured, Error> {
    let critical = crate::measure::critical::interpolated(OMEGA, ETA)?;
    let at = |share: f64| error_of_closing(critical * share, N);
    let found = format!(
        "after 60 impacts it is off by {} % in the middle of the range, {} % at 0.9 of the way to a_cr and {} % at 0.999; \
         more impacts mend it",
        rounded(100.0 * at(0.5)?),
        rounded(100.0 * at(0.9)?),
        rounded(100.0 * at(0.999)?)
    );
    Ok(Measured::new(at(0.999)?, found))
}
