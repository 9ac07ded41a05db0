//! Errors of Python: the line that the command would print.

use std::fmt::Display;

use pyo3::{PyErr, exceptions::PyValueError};

/// A `ValueError` with this line, numbers that are none as Python writes them.
pub fn value_error(line: impl Display) -> PyErr {
    PyValueError::new_err(line.to_string().replace("= NaN is", "= nan is"))
}

/// The same of a scene, without the number of the line of a file that nobody wrote.
pub fn scene_error(line: impl Display) -> PyErr {
    let line = line.to_string();
    let said = line
        .strip_prefix("line ")
        .and_then(|rest| rest.split_once(": "))
        .filter(|(number, _)| number.parse::<usize>().is_ok());
    value_error(said.map_or(line.as_str(), |(_, said)| said))
}
