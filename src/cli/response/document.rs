//! What happens, as JSON.

use chattercheck::motion::{
    response::{Asked, Bout, Peak, Response},
    scene::{Account, Scene},
};
use contract::Model;
use serde::Serialize;

use super::super::{case_facts::CaseFacts, motion_facts::MotionFacts};

/// Times are `τ` since the start of the motion.
#[derive(Serialize)]
pub(super) struct Document<'a> {
    title: &'a str,
    model: &'static str,
    /// Of a sinusoid under a block at rest.
    #[serde(flatten)]
    case: Option<CaseFacts>,
    /// Of another motion.
    #[serde(flatten)]
    motion: Option<MotionFacts>,
    /// `p`, 1/s: a time over it is in seconds.
    frequency_parameter: f64,
    /// In seconds, degrees and g.
    summary: &'a Account,
    /// The largest rotation; `null` if the block never rocks.
    peak: Option<PeakRow>,
    bouts: Vec<BoutRow>,
    rests: Vec<RestRow>,
    end: f64,
}

#[derive(Serialize)]
struct PeakRow {
    tau: f64,
    /// `θ/α`, with its sign: at 1 the block stands on its corner.
    phi: f64,
    /// In degrees.
    theta: f64,
}

#[derive(Serialize)]
struct BoutRow {
    from: f64,
    to: f64,
    /// How many impacts were resolved; infinitely many follow where the ending is `complete`.
    impacts: usize,
    ending: &'static str,
    /// What is expected to be wrong with `to`; `null` where nothing is known of it, which the ending `unsure` says too.
    uncertainty: Option<f64>,
    /// The first impacts, as many as are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    impact_times: Option<Vec<f64>>,
    /// `φ'` just after each of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    impact_velocities: Option<Vec<f64>>,
}

#[derive(Serialize)]
struct RestRow {
    from: f64,
    to: f64,
}

pub(super) fn document<'a>(
    scene: &'a Scene,
    account: &'a Account,
    asked: &Asked,
    response: &Response,
    peak: Option<Peak>,
    impacts: Option<usize>,
) -> Document<'a> {
    let (case, motion) = match asked {
        Asked::Sinusoid(request) => (Some(CaseFacts::of(&request.case)), None),
        Asked::Motion(request) => (None, Some(MotionFacts::of(scene, request))),
    };
    let degrees = scene.block.slenderness.to_degrees();
    let peak = peak.map(|Peak { time, rotation }| PeakRow { tau: time, phi: rotation, theta: rotation * degrees });
    Document {
        title: &scene.title,
        model: if scene.ask.model == Model::Linear { "linear" } else { "nonlinear" },
        case,
        motion,
        frequency_parameter: scene.block.frequency_parameter(),
        summary: account,
        peak,
        bouts: response.bouts.iter().map(|bout| row(bout, asked.eta(), impacts)).collect(),
        rests: response.rests().into_iter().map(|(from, to)| RestRow { from, to }).collect(),
        end: response.end,
    }
}

fn row(bout: &Bout, eta: f64, impacts: Option<usize>) -> BoutRow {
    let uncertainty = Some(bout.uncertainty()).filter(|uncertainty| uncertainty.is_finite());
    let listed = impacts.map(|most| bout.impact_list(eta).take(most).collect::<Vec<_>>());
    BoutRow {
        from: bout.begin(),
        to: bout.end(),
        impacts: bout.impacts(),
        ending: bout.ending(),
        uncertainty,
        impact_times: listed.as_ref().map(|listed| listed.iter().map(|(time, ..)| *time).collect()),
        impact_velocities: listed.map(|listed| listed.iter().map(|(.., velocity)| *velocity).collect()),
    }
}
