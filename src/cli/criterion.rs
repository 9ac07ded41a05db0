use std::path::PathBuf;

use anyhow::anyhow;
use chattercheck::{
    motion::{
        criterion::{Criterion, criteria},
        response::{Bout, Response, Termination},
    },
    panel,
};
use clap::Args;
use serde::Serialize;

use super::{
    Status,
    case_flags::read_scene_as,
    moment::Moment,
    output::{Format, note},
};

/// When it is certain that a block comes to rest: for each time of rocking, from which impact on, when rest comes, and when the ground pushes again
///
/// Impacts can accumulate only in a gap, while the ground acceleration is below the threshold. After each impact the pull towards the base is bounded over what is left;
/// where the bounds prove that infinitely many impacts fit into the gap, rest is certain, and so is when it comes, between two bounds. A push before it ends the gap: then
/// the chattering was incomplete there, and rest may come in a later gap.
#[derive(Args)]
pub(super) struct Arguments {
    /// The scene, in TOML; see `chattercheck scene`
    scene: PathBuf,
    /// The equation of motion, linear or nonlinear [default: the one that the scene asks for]
    #[arg(long, value_name = "MODEL")]
    model: Option<String>,
    /// Follow the block to this time at the most: tau, as in 2.5, or seconds, as in 2.5s
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    until: Option<Moment>,
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
    bouts: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    from: f64,
    to: f64,
    ending: &'static str,
    /// The impact from which on rest was certain; `null` if it never was.
    certain_from_impact: Option<usize>,
    certain_at: Option<f64>,
    /// The bounds on the time of rest that were proven then.
    rest_lower: Option<f64>,
    rest_upper: Option<f64>,
    /// When the ground pushes the block off again; `null` if it does not.
    gap_end: Option<f64>,
    /// What is left of the gap at rest.
    margin: Option<f64>,
    /// Whether a gap was missed before: incomplete chattering.
    missed_a_gap: bool,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let scene = read_scene_as(&arguments.scene, arguments.model.as_deref())?;
    let until = arguments.until.map(|until| until.tau(scene.block.frequency_parameter()));
    let request = scene.on_motion(until, Termination::Exact)?;
    let oracle = panel::stepper_on(&request.body, &request.motion);
    let declined = |decline| anyhow!("{} declines: {decline}", oracle.name());
    let response = Response::on_motion(oracle.as_ref(), &request).map_err(declined)?;
    let found = criteria(oracle.as_ref(), &request, &response).map_err(declined)?;
    let bouts = response.bouts.iter().zip(&found).map(|(bout, criterion)| row(bout, criterion)).collect();
    let answer = Answer { title: scene.title.clone(), frequency_parameter: scene.block.frequency_parameter(), bouts };
    arguments.format.print(&answer, text)?;
    note(format_args!("by the flights of {}", oracle.name()));
    Ok(Status::Well)
}

fn row(bout: &Bout, criterion: &Criterion) -> Row {
    let Criterion { certain, gap_end, missed_a_gap } = *criterion;
    let between = certain.and_then(|certain| certain.between);
    Row {
        from: bout.begin(),
        to: bout.end(),
        ending: bout.ending(),
        certain_from_impact: certain.map(|certain| certain.impact),
        certain_at: certain.map(|certain| certain.time),
        rest_lower: between.map(|(lower, _)| lower),
        rest_upper: between.map(|(_, upper)| upper),
        gap_end,
        margin: gap_end.map(|end| end - bout.end()),
        missed_a_gap,
    }
}

fn text(answer: &Answer) -> String {
    let Answer { title, frequency_parameter: p, bouts } = answer;
    let mut lines = vec![if title.is_empty() { "(no title)".to_owned() } else { title.clone() }];
    if bouts.is_empty() {
        lines.push("  the block never rocks".to_owned());
    }
    for Row {
        from, to, ending, certain_from_impact, certain_at, rest_lower, rest_upper, margin, missed_a_gap, ..
    } in bouts
    {
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
        lines.push(match margin {
            Some(margin) => format!("    the ground pushes again {:.6} s after it came to rest", margin / p),
            None if *ending == "complete" => "    the ground does not push again".to_owned(),
            None => continue,
        });
    }
    lines.join("\n")
}
