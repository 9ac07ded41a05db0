//! The stability atlas: what each known way of handling the accumulation point does, over the distance to the critical amplitude, the restitution
//! and the depth of the sequence. The ways that fail are the [`specimens`](crate::studies::specimens); beside them stand the oracles.
//!
//! The truth is the enclosure's: whether the chattering is complete, `τ_ch`, every interval, and what happens in the half period after `T/2`.

mod charts;
mod depth;
mod measure;
mod methods;
mod summary;
mod truth;

use std::collections::BTreeMap;

use contract::Decline;
use rayon::prelude::*;

use crate::studies::chart::csv_text;

pub use charts::CHARTS;
pub use depth::DepthRow;
pub use measure::AtlasRow;
pub use methods::{Contender, LIFT, methods};
pub use summary::markdown;

/// What is looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Scope {
    /// The frequency ratio.
    pub omega: f64,
    /// The restitutions.
    pub etas: Vec<f64>,
    /// The distances to the critical amplitude, `(a_cr - a)/(a_cr - 1)`: positive below it.
    pub distances: Vec<f64>,
}

impl Default for Scope {
    /// The frequency of the paper's figures, the restitutions of Fig. 6 and beyond, and distances decade by decade from both sides.
    fn default() -> Self {
        let decades = [0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8];
        let above = decades.iter().rev().map(|distance| -distance);
        Self {
            omega: 2.0,
            etas: vec![0.6, 0.7, 0.8, 0.86, 0.92, 0.97],
            distances: decades.iter().copied().chain(above).collect(),
        }
    }
}

/// The tables, one for each file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tables {
    /// Every method on every case.
    pub atlas: Vec<AtlasRow>,
    /// Where each method loses the sequence: the error of each interval.
    pub depth: Vec<DepthRow>,
}

impl Tables {
    /// Asks every method every case. `done` is called after each case, from any thread.
    ///
    /// # Errors
    /// When a frequency or a restitution is outside of what the enclosure or the critical amplitude can do.
    pub fn measure(request: &Scope, done: impl Fn() + Sync) -> Result<Self, Decline> {
        let methods = methods();
        let places = request.etas.iter().flat_map(|eta| request.distances.iter().map(move |to_go| (*eta, *to_go)));
        let rows = places.collect::<Vec<_>>().into_par_iter().map(|(eta, to_go)| {
            let rows = measure::at(&methods, request.omega, eta, to_go);
            done();
            rows
        });
        let atlas = rows.collect::<Result<Vec<_>, _>>()?.concat();
        Ok(Self { atlas, depth: depth::measure(request.omega)? })
    }

    /// The name of each file and its text.
    ///
    /// # Errors
    /// Never, as far as rows of numbers and names can be written.
    pub fn files(&self) -> Result<BTreeMap<&'static str, String>, csv::Error> {
        Ok(BTreeMap::from([
            ("atlas.csv", csv_text(&self.atlas)?),
            ("atlas_depth.csv", csv_text(&self.depth)?),
            ("atlas.md", markdown(&self.atlas)),
        ]))
    }
}
