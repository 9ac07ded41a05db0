//! COSMOS V1 and V2: the strong-motion data format of the Consortium of Organizations for Strong-Motion Observation Systems, version 1.20 (2001).
//!
//! A channel has 13 lines of text, of which the first is `Corrected acceleration    (Format v01.20 with 13 text lines)`; 100 integers; 100 reals; comments;
//! and the data. Each block begins with a line that says how many values or lines follow in which Fortran format, such as
//! `42000 acceleration pts, approx  210 secs, units=cm/sec2(04),Format=(1E15.6)`. Integer 3 is the code of the units (2 g, 4 cm/s², 10 gal), real 62 the
//! interval of the samples in ms. A file may have several channels, one after the other.

use super::{
    Found, RecordError, Units,
    error::shown,
    fixed::{self, Layout},
    peak,
    text::{Text, contains, first_number},
    units,
};

/// Within so many lines of a channel its first block begins.
const TEXT_LINES: usize = 60;

/// Whether a file is one.
pub fn is(text: &Text<'_>) -> bool {
    contains(text.line(1), "(Format v") && text.find(1, TEXT_LINES, "Integer-header values follow").is_some()
}

/// Reads a channel: the only one unless told which.
pub fn read(text: &Text<'_>, channel: Option<usize>) -> Result<Found, RecordError> {
    let starts = || text.from(1).filter(|(_, line)| contains(line, "(Format v")).map(|(line, _)| line);
    let start = one_of(starts(), channel)?;
    Channel::of(text, start)?.read()
}

/// The start of a channel: of the only one, or of the one that is asked.
pub fn one_of(starts: impl Iterator<Item = usize>, channel: Option<usize>) -> Result<usize, RecordError> {
    let starts: Vec<usize> = starts.collect();
    let asked = channel.or((starts.len() == 1).then_some(1));
    let start = asked.and_then(|asked| starts.get(asked.checked_sub(1)?));
    start.copied().ok_or_else(|| {
        let said = channel.map_or_else(String::new, |asked| format!(", and column = {asked} asks for none of them"));
        let number = starts.len();
        let message = format!("the file has {number} channels{said}; expected is column = 1 to {number} in the scene");
        RecordError::whole(message)
    })
}

/// A channel with its headers.
struct Channel<'t, 'a> {
    text: &'t Text<'a>,
    integers: Vec<f64>,
    reals: Vec<f64>,
    reals_line: usize,
    /// The line that announces the data.
    data: usize,
}

impl<'t, 'a> Channel<'t, 'a> {
    fn of(text: &'t Text<'a>, start: usize) -> Result<Self, RecordError> {
        let integers_line = text.find(start, TEXT_LINES, "Integer-header").unwrap_or(start);
        let (integers, reals_line) = block(text, integers_line, "Integer-header values follow")?;
        let (reals, comments_line) = block(text, reals_line, "Real-header values follow")?;
        let data = comments_line + 1 + announced(text, comments_line, "Comment line(s) follow")?;
        Ok(Self { text, integers, reals, reals_line, data })
    }

    fn read(&self) -> Result<Found, RecordError> {
        let said = self.text.line(self.data);
        let count = announced(self.text, self.data, "acceleration pts")?;
        let units = self.units(said)?;
        let layout = layout(self.data, said)?;
        let first = self.data + 1;
        let samples = fixed::read(self.text, first, count, self.data, layout)?;
        let after = first + layout.lines(count);
        let end = self.text.line(after);
        if !end.is_empty() && !contains(end, "End-of-data") && !contains(end, "End of data") {
            return Err(RecordError::at(
                after,
                format!("`{}`; expected is End-of-data after {count} values", shown(end)),
            ));
        }
        let level = if self.integers.first() == Some(&1.0) { "COSMOS V1" } else { "COSMOS V2" };
        let notes =
            self.real(64).and_then(|peak| peak::differs(peak, 1e-6, self.reals_line, &samples)).into_iter().collect();
        let dt = self.real(62).filter(|interval| *interval > 0.0).map(|interval| (interval / 1000.0, self.reals_line));
        Ok(Found {
            format: level,
            dt,
            units: Some((units, self.data)),
            samples,
            start: first,
            notes,
            has_offset: false,
        })
    }

    /// A real of the header, unless it stands for what is not known.
    fn real(&self, number: usize) -> Option<f64> {
        self.reals.get(number - 1).copied().filter(|value| ![-999.0, -9999.0].contains(value))
    }

    /// The units, by their code, and as the line before the data says.
    fn units(&self, said: &[u8]) -> Result<Units, RecordError> {
        let code = self.integers.get(2).copied().unwrap_or_default();
        let of_code = match code as i64 {
            2 => Some(Units::G),
            4 | 10 => Some(Units::CentimetresPerSecondSquared),
            _ => None,
        };
        let of_line = units::of_line(said).map(|(named, _)| named.known(self.data)).transpose()?;
        match (of_line, of_code) {
            (Some(line), Some(code)) if line != code => {
                let message = format!(
                    "the units are {line}, and {code} by the third integer of the header; expected is the same"
                );
                Err(RecordError::at(self.data, message))
            }
            (Some(units), _) | (None, Some(units)) => Ok(units),
            (None, None) => Err(units::other(self.data, format!("code {code}").as_bytes())),
        }
    }
}

/// The number that a line announces.
fn announced(text: &Text<'_>, line: usize, what: &str) -> Result<usize, RecordError> {
    let content = text.line(line);
    let number = first_number(content).filter(|(number, _)| contains(content, what) && *number >= 0.0);
    number
        .map(|(number, _)| number as usize)
        .ok_or_else(|| RecordError::at(line, format!("`{}`; expected is a number and {what}", shown(content))))
}

/// The layout that a line announces.
fn layout(line: usize, content: &[u8]) -> Result<Layout, RecordError> {
    Layout::of(content).ok_or_else(|| {
        RecordError::at(line, format!("`{}`; expected is a Fortran format such as (8F10.5)", shown(content)))
    })
}

/// Reads a block of header values; and the line after it.
fn block(text: &Text<'_>, line: usize, what: &str) -> Result<(Vec<f64>, usize), RecordError> {
    let count = announced(text, line, what)?;
    let layout = layout(line, text.line(line))?;
    Ok((fixed::read(text, line + 1, count, line, layout)?, line + 1 + layout.lines(count)))
}
