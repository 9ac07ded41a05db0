//! The units of an acceleration, and where a header names them.

use std::fmt;

use super::{
    RecordError,
    error::shown,
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

/// What a word names, if it is a unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Named {
    /// A unit that is read.
    Known(Units),
    /// One that is not.
    Other,
}

/// The unit that a word is.
pub fn of_word(word: &[u8]) -> Option<Named> {
    let lower = word.to_ascii_lowercase();
    let word = std::str::from_utf8(&lower).ok()?;
    let word = word.trim_end_matches('.').replace("sec", "s").replace("**", "^").replace("²", "2");
    let squared = |length: &str| {
        let rest = word.strip_prefix(length);
        rest.is_some_and(|rest| ["/s2", "/s^2", "/s/s", "/s2/s0", "/(s^2)", "*s^-2", " s-2"].contains(&rest))
    };
    Some(match word.as_str() {
        "g" | "g's" | "gs" => Named::Known(Units::G),
        "gal" | "gals" => Named::Known(Units::CentimetresPerSecondSquared),
        _ if squared("cm") => Named::Known(Units::CentimetresPerSecondSquared),
        _ if squared("m") => Named::Known(Units::MetresPerSecondSquared),
        other if OTHERS.contains(&other) => Named::Other,
        _ => return None,
    })
}

/// The unit that a line names, as in `UNITS OF G`, `units=cm/sec2(04)`, `The units are (g)`, or, more weakly, `Accel[g]`; whether it speaks of units,
/// and the word.
pub fn of_line(line: &[u8]) -> Option<(Named, bool, &[u8])> {
    if let Some(place) = text::place_of(line, "unit") {
        let rest = line.get(place..).unwrap_or_default();
        return parts(rest).take(8).find_map(|word| of_word(word).map(|named| (named, true, word)));
    }
    bracketed(line).find_map(|word| match of_word(word) {
        Some(Named::Known(units)) => Some((Named::Known(units), false, word)),
        _ => None,
    })
}

/// The unit that a title such as `Accel[g]` or `acc_ns (cm/s2)` has in brackets.
pub fn of_title(title: &[u8]) -> Option<(Named, &[u8])> {
    bracketed(title).find_map(|word| of_word(word).map(|named| (named, word)))
}

/// The unit that some header lines name, with the line. A line that speaks of units counts more than one in brackets.
pub fn of_header(lines: &[Numbered<'_>]) -> Result<Option<(Units, usize)>, RecordError> {
    for speaks in [true, false] {
        let mut found: Option<(Units, usize)> = None;
        for &(number, line) in lines {
            match (of_line(line), found) {
                (Some((_, said, _)), _) if said != speaks => {}
                (Some((Named::Other, _, word)), _) => return Err(other(number, word)),
                (Some((Named::Known(units), ..)), None) => found = Some((units, number)),
                (Some((Named::Known(units), ..)), Some((before, at))) if units != before => {
                    return Err(RecordError::at(
                        number,
                        format!(
                            "the file says that its units are {units}, and {before} at line {at}; expected is one of them"
                        ),
                    ));
                }
                _ => {}
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
