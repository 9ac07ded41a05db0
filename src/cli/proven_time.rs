//! The chattering time of a scene that is more than a case, as the judge proves it: that of its first rocking, by the road of `response --oracle enclosure`.

use anyhow::anyhow;
use chattercheck::motion::{response::Termination, scene::Scene};
use contract::{BoutEnd, Followed};

use super::{case_flags::CaseFlags, chattering_answer::Answer, motion_facts::Facts, oracle_flags::OracleFlags};

/// What is proven, if the judge is the oracle that is named and a scene is given that is more than a case; `None` otherwise.
///
/// # Errors
/// As [`of_scene`].
pub(super) fn of_more_than_a_case(
    flags: &CaseFlags,
    oracle: &OracleFlags,
    digits: Option<i64>,
) -> anyhow::Result<Option<Answer>> {
    let Some(scene) = flags.scene()? else { return Ok(None) };
    let is_case = scene.sine().is_ok() && scene.question()?.request.is_none();
    if is_case { Ok(None) } else { of_scene(flags, oracle, digits) }
}

/// What is proven, if the judge is the oracle that is named and a scene is given; `None` otherwise.
///
/// # Errors
/// When an option is not used, or the judge declines.
pub(super) fn of_scene(flags: &CaseFlags, oracle: &OracleFlags, digits: Option<i64>) -> anyhow::Result<Option<Answer>> {
    let Some(scene) = flags.scene()? else { return Ok(None) };
    let request = scene.on_motion(flags.until(), Termination::Exact)?;
    // The rest is found whatever the number of impacts that are listed.
    let asked = Followed { start: request.start, until: request.until, most_impacts: 1 };
    let to_prove = (&request.body, &*request.motion, &asked);
    let Some((name, bouts)) = oracle.proven_bouts(flags, digits, scene.ask.model, to_prove)? else { return Ok(None) };
    let bouts = bouts.map_err(|decline| anyhow!("{name} declines {}: {decline}", scene.ground_name()))?;
    let first = bouts.first();
    let time = first.and_then(|first| first.lasts.as_ref());
    let value = time.map(|time| time.estimate.value);
    let bounds = time.map(|time| time.bounds.clone());
    let (lower, upper) = bounds.map_or((None, None), |[lower, upper]| (Some(lower), Some(upper)));
    let end = first.map(|first| first.bout.end);
    Ok(Some(Answer {
        asked: Facts::of(&scene)?,
        rocks: first.is_some(),
        complete: match end {
            Some(BoutEnd::Rest(_)) => Some(true),
            Some(BoutEnd::Overturned | BoutEnd::Aloft) => Some(false),
            Some(BoutEnd::Undecided) | None => None,
        },
        tau_ch: value,
        uncertainty: time.map(|time| time.estimate.uncertainty),
        lower,
        upper,
        seconds: value.map(|time| time / scene.block.frequency_parameter()),
        half_period_fraction: value.zip(half_period(&scene)).map(|(time, half_period)| time / half_period),
        impacts: first.map_or(0, |first| first.bout.impacts.len()),
        oracle: name,
        method: time.map(|_| "proven bounds"),
        ending: match end {
            None => "never rocks",
            Some(BoutEnd::Rest(_)) => "complete",
            Some(BoutEnd::Overturned) => "overturned",
            Some(BoutEnd::Aloft) => "rocking",
            Some(BoutEnd::Undecided) => "undecided",
        }
        .to_owned(),
    }))
}

/// Only a sinusoid has a half period.
fn half_period(scene: &Scene) -> Option<f64> {
    let sine = scene.sine().ok()?;
    Some(std::f64::consts::PI / scene.block.omega(sine.frequency))
}
