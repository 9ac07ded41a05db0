//! The titles of the columns of a table: the last line before the numbers, if it is that.

use super::{
    RecordError, Units,
    cells::{column, columns},
    error::shown,
    text::{Numbered, Text, contains},
    units,
};

/// What the title of the first column says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Title {
    /// Times.
    Time,
    /// The numbers of the samples.
    Count,
    /// Periods or frequencies.
    Spectrum,
    /// Something else, or there is none.
    Other,
}

const TIMES: [&str; 11] =
    ["t", "time", "times", "sec", "secs", "second", "seconds", "zeit", "temps", "tiempo", "tempo"];
const SPECTRA: [&str; 5] = ["period", "periods", "freq", "frequency", "frequencies"];
const COUNTS: [&str; 10] = ["k", "i", "n", "index", "no", "nr", "number", "sample", "point", "id"];
/// Accelerations and velocities of a spectrum.
const SPECTRAL: [&str; 3] = ["sa", "psa", "psv"];
/// Units of time that are not the second.
const NOT_SECONDS: [&str; 9] = ["ms", "msec", "millisecond", "milliseconds", "us", "min", "minutes", "h", "hours"];

/// The line of titles before the first line of numbers.
fn line<'a>(text: &Text<'a>, first: usize) -> Option<Numbered<'a>> {
    text.from(1).take(first - 1).filter(|(_, line)| !line.is_empty()).last()
}

/// The words of a title, without what is not a letter.
fn words(title: &[u8]) -> impl Iterator<Item = &[u8]> {
    title.split(|byte| !byte.is_ascii_alphabetic()).filter(|word| !word.is_empty())
}

fn is(word: &[u8], known: &[&str]) -> bool {
    known.iter().any(|known| word.eq_ignore_ascii_case(known.as_bytes()))
}

/// What the first column holds, by the first word of the titles.
pub fn first(text: &Text<'_>, first: usize) -> Title {
    match line(text, first).and_then(|(_, line)| words(line).next()) {
        Some(word) if is(word, &TIMES) => Title::Time,
        Some(word) if is(word, &SPECTRA) => Title::Spectrum,
        Some(word) if is(word, &COUNTS) => Title::Count,
        _ => Title::Other,
    }
}

/// Refuses a spectrum, and times in another unit than seconds.
pub fn check(text: &Text<'_>, first_line: usize) -> Result<(), RecordError> {
    let Some((number, titles)) = line(text, first_line) else { return Ok(()) };
    let refused = |what: &str| Err(RecordError::at(number, format!("`{}` {what}", shown(titles))));
    let is_spectral = words(titles).any(|word| is(word, &SPECTRAL));
    match first(text, first_line) {
        Title::Spectrum => refused("is of a spectrum; expected is an acceleration in time"),
        _ if is_spectral => refused("is of a spectrum; expected is an acceleration in time"),
        // Its unit is the next word.
        Title::Time if words(titles).nth(1).is_some_and(|word| is(word, &NOT_SECONDS)) => {
            refused("has times in another unit; expected are seconds")
        }
        _ => Ok(()),
    }
}

/// The units in the title of a column, if the titles are as many as the columns; otherwise in the header.
pub fn units(
    text: &Text<'_>,
    first: usize,
    number: usize,
    wanted: usize,
) -> Result<Option<(Units, usize)>, RecordError> {
    let titled = line(text, first).and_then(|(line, titles)| Some((line, title(titles, number, wanted)?)));
    let Some((line, title)) = titled else { return units::of_header(&text.before(first)) };
    if is_of_other(title) {
        let message = format!("the title of the column is `{}`; expected is an acceleration", shown(title));
        return Err(RecordError::at(line, message));
    }
    match units::of_title(title) {
        Some(named) => Ok(Some((named.known(line)?, line))),
        None => units::of_header(&text.before(line)),
    }
}

/// The title of a column, if a line of titles can be parted into as many as there are columns: as the numbers are, or else, where titles have blanks in
/// them, at tabs, at two blanks, or behind brackets.
fn title(line: &[u8], number: usize, wanted: usize) -> Option<&[u8]> {
    if columns(line) == number {
        return column(line, wanted);
    }
    let text = std::str::from_utf8(line).ok()?;
    let parted = |ends: &[&str]| {
        let mut cells = vec![text];
        for end in ends {
            cells = cells.into_iter().flat_map(|cell| cell.split_inclusive(end)).collect();
        }
        cells.retain(|cell| !cell.trim().is_empty());
        (cells.len() == number).then_some(cells)
    };
    let cells = parted(&["\t"]).or_else(|| parted(&["  "])).or_else(|| parted(&[")", "]"]))?;
    cells.get(wanted.checked_sub(1)?).map(|cell| cell.trim().as_bytes())
}

/// Whether a title has a word such as `vel` or `displacement` in it, and none such as `accel`.
fn is_of_other(title: &[u8]) -> bool {
    let starts =
        |word: &[u8], with: &[u8]| word.get(..with.len()).is_some_and(|start| start.eq_ignore_ascii_case(with));
    words(title).any(|word| starts(word, b"vel") || starts(word, b"disp")) && !contains(title, "acc")
}
