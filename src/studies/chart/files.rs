//! From rows to files, and from files to charts.

use std::{
    collections::BTreeMap,
    fs,
    io::{self, ErrorKind},
    path::Path,
};

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
/// When a file can't be written or a chart can't be drawn; nothing is written then.
pub fn write(out: &Path, files: &BTreeMap<&'static str, String>, charts: &[Chart]) -> Result<String, Error> {
    let mut all: BTreeMap<String, String> =
        files.iter().map(|(name, text)| ((*name).to_owned(), text.clone())).collect();
    for chart in charts {
        let text = files.get(chart.table).map_or("", String::as_str);
        all.insert(chart.name.to_owned(), (chart.draw)(&Table::from_reader(chart.table, text.as_bytes())?)?);
    }
    place(out, &all)
}

/// Draws charts again from the tables that are in a folder already. The paths, one a line.
///
/// # Errors
/// When a table is not there, or a chart can't be drawn or written; nothing is written then.
pub fn redraw<'a>(out: &Path, charts: impl IntoIterator<Item = &'a Chart>) -> Result<String, Error> {
    let drawn = charts.into_iter().map(|chart| {
        let table = Table::read(out.join(chart.table))?;
        Ok((chart.name.to_owned(), (chart.draw)(&table)?))
    });
    place(out, &drawn.collect::<Result<_, Error>>()?)
}

/// Writes files into a folder that exists: beside where they go, and when they are whole to their places. The paths, one a line.
///
/// # Errors
/// When a file can't be written; nothing is, as far as that can be known before.
pub fn place(out: &Path, files: &BTreeMap<String, String>) -> Result<String, Error> {
    let failed = |path: &Path, source| Error::Write { file: path.display().to_string(), source };
    let beside = folder_in(out).map_err(|source| failed(out, source))?;
    if let Some(taken) = files.keys().map(|name| out.join(name)).find(|path| path.is_dir()) {
        return Err(failed(&taken, ErrorKind::IsADirectory.into()));
    }
    for (name, text) in files {
        fs::write(beside.path().join(name), text).map_err(|source| failed(&out.join(name), source))?;
    }
    let mut written = String::new();
    for name in files.keys() {
        let path = out.join(name);
        fs::rename(beside.path().join(name), &path).map_err(|source| failed(&path, source))?;
        written += &format!("{}\n", path.display());
    }
    Ok(written)
}

/// A folder in `out` for files that are not whole yet; it goes when it is dropped.
///
/// # Errors
/// When none can be made there: what the system says, without the name of that folder, which nobody typed.
pub fn folder_in(out: &Path) -> io::Result<tempfile::TempDir> {
    let folder = tempfile::Builder::new().prefix(".chattercheck-").tempdir_in(out);
    folder.map_err(|error| match error.to_string().split_once(" at path ") {
        Some((says, _)) => io::Error::new(error.kind(), says),
        None => error,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files() -> BTreeMap<String, String> {
        [("a.csv", "x\n1\n"), ("b.svg", "<svg/>")].map(|(name, text)| (name.to_owned(), text.to_owned())).into()
    }

    #[test]
    fn files_are_put_in_their_places_over_older_ones() {
        let out = tempfile::tempdir().unwrap();
        fs::write(out.path().join("a.csv"), "old").unwrap();
        let written = place(out.path(), &files()).unwrap();
        assert_eq!(written.lines().count(), 2);
        assert_eq!(fs::read_to_string(out.path().join("a.csv")).unwrap(), "x\n1\n");
        assert_eq!(fs::read_dir(out.path()).unwrap().count(), 2, "nothing is left beside them");
    }

    #[test]
    fn nothing_is_written_when_one_of_the_files_cannot_be() {
        let out = tempfile::tempdir().unwrap();
        fs::create_dir(out.path().join("b.svg")).unwrap();
        let error = place(out.path(), &files()).unwrap_err();
        assert!(error.to_string().contains("b.svg"), "{error}");
        assert_eq!(fs::read_dir(out.path()).unwrap().count(), 1);
        let absent = out.path().join("absent");
        assert!(place(&absent, &files()).unwrap_err().to_string().contains("absent"));
    }

    #[test]
    fn a_chart_that_cannot_be_drawn_leaves_no_table() {
        let out = tempfile::tempdir().unwrap();
        let draw: fn(&Table) -> Result<String, Error> = |table| table.numbers("y").map(|_| String::new());
        let files = BTreeMap::from([("a.csv", "x\n1\n".to_owned())]);
        assert!(write(out.path(), &files, &[Chart { name: "b.svg", table: "a.csv", draw }]).is_err());
        assert_eq!(fs::read_dir(out.path()).unwrap().count(), 0);
    }
}
