//! The response as the judge proves it: when the block rocks and rests, between bounds. It has no table and no drawing.

use anyhow::anyhow;
use chattercheck::{
    motion::{response::Termination, scene::Scene},
    panel::ProvenBout,
};
use contract::{Bout, BoutEnd, Followed, Invalid};
use serde::Serialize;

use super::{
    super::{
        Status,
        output::{json, note, print, say},
    },
    Arguments, Format, Scheme,
    drawings::Files,
    typed,
};

/// How many impacts are listed unless told otherwise: none are asked for.
const LISTED: usize = 1;

#[derive(Serialize)]
struct Answer<'a> {
    title: &'a str,
    oracle: String,
    /// What the proof is of.
    proven_of: &'static str,
    frequency_parameter: f64,
    bouts: Vec<Row>,
}

/// A scene becomes numbers over the threshold and over `τ`, and a named pulse the sinusoids that it is the sum of.
const PROVEN_OF: &str = "the block and the motion with their numbers rounded to doubles";

/// Times are `τ` since the start of the motion; bounds are decimals, rounded outward.
#[derive(Serialize)]
struct Row {
    from: f64,
    from_lower: String,
    from_upper: String,
    /// When the block rests; `null` where it does not, or that is undecided.
    to: Option<f64>,
    lower: Option<String>,
    upper: Option<String>,
    ending: &'static str,
    /// The first impacts, as many as are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    impact_times: Option<Vec<f64>>,
    /// `φ'` just after each of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    impact_velocities: Option<Vec<f64>>,
}

/// Answers by the judge, if that is the oracle that is named; `None` if it is not.
///
/// # Errors
/// When an option is not used, or the judge declines.
pub(super) fn run(arguments: &Arguments, scene: &Scene, files: &Files) -> anyhow::Result<Option<Status>> {
    if !arguments.flights.names_an_oracle() {
        return Ok(None);
    }
    let until = arguments.until.map(|until| until.tau(scene.block.frequency_parameter()));
    let request = scene.on_motion(until, Termination::Exact)?;
    let asked =
        Followed { start: request.start, until: request.until, most_impacts: arguments.impacts.unwrap_or(LISTED) };
    let Some((oracle, bouts)) =
        arguments.flights.proven(scene.ask.model, arguments.digits, (&request.body, &request.motion, &asked))?
    else {
        return Ok(None);
    };
    if let Some((field, value)) = unused(arguments, files) {
        return Err(Invalid::new(field, value, "only with an oracle that follows flights, not with enclosure").into());
    }
    let bouts = bouts.map_err(|decline| anyhow!("{oracle} declines: {decline}"))?;
    let rows: Vec<Row> = bouts.iter().map(|bout| row(bout, arguments.impacts.is_some())).collect();
    let is_open = bouts.iter().any(|proven| proven.bout.end == BoutEnd::Undecided);
    let frequency_parameter = scene.block.frequency_parameter();
    let answer = Answer { title: &scene.title, oracle, proven_of: PROVEN_OF, frequency_parameter, bouts: rows };
    match arguments.format {
        Some(Format::Json) => print(&json(&answer, false)?)?,
        Some(Format::JsonLine) => print(&json(&answer, true)?)?,
        Some(Format::Text | Format::Csv) | None => say(&(text(&answer) + "\n"))?,
    }
    if is_open {
        note("undecided with the digits that are tried: too near to where the ending changes, or too many impacts");
    }
    Ok(Some(Status::Well))
}

/// The first option that a proof does not use, and its value.
fn unused(arguments: &Arguments, files: &Files) -> Option<(&'static str, String)> {
    let is_scheme = arguments.termination != Scheme::Exact;
    let is_csv = matches!(arguments.format, Some(Format::Csv));
    let options = [
        ("termination", is_scheme.then(|| typed(arguments.termination))),
        ("velocity-threshold", arguments.velocity_threshold.map(|threshold| threshold.to_string())),
        ("condition", arguments.condition.map(typed)),
        ("closing", arguments.closing.map(typed)),
        ("from", arguments.from.map(|moment| moment.to_string())),
        ("to", arguments.to.map(|moment| moment.to_string())),
        ("steps", arguments.steps.map(|steps| steps.to_string())),
        ("drawing", (!files.is_empty()).then(|| "--svg or --html".to_owned())),
        ("format", is_csv.then(|| "csv".to_owned())),
    ];
    options.into_iter().find_map(|(field, value)| Some((field, value?)))
}

fn row(ProvenBout { bout, begin, rest, .. }: &ProvenBout, lists: bool) -> Row {
    let Bout { begin: from, impacts, end, .. } = bout;
    let [from_lower, from_upper] = begin.clone();
    let (lower, upper) = rest.clone().map_or((None, None), |[lower, upper]| (Some(lower), Some(upper)));
    Row {
        from: from.value,
        from_lower,
        from_upper,
        to: if let BoutEnd::Rest(at) = end { Some(at.value) } else { None },
        lower,
        upper,
        ending: match end {
            BoutEnd::Rest(_) => "complete",
            BoutEnd::Overturned => "overturned",
            BoutEnd::Aloft => "rocking",
            BoutEnd::Undecided => "undecided",
        },
        impact_times: lists.then(|| impacts.iter().map(|impact| impact.time).collect()),
        impact_velocities: lists.then(|| impacts.iter().map(|impact| impact.velocity).collect()),
    }
}

fn text(Answer { title, oracle, proven_of, bouts, .. }: &Answer) -> String {
    let title = if title.is_empty() { "(no title)" } else { title };
    let mut lines = vec![format!("{title}, proven by {oracle} of {proven_of}; times are tau")];
    for Row { from_lower, from_upper, lower, upper, ending, .. } in bouts {
        lines.push(format!("  rocks from {from_lower}\n          to {from_upper}"));
        lines.push(match (lower, upper) {
            (Some(lower), Some(upper)) => format!("  rests from {lower}\n          to {upper}"),
            _ => format!("  ending     {ending}"),
        });
    }
    if bouts.is_empty() {
        lines.push("  never rocks".to_owned());
    }
    lines.join("\n")
}
