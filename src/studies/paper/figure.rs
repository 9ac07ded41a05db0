use super::Error;
use crate::studies::chart::{self, Table};

/// A figure of the paper: a table, and what is drawn from it.
pub struct Figure {
    /// The name of its table without the ending, as in `fig_3a`.
    pub name: &'static str,
    /// Measures its rows: the text of the table.
    pub measure: fn() -> Result<String, Error>,
    /// The name of each chart and what draws it from the table.
    pub charts: &'static [(&'static str, Draw)],
}

/// Draws a chart from a table.
pub type Draw = fn(&Table) -> Result<String, chart::Error>;
