//! From rows to files, and from files to charts.

use std::{collections::BTreeMap, fs, path::Path};

use serde::Serialize;

use super::{Error, Table};

/// A chart and the file that it is drawn from.
pub struct Chart {
    /// The name of the SVG.
    pub name: &'static str,
    /// The name of the CSV.
    pub table: &'static str,
    /// Draws it.
    pub draw: fn(&Table) -> Result<String, Error>,
}

/// Rows as CSV, under the names of their fields.
///
/// # Errors
/// When a field of a row is no number, name or option of one.
pub fn csv_text<Row: Serialize>(rows: &[Row]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    let bytes = writer.into_inner().map_err(|error| error.into_error())?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Writes the files into a folder that exists and draws the charts from them, not from what made them. The paths, one a line.
///
/// # Errors
/// When a file can't be written or a chart can't be drawn.
pub fn write(out: &Path, files: &BTreeMap<&'static str, String>, charts: &[Chart]) -> Result<String, Error> {
    let mut written = String::new();
    let mut put = |name: &str, text: &str| {
        let path = out.join(name);
        fs::write(&path, text).map_err(|source| Error::Write { file: path.display().to_string(), source })?;
        written += &format!("{}\n", path.display());
        Ok::<_, Error>(())
    };
    files.iter().try_for_each(|(name, text)| put(name, text))?;
    charts.iter().try_for_each(|chart| put(chart.name, &(chart.draw)(&Table::read(out.join(chart.table))?)?))?;
    Ok(written)
}
