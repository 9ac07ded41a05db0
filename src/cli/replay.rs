use std::path::PathBuf;

use anyhow::Context as _;
use chattercheck::{
    cases::{generate::Named, toml_error::printable},
    engines::Started,
    gate::{
        judge::Judges,
        replay::Replay,
        report::{self, Report},
        run,
        verdict::Verdict,
    },
    panel,
};
use clap::Args;
use contract::Oracle;

use super::{
    Status,
    case_flags::read_text,
    engine_flags::EngineFlags,
    output::note,
    report_files::{ReportFiles, Told},
};

/// Run one stored disagreement again
#[derive(Args)]
pub(super) struct Arguments {
    /// A replay file, as `verify` writes it
    file: PathBuf,
    #[command(flatten)]
    engines: EngineFlags,
    #[command(flatten)]
    files: ReportFiles,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let path = arguments.file.display();
    let engines = arguments.engines.read(&[&arguments.file])?;
    let files = arguments.files.check(&engines.taken())?;
    let text = read_text(&arguments.file)?;
    let other = version_of(&text).filter(|version| version != env!("CARGO_PKG_VERSION"));
    let (replay, case) = Replay::read(&text).with_context(|| match &other {
        Some(version) => format!("{path}, written by version {version}, not by {}", env!("CARGO_PKG_VERSION")),
        None => path.to_string(),
    })?;
    if let Some(version) = other {
        let ours = env!("CARGO_PKG_VERSION");
        note(format_args!("{path} was written by version {version}; this is {ours}, whose oracles may differ"));
    }
    let Some(mut engines) = engines.start()? else { return Ok(Status::Failed) };
    engines.fleet.engines.retain(|engine| replay.oracles.contains(&engine.entry.launch.name));
    let of_panel: Vec<&str> =
        replay.oracles.iter().map(String::as_str).filter(|name| engines.fleet.engine(name).is_none()).collect();
    let panel = panel::select(&of_panel.join(","))
        .with_context(|| format!("{path}; an engine is found by --engines FILE, the manifest that it is in"))?;
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let panel = engines.beside(&panel);
    let (judges, closing) = (panel::judges(), panel::closing());
    let closing = engines.fleet.engines.is_empty().then_some(closing.as_ref());
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: 1, closing };
    let cases = [Named::parse(&replay.found_in, case)];
    let run = run::run(&panel, &judges, &cases, replay.seed, None, &());
    let described = engines.fleet.engines.iter().map(Started::described).collect();
    let report = engines.with_roles(|roles| Report::new(&run, roles)).with_engines(described, &run);
    let mut text = format!("found then: {}\n", replay.finding);
    for failure in &report.failures {
        text += &format!("{}\n", report::failure_text(failure));
    }
    for shortfall in &report.shortfalls {
        text += &format!("SHORTFALL: {shortfall}\n");
    }
    let (verdict, status) = match (report.verdict, report.failures.is_empty()) {
        (Verdict::Pass, _) => ("PASS: the oracles agree on this case now", Status::Well),
        (Verdict::Undecided, _) => ("UNDECIDED: an engine broke", Status::Failed),
        (Verdict::Fail, true) => ("FAIL: this says nothing about the disagreement", Status::Disagreed),
        (Verdict::Fail, false) => ("FAIL: the disagreement is still there", Status::Disagreed),
    };
    let status = status.after(files.print(&format!("{text}{verdict}\n")));
    let told = Told { report: &report, cases: &cases, outcomes: &run.outcomes, replays: None };
    let status = status.after(files.write(&told));
    drop(panel);
    Ok(status.after(engines.stop()))
}

/// The version that a replay file says it was written by, even where this one can't read the rest.
fn version_of(text: &str) -> Option<String> {
    Some(printable(text.parse::<toml::Table>().ok()?.get("version")?.as_str()?))
}
