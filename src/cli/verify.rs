use std::path::{Path, PathBuf};

use anyhow::bail;
use chattercheck::{
    engines::Started,
    gate::{
        failure::{Failure, by_cause},
        judge::Judges,
        ladder,
        progress::Progress,
        replay::Replay,
        report::{self, Report},
        run::{self, Selection},
        shrink::{shrink, unshrunk},
        verdict::Verdict,
    },
    panel,
};
use clap::Args;
use contract::{Invalid, Oracle};
use rayon::prelude::*;

use super::{
    Status,
    engine_flags::EngineFlags,
    files::{check_folder, make_folder, write_numbered},
    numbers::count,
    output::note,
    report_files::ReportFiles,
    seed::Seed,
    verified_responses::Responses,
    watch::Watch,
};

/// Cross-check the whole panel of oracles on listed, edge, spaced and random cases
#[derive(Args)]
pub(super) struct Arguments {
    /// How many random cases, beside those of the other generators
    #[arg(long, value_name = "N", default_value_t = Selection::DEFAULT_CASES, allow_negative_numbers = true, value_parser = count::<0, { Selection::MOST_CASES }>)]
    cases: usize,
    #[command(flatten)]
    responses: Responses,
    #[command(flatten)]
    seed: Seed,
    /// Names of oracles, separated by commas; `ode` stands for all that begin so [default: the default panel; where engines are given, those that step fastest]
    #[arg(long, value_name = "LIST")]
    oracles: Option<String>,
    #[command(flatten)]
    engines: EngineFlags,
    #[command(flatten)]
    files: ReportFiles,
    /// Judge every N-th case by proven enclosures, or `all`; listed cases and those with something wrong are judged anyway
    #[arg(long, value_name = "all|N", default_value = "10", allow_hyphen_values = true)]
    judge: String,
    /// Run only the K-th of N shares of the cases
    #[arg(long, value_name = "K/N", default_value = "1/1", allow_hyphen_values = true)]
    partition: String,
    #[arg(long, value_name = "DIR", help = format!("Where replay files of failures go [default: {REPLAYS}]"))]
    replays: Option<PathBuf>,
    /// Print the wide tables too: every pair, every claim, every law
    #[arg(long)]
    full: bool,
    /// No progress bar
    #[arg(long)]
    quiet: bool,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let engines = arguments.engines.read()?;
    let panel = match &arguments.oracles {
        Some(list) => panel::select(list)?,
        None if engines.is_empty() => panel::default(),
        None => engines.panel(),
    };
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let seed = arguments.seed.value()?;
    let partition = partition(&arguments.partition)?;
    if arguments.cases > Selection::MOST_CASES {
        return Err(Invalid::new("cases", arguments.cases, "at most 1000000").into());
    }
    let every = every(&arguments.judge)?;
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every };
    let files = arguments.files.check(None)?;
    if arguments.full && files.take_stdout() {
        bail!("--full is not used where stdout is for the report of machines (- as FILE); it is for that of people");
    }
    let replays = arguments.replays()?;
    let Some(engines) = engines.start()? else { return Ok(Status::Failed) };
    let all = engines.beside(&panel);
    if all.len() < 2 {
        let wanted = arguments.oracles.as_deref().unwrap_or_default();
        return Err(Invalid::new("oracles", wanted, "names of two oracles at least: one alone proves nothing").into());
    }
    let cases = run::cases(&Selection { cases: arguments.cases, seed, partition }, panel::stepper().as_ref());
    if cases.is_empty() {
        return Err(Invalid::new("partition", &arguments.partition, "a share that has cases in it").into());
    }
    let has_engines = !engines.fleet.engines.is_empty();
    let responses = arguments.responses.chosen(&panel, has_engines, seed, partition)?;
    let watch = Watch::start(cases.len() + responses.len(), arguments.quiet);
    let ladders = Some(ladder::descend(&panel, panel::SERIES)?);
    // The ladders are a test of the panel itself.
    let known = engines.fleet.known();
    let run = engines.with_guests(&known, |guests| {
        run::with_guests(&all, guests, &judges, &cases, seed, ladders, &watch).excused(&known, &cases)
    });
    let (of_responses, wrong_responses) = responses.run(&watch);
    watch.end();
    let described = engines.fleet.engines.iter().map(Started::described).collect();
    let report = engines.with_roles(|roles| Report::new(&run, roles));
    let report = report.with_engines(described, &run.tally).with_responses(of_responses);
    // Who has to stop has no time for it.
    let report =
        if watch.is_interrupted() { report } else { report.explained(|name| engines.explain(name, &run.tally)) };
    // First what was found: shrinking may take a while.
    let status = match report.verdict {
        Verdict::Pass => Status::Well,
        Verdict::Undecided => Status::Failed,
        Verdict::Fail => Status::Disagreed,
    };
    let tables = if arguments.full { format!("\n{}", report::full(&report)) } else { String::new() };
    let text = format!("{}{}{tables}", report::text(&report), next(&report, arguments.full, replays));
    let status = status.after(files.print(&text));
    let status = status.after(files.write(&report, &cases));
    // A disagreement stays one where its replay files can't be written.
    let part = of_partition(partition);
    let place = Place { folder: replays, stem: format!("seed-{seed}{part}"), seed };
    let written = write_replays(&all, &judges, &run.failures, &place, &engines.flag(), &watch);
    if let Err(error) = written.and(responses.write_scenes(seed, &wrong_responses, replays, &part, &watch)) {
        note(format_args!("chattercheck: no replay files: {error:#}"));
    }
    drop(all);
    Ok(status.after(engines.stop()))
}

/// What to do next, in a line.
fn next(report: &Report, full: bool, folder: &Path) -> String {
    let tables = if full { "" } else { "; --full prints every pair, claim and law" };
    let failed = report.failures.len() + report.responses.as_ref().map_or(0, |of| of.failures.len());
    match report.verdict {
        Verdict::Pass => format!("  next         another seed: --seed {}{tables}\n", report.seed.wrapping_add(1)),
        Verdict::Undecided if !report.broke.is_empty() => {
            "next: mend what broke the engine; `chattercheck engine ask` shows the talk about a case\n".to_owned()
        }
        Verdict::Undecided => "next: run it again to its end; --partition K/N runs a share of the cases\n".to_owned(),
        Verdict::Fail if failed == 0 => format!("next: see which oracles the shortfalls name{tables}\n"),
        Verdict::Fail => {
            let folder = folder.display();
            format!(
                "next: the smallest cases that still fail go to {folder}; run them again with `chattercheck replay`, scenes with `chattercheck response`{tables}\n"
            )
        }
    }
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

/// What tells the files of one share of a run from those of another.
fn of_partition((part, parts): (usize, usize)) -> String {
    if parts > 1 { format!("-part-{part}-of-{parts}") } else { String::new() }
}

/// How many causes are shrunk, and how many failures of each.
const CAUSES: usize = 5;
const OF_EACH: usize = 2;

/// Where replay files go, what their names begin with, and the seed of the run.
struct Place<'a> {
    folder: &'a Path,
    stem: String,
    seed: u64,
}

/// Shrinks the first finding of a few failures of each cause, and writes each to a file.
fn write_replays(
    panel: &[&dyn Oracle],
    judges: &Judges,
    failures: &[Failure],
    place: &Place,
    flag: &str,
    watch: &Watch,
) -> anyhow::Result<()> {
    let Place { folder, stem, seed } = place;
    let groups = by_cause(failures, Failure::cause);
    let chosen: Vec<&Failure> =
        groups.into_iter().take(CAUSES).flat_map(|(_, group)| group.into_iter().take(OF_EACH)).collect();
    let replays: Vec<(Replay, bool)> = chosen
        .into_par_iter()
        .filter_map(|failure| {
            let (case, finding) = (&failure.named.case, failure.findings.first()?);
            // Who has to stop has no time for it, and what breaks an engine is not tried again and again.
            let is_as_found = watch.is_interrupted() || finding.is_breakdown();
            let shrunk =
                if is_as_found { unshrunk(panel, case, finding) } else { shrink(panel, judges, case, finding) };
            Some((Replay::new(&shrunk, failure.named.to_string(), *seed), is_as_found))
        })
        .collect();
    if !replays.is_empty() {
        make_folder("replays", folder)?;
    }
    for (replay, is_as_found) in &replays {
        let path = write_numbered(folder, stem, |_| Ok(replay.to_text()?))?;
        note(format_args!(
            "{} {}: {}\n  run again: chattercheck replay {}{flag}",
            if *is_as_found { "found" } else { "shrunk" },
            replay.found_in,
            replay.finding,
            path.display()
        ));
    }
    Ok(())
}
