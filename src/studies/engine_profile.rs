//! The profiles of engines as tables, and as charts drawn from these: errors against depth, the sides of the critical amplitude, endings, speed.

use std::collections::BTreeMap;

use serde::Serialize;

use super::chart::{Axis, Chart, Draw, Error, LineChart, Panel, Point, Series, Table, csv_text};
use crate::gate::profile::{Profile, Side};

/// The charts.
pub const CHARTS: [Chart; 2] = [
    Chart { name: "profile_depth.svg", table: "profile_depth.csv", draw: depth_chart },
    Chart { name: "profile_sides.svg", table: "profile_sides.csv", draw: sides_chart },
];

/// How long right answers of an engine took.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Speed {
    /// How many answers.
    pub answers: usize,
    /// How many impacts they list.
    pub impacts: usize,
    /// How long they took as seen from outside, in seconds.
    pub seconds: f64,
    /// The impacts of those for which the engine says how long it took...
    pub own_impacts: usize,
    /// ...and how long that is, in seconds.
    pub own_seconds: f64,
}

impl Speed {
    /// Impacts a second as seen from outside.
    pub fn outside(&self) -> Option<f64> {
        (self.seconds > 0.0).then(|| self.impacts as f64 / self.seconds)
    }

    /// Impacts a second as the engine reports them.
    pub fn own(&self) -> Option<f64> {
        (self.own_seconds > 0.0).then(|| self.own_impacts as f64 / self.own_seconds)
    }
}

/// An engine: its name, its profile and its speed.
pub struct Profiled<'a> {
    /// The name.
    pub name: &'a str,
    /// The profile.
    pub profile: &'a Profile,
    /// The speed.
    pub speed: Speed,
}

#[derive(Serialize)]
struct DepthRow<'a> {
    engine: &'a str,
    from: usize,
    to: usize,
    compared: usize,
    right: usize,
    lacking: usize,
    half_within: Option<f64>,
    worst: Option<f64>,
}

#[derive(Serialize)]
struct SideRow<'a> {
    engine: &'a str,
    side: &'static str,
    distance: f64,
    right: usize,
    wrong: usize,
    other_side: usize,
    share_right: f64,
}

#[derive(Serialize)]
struct EndingRow<'a> {
    engine: &'a str,
    ends: &'a str,
    answers: usize,
    right: usize,
    open: usize,
    wrong: usize,
}

#[derive(Serialize)]
struct SpeedRow<'a> {
    engine: &'a str,
    right_answers: usize,
    impacts: usize,
    impacts_per_second_outside: Option<f64>,
    impacts_per_second_own: Option<f64>,
}

/// The tables.
///
/// # Errors
/// Never, as far as rows of numbers and names can be written.
pub fn files(engines: &[Profiled]) -> Result<BTreeMap<&'static str, String>, csv::Error> {
    let depth: Vec<DepthRow> = engines.iter().flat_map(depth_rows).collect();
    let sides: Vec<SideRow> = engines.iter().flat_map(side_rows).collect();
    let endings: Vec<EndingRow> = engines.iter().flat_map(ending_rows).collect();
    let speed: Vec<SpeedRow> = engines.iter().map(speed_row).collect();
    Ok(BTreeMap::from([
        ("profile_depth.csv", csv_text(&depth)?),
        ("profile_sides.csv", csv_text(&sides)?),
        ("profile_endings.csv", csv_text(&endings)?),
        ("profile_speed.csv", csv_text(&speed)?),
    ]))
}

fn depth_rows<'a>(of: &'a Profiled<'a>) -> impl Iterator<Item = DepthRow<'a>> {
    of.profile.depth.iter().map(|depth| DepthRow {
        engine: of.name,
        from: depth.from,
        to: depth.to,
        compared: depth.intervals.count,
        right: depth.right,
        lacking: depth.lacking,
        half_within: depth.intervals.median(),
        worst: (depth.intervals.count > 0).then_some(depth.intervals.worst),
    })
}

fn side_rows<'a>(of: &'a Profiled<'a>) -> impl Iterator<Item = SideRow<'a>> {
    let sides: [(&'static str, &Side); 2] = [("below", &of.profile.sides.below), ("above", &of.profile.sides.above)];
    sides.into_iter().flat_map(move |(side, counted)| {
        counted.by_distance.iter().map(move |(decade, counts)| SideRow {
            engine: of.name,
            side,
            distance: 10.0_f64.powi(*decade),
            right: counts.right,
            wrong: counts.wrong,
            other_side: counts.turned,
            share_right: counts.right as f64 / (counts.right + counts.wrong).max(1) as f64,
        })
    })
}

fn ending_rows<'a>(of: &'a Profiled<'a>) -> impl Iterator<Item = EndingRow<'a>> {
    of.profile.endings.iter().map(|(ends, said)| EndingRow {
        engine: of.name,
        ends,
        answers: said.count(),
        right: said.right,
        open: said.open,
        wrong: said.wrong,
    })
}

fn speed_row<'a>(of: &Profiled<'a>) -> SpeedRow<'a> {
    SpeedRow {
        engine: of.name,
        right_answers: of.speed.answers,
        impacts: of.speed.impacts,
        impacts_per_second_outside: of.speed.outside(),
        impacts_per_second_own: of.speed.own(),
    }
}

/// Where errors end, and where they are as large as can be shown.
const FLOOR: f64 = 1e-17;
const LOST: f64 = 10.0;

fn depth_chart(table: &Table) -> Result<String, Error> {
    let panel = |(engine, rows): (String, Table)| {
        let series = |name: &str, column: &str| -> Result<Series, Error> {
            let (from, error) = (rows.numbers("from")?, rows.numbers(column)?);
            let points = from.into_iter().zip(error).filter_map(|(x, y)| Some(Point { x: x?, y: Some(y?.min(LOST)) }));
            Ok(Series::new(name, points.collect()).with_least(FLOOR))
        };
        Ok(Panel::new(engine, vec![series("half within", "half_within")?, series("worst", "worst")?]))
    };
    LineChart {
        title: "Errors of the intervals by depth".into(),
        caption: "Each point stands for the impacts from there to twice as deep: the power of ten within which half of the relative errors are, and the \
                  largest. An error of 1 and more is a sequence that was lost."
            .into(),
        x: Axis::log("impact"),
        y: Axis::log("relative error of the interval").with_range(FLOOR, LOST),
        columns: 2,
        missing: String::new(),
        panels: table.groups("engine")?.into_iter().map(panel).collect::<Result<_, Error>>()?,
    }
    .svg()
}

fn sides_chart(table: &Table) -> Result<String, Error> {
    let panel = |(engine, rows): (String, Table)| {
        let series = rows.series("side", "distance", "share_right")?;
        Ok(Panel::new(engine, series.into_iter().map(|series| series.with_draw(Draw::Both)).collect()))
    };
    LineChart {
        title: "Right answers next to the critical amplitude".into(),
        caption: "The share of right answers by the distance from a_{cr}, in powers of ten: below it the block comes to rest, above it it rocks on.".into(),
        x: Axis::log("|a − a_{cr}|/(a_{cr} − 1)"),
        y: Axis::linear("share of right answers").with_range(-0.05, 1.05),
        columns: 2,
        missing: String::new(),
        panels: table.groups("engine")?.into_iter().map(panel).collect::<Result<_, Error>>()?,
    }
    .svg()
}
