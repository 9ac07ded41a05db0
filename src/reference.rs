//! Values with many digits, to test against: made from the printed equations, by the `reference` command.

use contract::Decline;
use serde::{Deserialize, Serialize};

use crate::{generate::Generator, panel};

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
    let printed = panel::printed();
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
