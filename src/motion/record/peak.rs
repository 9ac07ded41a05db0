//! The largest sample and the mean: what a header says about them, and what an engineer should know.

use super::Units;

/// The samples are rounded as well as what the header says of them: three digits of a number are as few as a format keeps.
const ROUNDED: f64 = 2e-3;

/// A note where the peak that a header says, to its last digit `digit`, is not that of the samples.
pub fn differs(said: f64, digit: f64, line: usize, samples: &[f64]) -> Option<String> {
    let found = largest(samples, 0.0);
    let differs = said.is_finite() && said != 0.0 && (said.abs() - found).abs() > digit + ROUNDED * found;
    differs.then(|| format!("line {line} says that the peak is {}, but the largest sample is {found}", said.abs()))
}

/// A note about the mean of the samples: always, if the format is known to leave an offset; otherwise if it is a tenth of the peak.
pub fn offset(samples: &[f64], units: Units, always: bool) -> Option<String> {
    const SHARE: f64 = 0.1;
    let mean = samples.iter().sum::<f64>() / samples.len() as f64;
    let peak = largest(samples, mean);
    let tells = always || mean.abs() > SHARE * peak;
    (tells && mean != 0.0).then(|| {
        let (mean, peak) = (short(mean), short(peak));
        format!(
            "the mean of the record is {mean:?} {units}, and its peak from there {peak:?} {units}; the mean is not removed"
        )
    })
}

/// A number with four digits.
fn short(number: f64) -> f64 {
    format!("{number:.3e}").parse().unwrap_or(number)
}

/// The largest distance from a value.
fn largest(samples: &[f64], from: f64) -> f64 {
    samples.iter().fold(0.0, |largest, sample| f64::max(largest, (sample - from).abs()))
}
