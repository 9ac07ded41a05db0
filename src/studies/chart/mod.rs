//! Charts as SVG, drawn from CSV files that were already written: what a chart shows and what a test asserts are the same rows.
//!
//! [`Table`] reads the file; [`LineChart`], [`HeatMap`] and [`Strips`] are descriptions that their `svg` draws. Nothing
//! is measured or computed here. The same description gives the same SVG, byte for byte.
//!
//! What went wrong stays visible: an empty number is a failure, drawn as a cross above the axes or as a hatched cell, never left out.
//!
//! Every text may hold subscripts, `a_{cr}`, superscripts, `ε^{3/2}`, and no-break spaces where a line must not end.
//!
//! ```
//! use chattercheck::studies::chart::{Axis, LineChart, Mark, Panel, Table};
//!
//! # fn main() -> Result<(), chattercheck::studies::chart::Error> {
//! let csv = "eta,method,a,error\n0.9,exact,1.01,1e-16\n0.9,exact,1.02,2e-16\n0.9,series,1.01,1e-3\n0.9,series,1.02,\n";
//! let table = Table::from_reader("errors.csv", csv.as_bytes())?;
//! let mut panels = Vec::new();
//! for (eta, rows) in table.groups("eta")? {
//!     let panel = Panel::new(format!("η = {eta}"), rows.series("method", "a", "error")?);
//!     panels.push(panel.with_marks(vec![Mark::at(1.038, "a_{cr}")]));
//! }
//! let chart = LineChart {
//!     title: "Error of the chattering time".into(),
//!     caption: "Crosses: the series does not converge.".into(),
//!     x: Axis::linear("a"),
//!     y: Axis::log("relative error of τ_{ch}/(T/2)"),
//!     columns: 3,
//!     missing: "declined".into(),
//!     panels,
//! };
//! assert!(chart.svg()?.starts_with("<svg"));
//! # Ok(())
//! # }
//! ```

mod axis;
mod canvas;
mod caption;
mod colour;
mod colour_bar;
mod colour_map;
mod error;
mod files;
mod frame;
mod geometry;
mod heat;
mod legend;
mod lines;
mod mark;
mod marker;
mod number;
mod palette;
mod series;
mod sheet;
mod strips;
mod stroke;
mod table;
mod text;
mod thin;
mod ticks;

pub use axis::{Axis, Scale};
pub use error::{Error, csv_in_words};
pub use files::{Chart, csv_text, folder_in, place, redraw, write};
pub use heat::{Cell, HeatMap, HeatPanel};
pub use lines::{LineChart, Panel};
pub use mark::Mark;
pub use series::{Draw, Point, Series};
pub use strips::{Right, Shade, Strip, Strips};
pub use table::Table;
