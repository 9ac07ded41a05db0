//! SMC (U.S. Geological Survey): 11 lines of text, 48 integers (8I10), 50 reals (5E15.7), comments, and the accelerations in cm/s².
//!
//! The first line says what is in the file: `2 CORRECTED ACCELEROGRAM`. Integer 16 is the number of comment lines, integer 17 that of values, integer 47
//! that of digits; real 2 is the number of samples a second, reals 30 and 32 the largest and the smallest value. -32768 and 1.7E+38 stand for what is not
//! known. Values are in columns of 10 characters with an exponent of one digit (8E10.4E1), which touch; of 14 with 8 digits (USGS, "SMC-format data
//! files"; D. M. Boore, smcwrite). Uncorrected files have pairs of time and acceleration, unevenly spaced.

use super::{
    Found, RecordError, Units,
    error::shown,
    fixed::{self, Layout},
    peak,
    text::{Text, words},
};

const TEXT_LINES: usize = 11;
const INTEGERS: (usize, Layout) = (48, Layout { a_line: 8, width: 10 });
const REALS: (usize, Layout) = (50, Layout { a_line: 5, width: 15 });
/// Reals above that stand for what is not known.
const NULL: f64 = 1e38;
/// What the first line may say; only a corrected accelerogram, and an uncorrected one that is evenly sampled, are read.
const KINDS: [&str; 7] = [
    "UNKNOWN",
    "UNCORRECTED ACCELEROGRAM",
    "CORRECTED ACCELEROGRAM",
    "VELOCITY",
    "DISPLACEMENT",
    "RESPONSE SPECTRA",
    "FOURIER AMPLITUDE SPECTRA",
];

/// Whether a file is one: a digit and what it stands for, in the first line, and `*` or a text in the next.
pub fn is(text: &Text<'_>) -> bool {
    kind(text.line(1)).is_some()
}

/// The digit of the first line.
fn kind(line: &[u8]) -> Option<usize> {
    let digit = words(line).next().filter(|word| word.len() == 1)?.first()?.checked_sub(b'0')?;
    let said = line.trim_ascii().get(1..)?.trim_ascii();
    let known = KINDS.get(usize::from(digit))?;
    let is_said =
        said.get(..known.len().min(8)).is_some_and(|said| known.as_bytes().starts_with(&said.to_ascii_uppercase()));
    is_said.then_some(usize::from(digit))
}

/// Reads a file.
pub fn read(text: &Text<'_>) -> Result<Found, RecordError> {
    let what = kind(text.line(1)).filter(|kind| matches!(kind, 1 | 2)).ok_or_else(|| {
        let message = format!("`{}`; expected is 2 CORRECTED ACCELEROGRAM", shown(text.line(1)));
        RecordError::at(1, message)
    })?;
    let first_real = TEXT_LINES + 1 + INTEGERS.1.lines(INTEGERS.0);
    let first_comment = first_real + REALS.1.lines(REALS.0);
    let integers = fixed::read(text, TEXT_LINES + 1, INTEGERS.0, TEXT_LINES + 1, INTEGERS.1)?;
    let reals = fixed::read(text, first_real, REALS.0, first_real, REALS.1)?;
    let integer =
        |number: usize| integers.get(number - 1).copied().filter(|value| *value >= 0.0).map(|value| value as usize);
    let real = |number: usize| reals.get(number - 1).copied().filter(|value| value.abs() < NULL);

    let Some(rate) = real(2).filter(|rate| *rate > 0.0) else {
        let why = if what == 1 {
            "its values are pairs of unevenly spaced times and accelerations"
        } else {
            "it is not given"
        };
        let message =
            format!("no sampling rate (the second real of the header): {why}; expected is an evenly sampled record");
        return Err(RecordError::at(first_real, message));
    };
    let first = first_comment + comments(text, first_comment, integer(16).unwrap_or(0))?;
    let count_line = TEXT_LINES + 3;
    let count = integer(17).ok_or_else(|| {
        RecordError::at(count_line, "the 17th integer of the header; expected is the number of values")
    })?;
    let width = if integer(47) == Some(8) { 14 } else { 10 };
    let layout = Layout { a_line: if width == 14 { 5 } else { 8 }, width };
    let samples = fixed::read(text, first, count, count_line, layout)?;
    if let Some((line, content)) = text.from(first + layout.lines(count)).find(|(_, content)| !content.is_empty()) {
        return Err(RecordError::at(line, format!("`{}`; expected is the end after {count} values", shown(content))));
    }
    let peak = [real(30), real(32)].into_iter().flatten().fold(0.0, |peak, value| f64::max(peak, value.abs()));
    let notes = peak::differs(peak, 0.0, first_real + 5, &samples).into_iter().collect();
    Ok(Found {
        format: "SMC",
        dt: Some((1.0 / rate, first_real)),
        units: Some((Units::CentimetresPerSecondSquared, 1)),
        samples,
        start: first,
        notes,
        has_offset: false,
    })
}

/// Checks that the comments are there, and counts them.
fn comments(text: &Text<'_>, first: usize, count: usize) -> Result<usize, RecordError> {
    match text.from(first).take(count).find(|(_, line)| !line.starts_with(b"|")) {
        Some((line, content)) => {
            let message = format!(
                "`{}`; expected are {count} comments from line {first} on, each with | in front",
                shown(content)
            );
            Err(RecordError::at(line, message))
        }
        None => Ok(count),
    }
}
