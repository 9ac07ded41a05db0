//! The gate for simulators that are written in Python, each run as an engine by a process of its own.

use std::path::Path;

use chattercheck::{
    engines::{Fleet, Manifest, Started, record::Keeper},
    faults::explain,
    gate::{
        finding::Finding,
        guests::Guests,
        judge::Judges,
        ladder,
        laws::Law,
        report::{self, Report},
        roles::Roles,
        run::{self, Placed, Selection},
    },
    page,
    panel::{self, Role},
};
use contract::{Invalid, Model, Oracle};
use pyo3::{prelude::*, types::PyDict};

use crate::{
    error::value_error,
    wait::{Stop, interruptible},
};

/// A run that is over.
struct Run {
    report: Report,
    page: String,
    name: String,
}

/// Why there is no report.
enum Failed {
    /// The request is wrong.
    Wrong(String),
    /// An engine does not start: its name, and how.
    Start(String),
}

/// What a run is made of.
#[derive(Clone, Copy)]
struct Asked {
    selection: Selection,
    judge_every: usize,
}

/// Puts the engine of a manifest under the gate. A dictionary: whether it passes, texts, the page, the report as JSON, and the findings.
#[pyfunction]
#[pyo3(signature = (manifest, cases=200, seed=1, judge_every=10))]
pub fn verify<'py>(
    py: Python<'py>,
    manifest: &str,
    cases: usize,
    seed: u64,
    judge_every: usize,
) -> PyResult<Bound<'py, PyDict>> {
    if cases > Selection::MOST_CASES {
        return Err(value_error(Invalid::new("cases", cases, "at most 1000000")));
    }
    if judge_every == 0 {
        return Err(value_error(Invalid::new("judge_every", 0, "at least 1")));
    }
    let manifest = Manifest::parse(Path::new("engine"), manifest).map_err(value_error)?;
    let asked = Asked { selection: Selection { cases, seed }, judge_every };
    let stop = Stop::default();
    let work = {
        let stop = stop.clone();
        move || run(&manifest, asked, &stop)
    };
    let Run { report, page, name } = match interruptible(py, &stop, work)? {
        Ok(run) => run,
        Err(Failed::Wrong(line)) => return Err(value_error(line)),
        Err(Failed::Start(line)) => {
            return Err(pyo3::exceptions::PyRuntimeError::new_err(line));
        }
    };
    let found = PyDict::new(py);
    found.set_item("ok", report.passes())?;
    found.set_item("verdict", report.verdict.to_string())?;
    found.set_item("headline", report::verdict(&report))?;
    found.set_item("text", report::text(&report))?;
    found.set_item("summary", report::summary(&report, None))?;
    found.set_item("page", page)?;
    found.set_item("json", serde_json::to_string(&report).map_err(value_error)?)?;
    found.set_item("explanation", explanation(&report, &name))?;
    found.set_item("findings", findings(&report, &name))?;
    let shortfalls: Vec<String> = report.shortfalls.iter().map(ToString::to_string).collect();
    found.set_item("shortfalls", shortfalls)?;
    let known = report.known_failures.iter().map(|known| (known.says.clone(), known.failed, known.is_out_of_date));
    found.set_item("known", known.collect::<Vec<_>>())?;
    Ok(found)
}

/// What would explain what is wrong.
fn explanation(report: &Report, name: &str) -> Vec<String> {
    let mut lines = Vec::new();
    for engine in report.engines.iter().filter(|engine| engine.engine.name == name) {
        lines.extend(engine.explanations.iter().flat_map(|found| report::explained(found)));
        lines.extend(engine.signs.iter().cloned());
    }
    lines
}

/// Each finding: its class, the name of the case, in words, and the first impact that is wrong.
fn findings(report: &Report, name: &str) -> Vec<(String, String, String, usize)> {
    let mut found = Vec::new();
    for failure in &report.failures {
        let about = failure.findings.iter().filter(|finding| finding.oracles().contains(&name));
        found
            .extend(about.map(|finding| {
                (class(finding), failure.name.clone(), report::finding_text(finding), finding.impact())
            }));
    }
    found
}

/// The class of a finding, as `known` of a manifest names it.
fn class(finding: &Finding) -> String {
    match finding {
        Finding::Pair { disagreement, .. } | Finding::Refuted { disagreement, .. } => {
            disagreement.observable.name().replace(' ', "-")
        }
        Finding::Law { breach, .. } if breach.law == Law::IntervalRatio => "interval-ratio".to_owned(),
        Finding::Law { breach, .. } => {
            serde_json::to_value(breach.law).ok().and_then(|law| law.as_str().map(str::to_owned)).unwrap_or_default()
        }
        Finding::Broke { breakdown, .. } => breakdown.clone(),
    }
}

fn run(manifest: &Manifest, Asked { selection, judge_every }: Asked, stop: &Stop) -> Result<Run, Failed> {
    let sensitive = || panel::with_role(Role::Sensitivities).into_iter().next().unwrap_or_else(panel::stepper);
    let fleet = Fleet::start(&manifest.engines, sensitive, &Keeper::default()).map_err(|broke| {
        let lines = broke.iter().map(|(name, how)| format!("{name}: {how}\n{}", how.stderr.trim_end()));
        Failed::Start(lines.collect::<Vec<_>>().join("\n").trim_end().to_owned())
    })?;
    let models: Vec<Model> = manifest.engines.iter().map(|entry| entry.launch.model).collect();
    let panel = panel::beside(&models);
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let all: Vec<&dyn Oracle> = panel.iter().copied().chain(fleet.oracles()).collect();
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: judge_every, closing: None };
    let cases = run::cases(&selection, panel::stepper().as_ref());
    let ladders = ladder::descend(&panel, panel::SERIES).map_err(|invalid| Failed::Wrong(invalid.to_string()))?;
    let known = fleet.known();
    let is_guest = |name: &str| fleet.engine(name).is_some();
    let guests = Guests { is_guest: &is_guest, known: &known, ..Guests::default() };
    let placed = Placed::all(&cases);
    let run = run::with_guests(&all, &guests, &judges, &placed, selection.seed, Some(ladders), stop);
    let run = run.excused(&known, &cases);
    let described = fleet.engines.iter().map(Started::described).collect();
    let report = with_roles(&fleet, |roles| Report::new(&run, roles)).with_engines(described, &run);
    let report = report.explained(|name| explain::for_guest(name, fleet.engine(name)?.entry.launch.model, &run.tally));
    let page = page::html(&report, &cases, &run.outcomes, None);
    let name = manifest.engines.first().map(|entry| entry.launch.name.clone()).unwrap_or_default();
    drop(all);
    fleet.stop();
    Ok(Run { report, page, name })
}

/// Hands `then` what the gate has to be told of the panel and of the engines.
fn with_roles<T>(fleet: &Fleet, then: impl FnOnce(&Roles<'_>) -> T) -> T {
    let may_decline =
        |name: &str| fleet.engine(name).map_or_else(|| panel::may_decline(name), |started| started.entry.may_decline);
    let granted = |name: &str| fleet.engine(name).is_some_and(Started::is_granted);
    let never_rests = |name: &str| fleet.engine(name).is_some_and(|started| started.entry.never_at_rest);
    let shown_by = |name: &str, flags: &str| match fleet.engine(name) {
        Some(_) => format!("{name}: {flags}"),
        None => panel::shown_by(name, flags),
    };
    then(&Roles {
        may_decline: &may_decline,
        granted: &granted,
        never_rests: &never_rests,
        shown_by: &shown_by,
        ..panel::roles()
    })
}
