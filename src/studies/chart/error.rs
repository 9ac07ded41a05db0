//! What can be wrong with a table or a chart.

use thiserror::Error as ThisError;

/// Why a table can't be read or a chart can't be drawn.
#[derive(Debug, ThisError)]
pub enum Error {
    /// The file can't be opened or isn't CSV.
    #[error("{file} cannot be read as a table: {how}")]
    Csv {
        /// The file.
        file: String,
        /// What is wrong, see [`csv_in_words`].
        how: String,
    },
    /// The file can't be written.
    #[error("cannot write {file}")]
    Write {
        /// The file.
        file: String,
        /// What the system says.
        source: std::io::Error,
    },
    /// The table has no such column.
    #[error("{file}: no column {column:?}; there are {}", if present.is_empty() { "none".to_owned() } else { present.join(", ") })]
    NoColumn {
        /// The file.
        file: String,
        /// The column that was asked for.
        column: String,
        /// The columns that are there.
        present: Vec<String>,
    },
    /// A field should be a number and isn't.
    #[error("{file}, line {line}, column {column:?}: {value:?} is not a number")]
    NotANumber {
        /// The file.
        file: String,
        /// The line in the file, the first being 1.
        line: u64,
        /// The column.
        column: String,
        /// What stands there.
        value: String,
    },
    /// A place on an axis is empty or not finite, so that the row can't be shown even as a failure.
    #[error("{file}, line {line}, column {column:?}: a finite number is needed to place the row")]
    NoPlace {
        /// The file.
        file: String,
        /// The line in the file, the first being 1.
        line: u64,
        /// The column.
        column: String,
    },
    /// A value has no place on a logarithmic axis.
    #[error("chart {chart:?}: {value:e} in {of:?} has no place on the logarithmic scale {axis:?}")]
    NotPositive {
        /// The title of the chart.
        chart: String,
        /// The series, panel or mark that it is in.
        of: String,
        /// The label of the axis.
        axis: String,
        /// The value.
        value: f64,
    },
    /// The range of an axis is empty, not finite, or not positive on a logarithmic scale.
    #[error("chart {chart:?}: {low:e} to {high:e} is no range for the scale {axis:?}")]
    Range {
        /// The title of the chart.
        chart: String,
        /// The label of the axis.
        axis: String,
        /// The lower end.
        low: f64,
        /// The upper end.
        high: f64,
    },
    /// There are no panels or no points.
    #[error("chart {chart:?}: nothing to draw")]
    Nothing {
        /// The title of the chart.
        chart: String,
    },
    /// A place is not a finite number.
    #[error("chart {chart:?}: {value} in {of:?} is no place on the axis {axis:?}")]
    NotFinite {
        /// The title of the chart.
        chart: String,
        /// The series, panel or mark that it is in.
        of: String,
        /// The label of the axis.
        axis: String,
        /// The value.
        value: f64,
    },
    /// Two cells of a heat map have the same place.
    #[error("chart {chart:?}, panel {panel:?}: two cells at ({x}, {y})")]
    CellTwice {
        /// The title of the chart.
        chart: String,
        /// The title of the panel.
        panel: String,
        /// The place along the first axis.
        x: f64,
        /// The place along the second axis.
        y: f64,
    },
}

/// What is wrong with a file as CSV with a head, in the words of who wrote it.
pub fn csv_in_words(error: &csv::Error) -> String {
    let line = |position: &Option<csv::Position>| position.as_ref().map_or(0, csv::Position::line);
    match error.kind() {
        csv::ErrorKind::Io(error) => error.to_string(),
        csv::ErrorKind::Utf8 { .. } => "not a text (UTF-8)".to_owned(),
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            format!("line {}: columns = {len} are outside the allowed: {expected_len}, as in the head", line(pos))
        }
        _ => "not CSV with a head".to_owned(),
    }
}
