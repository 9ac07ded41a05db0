use std::path::{Path, PathBuf};

use anyhow::bail;
use chattercheck::{
    cases::generate::Named,
    engines::Started,
    gate::{
        failure::{Failure, by_cause},
        identity::Identity,
        judge::Judges,
        ladder,
        partition::{Names, Part, Partition, Request},
        progress::Progress,
        replay::Replay,
        report::Report,
        run::{self, Run},
        shrink::{shrink, unshrunk},
    },
    panel,
};
use clap::Args;
use contract::{Invalid, Oracle};
use rayon::prelude::*;

use super::{
    Status,
    conclusion::{Conclusion, Format},
    engine_flags::EngineFlags,
    engine_profile::{self, Clock},
    files::{check_folder, make_folder, write_numbered},
    output::note,
    part_file::PartFile,
    report_files::ReportFiles,
    run_cases::{self, RunCases},
    verified_responses::Responses,
    watch::Watch,
};

/// Cross-check the whole panel of oracles on listed, edge, spaced and random cases
#[derive(Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    cases: RunCases,
    #[command(flatten)]
    responses: Responses,
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
    /// Keep what this part of the run found in a file in DIR, for `chattercheck merge DIR`; a part that is there already is not run again
    #[arg(long, value_name = "DIR", conflicts_with_all = ["json", "junit", "html", "summary", "full"])]
    out: Option<PathBuf>,
    /// Print the cases of this run and run nothing: a line each, the name, a tab, and the flags that ask for it in other commands
    #[arg(long, conflicts_with_all = ["responses", "oracles", "engines", "only", "record", "json", "junit", "html", "summary", "replays", "format", "full", "out", "quiet"])]
    list: bool,
    #[arg(long, value_name = "DIR", help = format!("Where replay files of failures go [default: {REPLAYS}]"))]
    replays: Option<PathBuf>,
    /// How stdout is written: for people, or for a workflow of GitHub, with commands that it shows as annotations
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Write the profiles of the engines into DIR, how fast they are among them: tables (CSV), and charts (SVG) drawn from them
    #[arg(long, value_name = "DIR", requires = "engines", conflicts_with = "list")]
    profile: Option<PathBuf>,
    /// Print the wide tables too: every pair, every claim, every law
    #[arg(long)]
    full: bool,
    /// No progress bar
    #[arg(long)]
    quiet: bool,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let engines = arguments.engines.read(&arguments.cases.files())?;
    let panel = match &arguments.oracles {
        Some(list) => panel::select(list)?,
        None if engines.is_empty() => panel::default(),
        None => engines.panel(),
    };
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let partition = Partition::parse(&arguments.partition)?;
    let every = every(&arguments.judge)?;
    let (judges, closing) = (panel::judges(), panel::closing());
    // Simulators of others are told by the judge what is wrong with them.
    let closing = engines.is_empty().then_some(closing.as_ref());
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every, closing };
    if arguments.list {
        return run_cases::print(&arguments.cases.chosen()?.part(&judges, partition), partition);
    }
    let files = arguments.files.check(&engines.taken())?;
    let conclusion = Conclusion { full: arguments.full, format: arguments.format, replays: Path::new(""), next: None };
    conclusion.check(&files)?;
    let replays = arguments.replays()?;
    if let Some(folder) = &arguments.profile {
        make_folder("profile", folder)?;
    }
    let Some(engines) = engines.start()? else { return Ok(Status::Failed) };
    let all = engines.beside(&panel);
    if all.len() < 2 {
        let wanted = arguments.oracles.as_deref().unwrap_or_default();
        return Err(Invalid::new("oracles", wanted, "names of two oracles at least: one alone proves nothing").into());
    }
    let chosen = arguments.cases.chosen()?;
    let seed = chosen.selection.seed;
    let placed = chosen.part(&judges, partition);
    let has_engines = !engines.fleet.engines.is_empty();
    let responses = arguments.responses.chosen(&panel, chosen.whole && !has_engines, seed, partition)?;
    let request = Request {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        seed,
        cases: chosen.selection.cases,
        own: chosen.own.clone(),
        whole: chosen.whole,
        oracles: names(&all),
        judges: names(&judges.oracles),
        judge_every: every,
        responses: responses.asked(),
        responders: responses.responders(),
        engines: engines.asked(),
        all: Identity::of_all(&chosen.all),
    };
    let part_file = arguments.out.as_deref().map(|folder| PartFile::new(folder, partition)).transpose()?;
    if let Some(file) = &part_file
        && let Some(part) = file.there(&request)?
    {
        if let Some((option, _)) = arguments.of_asking().into_iter().find(|(_, is_given)| *is_given) {
            bail!("--{option} is not used: part {partition} is there already, and no engine is asked again");
        }
        let status = file.again(part, &chosen.all, &conclusion, &files)?;
        drop(all);
        return Ok(status.after(engines.stop()));
    }
    if placed.is_empty() && responses.len() == 0 && part_file.is_none() {
        note(format_args!("chattercheck: nothing ran: nothing of the run falls to part {partition}"));
        return Ok(Status::Nothing.after(engines.stop()));
    }
    let cases: Vec<Named> = placed.iter().map(|placed| placed.named.clone()).collect();
    let watch = Watch::start(cases.len() + responses.len(), arguments.quiet);
    // The ladders are a test of the panel itself.
    let ladders = chosen.whole.then(|| ladder::descend(&panel, panel::SERIES)).transpose()?;
    let known = engines.fleet.known();
    let clock = Clock::new(&engines.fleet);
    let run = engines.with_guests(&known, &clock, |guests| {
        run::with_guests(&all, guests, &judges, &placed, seed, ladders, &watch).excused(&known, &cases)
    });
    let (of_responses, wrong_responses, response_seconds) = responses.run(&watch);
    watch.end();
    let described = engines.fleet.engines.iter().map(Started::described).collect();
    let report = engines.with_roles(|roles| Report::new(&run, roles));
    let report = report.with_engines(described, &run).with_responses(of_responses.clone());
    // Who has to stop has no time for it.
    let report =
        if watch.is_interrupted() { report } else { report.explained(|name| engines.explain(name, &run.tally)) };
    let speeds = clock.speeds();
    if !arguments.quiet {
        engine_profile::tell(&speeds);
    }
    let profiles = arguments.profile.as_ref().filter(|_| !watch.is_interrupted());
    let profiles = profiles.map_or(Ok(()), |folder| engine_profile::write(folder, &report, &engines.fleet, &speeds));
    // First what was found: shrinking may take a while.
    let responses_run = report.responses.as_ref().map_or(&[][..], |of| &of.tally.names);
    let outcomes = run.outcomes.clone().with_responses(responses_run, response_seconds);
    let conclusion = Conclusion { replays, ..conclusion };
    let status = match &part_file {
        None => conclusion.give(&report, &cases, &outcomes, &files),
        Some(file) => {
            let named = Names { manifest: engines.path(), replays: replays.display().to_string() };
            let run = Run { outcomes, ..run.clone() };
            let part = Part { partition, request, named, run, responses: of_responses };
            file.keep(&part, report, &conclusion, &files)
        }
    };
    let status = status.after(profiles);
    // A disagreement stays one where its replay files can't be written.
    let part = partition.suffix();
    let granted = engines.fleet.engines.iter().filter(|started| started.is_granted());
    let granted = granted.map(|started| started.entry.launch.name.clone()).collect();
    let place = Place { folder: replays, stem: format!("seed-{seed}{part}"), seed, granted };
    let written = write_replays(&all, &judges, &run.failures, &place, &engines.flag(), &watch);
    if let Err(error) = written.and(responses.write_scenes(seed, &wrong_responses, replays, &part, &watch)) {
        note(format_args!("chattercheck: no replay files: {error:#}"));
    }
    drop(all);
    Ok(status.after(engines.stop()))
}

/// Where replay files go unless told otherwise.
const REPLAYS: &str = "chattercheck-replays";

impl Arguments {
    /// The options whose files come of asking engines, and whether each is given.
    fn of_asking(&self) -> [(&'static str, bool); 2] {
        [("profile", self.profile.is_some()), ("record", self.engines.is_recorded())]
    }

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

fn names(oracles: &[&dyn Oracle]) -> Vec<String> {
    oracles.iter().map(|oracle| oracle.name().to_owned()).collect()
}

/// `all`, or how many cases are run for one that is judged.
fn every(text: &str) -> Result<usize, Invalid> {
    let every = if text == "all" { Some(1) } else { text.parse().ok() };
    every
        .filter(|every| *every > 0)
        .ok_or_else(|| Invalid::new("judge", text, "all, or N >= 1 to judge every N-th case"))
}

/// How many causes are shrunk, and how many failures of each.
const CAUSES: usize = 5;
const OF_EACH: usize = 2;

/// Where replay files go, what their names begin with, and what is said in them of the run.
struct Place<'a> {
    folder: &'a Path,
    stem: String,
    seed: u64,
    /// The engines whose errors are granted, not claimed.
    granted: Vec<String>,
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
    let Place { folder, stem, seed, .. } = place;
    let groups = by_cause(failures, Failure::cause);
    let chosen: Vec<&Failure> =
        groups.into_iter().take(CAUSES).flat_map(|(_, group)| group.into_iter().take(OF_EACH)).collect();
    let replays: Vec<(Replay, bool)> = chosen
        .into_par_iter()
        .filter_map(|failure| {
            let (case, finding) = (&failure.named.case, failure.findings.first()?);
            // Who has to stop has no time for it, and what breaks an engine is not tried again and again.
            let is_as_found = watch.is_interrupted() || finding.is_breakdown();
            let mut shrunk =
                if is_as_found { unshrunk(panel, case, finding) } else { shrink(panel, judges, case, finding) };
            place.granted.iter().for_each(|engine| shrunk.finding.grant(engine));
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
