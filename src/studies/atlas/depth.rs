use contract::Decline;
use serde::Serialize;

use super::{Contender, methods, truth::Truth};
use crate::studies::specimens::Conclusion;

/// The error of one interval by one method.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DepthRow {
    /// `(a - 1)/(a_cr - 1)`.
    pub share: String,
    /// The method.
    pub method: String,
    /// Which impact ends the interval.
    pub n: usize,
    /// How long it is.
    pub interval: f64,
    /// How far off the method is, relative; nothing where it has no such impact any more, and does not say that it stopped.
    pub error: Option<f64>,
}

/// The distances at which every interval is looked at.
const SHARES: [(&str, f64); 2] = [("50 %", 0.5), ("99.9 %", 0.999)];
/// The restitution.
const ETA: f64 = 0.92;
/// Every so many impacts: an even number shows flights of one sign, the longer ones.
const EVERY: usize = 12;
/// The methods that have a sequence to lose, with the setting at which they keep it longest.
const METHODS: [(&str, &str); 7] = [
    ("Eq. 6 in absolute time", ""),
    ("one clock, state zero", "rtol 1e-12"),
    ("one clock, state lifted", "rtol 1e-12"),
    ("one clock, old step kept", "rtol 1e-12"),
    ("Moreau-Jean", "step 1e-6"),
    ("oracle", "closed-form"),
    ("oracle", "ode/linear/tsit45"),
];

pub(super) fn measure(omega: f64) -> Result<Vec<DepthRow>, Decline> {
    let methods = methods();
    let mut rows = Vec::new();
    for (name, share) in SHARES {
        let truth = Truth::at(omega, ETA, 1.0 - share)?;
        for (family, setting) in METHODS {
            let method = methods.iter().find(|method| method.family() == family && method.setting() == setting);
            let Some(method) = method else { continue };
            rows.extend(of_one(method, &truth, name));
        }
    }
    Ok(rows)
}

fn of_one(method: &Contender, truth: &Truth, share: &str) -> Vec<DepthRow> {
    let Some(run) = method.run(&truth.case) else { return Vec::new() };
    let name = match method {
        Contender::Specimen(specimen) => format!("{} {}", specimen.family(), specimen.setting()).trim_end().to_owned(),
        Contender::Oracle(oracle) => oracle.name().to_owned(),
    };
    let is_over = matches!(run.conclusion, Conclusion::Rests(_));
    let listed = truth.impacts.iter().enumerate().skip(EVERY).step_by(EVERY);
    let rows = listed.map(|(index, exact)| DepthRow {
        share: share.to_owned(),
        method: name.clone(),
        n: index + 1,
        interval: exact.interval,
        error: run.impacts.get(index).map(|found| (found.interval / exact.interval - 1.0).abs()),
    });
    // After the last impact of a method the first that is missing is marked, and no more.
    let mut rows: Vec<DepthRow> = rows.collect();
    let has = rows.iter().take_while(|row| row.error.is_some()).count();
    rows.truncate(has + usize::from(!is_over));
    rows
}
