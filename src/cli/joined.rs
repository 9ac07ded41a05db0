//! The report on a run whose parts are put together.

use anyhow::anyhow;
use chattercheck::{
    cases::generate::Named,
    faults::explain,
    gate::{
        outcome::Outcomes,
        partition::{EngineAsked, Part, Request, Whole, join},
        report::Report,
    },
    panel,
};

use super::engine_flags::with_roles;

/// The report on the run that these parts are, of which `all` are the cases. The engines are not here any more.
///
/// # Errors
/// When there are no parts.
pub(super) fn report(
    request: &Request,
    manifest: &str,
    parts: Vec<Part>,
    all: &[Named],
) -> anyhow::Result<(Report, Outcomes)> {
    let places = all.iter().enumerate().map(|(place, named)| (named.to_string(), place)).collect();
    let Whole { run, responses } = join(parts, &places).ok_or_else(|| anyhow!("there are no parts"))?;
    let engine = |name: &str| request.engines.iter().find(|asked| asked.engine.name == name);
    let described = request.engines.iter().map(|EngineAsked { engine, .. }| engine.clone()).collect();
    let report = with_roles(&request.engines, manifest, |roles| Report::new(&run, roles));
    let report = report.with_engines(described, &run).with_responses(responses);
    let report = report.explained(|name| {
        let model = panel::model_named(&engine(name)?.model).ok()?;
        explain::for_guest(name, model, &run.tally)
    });
    Ok((report, run.outcomes))
}
