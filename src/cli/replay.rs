use std::path::PathBuf;

use anyhow::Context as _;
use chattercheck::{
    cases::{generate::Named, toml_error::printable},
    gate::{
        judge::Judges,
        replay::Replay,
        report::{self, Report},
        run,
    },
    panel,
};
use clap::Args;
use contract::Oracle;

use super::{Status, case_flags::read_text, output::note, report_files::ReportFiles};

/// Run one stored disagreement again
#[derive(Args)]
pub(super) struct Arguments {
    /// A replay file, as `verify` writes it
    file: PathBuf,
    #[command(flatten)]
    files: ReportFiles,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let path = arguments.file.display();
    let files = arguments.files.check()?;
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
    let panel = panel::select(&replay.oracles.join(",")).with_context(|| path.to_string())?;
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: 1 };
    let cases = [Named::parse(&replay.found_in, case)];
    let report = Report::new(&run::run(&panel, &judges, &cases, replay.seed, None, &()), &panel::roles());
    let mut text = format!("found then: {}\n", replay.finding);
    for failure in &report.failures {
        text += &format!("{}\n", report::failure_text(failure));
    }
    for shortfall in &report.shortfalls {
        text += &format!("SHORTFALL: {shortfall}\n");
    }
    let verdict = match (report.passes(), report.failures.is_empty()) {
        (true, _) => "PASS: the oracles agree on this case now",
        (false, true) => "FAIL: this says nothing about the disagreement",
        (false, false) => "FAIL: the disagreement is still there",
    };
    let status = if report.passes() { Status::Well } else { Status::Disagreed };
    let status = status.after(files.print(&format!("{text}{verdict}\n")));
    Ok(status.after(files.write(&report, &cases)))
}

/// The version that a replay file says it was written by, even where this one can't read the rest.
fn version_of(text: &str) -> Option<String> {
    Some(printable(text.parse::<toml::Table>().ok()?.get("version")?.as_str()?))
}
