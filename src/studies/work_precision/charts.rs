//! The charts, each drawn from the file.

use crate::studies::chart::{Axis, Chart, Draw, Error, LineChart, Panel, Point, Series, Table};

/// All of them.
pub const CHARTS: [Chart; 6] = [
    Chart { name: "work_chattering_time.svg", table: "work_precision.csv", draw: chattering_time },
    Chart { name: "work_impacts.svg", table: "work_precision.csv", draw: impacts },
    Chart { name: "work_solvers.svg", table: "work_precision.csv", draw: solvers },
    Chart { name: "work_solvers_seconds.svg", table: "work_precision.csv", draw: solvers_seconds },
    Chart { name: "work_solvers_chattering_time.svg", table: "work_precision.csv", draw: solvers_chattering_time },
    Chart { name: "work_impact_40.svg", table: "work_precision.csv", draw: impact_40 },
];

/// Simulators of somebody else, beside a few of the others.
pub const BESIDE: Chart = Chart { name: "profile_work.svg", table: "profile_work.csv", draw: beside };

/// Where errors end.
const FLOOR: f64 = 1e-16;
const SECONDS: &str = "seconds on this machine";
const OF_TAU_CH: &str = "relative error of the chattering time";
const OF_IMPACT_40: &str = "relative error of the time of impact 40";

/// A panel for each distance, with the series whose names begin with one of `families`.
fn panels(table: &Table, families: &[&str], x: &str, y: &str) -> Result<Vec<Panel>, Error> {
    let groups = table.groups("share")?.into_iter();
    let panel = |(share, rows): (String, Table)| {
        let mut series = Vec::new();
        for (family, rows) in rows.groups("family")? {
            if families.iter().any(|wanted| family.starts_with(wanted)) {
                // The settings of a peer are ways to use it and no sequence.
                let draw = if family.ends_with("(peer)") { Draw::Markers } else { Draw::Both };
                series.push(Series::new(family, points(&rows, x, y)?).with_draw(draw).with_least(FLOOR));
            }
        }
        Ok(Panel::new(format!("{share} of the way to the critical amplitude"), series))
    };
    groups.map(panel).collect()
}

/// The settings that have such a cost: with an error, or failed. One without either was not asked for this number.
fn points(rows: &Table, x: &str, y: &str) -> Result<Vec<Point>, Error> {
    let places = rows.numbers(x)?.into_iter().zip(rows.numbers(y)?).zip(rows.texts("outcome")?);
    let asked = |((x, y), outcome): ((Option<f64>, Option<f64>), &str)| {
        (y.is_some() || !outcome.is_empty()).then_some(Point { x: x?, y })
    };
    Ok(places.filter_map(asked).collect())
}

fn chart(
    table: &Table,
    title: &str,
    caption: &str,
    families: &[&str],
    (x, label): (&str, &str),
    (y, error): (&str, &str),
) -> Result<String, Error> {
    LineChart {
        title: format!("{title} (ω = 2, η = 0.92)"),
        caption: caption.into(),
        x: Axis::log(label),
        y: Axis::log(error).with_range(FLOOR, 10.0),
        columns: 3,
        missing: "failed".into(),
        panels: panels(table, families, x, y)?,
    }
    .svg()
}

fn chattering_time(table: &Table) -> Result<String, Error> {
    chart(
        table,
        "What the chattering time costs",
        "A point a setting: impacts of the closed form, terms of the series, tolerances of the solver, digits of the enclosure (its proven width), \
         thresholds from 10⁻¹ to 10⁻¹², steps from 10⁻² to 10⁻⁶. Coefficients of the series are computed anew for each value.",
        &[
            "closed form, Eq. 75",
            "closed form, higher orders",
            "velocity threshold",
            "series by order",
            "series, resummed",
            "tsit45, rescaled",
            "Moreau-Jean",
            "enclosure",
        ],
        ("seconds", SECONDS),
        ("tau_ch_error", OF_TAU_CH),
    )
}

fn impacts(table: &Table) -> Result<String, Error> {
    chart(
        table,
        "How many impacts the chattering time takes",
        "All flights are those of the closed form; only the end differs: the sum closed by one geometric ratio (Eq. 75) or by its higher orders, or cut \
         off where a velocity, or two intervals in a row, are below a threshold.",
        &["closed form", "velocity threshold", "threshold of two intervals"],
        ("impacts", "impacts"),
        ("tau_ch_error", OF_TAU_CH),
    )
}

/// diffsol in every way, and time stepping.
const SOLVERS: [&str; 8] = [
    "tsit45, rescaled",
    "bdf, rescaled",
    "tr-bdf2, rescaled",
    "esdirk34, rescaled",
    "tsit45, one clock, zero",
    "tsit45, one clock, lifted",
    "tsit45, one clock, old step",
    "Moreau-Jean",
];

const OF_SOLVERS: &str = "diffsol at tolerances from 10⁻³ to 10⁻¹², each flight in its own units or all on one clock, and time stepping with steps from \
                          10⁻² to 10⁻⁶. The cost is that of the impacts that close the sum (80, 120 and 200). Crosses: it never got there.";

fn solvers(table: &Table) -> Result<String, Error> {
    chart(
        table,
        "General solvers to impact 40",
        OF_SOLVERS,
        &SOLVERS,
        ("rhs", "evaluations of the right-hand side"),
        ("impact_40_error", OF_IMPACT_40),
    )
}

fn solvers_seconds(table: &Table) -> Result<String, Error> {
    chart(
        table,
        "General solvers to impact 40",
        OF_SOLVERS,
        &SOLVERS,
        ("seconds", SECONDS),
        ("impact_40_error", OF_IMPACT_40),
    )
}

fn solvers_chattering_time(table: &Table) -> Result<String, Error> {
    chart(
        table,
        "General solvers to the chattering time",
        OF_SOLVERS,
        &SOLVERS,
        ("rhs", "evaluations of the right-hand side"),
        ("tau_ch_error", OF_TAU_CH),
    )
}

fn impact_40(table: &Table) -> Result<String, Error> {
    chart(
        table,
        "What impact 40 costs, beside other tools",
        "Peers: numba, heyoka.py, SUNDIALS CVODE and SciPy, each in several ways (benches/peers), where their rows were given. The cost is that \
         of the impacts that close the sum (80, 120 and 200; of the closed form 10 to 400), of the enclosure 40.",
        &["closed form, higher orders", "tsit45, rescaled", "enclosure", "numba", "heyoka", "SUNDIALS", "SciPy"],
        ("seconds", SECONDS),
        ("impact_40_error", OF_IMPACT_40),
    )
}

fn beside(table: &Table) -> Result<String, Error> {
    chart(
        table,
        "What the chattering time costs an engine",
        "All on this machine. A point a setting: impacts of the closed form, tolerances of the solver; an engine has one, the best of some questions, as it \
         reports its time or else as seen from outside. Crosses: no chattering time.",
        &[""],
        ("seconds", SECONDS),
        ("tau_ch_error", OF_TAU_CH),
    )
}
