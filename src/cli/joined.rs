//! The report on a run whose parts are put together.

use anyhow::anyhow;
use chattercheck::{
    cases::generate::Named,
    faults::explain,
    gate::{
        outcome::Outcomes,
        partition::{EngineAsked, Part, Request, Whole, join},
        report::Report,
        roles::Roles,
    },
    panel,
};

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
    let may_decline =
        |oracle: &str| engine(oracle).map_or_else(|| panel::may_decline(oracle), |asked| asked.may_decline);
    let granted = |oracle: &str| engine(oracle).is_some_and(|asked| !asked.engine.claims);
    let shown_by = |oracle: &str, flags: &str| match engine(oracle) {
        Some(_) => format!("chattercheck engine ask {oracle} --engines {manifest} {flags}"),
        None => panel::shown_by(oracle, flags),
    };
    let roles = Roles { may_decline: &may_decline, granted: &granted, shown_by: &shown_by, ..panel::roles() };
    let described = request.engines.iter().map(|EngineAsked { engine, .. }| engine.clone()).collect();
    let report = Report::new(&run, &roles).with_engines(described, &run.tally).with_responses(responses);
    let report = report.explained(|name| {
        let model = panel::model_named(&engine(name)?.model).ok()?;
        explain::for_guest(name, model, &run.tally)
    });
    Ok((report, run.outcomes))
}
