use std::path::PathBuf;

use anyhow::{anyhow, ensure};
use chattercheck::{
    motion::{
        certainty::Changes,
        criterion::{Crossing, Crossings, crossings},
        response::Termination,
    },
    panel,
};
use clap::{Args, ValueEnum};
use contract::Invalid;
use serde::Serialize;

use super::{
    Status,
    case_flags::read_scene_as,
    flight_flags::FlightFlags,
    numbers::number,
    output::{Format, note},
};

/// How much stronger or weaker a motion has to be for the block to overturn, and for its chattering to be incomplete
///
/// The scale multiplies the whole ground acceleration of the scene. A range of scales is searched at 400 of them, and each change that shows is narrowed down to
/// neighbouring numbers: a block may survive a stronger shake than one that overturns it. By the responses themselves; what comes and goes between two of the 400
/// scales is not seen. The first change is proven from both sides by the judge where it can: then lower and upper are the nearest scales of which it is certain.
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
    #[command(flatten)]
    flights: FlightFlags,
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
    overturning: Changes,
    incomplete: Changes,
    from: f64,
    to: f64,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let Arguments { from, to, by: By::Scale, .. } = *arguments;
    let scene = read_scene_as(&arguments.scene, arguments.model.as_deref())?;
    ensure!((1e-6..=1e6).contains(&from), Invalid::new("from", format!("{from:?}"), "1e-6 to 1e6"));
    ensure!(to > from && to <= 1e6, Invalid::new("to", format!("{to:?}"), "above --from, up to 1e6"));
    let request = scene.on_motion(None, Termination::Exact)?;
    let oracle = arguments.flights.on_motion(scene.ask.model, &request)?;
    let Crossings { at_first, incomplete, overturned } =
        crossings(oracle.as_ref(), &request, (from, to)).map_err(|why| anyhow!("{}: {why}", oracle.name()))?;
    let judge = panel::judge_of(scene.ask.model);
    let judged = judge.as_deref().map(|judge| (judge, &request));
    let answer = Answer {
        title: scene.title.clone(),
        overturning: Changes::of(at_first.overturned, overturned, judged, |fate| fate.overturned),
        incomplete: Changes::of(at_first.incomplete, incomplete, judged, |fate| fate.incomplete),
        from,
        to,
    };
    arguments.format.print(&answer, text)?;
    note(format_args!("by the flights of {}", oracle.name()));
    Ok(Status::Well)
}

fn text(answer: &Answer) -> String {
    let Answer { title, overturning, incomplete, from, to } = answer;
    let mut lines = vec![if title.is_empty() { "(no title)".to_owned() } else { title.clone() }];
    for (of, happens, does_not) in [
        (incomplete, "some chattering is incomplete", "all chattering is complete"),
        (overturning, "the block overturns", "the block does not overturn"),
    ] {
        let Changes { happens_at_from, changes, .. } = of;
        let said = |is: bool| if is { happens } else { does_not };
        lines.push(format!("  at {from} times the motion {}", said(*happens_at_from)));
        for (place, Crossing { upper, happens_above, .. }) in changes.iter().enumerate() {
            lines.push(format!("  from {upper} times on {}", said(*happens_above)));
            if let (0, true, Some(below), Some(above)) = (place, of.certified, of.lower, of.upper) {
                lines.push(format!("    proven: not at {below} times, and at {above} times"));
            }
        }
        lines.push(format!("  up to {to} times"));
    }
    lines.join("\n")
}
