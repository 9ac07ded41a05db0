//! Times of samples: whether they are evenly spaced, as printed, and by how much.

use super::{RecordError, Step, error::shown, number};

/// How far two time steps that should be the same may differ, relative.
const SAME: f64 = 1e-9;

/// The time step that the file and who asks agree on.
pub fn agree(file: Option<(f64, usize)>, asked: Step) -> Result<Option<f64>, RecordError> {
    match (file, asked) {
        (_, Step::Seconds(asked)) if !(asked.is_finite() && asked > 0.0) => {
            Err(RecordError::whole(format!("dt is {asked:?} s in the scene; expected is a number above 0")))
        }
        (Some((file, line)), Step::Seconds(asked)) if !is_same(file, asked) => Err(RecordError::at(
            line,
            format!("the file says that its time step is {file:?} s, the scene dt = {asked:?} s; expected is the same"),
        )),
        (Some((file, _)), _) => Ok(Some(file)),
        (None, Step::Seconds(asked)) => Ok(Some(asked)),
        (None, Step::Elsewhere) => Ok(None),
        (None, Step::OfFile) => Err(RecordError::whole(
            "the file does not give its time step; expected is dt = { seconds = number } in the scene",
        )),
    }
}

/// Whether two time steps are the same.
pub fn is_same(one: f64, other: f64) -> bool {
    (one - other).abs() <= SAME * one.abs().max(other.abs())
}

/// A time as printed, and the line.
#[derive(Debug, Clone, Copy)]
pub struct Time<'a> {
    /// As typed.
    pub typed: &'a [u8],
    /// In seconds.
    pub value: f64,
    /// The line.
    pub line: usize,
}

/// The time step of evenly spaced times: the one that was asked, if all times are where it puts them, to the rounding of what is printed; otherwise the
/// plainest number that puts them there.
///
/// # Errors
/// The first line whose time is not where even spacing puts it.
pub fn step(times: &[Time<'_>], asked: Step) -> Result<f64, RecordError> {
    if let Some((before, next)) = pairs(times).find(|(before, next)| next.value <= before.value) {
        let message =
            format!("the time {} s follows {} s; expected is a later one", shown(next.typed), shown(before.typed));
        return Err(RecordError::at(next.line, message));
    }
    let (Some(first), Some(second), Some(last)) = (times.first(), times.get(1), times.last()) else {
        return Err(RecordError::whole("fewer than 2 times; expected are at least 2"));
    };
    let possible = Possible::of(times, first);
    if let Step::Seconds(asked) = asked
        && possible.contains(asked)
    {
        return Ok(asked);
    }
    let mean = (last.value - first.value) / (times.len() - 1) as f64;
    let differs = |(before, next): &(&Time<'_>, &Time<'_>), by: f64| {
        ((next.value - before.value) - (second.value - first.value)).abs() > by
    };
    if !pairs(times).any(|pair| differs(&pair, 1e-6 * mean)) {
        return Ok(shortest(mean, 1e-12 * mean));
    }
    // Where a step has less than ten units of the last digit, a gap in the times may look like rounding.
    let is_coarse = 20.0 * possible.rounding > mean;
    if !is_coarse && possible.lowest <= possible.highest {
        return Ok(possible.plainest());
    }
    let by = if is_coarse { 1e-6 * mean } else { 4.0 * possible.rounding };
    let pair = pairs(times).find(|pair| differs(pair, by)).unwrap_or((first, last));
    Err(uneven(pair, second.value - first.value, is_coarse))
}

/// Neighbours.
fn pairs<'t, 'a>(times: &'t [Time<'a>]) -> impl Iterator<Item = (&'t Time<'a>, &'t Time<'a>)> {
    times.iter().zip(times.iter().skip(1))
}

/// What is wrong with a step after others.
fn uneven((before, next): (&Time<'_>, &Time<'_>), others: f64, is_coarse: bool) -> RecordError {
    let hint = if is_coarse { " (or dt in the scene, if that is the rounding of what is printed)" } else { "" };
    let message = format!(
        "the time {} s follows {} s, a step of {} s after steps of {} s; expected are evenly spaced times{hint}",
        shown(next.typed),
        shown(before.typed),
        shortest(next.value - before.value, 1e-9),
        shortest(others, 1e-9),
    );
    RecordError::at(next.line, message)
}

/// The time steps that put all times where they are, to their rounding.
#[derive(Debug)]
struct Possible {
    lowest: f64,
    highest: f64,
    /// The largest of a time.
    rounding: f64,
}

impl Possible {
    fn of(times: &[Time<'_>], first: &Time<'_>) -> Self {
        // The shortest way to print 0.02 has two digits, and 0.025 three: the digits of all count.
        let decimals = |with_exponent: bool| {
            let typed = times.iter().map(|time| number::decimals(time.typed));
            typed.filter(|(_, exponent)| exponent.is_some() == with_exponent).map(|(decimals, _)| decimals).max()
        };
        let (plain, scientific) = (decimals(false).unwrap_or(0), decimals(true).unwrap_or(0));
        let rounding = |time: &Time<'_>| {
            let exponent = match number::decimals(time.typed) {
                (_, Some(exponent)) => exponent - scientific,
                (_, None) => -plain,
            };
            // What single precision rounds is more than the digits that are printed of it.
            f64::max(0.5 * 10_f64.powi(exponent), f64::from(f32::EPSILON) * time.value.abs())
                * f64::from(time.value != 0.0)
        };
        let mut possible = Self { lowest: 0.0, highest: f64::INFINITY, rounding: 0.0 };
        for (place, time) in times.iter().enumerate().skip(1) {
            let (since, rounding) = (time.value - first.value, rounding(time) + rounding(first));
            possible.lowest = f64::max(possible.lowest, (since - rounding) / place as f64);
            possible.highest = f64::min(possible.highest, (since + rounding) / place as f64);
            possible.rounding = f64::max(possible.rounding, rounding);
        }
        possible
    }

    fn contains(&self, step: f64) -> bool {
        self.lowest * (1.0 - SAME) <= step && step <= self.highest * (1.0 + SAME)
    }

    /// A number of up to four digits; else a whole number of samples a second; else the fewest digits.
    fn plainest(&self) -> f64 {
        let (middle, slack) = (0.5 * (self.lowest + self.highest), 0.5 * (self.highest - self.lowest));
        let short = (0..4).filter_map(|digits| rounded(middle, digits)).find(|step| (step - middle).abs() <= slack);
        let rate = || Some(1.0 / (1.0 / middle).round()).filter(|step| (step - middle).abs() <= slack);
        short.or_else(rate).unwrap_or_else(|| shortest(middle, slack))
    }
}

/// A number with so many digits after the first.
fn rounded(number: f64, digits: usize) -> Option<f64> {
    format!("{number:.digits$e}").parse().ok()
}

/// The number with the fewest digits within a slack.
fn shortest(number: f64, slack: f64) -> f64 {
    let mut numbers = (0..17).filter_map(|digits| rounded(number, digits));
    numbers.find(|rounded| (rounded - number).abs() <= slack).unwrap_or(number)
}
