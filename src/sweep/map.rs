//! A table as a heat map: one of its columns over two of its axes, with a panel for each combination of the others.

use super::{Column, Sweep, column::NAMES_OF_ENDINGS};
use crate::studies::chart::{Axis, Cell, Error, HeatMap, HeatPanel, Table};

/// The most panels.
const MOST_PANELS: usize = 12;
/// The most cells.
const MOST_CELLS: usize = 100_000;

/// What is asked for, by name; `None` for what is usual.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Asked<'a> {
    /// The axis to the right; usually the last that has several values.
    pub x: Option<&'a str>,
    /// The axis upwards; usually the last but one.
    pub y: Option<&'a str>,
    /// The column that is shown; usually the first that is a number.
    pub column: Option<&'a str>,
    /// Whether the colours are spread by the logarithm.
    pub is_log: bool,
}

/// What is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    x: String,
    y: String,
    /// The axes whose combinations have a panel each.
    others: Vec<String>,
    column: Column,
    is_log: bool,
}

/// Why a sweep can't be drawn as it is asked: the option, what it was, and what is allowed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{option} = {value} is outside the allowed range: {allowed}")]
pub struct MapError {
    option: &'static str,
    value: String,
    allowed: String,
}

impl Drawing {
    /// What is asked for of a sweep.
    ///
    /// # Errors
    /// When an axis or a column is none, or there are too many panels or cells.
    pub fn choose(sweep: &Sweep, asked: Asked) -> Result<Self, MapError> {
        let wrong = |option, value: &str, allowed: String| MapError { option, value: value.to_owned(), allowed };
        let several = || sweep.points.axes().filter(|axis| axis.spread.count() > 1);
        if let Some(random) = several().find(|axis| axis.spread.is_random()) {
            return Err(wrong("svg", "a map", format!("a sweep on a grid, and axes.{} is random", random.name)));
        }
        let is_number = |name: &&str| {
            let axis = sweep.points.axes().find(|axis| axis.name == **name);
            axis.is_some_and(|axis| axis.spread.extremes().iter().all(|value| value.number().is_some()))
        };
        let places: Vec<&str> = several().map(|axis| axis.name.as_str()).filter(is_number).collect();
        let allowed = || {
            format!(
                "two axes of several numbers, of {}",
                if places.is_empty() { "which there are none".to_owned() } else { places.join(", ") }
            )
        };
        let axis = |option, named: Option<&str>, taken: Option<&str>| {
            let usual = || places.iter().rev().copied().find(|name| Some(*name) != taken);
            let name = named.or_else(usual).ok_or_else(|| wrong(option, "none", allowed()))?;
            if places.contains(&name) && Some(name) != taken {
                Ok(name.to_owned())
            } else {
                Err(wrong(option, name, allowed()))
            }
        };
        // One that is named is not taken for the other.
        let x = axis("x", asked.x, asked.y)?;
        let y = axis("y", asked.y, Some(&x))?;
        let drawn = || sweep.columns.iter().copied().filter(|column| column.label().is_some());
        let names = || drawn().map(Column::name).collect::<Vec<_>>().join(", ");
        let column = match asked.column {
            None => drawn().next().ok_or_else(|| wrong("column", "none", "a sweep that wants a number".to_owned()))?,
            Some(name) => drawn().find(|column| column.name() == name).ok_or_else(|| wrong("column", name, names()))?,
        };
        let others: Vec<&super::Axis> = several().filter(|axis| axis.name != x && axis.name != y).collect();
        let panels: usize = others.iter().map(|axis| axis.spread.count()).fold(1, usize::saturating_mul);
        if panels > MOST_PANELS {
            let value = format!("{x} and {y}");
            return Err(wrong(
                "svg",
                &value,
                format!("up to {MOST_PANELS} values of all other axes, and there are {panels}"),
            ));
        }
        let cells = sweep.points.count();
        if cells > MOST_CELLS {
            return Err(wrong("svg", &format!("{cells} points"), format!("up to {MOST_CELLS} points in a drawing")));
        }
        let others = others.into_iter().map(|axis| axis.name.clone()).collect();
        Ok(Self { x, y, others, column, is_log: asked.is_log })
    }

    /// The table of the sweep, drawn.
    ///
    /// # Errors
    /// When the table is not that of the sweep, or can't be drawn so.
    pub fn svg(&self, sweep: &Sweep, table: &Table) -> Result<String, Error> {
        let mut panels = vec![(Vec::new(), table.clone())];
        for other in &self.others {
            let mut finer = Vec::new();
            for (titles, rows) in panels {
                for (value, rows) in rows.groups(other)? {
                    finer.push(([&titles[..], &[format!("{} = {value}", named(other))]].concat(), rows));
                }
            }
            panels = finer;
        }
        let word = if self.column == Column::TauCh && table.texts(Column::TauChEnding.name()).is_ok() {
            Column::TauChEnding
        } else {
            Column::Ending
        };
        let panel = |(titles, rows): (Vec<String>, Table)| {
            let endings = rows.texts(word.name())?;
            let cells = rows.cells(&self.x, &self.y, self.column.name())?;
            let why = |ending: &str| NAMES_OF_ENDINGS.iter().position(|name| *name == ending).unwrap_or_default();
            let cells = cells.into_iter().zip(endings).map(|(cell, ending)| Cell { why: why(ending), ..cell });
            Ok(HeatPanel::new(titles.join(", "), cells.collect()))
        };
        let panels = panels.into_iter().map(panel).collect::<Result<Vec<_>, Error>>()?;
        let axis = |name: &str| {
            let is_log = sweep.points.axes().any(|axis| axis.name == name && axis.spread.is_log());
            if is_log { Axis::log(named(name)) } else { Axis::linear(named(name)) }
        };
        let label = self.column.label().unwrap_or_default();
        let title = if sweep.title.is_empty() { "A sweep".to_owned() } else { sweep.title.clone() };
        HeatMap {
            title,
            caption: format!("{} points; hatched: no value, for the reason named.", table.len()),
            x: axis(&self.x),
            y: axis(&self.y),
            colour: if self.is_log { Axis::log(label) } else { Axis::linear(label) },
            columns: 3,
            missing: NAMES_OF_ENDINGS.map(str::to_owned).to_vec(),
            panels,
        }
        .svg()
    }
}

/// An axis as it is called on paper.
fn named(axis: &str) -> &str {
    match axis {
        "epsilon" => "ε = a − 1",
        "omega" => "ω",
        "eta" => "η",
        "alpha" => "α (radians)",
        other => other,
    }
}
