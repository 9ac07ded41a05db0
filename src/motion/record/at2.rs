//! PEER AT2: some lines of prose, a line with `NPTS` and `DT`, and the accelerations in rows, usually in g.
//!
//! The PEER NGA-West2 database writes four header lines, of which the third names the units (`ACCELERATION TIME SERIES IN UNITS OF G`) and the fourth is
//! `NPTS=   8000, DT=   .0050 SEC`; older files have `4000 0.005 NPTS, DT` there (OpenSees, ReadSMDFile.tcl, knows both). Copies that went round have
//! more or fewer lines of prose, `dt=` in small letters, no `SEC`, marks around the data, and CR CR LF at the end of lines.

use super::{
    Found, RecordError,
    error::shown,
    header::{Counted, npts_dt},
    rows,
    text::Text,
    units,
};

/// Reads a file whose line with `NPTS` and `DT` is known.
pub fn read(text: &Text<'_>, line: usize) -> Result<Found, RecordError> {
    let counted: Counted = npts_dt(line, text.line(line))?;
    let first = rows::first(text, line + 1).unwrap_or(line + 1);
    rows::check_between(text, line + 1, first)?;
    let block = rows::numbers(text, first)?;
    counted.check(block.numbers.len(), block.last).map_err(|error| {
        let skipped = text.from(line + 1).take(first - line - 1).find(|(_, content)| !content.is_empty());
        error.and(skipped.map(|(line, content)| format!("; none is in line {line}, `{}`", shown(content))))
    })?;
    let units = units::of_header(&text.before(line + 1))?;
    Ok(Found {
        format: "PEER AT2",
        dt: Some((counted.dt, line)),
        units,
        samples: block.numbers,
        start: first,
        notes: block.end.into_iter().collect(),
        ..Found::default()
    })
}
