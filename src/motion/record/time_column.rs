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

impl Time<'_> {
    /// How far the printed time may be from the true one: half of its last digit, or what single precision rounds.
    fn rounding(&self) -> f64 {
        f64::max(0.5 * number::resolution(self.typed), 6e-8 * self.value.abs())
    }
}

/// The time step of evenly spaced times: the one that was asked if the times allow it, and otherwise the shortest decimal number that they do.
///
/// # Errors
/// The first line whose time is not where even spacing puts it, beyond the rounding of what is printed.
pub fn step(times: &[Time<'_>], asked: Step) -> Result<f64, RecordError> {
    let (Some(first), Some(last)) = (times.first(), times.last()) else {
        return Err(RecordError::whole("no times"));
    };
    if let Some((before, next)) =
        times.iter().zip(times.iter().skip(1)).find(|(before, next)| next.value <= before.value)
    {
        let message =
            format!("the time {} s follows {} s; expected is a later one", shown(next.typed), shown(before.typed));
        return Err(RecordError::at(next.line, message));
    }
    let steps = (times.len().max(2) - 1) as f64;
    let (mean, slack) = ((last.value - first.value) / steps, (first.rounding() + last.rounding()) / steps);
    if let Some(uneven) = first_uneven(times, first.value, mean, slack * steps) {
        return Err(uneven);
    }
    match asked {
        Step::Seconds(asked) if (asked - mean).abs() <= slack || is_same(asked, mean) => Ok(asked),
        _ => Ok(shortest(mean, slack)),
    }
}

/// What is wrong with the first time that is not evenly spaced, if one is.
fn first_uneven(times: &[Time<'_>], start: f64, mean: f64, slack: f64) -> Option<RecordError> {
    // The step that most of the times have: with a gap in them the mean is that of none.
    let second = times.get(1).map_or(mean, |time| time.value - start);
    let is_even = |time: &Time<'_>, place: usize, step: f64| {
        (time.value - start - place as f64 * step).abs() <= time.rounding() + slack + 1e-12 * time.value.abs()
    };
    if times.iter().enumerate().all(|(place, time)| is_even(time, place, mean)) {
        return None;
    }
    let step = |before: &Time<'_>, next: &Time<'_>| next.value - before.value;
    let pairs = || times.iter().zip(times.iter().skip(1));
    let differs = |(before, next): &(&Time<'_>, &Time<'_>)| {
        (step(before, next) - second).abs() > 2.0 * (next.rounding() + before.rounding()) + 1e-9 * second
    };
    // Times that drift have no step that differs by itself.
    let drifts =
        || pairs().enumerate().find(|(place, (_, next))| !is_even(next, place + 1, mean)).map(|(_, pair)| pair);
    let (before, next) = pairs().find(differs).or_else(drifts)?;
    let message = format!(
        "the time {} s follows {} s, a step of {:.6} s after steps of {second:.6} s; expected are evenly spaced times",
        shown(next.typed),
        shown(before.typed),
        step(before, next),
    );
    Some(RecordError::at(next.line, message))
}

/// The number with the fewest digits within a slack.
fn shortest(number: f64, slack: f64) -> f64 {
    let rounded = (0..17).filter_map(|digits| format!("{number:.digits$e}").parse::<f64>().ok());
    rounded.into_iter().find(|rounded| (rounded - number).abs() <= slack.max(1e-15 * number)).unwrap_or(number)
}
