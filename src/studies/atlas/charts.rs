//! The charts, each drawn from one of the files.

use crate::studies::chart::{Axis, Chart, Error, HeatMap, HeatPanel, LineChart, Mark, Panel, Table};

/// All of them.
pub const CHARTS: [Chart; 7] = [
    Chart { name: "atlas_velocity_thresholds.svg", table: "atlas.csv", draw: velocity_thresholds },
    Chart { name: "atlas_interval_thresholds.svg", table: "atlas.csv", draw: interval_thresholds },
    Chart { name: "atlas_solvers.svg", table: "atlas.csv", draw: solvers },
    Chart { name: "atlas_time_stepping.svg", table: "atlas.csv", draw: time_stepping },
    Chart { name: "atlas_oracles.svg", table: "atlas.csv", draw: oracles },
    Chart { name: "atlas_resolved.svg", table: "atlas.csv", draw: resolved },
    Chart { name: "atlas_depth.svg", table: "atlas_depth.csv", draw: depth },
];

/// Kind, setting, and the title of the panel.
type Choice = (&'static str, &'static str, &'static str);

/// Where errors end.
const FLOOR: f64 = 1e-16;

fn panels(table: &Table, column: &str, choices: &[Choice]) -> Result<Vec<HeatPanel>, Error> {
    let panel = |(family, setting, title): &Choice| {
        let rows = table.filter("family", family)?.filter("setting", setting)?;
        let cells = rows.cells("place", "eta", column)?;
        Ok(HeatPanel::new(*title, cells).with_marks(vec![Mark::at(0.0, "a_{cr}")]))
    };
    choices.iter().map(panel).collect()
}

/// The distance to the critical amplitude, by decades to either side of it: logarithmic both ways.
fn place() -> Axis {
    let tick = |decade: i32| {
        let (sign, place) = (if decade < 0 { "−" } else { "" }, f64::from(decade));
        (place, format!("{sign}10^{{−{}}}", 9 - decade.abs()))
    };
    Axis::linear("(a − a_{cr})/(a_{cr} − 1): left of a_{cr} the chattering is complete, right of it incomplete")
        .with_ticks([-8, -5, -2, 2, 5, 8].map(tick).into())
}

fn map(table: &Table, title: &str, caption: &str, choices: &[Choice]) -> Result<String, Error> {
    HeatMap {
        title: title.into(),
        caption: caption.into(),
        x: place(),
        y: Axis::linear("η"),
        colour: Axis::log("error: left of a_{cr} of τ_{ch}, right of it of the response after T/2")
            .with_range(FLOOR, 1.0),
        columns: 2,
        missing: vec!["no answer: lost, hangs or declines".into()],
        panels: panels(table, "error", choices)?,
    }
    .svg()
}

fn velocity_thresholds(table: &Table) -> Result<String, Error> {
    const OF: &str = "velocity threshold";
    map(
        table,
        "At rest below a velocity",
        "Left: the lower the threshold, the later the rest, and the smaller the error of the chattering time. Right: dark is right; elsewhere a block \
         is put to rest that rocks on, which near a_{cr} hardly shows after T/2, and further away changes the response altogether (Fig. 11).",
        &[
            (OF, "1e-1", "φ′ ≤ 10⁻¹"),
            (OF, "1e-2", "φ′ ≤ 10⁻²"),
            (OF, "1e-4", "φ′ ≤ 10⁻⁴"),
            (OF, "1e-6", "φ′ ≤ 10⁻⁶"),
            (OF, "1e-9", "φ′ ≤ 10⁻⁹"),
            (OF, "1e-12", "φ′ ≤ 10⁻¹²"),
        ],
    )
}

fn interval_thresholds(table: &Table) -> Result<String, Error> {
    const ONE: &str = "interval threshold";
    const TWO: &str = "threshold of two intervals";
    map(
        table,
        "At rest below an interval",
        "Flights of one sign are much shorter than those of the other, so a threshold on one interval stops far earlier than the same on two in a row. \
         Right: dark is right; elsewhere a block is put to rest that rocks on.",
        &[
            (ONE, "1e-2", "one below 10⁻²"),
            (ONE, "1e-4", "one below 10⁻⁴"),
            (ONE, "1e-8", "one below 10⁻⁸"),
            (TWO, "1e-2", "two below 10⁻²"),
            (TWO, "1e-4", "two below 10⁻⁴"),
            (TWO, "1e-8", "two below 10⁻⁸"),
        ],
    )
}

fn solvers(table: &Table) -> Result<String, Error> {
    const ZERO: &str = "one clock, state zero";
    const LIFTED: &str = "one clock, state lifted";
    const OLD: &str = "one clock, old step kept";
    map(
        table,
        "A general solver on one clock, without a threshold",
        "Left: whatever the tolerance and whatever starts a flight, the solver (diffsol, Tsit45) finds no end to the chattering: it hangs, falls through the base, or \
         rocks on (yellow). Right: started with its old step it falls through the base nearly everywhere.",
        &[
            (ZERO, "rtol 1e-6", "state zero, 10⁻⁶"),
            (LIFTED, "rtol 1e-6", "state lifted, 10⁻⁶"),
            (OLD, "rtol 1e-6", "old step kept, 10⁻⁶"),
            (ZERO, "rtol 1e-12", "state zero, 10⁻¹²"),
            (LIFTED, "rtol 1e-12", "state lifted, 10⁻¹²"),
            (OLD, "rtol 1e-12", "old step kept, 10⁻¹²"),
        ],
    )
}

fn time_stepping(table: &Table) -> Result<String, Error> {
    const OF: &str = "Moreau-Jean";
    map(
        table,
        "Time stepping, the ad hoc scheme, and Eq. 6 as printed",
        "Time stepping (Moreau and Jean) always answers, coarsely: it rattles where a block rests, and what is slower than that is hidden. The ad hoc scheme hangs where Eq. 65 is \
         later than the true time, or Eq. 76 below the true amplitude. Eq. 6 in absolute time finds no end.",
        &[
            (OF, "step 1e-2", "step 10⁻²"),
            (OF, "step 1e-3", "step 10⁻³"),
            (OF, "step 1e-4", "step 10⁻⁴"),
            (OF, "step 1e-6", "step 10⁻⁶"),
            ("ad hoc (Eqs 65 and 76)", "", "ad hoc (Eqs 65, 76)"),
            ("Eq. 6 in absolute time", "", "Eq. 6, absolute time"),
        ],
    )
}

fn oracles(table: &Table) -> Result<String, Error> {
    const OF: &str = "oracle";
    map(
        table,
        "The oracles",
        "The closed form and the solver with rescaled flights answer up to a_{cr} from both sides, as well as the conditioning there allows; the series \
         answer below a_{cr} and decline where they would be too far off.",
        &[
            (OF, "closed-form", "closed form"),
            (OF, "ode/linear/tsit45", "Tsit45, rescaled"),
            (OF, "ode/linear/bdf", "BDF, rescaled"),
            (OF, "asymptotic/paper", "series, Eq. 65"),
            (OF, "asymptotic/order-16", "series, 16 terms"),
            (OF, "asymptotic/resummed", "series, resummed"),
        ],
    )
}

fn resolved(table: &Table) -> Result<String, Error> {
    HeatMap {
        title: "How deep the sequence is followed".into(),
        caption: "The shortest interval up to which all are within 1 %. Oracles are asked for those down to 10⁻³⁰. On one clock a double can't tell \
                  apart impacts less than 10⁻¹⁶ apart, and most ways lose the sequence long before. Right of a_{cr} the sequence ends by \
                  itself where that of the last panel does."
            .into(),
        x: place(),
        y: Axis::linear("η"),
        colour: Axis::log("shortest interval resolved").with_range(1e-30, 1.0),
        columns: 2,
        missing: vec!["not even the first".into()],
        panels: panels(
            table,
            "shortest",
            &[
                ("Eq. 6 in absolute time", "", "Eq. 6, absolute time"),
                ("one clock, state zero", "rtol 1e-12", "one clock, state zero"),
                ("one clock, state lifted", "rtol 1e-12", "one clock, state lifted"),
                ("one clock, old step kept", "rtol 1e-12", "one clock, old step kept"),
                ("Moreau-Jean", "step 1e-6", "Moreau-Jean, step 10⁻⁶"),
                ("oracle", "ode/linear/tsit45", "Tsit45, rescaled"),
            ],
        )?,
    }
    .svg()
}

fn depth(table: &Table) -> Result<String, Error> {
    let groups = table.groups("share")?.into_iter();
    let panels = groups.map(|(share, rows)| {
        let series = rows.series("method", "interval", "error")?.into_iter().map(|series| series.with_least(FLOOR));
        Ok(Panel::new(format!("{share} of the way to the critical amplitude"), series.collect()))
    });
    LineChart {
        title: "Where the sequence is lost (ω = 2, η = 0.92)".into(),
        caption: "Time runs to the left. On one clock, and in Eq. 6 in absolute time, the error of an interval grows as the interval shrinks, with \
                  no sign of it; in units of each flight it does not."
            .into(),
        x: Axis::log("interval").with_range(1e-30, 1.0),
        y: Axis::log("relative error of the interval").with_range(FLOOR, 1e2),
        columns: 2,
        missing: "no impact any more".into(),
        panels: panels.collect::<Result<_, _>>()?,
    }
    .svg()
}
