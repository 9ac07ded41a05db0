//! Values with many digits, to test against, made by the `reference` command: from the printed equations, and by the enclosure with proof.

use contract::{Case, Decline, Model, Normalisation, Slenderness};
use enclosure::Bounds;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::{
    cases::generate::Generator,
    measure::critical::{self, Term},
    panel,
};

/// Which impacts are tabulated.
const IMPACTS: [usize; 7] = [1, 2, 3, 5, 10, 20, 40];

/// One impact of one case, as `data/reference/linear_impacts.csv` has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ImpactRow {
    /// `a - 1`, the double itself.
    pub epsilon: f64,
    /// The frequency ratio.
    pub omega: f64,
    /// The restitution.
    pub eta: f64,
    /// Which impact.
    pub n: usize,
    /// `τ_n`, `Δτ_{n-1}` and `φ'_n(τ_n)`, in decimal.
    pub tau: String,
    /// See `tau`.
    pub interval: String,
    /// See `tau`.
    pub velocity: String,
}

/// The chattering time of one case, as `data/reference/linear_chattering_times.csv` has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TimeRow {
    /// `a - 1`, the double itself.
    pub epsilon: f64,
    /// The frequency ratio.
    pub omega: f64,
    /// The restitution.
    pub eta: f64,
    /// `τ_ch`, in decimal.
    pub tau_ch: String,
}

/// Computes both tables, for every third case of the grid. `done` is called after each case.
///
/// # Errors
/// When the printed equations can't be followed for one of the cases.
pub fn tables(done: impl Fn()) -> Result<(Vec<ImpactRow>, Vec<TimeRow>), Decline> {
    let printed = printed::Printed::default();
    let (mut impacts, mut times) = (Vec::new(), Vec::new());
    for named in Generator::Spaced.cases(0, 0, &printed).into_iter().step_by(3) {
        let Ok(case) = named.case.with_max_impacts(40) else { continue };
        let (epsilon, omega, eta) = (case.epsilon(), case.omega(), case.eta());
        for (n, impact) in (1..).zip(printed.decimals(&case)?).filter(|(n, _)| IMPACTS.contains(n)) {
            let (tau, interval, velocity) = (impact.time, impact.interval, impact.velocity);
            impacts.push(ImpactRow { epsilon, omega, eta, n, tau, interval, velocity });
        }
        match printed.chattering_time_decimal(&case) {
            Ok(tau_ch) => times.push(TimeRow { epsilon, omega, eta, tau_ch }),
            // The fit of a_cr that the grid is made with is above a_cr here: the chattering is incomplete.
            Err(Decline::NotConvergent { .. }) => {}
            Err(decline) => return Err(decline),
        }
        done();
    }
    Ok((impacts, times))
}

/// One impact of one case, as `data/reference/proven_impacts.csv` has it: every digit is proven, the last one rounded down.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ProvenImpactRow {
    /// `a - 1`.
    pub epsilon: f64,
    /// The frequency ratio.
    pub omega: f64,
    /// The restitution.
    pub eta: f64,
    /// The slenderness of a case of the nonlinear model; empty for one of the linear model.
    pub alpha: Option<f64>,
    /// Its normalisation.
    pub normalisation: Option<String>,
    /// Which impact.
    pub n: usize,
    /// `τ_n`, `Δτ_{n-1}` and `φ'_n(τ_n)`, in decimal.
    pub tau: String,
    /// See `tau`.
    pub interval: String,
    /// See `tau`.
    pub velocity: String,
}

/// The chattering time of one case, as `data/reference/proven_chattering_times.csv` has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ProvenTimeRow {
    /// `a - 1`.
    pub epsilon: f64,
    /// The frequency ratio.
    pub omega: f64,
    /// The restitution.
    pub eta: f64,
    /// The slenderness of a case of the nonlinear model; empty for one of the linear model.
    pub alpha: Option<f64>,
    /// Its normalisation.
    pub normalisation: Option<String>,
    /// `τ_ch`, in decimal, or nothing if the chattering is proven to be incomplete.
    pub tau_ch: Option<String>,
}

/// One critical amplitude, as `data/reference/critical_amplitudes.csv` has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CriticalRow {
    /// The frequency ratio.
    pub omega: f64,
    /// The restitution.
    pub eta: f64,
    /// An amplitude whose chattering is proven to be complete, rounded down.
    pub complete: String,
    /// One whose chattering is proven to be incomplete, rounded up.
    pub incomplete: String,
    /// The exponent of the approach.
    pub exponent: f64,
}

/// How many significant digits the proven tables have.
const DIGITS: u32 = 25;

/// Computes the proven tables: every case of the grid for the linear model, and every second one for the nonlinear model, some of them under
/// the slender normalisation. `done` is called after each case, from any thread.
///
/// # Errors
/// When the enclosure declines a case.
pub fn proven_tables(done: impl Fn() + Sync) -> Result<(Vec<ProvenImpactRow>, Vec<ProvenTimeRow>), Decline> {
    let grid: Vec<Case> =
        Generator::Spaced.cases(0, 0, &printed::Printed::default()).into_iter().map(|named| named.case).collect();
    let linear = grid.iter().map(|case| (Model::Linear, *case));
    let nonlinear = grid.iter().step_by(2).map(|case| (Model::Nonlinear, *case));
    let slender = grid.iter().filter_map(|case| {
        let slenderness = case.slenderness().filter(|slenderness| slenderness.alpha() < 0.1)?;
        let slender = Slenderness::new(slenderness.alpha(), Normalisation::Slender).ok()?;
        Some((Model::Nonlinear, case.with_slenderness(slender)))
    });
    let asked: Vec<(Model, Case)> = linear.chain(nonlinear).chain(slender.step_by(4)).collect();
    let rows = asked.par_iter().map(|(model, case)| {
        let rows = proven_rows(*model, case);
        done();
        rows
    });
    let rows: Vec<(Vec<ProvenImpactRow>, ProvenTimeRow)> = rows.collect::<Result<_, _>>()?;
    let (impacts, times): (Vec<_>, Vec<_>) = rows.into_iter().unzip();
    Ok((impacts.concat(), times))
}

fn proven_rows(model: Model, case: &Case) -> Result<(Vec<ProvenImpactRow>, ProvenTimeRow), Decline> {
    let out_of_range = |_| Decline::Unsupported { what: "so many impacts or digits" };
    let case = case.with_max_impacts(40).map_err(out_of_range)?;
    let slenderness = case.slenderness().filter(|_| model == Model::Nonlinear);
    let (epsilon, omega, eta) = (case.epsilon(), case.omega(), case.eta());
    let alpha = slenderness.map(|slenderness| slenderness.alpha());
    let normalisation = slenderness.map(|slenderness| match slenderness.normalisation() {
        Normalisation::Threshold => "threshold".to_owned(),
        Normalisation::Slender => "slender".to_owned(),
    });
    // A value may lie so near to the edge of a digit that it takes more of them to settle it.
    for digits in [DIGITS + 3, 2 * DIGITS, 4 * DIGITS] {
        let enclosed = enclosure::Enclosure::new(model).with_digits(digits).map_err(out_of_range)?.enclose(&case)?;
        let settled = |bounds: &Bounds| bounds.settled(DIGITS);
        let rows: Option<Vec<ProvenImpactRow>> = (1..)
            .zip(&enclosed.impacts)
            .filter(|(n, _)| IMPACTS.contains(n))
            .map(|(n, impact)| {
                let (tau, interval) = (settled(&impact.time)?, settled(&impact.interval)?);
                let (velocity, normalisation) = (settled(&impact.velocity)?, normalisation.clone());
                Some(ProvenImpactRow { epsilon, omega, eta, alpha, normalisation, n, tau, interval, velocity })
            })
            .collect();
        let time = enclosed.chattering_time.as_ref().map(settled);
        if let (Some(rows), None | Some(Some(_))) = (rows, &time) {
            return Ok((rows, ProvenTimeRow { epsilon, omega, eta, alpha, normalisation, tau_ch: time.flatten() }));
        }
    }
    Err(Decline::NotConvergent { why: "the digits are not settled".to_owned() })
}

/// Computes the certified critical amplitudes of a grid of `ω` and `η`. `done` is called after each.
///
/// # Errors
/// When no bracket is found.
pub fn critical_amplitudes(done: impl Fn() + Sync) -> Result<Vec<CriticalRow>, Decline> {
    let omegas = [0.5, 1.0, 2.0, 4.0, 6.0, 8.0];
    let pairs: Vec<_> = [0.5, 0.7, 0.8, 0.92, 0.97].iter().flat_map(|eta| omegas.map(|omega| (omega, *eta))).collect();
    let rows = pairs.par_iter().map(|&(omega, eta)| {
        let critical = enclosure::critical_amplitude(omega, eta)?;
        let [complete, incomplete] = critical.amplitude.decimals(18);
        done();
        Ok(CriticalRow { omega, eta, complete, incomplete, exponent: critical.exponent })
    });
    rows.collect()
}

/// Computes the polynomial that interpolates the critical amplitude, from values of the closed form. `done` is called after each of them.
///
/// # Errors
/// When the closed form has no critical amplitude at a node.
pub fn critical_interpolant(done: impl Fn() + Sync) -> Result<Vec<Term>, Decline> {
    let not_found = |why: String| Decline::NotConvergent { why };
    let stepper = panel::select("closed-form").map_err(|invalid| not_found(invalid.to_string()))?;
    let terms = stepper.first().map(|stepper| critical::terms(stepper.as_ref(), done)).transpose();
    let terms = terms.map_err(|invalid| not_found(invalid.to_string()))?;
    terms.flatten().ok_or_else(|| not_found("no critical amplitude at a node".to_owned()))
}
