//! Files of recorded ground motions.

use std::path::PathBuf;

use chattercheck::motion::record::{self, Asked, Step, Units};
use contract::Invalid;
use numpy::PyArray1;
use pyo3::{exceptions::PyFileNotFoundError, prelude::*, types::PyDict};

use crate::error::value_error;

/// Reads a file: the samples, the step in seconds, the units, the format and the notes.
#[pyfunction]
#[pyo3(signature = (path, units=None, dt=None, column=None))]
pub fn read_record<'py>(
    py: Python<'py>,
    path: PathBuf,
    units: Option<&str>,
    dt: Option<f64>,
    column: Option<usize>,
) -> PyResult<Bound<'py, PyDict>> {
    if !path.exists() {
        return Err(PyFileNotFoundError::new_err(format!(
            "{}: the record can't be read: it is not there",
            path.display()
        )));
    }
    let units = units.map(Units::named).transpose().map_err(value_error)?;
    if let Some(dt) = dt.filter(|dt| !(*dt > 0.0 && *dt <= 1e9)) {
        return Err(value_error(Invalid::new("dt", format!("{dt:?}"), "above 0, up to 1e9")));
    }
    if let Some(column) = column.filter(|column| !(1..=1000).contains(column)) {
        return Err(value_error(Invalid::new("column", column, "1 to 1000, the first being 1")));
    }
    let asked = Asked { units, step: dt.map_or(Step::OfFile, Step::Seconds), column };
    let read = py.detach(|| record::read_file(&path, &asked)).map_err(value_error)?;
    let found = PyDict::new(py);
    found.set_item("acc", PyArray1::from_vec(py, read.samples))?;
    found.set_item("dt", read.dt)?;
    found.set_item("units", read.units.to_string())?;
    found.set_item("format", read.format)?;
    found.set_item("notes", read.notes)?;
    Ok(found)
}
