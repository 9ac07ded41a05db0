//! Section 5.1 from Fig. 6 on: the critical amplitude.

use contract::{Case, Ending};
use rayon::prelude::*;

use super::{Measured, Measurement};
use crate::{
    measure::{
        asking::ask,
        critical::{eq76, eq77, interpolated},
    },
    panel,
    studies::{diagnose::spread, paper::Error},
};

pub(super) const ALL: &[Measurement] = &[
    ("a-cr", value),
    ("a-cr-by-fits", value_by_fits),
    ("eq-76", || fit("Eq. 76", eq76, 0.75)),
    ("eq-76-everywhere", || fit("Eq. 76", eq76, 0.5)),
    ("eq-77", || fit("Eq. 77", |_, eta| eq77(eta), 0.75)),
    ("fig-6-eta", falls_with_eta),
    ("fig-6-omega", influence_of_omega),
    ("independent-of-omega", independence),
    ("predominantly-eta", predominance),
    ("fig-7", half_per_cent),
    ("complete-below", both_sides),
];

const OMEGA: f64 = 2.0;
const ETA: f64 = 0.92;

/// Frequencies from 0.5 to 8, evenly in `1/ω`, in which the critical amplitude is smooth.
fn omegas() -> impl Iterator<Item = f64> + Clone {
    spread(2.0, 0.125, 75).map(f64::recip)
}

/// Restitutions from `least` to 0.98.
fn etas(least: f64) -> impl Iterator<Item = f64> + Clone {
    spread(least, 0.98, 60)
}

fn value() -> Result<Measured, Error> {
    let certified = enclosure::critical_amplitude(OMEGA, ETA)?;
    let a_cr = certified.amplitude.middle().0;
    Ok(Measured::new((a_cr - 1.038).abs(), format!("certified: {a_cr:.10} at ω = 2")))
}

fn value_by_fits() -> Result<Measured, Error> {
    let (one, other) = (eq76(OMEGA, ETA), eq77(ETA));
    let found = format!("Eq. 76 gives {one:.5} at ω = 2, which is 1.037 to these digits; Eq. 77 gives {other:.5}");
    Ok(Measured::new((one - 1.038).abs().max((other - 1.038).abs()), found))
}

/// The largest error of a fit for `η` from `least` to 0.98, and where it is.
fn fit(name: &str, fit: impl Fn(f64, f64) -> f64, least: f64) -> Result<Measured, Error> {
    let (mut worst, mut relative, mut place) = (0.0, 0.0, (0.0, 0.0));
    for (omega, eta) in omegas().flat_map(|omega| etas(least).map(move |eta| (omega, eta))) {
        let epsilon = interpolated(omega, eta)?;
        let error = (fit(omega, eta) - 1.0 - epsilon).abs();
        if error > worst {
            (worst, relative, place) = (error, error / epsilon, (omega, eta));
        }
    }
    let found = format!(
        "for η from {least} to 0.98 {name} is off by up to {worst:.4}, at ω = {:.2}, η = {:.2}: {:.0} % of a_cr − 1 there",
        place.0,
        place.1,
        100.0 * relative
    );
    Ok(Measured::new(worst, found))
}

fn falls_with_eta() -> Result<Measured, Error> {
    let (mut against, mut all) = (0, 0);
    for omega in omegas() {
        let amplitudes = etas(0.5).map(|eta| interpolated(omega, eta)).collect::<Result<Vec<_>, _>>()?;
        all += amplitudes.len() - 1;
        against += amplitudes.windows(2).filter(|two| two.last() >= two.first()).count();
    }
    let found = format!("a_cr falls in {} of {all} steps of η from 0.5 to 0.98, at ω from 0.5 to 8", all - against);
    Ok(Measured::new(against as f64, found))
}

/// How much `a_cr` changes from `ω` of 0.5 to 8: of itself, and of `a_cr - 1`.
fn change(eta: f64) -> Result<(f64, f64), Error> {
    let amplitudes = omegas().map(|omega| interpolated(omega, eta)).collect::<Result<Vec<_>, _>>()?;
    let (low, high) = amplitudes.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), e| (low.min(*e), high.max(*e)));
    Ok(((high - low) / (1.0 + high), (high - low) / high))
}

fn influence_of_omega() -> Result<Measured, Error> {
    let changes = etas(0.5).map(change).collect::<Result<Vec<_>, _>>()?;
    let against = changes.windows(2).filter(|two| two.last().map(|c| c.0) >= two.first().map(|c| c.0)).count();
    let percent = |eta: f64| Ok::<_, Error>(format!("{:.2}", 100.0 * change(eta)?.0));
    let found = format!(
        "from ω = 0.5 to 8 a_cr changes by {}, {}, {} and {} % at η = 0.5, 0.75, 0.92 and 0.98; of a_cr − 1 that is {:.0}, {:.0}, {:.0} and {:.0} %",
        percent(0.5)?,
        percent(0.75)?,
        percent(ETA)?,
        percent(0.98)?,
        100.0 * change(0.5)?.1,
        100.0 * change(0.75)?.1,
        100.0 * change(ETA)?.1,
        100.0 * change(0.98)?.1
    );
    Ok(Measured::new(against as f64, found))
}

fn independence() -> Result<Measured, Error> {
    let (of_itself, of_the_rest) = change(0.75)?;
    let found = format!(
        "at η = 0.75 ω changes a_cr by {:.2} % of itself from 0.5 to 8, which is {:.0} % of a_cr − 1, nearly all of it below ω = 2: {:.2} % above",
        100.0 * of_itself,
        100.0 * of_the_rest,
        100.0 * (1.0 - (1.0 + interpolated(2.0, 0.75)?) / (1.0 + interpolated(8.0, 0.75)?))
    );
    Ok(Measured::new(of_itself, found))
}

fn predominance() -> Result<Measured, Error> {
    let by_omega = interpolated(8.0, 0.75)? - interpolated(0.5, 0.75)?;
    let by_eta = interpolated(0.5, 0.75)? - interpolated(0.5, 0.98)?;
    let at_eight = interpolated(8.0, 0.75)? - interpolated(8.0, 0.98)?;
    let found = format!(
        "for η from 0.75 to 0.98 and ω from 0.5 to 8 a_cr changes by up to {by_omega:.3} with ω, and by {by_eta:.3} (ω = 0.5) to {at_eight:.3} (ω = 8) with η"
    );
    Ok(Measured::new(by_omega / (by_omega + by_eta), found))
}

fn half_per_cent() -> Result<Measured, Error> {
    let (of_itself, of_the_rest) = change(ETA)?;
    let (slow, fast) = (1.0 + interpolated(0.5, ETA)?, 1.0 + interpolated(8.0, ETA)?);
    let found = format!(
        "a_cr runs from {slow:.5} to {fast:.5}, by {:.2} % of itself; by {:.0} % of a_cr − 1",
        100.0 * of_itself,
        100.0 * of_the_rest
    );
    Ok(Measured::new((of_itself - 0.005).abs(), found))
}

fn both_sides() -> Result<Measured, Error> {
    let places: Vec<(f64, f64)> = [0.5, 0.7, 1.0, 2.0, 4.0, 8.0]
        .into_iter()
        .flat_map(|omega| [0.5, 0.6, 0.7, 0.8, 0.86, 0.92, 0.98].map(|eta| (omega, eta)))
        .collect();
    let below = [1e-3, 0.3, 0.9, 1.0 - 1e-6];
    let above = [1.0 + 1e-6, 1.1, 1.5, 3.0];
    let wrong = places.par_iter().map(|&(omega, eta)| {
        let critical = interpolated(omega, eta)?;
        let is_complete = |share: f64| {
            let case = Case::from_epsilon(share * critical, omega, eta)?.with_max_impacts(20_000)?;
            let answer = ask(panel::stepper().as_ref(), &case);
            Ok::<_, Error>(answer.observed().is_some_and(|observed| observed.history.ending == Ending::AtRest))
        };
        let mut wrong = 0;
        for share in below {
            wrong += usize::from(!is_complete(share)?);
        }
        for share in above {
            wrong += usize::from(is_complete(share)?);
        }
        Ok(wrong)
    });
    let wrong: usize = wrong.collect::<Result<Vec<_>, Error>>()?.into_iter().sum();
    let all = places.len() * (below.len() + above.len());
    let found = format!(
        "so in {} of {all} cases, from 0.001 to 3 times a_cr − 1 and a millionth of it on either side, for ω from 0.5 to 8 and η from 0.5 to 0.98",
        all - wrong
    );
    Ok(Measured::new(wrong as f64, found))
}
