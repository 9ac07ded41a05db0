use std::path::PathBuf;

use anyhow::{anyhow, ensure};
use chattercheck::{
    motion::{
        criterion::{Told, criteria, critical_scale},
        response::{Response, Termination},
    },
    panel,
};
use clap::Args;
use contract::Invalid;
use serde::Serialize;

use super::{
    Status,
    case_flags::read_scene_as,
    flight_flags::FlightFlags,
    moment::Moment,
    numbers::number,
    output::{Format, note},
};

/// When it is certain that a block comes to rest: for each time of rocking, from which impact on, when rest comes, and when the ground pushes again
///
/// Impacts can accumulate only in a gap, while the ground acceleration is below the threshold. After each impact the pull towards the base is bounded over what is left;
/// where the bounds prove that infinitely many impacts fit into the gap, rest is certain, and so is when it comes, between two bounds; they are wider by what rounding may have
/// done to the flights before. A push before it ends the gap: then the chattering was incomplete there, and rest may come in a later gap.
///
/// Beside it stands what the local series of one impact alone said, from the first impact on at which it is trusted. At last the scale of the motion is looked for, from 1 on,
/// at which some chattering becomes incomplete: among 400 scales, and then to neighbouring numbers, by the fastest flights. It is not certified:
/// `overturning` proves such changes from both sides where it can.
#[derive(Args)]
pub(super) struct Arguments {
    /// The scene, in TOML; see `chattercheck scene`
    scene: PathBuf,
    /// The equation of motion, linear or nonlinear [default: the one that the scene asks for]
    #[arg(long, value_name = "MODEL")]
    model: Option<String>,
    #[command(flatten)]
    flights: FlightFlags,
    /// Follow the block to this time at the most: tau, as in 2.5, or seconds, as in 2.5s
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    until: Option<Moment>,
    /// To which scale of the motion it is looked for incomplete chattering
    #[arg(long, value_name = "S", allow_hyphen_values = true, value_parser = number, default_value = "2")]
    to_scale: f64,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// Times are `τ` since the start of the motion.
#[derive(Serialize)]
struct Answer {
    title: String,
    /// `p`, 1/s: a time over it is in seconds.
    frequency_parameter: f64,
    bouts: Vec<Told>,
    incomplete: Incomplete,
}

/// How much stronger the motion has to be for some chattering to be incomplete.
#[derive(Serialize)]
struct Incomplete {
    /// The scale from which on is between these, both 1 if it is so already; `null` where it is not found.
    lower: Option<f64>,
    upper: Option<f64>,
    searched_to: f64,
    /// Whether that is proven: never here, see `overturning`.
    certified: bool,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let scene = read_scene_as(&arguments.scene, arguments.model.as_deref())?;
    let most = arguments.to_scale;
    ensure!(most > 1.0 && most <= 1e6, Invalid::new("to-scale", format!("{most:?}"), "above 1, up to 1e6"));
    let until = arguments.until.map(|until| until.tau(scene.block.frequency_parameter()));
    let request = scene.on_motion(until, Termination::Exact)?;
    let oracle = arguments.flights.on_motion(scene.ask.model, &request)?;
    let declined = |decline| anyhow!("{} declines: {decline}", oracle.name());
    let response = Response::on_motion(oracle.as_ref(), &request).map_err(declined)?;
    let closing = panel::closing();
    let found = criteria((oracle.as_ref(), closing.as_ref()), &request, &response).map_err(declined)?;
    // Hundreds of responses: by the fastest flights, whoever is named for the one that is told of.
    let fastest = panel::stepper_on(&request.body, &request.motion);
    let critical =
        critical_scale(fastest.as_ref(), &request, most).map_err(|why| anyhow!("{}: {why}", fastest.name()))?;
    let bouts = response.bouts.iter().zip(&found).map(|(bout, criterion)| criterion.told(bout)).collect();
    let answer = Answer {
        title: scene.title.clone(),
        frequency_parameter: scene.block.frequency_parameter(),
        bouts,
        incomplete: Incomplete {
            lower: critical.map(|crossing| crossing.lower),
            upper: critical.map(|crossing| crossing.upper),
            searched_to: most,
            certified: false,
        },
    };
    arguments.format.print(&answer, text)?;
    note(format_args!("by the flights of {}", oracle.name()));
    Ok(Status::Well)
}

fn text(answer: &Answer) -> String {
    let Answer { title, frequency_parameter: p, bouts, incomplete } = answer;
    let mut lines = vec![if title.is_empty() { "(no title)".to_owned() } else { title.clone() }];
    if bouts.is_empty() {
        lines.push("  the block never rocks".to_owned());
    }
    for bout in bouts {
        let Told {
            from,
            to,
            ending,
            certain_from_impact,
            certain_at,
            rest_lower,
            rest_upper,
            margin,
            missed_a_gap,
            ..
        } = bout;
        lines.push(format!("  rocks from {:.6} s to {:.6} s (tau = {from} to {to}): {ending}", from / p, to / p));
        if *missed_a_gap {
            lines.push("    it was still rocking when the ground pushed again: a gap was missed".to_owned());
        }
        if let (Some(impact), Some(at)) = (certain_from_impact, certain_at) {
            let between = rest_lower.zip(*rest_upper);
            let between = between
                .map_or(String::new(), |(low, high)| format!(", and that it comes between tau = {low} and {high}"));
            lines.push(format!("    rest was certain from impact {impact} on, at {:.6} s{between}", at / p));
        }
        lines.extend(prediction(bout));
        lines.push(match margin {
            Some(margin) => format!("    the ground pushes again {:.6} s after it came to rest", margin / p),
            None if *ending == "complete" => "    the ground does not push again".to_owned(),
            None => continue,
        });
    }
    let Incomplete { lower, upper, searched_to, .. } = incomplete;
    lines.push(match (lower, upper) {
        (Some(lower), Some(upper)) if lower == upper => "  some chattering is incomplete as it is".to_owned(),
        (_, Some(upper)) => format!("  from {upper} times the motion on some chattering is incomplete"),
        _ => format!("  up to {searched_to} times the motion all chattering is complete"),
    });
    lines.join("\n")
}

/// What the series said, and what came.
fn prediction(bout: &Told) -> Option<String> {
    let (impact, uncertainty) = (bout.predicted_from_impact?, bout.predicted_uncertainty?);
    let (predicted, left) = (bout.predicted_left?, bout.true_left?);
    let off = predicted - left;
    Some(format!(
        "    impact {impact} alone says that tau = {predicted} is left until then, to {uncertainty:.0e}; the flights say {:.0e} {}",
        off.abs(),
        if off > 0.0 { "less" } else { "more" },
    ))
}
