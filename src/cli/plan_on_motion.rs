//! `plan` for a scene that is no case: the responses by both models, compared.

use chattercheck::{
    motion::scene::Scene,
    panel,
    plan::{Compared, Followed, MotionPlan, Parted},
};
use contract::{Body, Model, Motion, Oracle};
use serde::Serialize;

use super::{
    Status,
    output::{Format, note},
};

/// Times are `τ` since the start of the motion.
#[derive(Serialize)]
struct Document {
    title: String,
    ground: &'static str,
    eta: f64,
    alpha: f64,
    /// The equation that the scene asks for.
    model: &'static str,
    tolerance: f64,
    /// `p`, 1/s: a time over it is in seconds.
    frequency_parameter: f64,
    candidates: Vec<Row>,
    chosen: String,
    /// The times of rocking that both models have.
    bouts: Vec<BoutRow>,
    /// Why they are not compared any further; `null` if they are compared to the end.
    parted: Option<PartedRow>,
    largest_rotation: Option<Rotation>,
    meets_tolerance: bool,
}

#[derive(Serialize)]
struct Row {
    method: String,
    /// `linear` or `nonlinear`.
    model: &'static str,
    /// How many flights it took; `null` of one that was not asked.
    flights: Option<usize>,
    errors: Option<Errors>,
    /// `chosen`, `refused` or `not needed`.
    verdict: &'static str,
    why: String,
}

/// Relative errors of when the block rests and of how far it turns.
#[derive(Serialize)]
struct Errors {
    /// From solving another equation than that of the block as it is; `null` where it is another response.
    model: Option<f64>,
    /// From rounding and steps.
    conditioning: f64,
}

#[derive(Serialize)]
struct BoutRow {
    from: f64,
    to_linear: f64,
    to_nonlinear: f64,
    ending: &'static str,
    /// Relative to how long it lasts.
    error: f64,
    uncertainty: f64,
}

#[derive(Serialize)]
struct PartedRow {
    from: f64,
    why: &'static str,
}

/// As shares of `α`.
#[derive(Serialize)]
struct Rotation {
    linear: f64,
    nonlinear: f64,
    /// Relative.
    error: f64,
}

/// Plans, and prints the plan.
pub(super) fn run(scene: &Scene, tolerance: f64, format: Format) -> anyhow::Result<Status> {
    let plan = MotionPlan::new(scene)?;
    let document = document(scene, &plan, tolerance)?;
    format.print(&document, text)?;
    note(format_args!("compared: the flights of {} and of {}", plan.linear.oracle, plan.nonlinear.oracle));
    let known = !matches!(plan.parted, Some(Parted::Unknown(_))) || !plan.bouts.is_empty();
    Ok(if known { Status::Well } else { Status::Disagreed })
}

fn document(scene: &Scene, plan: &MotionPlan, tolerance: f64) -> anyhow::Result<Document> {
    let request = scene.on_motion(None, chattercheck::motion::response::Termination::Exact)?;
    let asked_linear = scene.ask.model == Model::Linear;
    let chosen = plan.chosen(scene.ask.model, tolerance);
    let why = |model: Model| match (model, chosen) {
        (Model::Linear, Model::Linear) if asked_linear => "the linear model is asked for".to_owned(),
        (Model::Linear, Model::Linear) => "accurate enough".to_owned(),
        (Model::Linear, Model::Nonlinear) => match plan.parted {
            Some(Parted::Differ(from)) => format!("it has another response from tau = {from} on"),
            Some(Parted::Unknown(from)) => format!("rounding alone changes what happens from tau = {from} on"),
            None => "its error of the model is too large".to_owned(),
        },
        (Model::Nonlinear, Model::Nonlinear) => "the equation of the block as it is".to_owned(),
        (Model::Nonlinear, Model::Linear) if asked_linear => "the linear model is asked for".to_owned(),
        (Model::Nonlinear, Model::Linear) => "accurate, but the slender block will do".to_owned(),
    };
    let row = |model: Model, followed: &Followed| Row {
        method: followed.oracle.clone(),
        model: name(model),
        flights: Some(followed.flights),
        errors: Some(Errors { model: plan.error_of(model), conditioning: followed.uncertainty() }),
        verdict: match model {
            _ if model == chosen => "chosen",
            Model::Linear => "refused",
            Model::Nonlinear if asked_linear => "refused",
            Model::Nonlinear => "not needed",
        },
        why: why(model),
    };
    let asked = [row(Model::Linear, &plan.linear), row(Model::Nonlinear, &plan.nonlinear)];
    let body = Body::new(scene.block.restitution, Some(scene.block.slenderness))?;
    let others = others(&asked, &body, &request.motion);
    Ok(Document {
        title: scene.title.clone(),
        ground: scene.ground_name(),
        eta: scene.block.restitution,
        alpha: scene.block.slenderness,
        model: name(scene.ask.model),
        tolerance,
        frequency_parameter: scene.block.frequency_parameter(),
        chosen: plan.by(chosen).oracle.clone(),
        candidates: asked.into_iter().chain(others).collect(),
        bouts: plan.bouts.iter().map(bout_row).collect(),
        parted: plan.parted.map(|parted| match parted {
            Parted::Differ(from) => PartedRow { from, why: "one model has another response from there on" },
            Parted::Unknown(from) => PartedRow { from, why: "rounding alone changes what happens from there on" },
        }),
        largest_rotation: plan
            .linear
            .peak
            .zip(plan.nonlinear.peak)
            .zip(plan.rotation)
            .map(|((one, other), error)| Rotation { linear: one.rotation, nonlinear: other.rotation, error }),
        meets_tolerance: plan.meets(scene.ask.model, tolerance),
    })
}

/// Those that were not asked: whether they could have been.
fn others(asked: &[Row], body: &Body, motion: &Motion) -> Vec<Row> {
    let row = |oracle: &dyn Oracle| {
        let (verdict, why) = match oracle.flights_on(body, motion) {
            Ok(_) => ("not needed", "could follow it too; not asked, so that its cost is not known".to_owned()),
            Err(why) => ("refused", why.to_string()),
        };
        Row { method: oracle.name().to_owned(), model: name(oracle.model()), flights: None, errors: None, verdict, why }
    };
    let panel = panel::default();
    let others = panel.iter().map(AsRef::as_ref);
    others.filter(|oracle| asked.iter().all(|row| row.method != oracle.name())).map(row).collect()
}

/// What an answer by the linear model is to the block as it is, where the scene asks for that model (`model = "linear"`), whatever it costs.
fn beside_the_block(document: &Document) -> String {
    if document.model != name(Model::Linear) {
        return String::new();
    }
    let linear = document.candidates.iter().find(|row| row.model == name(Model::Linear));
    let error = linear.and_then(|row| row.errors.as_ref()).and_then(|errors| errors.model);
    let off = error.map_or("has another response".to_owned(), |error| format!("differs by {error:.0e}"));
    format!(", of the linear model that the scene asks for; the block as it is {off} (model = \"nonlinear\")")
}

fn name(model: Model) -> &'static str {
    match model {
        Model::Linear => "linear",
        Model::Nonlinear => "nonlinear",
    }
}

fn bout_row(bout: &Compared) -> BoutRow {
    let Compared { from, linear, nonlinear, ending, error, uncertainty } = *bout;
    BoutRow { from, to_linear: linear, to_nonlinear: nonlinear, ending, error, uncertainty }
}

fn text(document: &Document) -> String {
    let Document { title, ground, eta, alpha, tolerance, frequency_parameter: p, .. } = document;
    let mut lines = vec![
        title.clone(),
        format!(
            "  {ground}; an impact leaves {eta:.4} of the velocity (eta); {alpha:.4} rad from upright to the balance (alpha)"
        ),
        format!(
            "asked: when the block rests and how far it turns, to {tolerance:.0e} of that. No formula predicts it on such a motion: both models were followed."
        ),
        format!("  {:22}{:>11}{:>9}{:>9}{:>9}", "method", "equation", "model", "numbers", "flights"),
    ];
    let mut unasked: Vec<(String, Vec<&str>)> = Vec::new();
    for Row { method, model, flights, errors, verdict, why } in &document.candidates {
        let (Some(errors), Some(flights)) = (errors, flights) else {
            let said = format!("{verdict}: {why}");
            match unasked.iter_mut().find(|(other, _)| *other == said) {
                Some((_, methods)) => methods.push(method),
                None => unasked.push((said, vec![method])),
            }
            continue;
        };
        let off = errors.model.map_or("-".to_owned(), |error| format!("{error:.0e}"));
        let numbers = format!("{:.0e}", errors.conditioning);
        lines.push(format!("  {method:22}{model:>11}{off:>9}{numbers:>9}{flights:>9}  {verdict}: {why}"));
    }
    lines.extend(unasked.into_iter().map(|(said, methods)| format!("  {} {said}", methods.join(", "))));
    lines.push("  (model: what linearisation costs, relative; numbers: from rounding and steps)".to_owned());
    for BoutRow { from, to_linear, to_nonlinear, ending, error, .. } in &document.bouts {
        lines.push(format!(
            "  rocks from {:.6} s to {:.6} s ({ending}); the slender block to {:.6} s, {error:.0e} of it off",
            from / p,
            to_nonlinear / p,
            to_linear / p
        ));
    }
    if let Some(PartedRow { from, why }) = &document.parted {
        lines.push(format!("  not compared from {:.6} s on: {why}", from / p));
    }
    lines.push(match &document.largest_rotation {
        Some(Rotation { linear, nonlinear, error }) => format!(
            "  turns up to {:.6} of alpha; the slender block up to {:.6}, {error:.0e} of it off",
            nonlinear.abs(),
            linear.abs()
        ),
        None => "  the block never rocks, or not by both models".to_owned(),
    });
    let worse = if document.meets_tolerance { "as asked" } else { "WORSE THAN ASKED, or not known to be better" };
    lines.push(format!("answer: by {}, {worse}{}", document.chosen, beside_the_block(document)));
    lines.join("\n")
}
