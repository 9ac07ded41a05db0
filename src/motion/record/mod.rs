//! Recorded ground motions: the file of an earthquake database becomes samples of an acceleration.
//!
//! What is read is what the file says: sample `k` is at `k dt`, in the units of the file. Nothing is corrected, filtered, resampled or converted.
//! Units and time step are taken from the file or from who asks, never guessed; where both name them and differ, that is an error that names both.
//!
//! | format | how it is known | described in |
//! | --- | --- | --- |
//! | PEER AT2 | a line with `NPTS` and `DT` before the numbers | `at2.rs` |
//! | SMC (USGS) | a first line such as `2 CORRECTED ACCELEROGRAM` | `smc.rs` |
//! | COSMOS V1, V2 | `(Format v01.20 ..)` in the first line | `cosmos.rs` |
//! | CSMIP V2 (the older volume 2 of California) | `points of accel data equally spaced at` | `csmip.rs` |
//! | K-NET, KiK-net | `Scale Factor` among the 17 header lines | `knet.rs` |
//! | numbers in rows or columns, CSV | none of these | `rows.rs`, `table.rs` |

mod at2;
mod cells;
mod cosmos;
mod csmip;
mod error;
mod file;
mod fixed;
mod header;
mod knet;
mod number;
mod peak;
mod plain;
mod refuse;
mod rows;
mod smc;
mod table;
mod text;
mod time_column;
mod titles;
mod units;

#[cfg(test)]
mod tests;

pub use error::RecordError;
pub use file::{line_of_sample, read_file};
pub use units::Units;

use text::Text;

/// The largest file that is read, in bytes.
pub const MOST_BYTES: usize = 200_000_000;
/// The most samples of a record.
pub const MOST_SAMPLES: usize = 10_000_000;

/// What is known about a record without its file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Asked {
    /// The units of the samples; `None` if the file has to name them.
    pub units: Option<Units>,
    /// The time step.
    pub step: Step,
    /// Which column of a table holds the acceleration, counted from 1; in a file of several channels, which channel.
    pub column: Option<usize>,
}

/// What is known about the time step without the file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Step {
    /// Nothing: the file has to give it.
    #[default]
    OfFile,
    /// It is so many seconds; a file that gives another is refused.
    Seconds(f64),
    /// Who asks has one in another unit (such as `τ`): the file need not give one.
    Elsewhere,
}

/// A record as its file has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Recorded {
    /// The time step in seconds, of the file, of its column of times, or as asked; `None` only where [`Step::Elsewhere`] was asked.
    pub dt: Option<f64>,
    /// The units of the samples, of the file or as asked.
    pub units: Units,
    /// The accelerations at `k dt`, in `units`; at least two.
    pub samples: Vec<f64>,
    /// The line of the file that gives the step, where one does.
    pub dt_line: Option<usize>,
    /// The line of the first sample.
    pub start: usize,
    /// The name of the format.
    pub format: &'static str,
    /// What a reader should know: an offset that is not removed, times that do not begin at 0.
    pub notes: Vec<String>,
}

/// What a format finds in a file, before it is compared with what was asked.
#[derive(Debug, Default)]
struct Found {
    format: &'static str,
    /// With the line that gives it.
    dt: Option<(f64, usize)>,
    /// With the line that names it.
    units: Option<(Units, usize)>,
    samples: Vec<f64>,
    /// The line of the first sample.
    start: usize,
    notes: Vec<String>,
    /// Whether the file is known to hold an offset, which is then always told.
    has_offset: bool,
}

/// Reads a recorded ground motion.
///
/// # Errors
/// What is wrong with the file, in one line: the line of the file, what stands there, and what is expected.
pub fn read(bytes: &[u8], asked: &Asked) -> Result<Recorded, RecordError> {
    refuse::other_than_text(bytes)?;
    let text = Text::new(bytes);
    let one = |found: Found| one_series(found, asked.column);
    let found = if knet::is(&text) {
        one(knet::read(&text)?)?
    } else if cosmos::is(&text) {
        cosmos::read(&text, asked.column)?
    } else if csmip::is(&text) {
        csmip::read(&text, asked.column)?
    } else if smc::is(&text) {
        one(smc::read(&text)?)?
    } else {
        plain::read(&text, asked)?
    };
    agree(found, asked)
}

/// The first line from one on that has a number of this value, and the number as it is typed.
fn line_with(text: &Text<'_>, from: usize, value: f64) -> Option<(usize, String)> {
    text.from(from).find_map(|(line, content)| {
        let is_it = |field: &&[u8]| number::value(field) == Some(value);
        rows::fields(content).find(is_it).map(|field| (line, error::shown(field)))
    })
}

/// Refuses a column that is asked of a file with only one series.
fn one_series(found: Found, column: Option<usize>) -> Result<Found, RecordError> {
    match column {
        None | Some(1) => Ok(found),
        Some(asked) => Err(RecordError::whole(format!(
            "column = {asked} is asked, and the file ({}) has one series; expected is no column",
            found.format
        ))),
    }
}

/// Compares what the file says with what was asked.
fn agree(found: Found, asked: &Asked) -> Result<Recorded, RecordError> {
    let Found { format, dt, units, samples, start, mut notes, has_offset } = found;
    let dt_line = dt.map(|(_, line)| line);
    let units = units::agree(units, asked.units)?;
    let dt = time_column::agree(dt, asked.step)?;
    match samples.len() {
        0 | 1 => return Err(RecordError::whole(format!("{} numbers; a record has at least 2", samples.len()))),
        n if n > MOST_SAMPLES => return Err(error::too_many()),
        _ => notes.extend(peak::offset(&samples, units, has_offset)),
    }
    Ok(Recorded { dt, units, samples, dt_line, start, format, notes })
}
