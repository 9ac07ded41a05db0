//! The introduction: infinitely many impacts in finite time.

use contract::{Case, Ending, Model};
use rayon::prelude::*;

use super::{Measured, Measurement};
use crate::studies::{diagnose::truth::FEW_DIGITS, paper::Error};

pub(super) const ALL: &[Measurement] = &[("infinitely-many", infinitely_many)];

fn infinitely_many() -> Result<Measured, Error> {
    let (omegas, etas, shares) = ([0.5, 1.0, 2.0, 5.0, 8.0], [0.5, 0.7, 0.86, 0.92, 0.98], [0.01, 0.3, 0.9, 0.999]);
    let mut cases = Vec::new();
    for (omega, eta) in omegas.into_iter().flat_map(|omega| etas.map(|eta| (omega, eta))) {
        let critical = crate::measure::critical::interpolated(omega, eta)?;
        for share in shares {
            cases.push(Case::from_epsilon(share * critical, omega, eta)?.with_max_impacts(1)?);
        }
    }
    let complete = cases.par_iter().filter(|case| {
        // Whether, not when.
        let enclosure = enclosure::Enclosure::new(Model::Linear).with_digits(FEW_DIGITS);
        let enclosed = enclosure.ok().and_then(|enclosure| enclosure.enclose(case).ok());
        enclosed.is_some_and(|enclosed| enclosed.ending == Ending::AtRest && enclosed.chattering_time.is_some())
    });
    let (all, complete) = (cases.len(), complete.count());
    let found = format!("proven for {complete} of {all} cases with a from 1 to 0.999 of the way to a_cr");
    Ok(Measured::new((all - complete) as f64, found))
}
