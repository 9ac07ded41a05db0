use std::path::{Path, PathBuf};

use chattercheck::{
    gate::{
        examine::Finding,
        judge::Judges,
        ladder,
        replay::Replay,
        report::{self, Report},
        run::{self, Failure, Selection},
        shrink::shrink,
    },
    panel,
};
use clap::Args;
use contract::{Invalid, Oracle};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;

use super::{
    Status,
    files::{Target, check_folder, make_folder},
    output::note,
    report_files::ReportFiles,
    seed::Seed,
};

/// Cross-check the whole panel of oracles on listed, edge, spaced and random cases
#[derive(Args)]
pub(super) struct Arguments {
    /// How many random cases, beside those of the other generators
    #[arg(long, value_name = "N", default_value_t = Selection::DEFAULT_CASES, allow_negative_numbers = true)]
    cases: usize,
    #[command(flatten)]
    seed: Seed,
    /// Names of oracles, separated by commas; `ode` stands for all that begin so [default: the default panel]
    #[arg(long, value_name = "LIST")]
    oracles: Option<String>,
    #[command(flatten)]
    files: ReportFiles,
    /// Judge every N-th case by proven enclosures, or `all`; listed cases and those with something wrong are judged anyway
    #[arg(long, value_name = "all|N", default_value = "10", allow_hyphen_values = true)]
    judge: String,
    /// Run only the K-th of N shares of the cases
    #[arg(long, value_name = "K/N", default_value = "1/1")]
    partition: String,
    #[arg(long, value_name = "DIR", help = format!("Where replay files of failures go [default: {REPLAYS}]"))]
    replays: Option<PathBuf>,
    /// No progress bar
    #[arg(long)]
    quiet: bool,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let panel = match &arguments.oracles {
        Some(list) => panel::select(list)?,
        None => panel::default(),
    };
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let seed = arguments.seed.value()?;
    let partition = partition(&arguments.partition)?;
    if arguments.cases > Selection::MOST_CASES {
        return Err(Invalid::new("cases", arguments.cases, "at most 1000000").into());
    }
    if panel.len() < 2 {
        let wanted = arguments.oracles.as_deref().unwrap_or_default();
        return Err(Invalid::new("oracles", wanted, "names of two oracles at least: one alone proves nothing").into());
    }
    let every = every(&arguments.judge)?;
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every };
    let files = arguments.files.check()?;
    let replays = arguments.replays()?;
    let cases = run::cases(&Selection { cases: arguments.cases, seed, partition });
    if cases.is_empty() {
        return Err(Invalid::new("partition", &arguments.partition, "a share that has cases in it").into());
    }
    let bar = progress(cases.len() as u64, arguments.quiet);
    let ladders = Some(ladder::descend(&panel)?);
    let (report, failures) = run::run(&panel, &judges, &cases, seed, ladders, || bar.inc(1));
    bar.finish_and_clear();
    // First what was found: shrinking may take a while.
    let status = if report.passes() { Status::Well } else { Status::Disagreed };
    let status = status.after(files.print(&report::text(&report)));
    let status = status.after(files.write(&report, &cases));
    // A disagreement stays one where its replay files can't be written.
    if let Err(error) = write_replays(&panel, &judges, &report, &failures, replays, partition) {
        note(format_args!("chattercheck: no replay files: {error:#}"));
    }
    Ok(status)
}

/// Where replay files go unless told otherwise.
const REPLAYS: &str = "chattercheck-replays";

impl Arguments {
    /// The folder for replay files. One that is asked for has to be possible; without the usual one the run goes on.
    fn replays(&self) -> anyhow::Result<&Path> {
        match &self.replays {
            Some(folder) => check_folder("replays", folder)?,
            None => {
                if let Err(error) = check_folder("replays", Path::new(REPLAYS)) {
                    note(format_args!(
                        "verify: {error:#}: there will be no replay files; --replays DIR puts them elsewhere"
                    ));
                }
            }
        }
        Ok(self.replays.as_deref().unwrap_or(Path::new(REPLAYS)))
    }
}

/// `all`, or how many cases are run for one that is judged.
fn every(text: &str) -> Result<usize, Invalid> {
    let every = if text == "all" { Some(1) } else { text.parse().ok() };
    every
        .filter(|every| *every > 0)
        .ok_or_else(|| Invalid::new("judge", text, "all, or N >= 1 to judge every N-th case"))
}

/// `K/N` with `1 <= K <= N`.
fn partition(text: &str) -> Result<(usize, usize), Invalid> {
    text.split_once('/')
        .and_then(|(part, parts)| Some((part.parse().ok()?, parts.parse().ok()?)))
        .filter(|&(part, parts): &(usize, usize)| 1 <= part && part <= parts)
        .ok_or_else(|| Invalid::new("partition", text, "K/N with 1 <= K <= N"))
}

fn progress(length: u64, quiet: bool) -> ProgressBar {
    let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let bar = ProgressBar::with_draw_target(Some(length), target);
    match ProgressStyle::with_template("{bar:40} {pos}/{len} cases, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// The oracles that a replay asks: those of the finding, and one to compare with.
fn concerned(oracles: &[String], finding: &Finding) -> Vec<String> {
    let of_finding = |oracle: &&String| finding.oracles().contains(&oracle.as_str());
    let other = oracles.iter().find(|oracle| !of_finding(oracle));
    let needed = if finding.oracles().len() < 2 { other } else { None };
    oracles.iter().filter(of_finding).chain(needed).cloned().collect()
}

/// How many failures are shrunk and written.
const MOST_REPLAYS: usize = 10;

/// Shrinks the first finding of the first failures and writes each to a file.
fn write_replays(
    panel: &[&dyn Oracle],
    judges: &Judges,
    report: &Report,
    failures: &[Failure],
    folder: &Path,
    (part, parts): (usize, usize),
) -> anyhow::Result<()> {
    let replays: Vec<Replay> = failures
        .par_iter()
        .take(MOST_REPLAYS)
        .filter_map(|failure| {
            let (case, finding) = shrink(panel, judges, &failure.named.case, failure.findings.first()?);
            Some(Replay::new(
                &case,
                &finding,
                failure.named.to_string(),
                report.seed,
                &concerned(&report.oracles, &finding),
            ))
        })
        .collect();
    let part = if parts > 1 { format!("-part-{part}-of-{parts}") } else { String::new() };
    if !replays.is_empty() {
        make_folder("replays", folder)?;
    }
    for (number, replay) in (1..).zip(&replays) {
        let path = folder.join(format!("seed-{}{part}-{number}.toml", report.seed));
        Target::new(&path)?.write(&replay.to_text()?)?;
        note(format_args!("shrunk: {}\n  run again: chattercheck replay {}", replay.finding, path.display()));
    }
    Ok(())
}
