//! CSMIP V2: the volume 2 of the California Strong Motion Instrumentation Program (Shakal and Huang, OSMS 85-03), also of the older Caltech and USC files.
//!
//! A channel has headers, a line such as `7500 points of accel data equally spaced at  .010 sec, in cm/sec2. (8f10.6)` with the accelerations after it, and
//! likewise velocities and displacements, which are left. Columns touch where numbers are large. A file may have several channels, one after the other.

use super::{
    Found, RecordError,
    cosmos::one_of,
    error::shown,
    fixed::{self, Layout},
    text::{Text, contains, first_number, place_of, words},
    units::{Named, of_word, of_words},
};

const DATA: &str = "points of accel data equally spaced at";
/// Where the line names no format.
const USUAL: Layout = Layout { a_line: 8, width: 10 };

/// Whether a file is one: the data of the first channel are announced.
pub fn is(text: &Text<'_>) -> bool {
    text.find(1, 200, DATA).is_some()
}

/// Reads a channel: the only one unless told which.
pub fn read(text: &Text<'_>, channel: Option<usize>) -> Result<Found, RecordError> {
    let starts = text.from(1).filter(|(_, line)| contains(line, DATA)).map(|(line, _)| line);
    let line = one_of(starts, channel)?;
    let said = text.line(line);
    let (count, dt, rest) = announced(said).ok_or_else(|| {
        let message =
            format!("`{}`; expected is such as 7500 points of accel data equally spaced at .010 sec", shown(said));
        RecordError::at(line, message)
    })?;
    let layout = Layout::of(rest).unwrap_or(USUAL);
    let samples = fixed::read(text, line + 1, count, line, layout)?;
    let after = line + 1 + layout.lines(count);
    let end = text.line(after);
    if !end.is_empty() && !contains(end, "points of") && !end.starts_with(b"/&") {
        return Err(RecordError::at(
            after,
            format!("`{}`; expected are the velocities after {count} values", shown(end)),
        ));
    }
    let units = named(rest).map(|named| named.known(line)).transpose()?.map(|units| (units, line));
    Ok(Found { format: "CSMIP V2", dt: Some((dt, line)), units, samples, start: line + 1, ..Found::default() })
}

/// How many values, how far apart, and the rest of the line.
fn announced(line: &[u8]) -> Option<(usize, f64, &[u8])> {
    let (count, _) = first_number(line).filter(|(count, _)| *count >= 0.0)?;
    let rest = line.get(place_of(line, DATA)? + DATA.len()..)?;
    let (dt, rest) = first_number(rest).filter(|(dt, _)| *dt > 0.0)?;
    Some((count as usize, dt, rest))
}

/// The units in the rest of the line.
fn named(rest: &[u8]) -> Option<Named<'_>> {
    let words = words(rest).map(|word| word.strip_suffix(b")").unwrap_or(word));
    of_words(words.filter(|word| matches!(of_word(word), Some(Named::Known(_)))))
}
