//! How what the oracles claim compares with their true errors, as the judge proves them.

use std::{collections::BTreeMap, sync::LazyLock};

use serde::{Deserialize, Serialize};

use crate::{gate::tolerance, measure::observables::Observable};

/// How claims compare with true errors, for each observable.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Calibration(BTreeMap<Observable, Ratios>);

/// Claims over true errors, counted in classes of equal width in the logarithm.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
struct Ratios {
    classes: BTreeMap<i32, usize>,
    smallest: f64,
}

/// The figures of one observable.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ClaimOverError {
    /// How many numbers were judged.
    pub numbers: usize,
    /// The smallest claim, in multiples of the true error: below 1 it is too small.
    pub smallest: f64,
    /// The median.
    pub median: f64,
}

/// What is on record for the claims of an oracle: the median in multiples of its true error.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Band {
    /// Its name.
    pub oracle: String,
    /// Of which observable.
    pub observable: Observable,
    /// The median over a default run.
    pub recorded: f64,
}

/// How many cases it takes until the medians are those of a default run, in which as many are judged and more.
pub const CASES_ON_RECORD: usize = 200;

/// What is on record for an oracle of the default panel. `tests/gate/calibration.rs` writes the record.
pub fn band(oracle: &str, observable: Observable) -> Option<Band> {
    RECORD.iter().find(|band| band.oracle == oracle && band.observable == observable).cloned()
}

static RECORD: LazyLock<Vec<Band>> = LazyLock::new(|| read(include_str!("../../data/record/calibration.csv")));

/// Reads a record. A test makes sure that no row is lost.
fn read(text: &str) -> Vec<Band> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().filter_map(Result::ok).collect()
}

impl Band {
    /// Whether a median is what is on record, give or take what it varies by from seed to seed: well below a factor of two.
    pub fn contains(&self, median: f64) -> bool {
        let off = (median / self.recorded).max(self.recorded / median);
        off <= tolerance::RECALIBRATION.value
    }
}

/// Classes for every factor of 10.
const CLASSES: f64 = 16.0;

/// Cap on claim over error, so that an exact answer has a finite ratio.
const LARGEST: f64 = 1e30;

impl Calibration {
    /// Notes a claim for a number that is `error` away from the middle of an enclosure that reaches `unsure` to both sides of it. An error that
    /// the enclosure can't tell from nothing counts as half of what it could be.
    pub(super) fn add(&mut self, observable: Observable, claim: f64, error: f64, unsure: f64) {
        let ratio = (claim / error.max(0.5 * unsure)).clamp(0.0, LARGEST);
        let ratios = self.0.entry(observable).or_insert(Ratios { classes: BTreeMap::new(), smallest: f64::INFINITY });
        // What is not a number is no claim at all.
        let class = if ratio > 0.0 { (CLASSES * ratio.log10()).floor() as i32 } else { i32::MIN };
        *ratios.classes.entry(class).or_default() += 1;
        ratios.smallest = ratios.smallest.min(if ratio.is_nan() { 0.0 } else { ratio });
    }

    /// Adds the claims of other cases.
    pub fn add_all(&mut self, other: Self) {
        for (observable, theirs) in other.0 {
            let mine = self.0.entry(observable).or_insert(Ratios { classes: BTreeMap::new(), smallest: f64::INFINITY });
            mine.smallest = mine.smallest.min(theirs.smallest);
            for (class, count) in theirs.classes {
                *mine.classes.entry(class).or_default() += count;
            }
        }
    }

    /// The figures of each observable.
    pub fn figures(&self) -> BTreeMap<Observable, ClaimOverError> {
        self.0.iter().map(|(&observable, ratios)| (observable, ratios.figures())).collect()
    }
}

impl Ratios {
    fn figures(&self) -> ClaimOverError {
        let numbers: usize = self.classes.values().sum();
        let mut below = 0;
        let middle = self.classes.iter().find(|(_, count)| {
            below += **count;
            2 * below >= numbers
        });
        let median = middle.map_or(f64::NAN, |(&class, _)| 10.0_f64.powf((f64::from(class) + 0.5) / CLASSES));
        ClaimOverError { numbers, smallest: self.smallest, median }
    }
}

#[cfg(test)]
mod tests;
