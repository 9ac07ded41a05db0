//! The units of an acceleration, and where a header names them.

use std::fmt;

use contract::Invalid;

use super::{
    RecordError,
    error::shown,
    number,
    text::{self, Numbered},
};

/// The units of the samples of a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Units {
    /// The acceleration of gravity.
    G,
    /// m/s².
    MetresPerSecondSquared,
    /// cm/s², which is a gal.
    CentimetresPerSecondSquared,
    /// The threshold of the block: no file names it.
    Threshold,
}

impl Units {
    /// The units of this name.
    ///
    /// # Errors
    /// When it is none.
    pub fn named(name: &str) -> Result<Self, Invalid> {
        match name {
            "g" => Ok(Self::G),
            "m/s2" => Ok(Self::MetresPerSecondSquared),
            "cm/s2" => Ok(Self::CentimetresPerSecondSquared),
            "threshold" => Ok(Self::Threshold),
            other => {
                let shown: String = other.chars().filter(|c| !c.is_control()).take(40).collect();
                Err(Invalid::new("units", format!("{shown:?}"), "\"g\", \"m/s2\", \"cm/s2\" or \"threshold\""))
            }
        }
    }
}

impl fmt::Display for Units {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::G => "g",
            Self::MetresPerSecondSquared => "m/s2",
            Self::CentimetresPerSecondSquared => "cm/s2",
            Self::Threshold => "threshold",
        })
    }
}

/// The units that the file and who asks agree on.
pub fn agree(file: Option<(Units, usize)>, asked: Option<Units>) -> Result<Units, RecordError> {
    match (file, asked) {
        (Some((file, line)), Some(asked)) if file != asked => Err(RecordError::at(
            line,
            format!("the file says that its units are {file}, the scene units = \"{asked}\"; expected is the same"),
        )),
        (Some((units, _)), _) | (None, Some(units)) => Ok(units),
        (None, None) => Err(RecordError::whole(
            "the file does not name its units; expected is units = \"g\", \"m/s2\", \"cm/s2\" or \"threshold\" in the scene",
        )),
    }
}

/// The units of what is no acceleration, or of one that is not read.
const OTHERS: [&str; 24] = [
    "cm/s", "cm/sec", "m/s", "m/sec", "mm/s", "mm/sec", "in/s", "in/sec", "cm", "mm", "m", "in", "inch", "inches",
    "mm/s2", "mm/s^2", "mm/sec2", "mm/s/s", "in/s2", "in/s^2", "in/sec2", "ft/s2", "mg", "counts",
];

/// Those of them that are accelerations.
const OTHER_ACCELERATIONS: [&str; 8] = ["mm/s2", "mm/s^2", "mm/sec2", "mm/s/s", "in/s2", "in/s^2", "in/sec2", "ft/s2"];

/// What some words name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Named<'a> {
    /// A unit that is read.
    Known(Units),
    /// One that is not.
    Other(&'a [u8]),
    /// Two that contradict each other.
    Two(&'a [u8], &'a [u8]),
}

impl Named<'_> {
    /// The unit, if it is one that is read.
    ///
    /// # Errors
    /// Otherwise, with what stands in the line.
    pub fn known(self, line: usize) -> Result<Units, RecordError> {
        match self {
            Self::Known(units) => Ok(units),
            Self::Other(word) => Err(other(line, word)),
            Self::Two(one, another) => Err(RecordError::at(
                line,
                format!("two units are named, `{}` and `{}`; expected is one of them", shown(one), shown(another)),
            )),
        }
    }
}

/// The unit that a word is.
pub fn of_word(word: &[u8]) -> Option<Named<'_>> {
    let plain = plain(word)?;
    let squared = |length: &str| {
        let rest = plain.strip_prefix(length);
        rest.is_some_and(|rest| ["/s2", "/s^2", "/s/s", "/s2/s0", "/(s^2)", "*s^-2", " s-2"].contains(&rest))
    };
    Some(match plain.as_str() {
        "g" | "g's" | "gs" => Named::Known(Units::G),
        "gal" | "gals" => Named::Known(Units::CentimetresPerSecondSquared),
        _ if squared("cm") => Named::Known(Units::CentimetresPerSecondSquared),
        _ if squared("m") => Named::Known(Units::MetresPerSecondSquared),
        other if OTHERS.contains(&other) => Named::Other(word),
        _ => return None,
    })
}

/// A word in small letters, with seconds and squares written in one way.
fn plain(word: &[u8]) -> Option<String> {
    let lower = word.to_ascii_lowercase();
    let word = std::str::from_utf8(&lower).ok()?;
    Some(word.trim_end_matches('.').replace("sec", "s").replace("**", "^").replace("²", "2"))
}

/// The unit that some words name: the first of them, if no later one is of another acceleration. A number in front makes a multiple of a first one, which is
/// no unit, and a quantity of a later one, as in `peak 0.3 g`.
pub fn of_words<'a>(words: impl Iterator<Item = &'a [u8]>) -> Option<Named<'a>> {
    let is_acceleration = |word: &[u8]| plain(word).is_some_and(|word| OTHER_ACCELERATIONS.contains(&word.as_str()));
    let mut found: Option<(Units, &[u8])> = None;
    let mut factor = None;
    for word in words {
        match (of_word(word), found, factor) {
            (Some(Named::Known(_)), None, Some(factor)) => return Some(Named::Other(factor)),
            (Some(Named::Known(units)), None, None) => found = Some((units, word)),
            (Some(other), None, _) => return Some(other),
            (Some(Named::Known(units)), Some((before, first)), None) if units != before => {
                return Some(Named::Two(first, word));
            }
            (Some(Named::Other(_)), Some((_, first)), None) if is_acceleration(word) => {
                return Some(Named::Two(first, word));
            }
            _ => {}
        }
        factor = number::value(word).filter(|factor| *factor != 1.0).map(|_| word);
    }
    found.map(|(units, _)| Named::Known(units))
}

/// The unit that a line names, as in `UNITS OF G`, `units=cm/sec2(04)`, `The units are (g)`, or, more weakly, `Accel[g]`; and whether it speaks of units.
pub fn of_line(line: &[u8]) -> Option<(Named<'_>, bool)> {
    if let Some(place) = text::place_of(line, "unit") {
        let rest = line.get(place..).unwrap_or_default();
        return of_words(parts(rest).take(8)).map(|named| (named, true));
    }
    let known = bracketed(line).filter(|word| matches!(of_word(word), Some(Named::Known(_))));
    of_words(known).map(|named| (named, false))
}

/// The unit that a title such as `Accel[g]` or `acc_ns (cm/s2)` has in brackets.
pub fn of_title(title: &[u8]) -> Option<Named<'_>> {
    of_words(bracketed(title))
}

/// The unit that some header lines name, with the line. A line that speaks of units counts more than one in brackets.
pub fn of_header(lines: &[Numbered<'_>]) -> Result<Option<(Units, usize)>, RecordError> {
    for speaks in [true, false] {
        let mut found: Option<(Units, usize)> = None;
        for &(number, line) in lines {
            let Some((named, _)) = of_line(line).filter(|(_, said)| *said == speaks) else { continue };
            let units = named.known(number)?;
            match found {
                Some((before, at)) if units != before => {
                    let message = format!(
                        "the file says that its units are {units}, and {before} at line {at}; expected is one of them"
                    );
                    return Err(RecordError::at(number, message));
                }
                _ => found = found.or(Some((units, number))),
            }
        }
        if found.is_some() {
            return Ok(found);
        }
    }
    Ok(None)
}

/// A unit that is not read.
pub fn other(line: usize, word: &[u8]) -> RecordError {
    RecordError::at(line, format!("the units are `{}`; expected is an acceleration in g, m/s2 or cm/s2", shown(word)))
}

/// What stands in brackets.
fn bracketed(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|byte| b"([{".contains(byte))
        .skip(1)
        .filter_map(|rest| rest.split(|byte| b")]}".contains(byte)).next())
        .map(<[u8]>::trim_ascii)
}

/// What stands between blanks, brackets and signs.
fn parts(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|byte| byte.is_ascii_whitespace() || b"()[]{}=:,;\"'".contains(byte)).filter(|part| !part.is_empty())
}
