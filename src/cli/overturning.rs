use std::path::PathBuf;

use anyhow::{anyhow, ensure};
use chattercheck::{
    motion::{
        criterion::{Crossing, Fate, crossings},
        response::Termination,
    },
    panel,
};
use clap::{Args, ValueEnum};
use contract::Invalid;
use serde::Serialize;

use super::{
    Status,
    case_flags::read_scene,
    numbers::number,
    output::{Format, note},
};

/// How much stronger or weaker a motion has to be for the block to overturn, and for its chattering to be incomplete
///
/// The scale multiplies the whole ground acceleration of the scene. A range of scales is searched at 400 of them, and each change that shows is narrowed down to
/// neighbouring numbers: a block may survive a stronger shake than one that overturns it. By the responses themselves; it is not certified, and what comes and goes between
/// two of the 400 scales is not seen.
#[derive(Args)]
pub(super) struct Arguments {
    /// The scene, in TOML; see `chattercheck scene`
    scene: PathBuf,
    /// What is varied
    #[arg(long, value_enum, default_value_t = By::Scale)]
    by: By,
    /// From which scale
    #[arg(long, value_name = "S", allow_hyphen_values = true, value_parser = number, default_value = "0.1")]
    from: f64,
    /// To which scale
    #[arg(long, value_name = "S", allow_hyphen_values = true, value_parser = number, default_value = "10")]
    to: f64,
    /// The equation of motion, linear or nonlinear [default: the one that the scene asks for]
    #[arg(long, value_name = "MODEL")]
    model: Option<String>,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum By {
    /// The strength of the motion
    Scale,
}

#[derive(Serialize)]
struct Answer {
    title: String,
    /// Where the block begins to overturn, the smallest scale first; `null` if it does not in the range.
    overturning: Option<Row>,
    /// Where some chattering begins to be incomplete; `null` if it does not in the range.
    incomplete: Option<Row>,
    /// Every change in the range.
    overturning_changes: Vec<Row>,
    incomplete_changes: Vec<Row>,
    from: f64,
    to: f64,
}

#[derive(Serialize, Clone)]
struct Row {
    lower: f64,
    upper: f64,
    /// Whether it is proven that the change is between the two.
    certified: bool,
    /// Whether it happens above, or ceases to.
    happens_above: bool,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let Arguments { from, to, by: By::Scale, .. } = *arguments;
    let mut scene = read_scene(&arguments.scene)?;
    if let Some(name) = &arguments.model {
        scene.ask.model = panel::model_named(name)?;
    }
    ensure!((1e-6..=1e6).contains(&from), Invalid::new("from", format!("{from:?}"), "1e-6 to 1e6"));
    ensure!(to > from && to <= 1e6, Invalid::new("to", format!("{to:?}"), "above --from, up to 1e6"));
    let request = scene.on_any_motion(None, Termination::Exact)?;
    let oracle = panel::stepper_on(&request.body, &request.motion);
    let changes = |fate| {
        crossings(oracle.as_ref(), &request, fate, (from, to)).map_err(|why| anyhow!("{}: {why}", oracle.name()))
    };
    let rows = |crossings: Vec<Crossing>| -> Vec<Row> {
        let row = |Crossing { lower, upper, happens_above }| Row { lower, upper, certified: false, happens_above };
        crossings.into_iter().map(row).collect()
    };
    let (overturning_changes, incomplete_changes) =
        (rows(changes(Fate::Overturned)?), rows(changes(Fate::Incomplete)?));
    let first = |rows: &[Row]| rows.iter().find(|row| row.happens_above).cloned();
    let answer = Answer {
        title: scene.title.clone(),
        overturning: first(&overturning_changes),
        incomplete: first(&incomplete_changes),
        overturning_changes,
        incomplete_changes,
        from,
        to,
    };
    arguments.format.print(&answer, text)?;
    note(format_args!("by the flights of {}; not certified", oracle.name()));
    Ok(Status::Well)
}

fn text(answer: &Answer) -> String {
    let Answer { title, overturning_changes, incomplete_changes, from, to, .. } = answer;
    let mut lines = vec![if title.is_empty() { "(no title)".to_owned() } else { title.clone() }];
    for (changes, begins, ceases) in [
        (incomplete_changes, "some chattering is incomplete from", "all chattering is complete again from"),
        (overturning_changes, "the block overturns from", "it does not overturn from"),
    ] {
        if changes.is_empty() {
            lines.push(format!("  {begins}: no change between {from} and {to} times the motion"));
        }
        for Row { upper, happens_above, .. } in changes {
            lines.push(format!("  {} {upper} times the motion on", if *happens_above { begins } else { ceases }));
        }
    }
    lines.join("\n")
}
