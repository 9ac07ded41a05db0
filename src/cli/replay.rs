use std::{fs, path::PathBuf};

use anyhow::Context as _;
use chattercheck::{
    generate::{Generator, Named},
    panel,
    replay::Replay,
    report, verify,
};
use clap::Args;
use contract::Oracle;

use super::{Verdict, report_files::ReportFiles};

/// Run one stored disagreement again
#[derive(Args)]
pub(super) struct Arguments {
    /// A replay file, as `verify` writes it
    file: PathBuf,
    #[command(flatten)]
    files: ReportFiles,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Verdict> {
    let path = arguments.file.display();
    arguments.files.check()?;
    let text = fs::read_to_string(&arguments.file).with_context(|| format!("cannot read {path}"))?;
    let (replay, case) = Replay::read(&text).with_context(|| path.to_string())?;
    let panel = panel::select(&replay.oracles.join(","))?;
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let cases = [Named { generator: Generator::List, name: replay.found_in.clone(), case }];
    println!("found then: {}", replay.fault);
    let (report, failures) = verify::run(&panel, &cases, replay.seed, Vec::new(), || ());
    for failure in &report.failures {
        println!("{}", report::failure_text(failure));
    }
    arguments.files.write(&report, &cases)?;
    if failures.is_empty() {
        println!("PASS: the oracles agree on this case now");
        return Ok(Verdict::Well);
    }
    println!("FAIL: the disagreement is still there");
    Ok(Verdict::Disagreed)
}
