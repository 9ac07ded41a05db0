//! The command line: one file a command; each parses, calls the library and prints.

mod case_facts;
mod case_flags;
mod chart;
mod chattering_answer;
mod chattering_time;
mod conclusion;
mod confusion;
mod criterion;
mod critical_amplitude;
mod detection_floor;
mod diagnose;
mod engine;
mod engine_flags;
mod engine_profile;
mod estimate;
mod files;
mod flight_flags;
mod followed;
mod joined;
mod judge;
mod map_flags;
mod merge;
mod moment;
mod motion_facts;
mod numbers;
mod oracle_flags;
mod oracles;
mod output;
mod overturning;
mod paper;
mod part_file;
mod part_files;
mod plan;
mod plan_on_motion;
mod proven_time;
mod reference;
mod replay;
mod report_files;
mod response;
mod rows;
mod run_cases;
mod scene;
mod seed;
mod simulate;
mod sweep;
mod tolerances;
mod typed;
mod verified_responses;
mod verify;
mod watch;

use std::{
    error::Error,
    io::{self, Write as _},
    process::ExitCode,
};

use clap::{
    Parser, Subcommand,
    error::ErrorKind::{DisplayHelpOnMissingArgumentOrSubcommand, MissingRequiredArgument},
};
use output::{Unwritten, complain};
use typed::as_typed;

/// Differential verification of the chattering of a rocking rigid block.
///
/// Data goes to stdout, progress and diagnostics to stderr. Exit status: 0 all is well; 1 a check disagreed; 2 the request was wrong; 3 there is no verdict:
/// the machine failed, as with a full disk, or the run was interrupted; 4 nothing ran.
#[derive(Parser)]
#[command(version, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Verify(verify::Arguments),
    Merge(merge::Arguments),
    Replay(replay::Arguments),
    Judge(judge::Arguments),
    Engine(engine::Arguments),
    Simulate(simulate::Arguments),
    ChatteringTime(chattering_time::Arguments),
    CriticalAmplitude(critical_amplitude::Arguments),
    Oracles(oracles::Arguments),
    Reference(reference::Arguments),
    Tolerances(tolerances::Arguments),
    DetectionFloor(detection_floor::Arguments),
    Confusion(confusion::Arguments),
    Diagnose(diagnose::Arguments),
    Chart(chart::Arguments),
    Paper(paper::Arguments),
    Scene(scene::Arguments),
    Response(response::Arguments),
    Criterion(criterion::Arguments),
    Overturning(overturning::Arguments),
    Plan(plan::Arguments),
    Sweep(sweep::Arguments),
}

/// What a command that ran came to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Status {
    /// All is well.
    Well,
    /// A check disagreed.
    Disagreed,
    /// The machine failed, as with a full disk, or the run was interrupted, before any check had disagreed.
    Failed,
    /// Nothing ran.
    Nothing,
}

impl Status {
    /// The status with what became of writing the outputs: a check that disagreed is told by the status even where nothing else can be written.
    fn after(self, written: anyhow::Result<()>) -> Self {
        match written {
            Ok(()) => self,
            Err(error) => {
                complain(&format!("{error:#}"));
                if self == Self::Well { Self::Failed } else { self }
            }
        }
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        match status {
            Status::Well => Self::SUCCESS,
            Status::Disagreed => Self::from(1),
            Status::Failed => Self::from(3),
            Status::Nothing => Self::from(4),
        }
    }
}

/// Parses the command line and runs the command.
pub(crate) fn run() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return refuse(&error),
    };
    let result = match cli.command {
        Command::Verify(arguments) => verify::run(&arguments),
        Command::Merge(arguments) => merge::run(&arguments),
        Command::Replay(arguments) => replay::run(&arguments),
        Command::Judge(arguments) => judge::run(&arguments),
        Command::Engine(arguments) => engine::run(&arguments),
        Command::Simulate(arguments) => simulate::run(&arguments),
        Command::ChatteringTime(arguments) => chattering_time::run(&arguments),
        Command::CriticalAmplitude(arguments) => critical_amplitude::run(&arguments),
        Command::Oracles(arguments) => oracles::run(&arguments),
        Command::Reference(arguments) => reference::run(&arguments),
        Command::Tolerances(arguments) => tolerances::run(&arguments),
        Command::DetectionFloor(arguments) => detection_floor::run(&arguments),
        Command::Confusion(arguments) => confusion::run(&arguments),
        Command::Diagnose(arguments) => diagnose::run(&arguments),
        Command::Chart(arguments) => chart::run(&arguments),
        Command::Paper(arguments) => paper::run(&arguments),
        Command::Scene(arguments) => scene::run(&arguments),
        Command::Response(arguments) => response::run(&arguments),
        Command::Criterion(arguments) => criterion::run(&arguments),
        Command::Overturning(arguments) => overturning::run(&arguments),
        Command::Plan(arguments) => plan::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
    };
    match result {
        Ok(status) => status.into(),
        Err(error) => {
            complain(&as_typed(format!("{error:#}"), &words()));
            if error.chain().any(is_of_machine) { Status::Failed.into() } else { ExitCode::from(2) }
        }
    }
}

/// Whether an error is the fault of the machine and not of the request: stdout that can't be written to, a disk that is full or broken.
fn is_of_machine(cause: &(dyn Error + 'static)) -> bool {
    use io::ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull, WriteZero};
    /// EIO, which has no kind.
    const DISK: i32 = 5;
    let full = |error: &io::Error| {
        matches!(error.kind(), FileTooLarge | QuotaExceeded | StorageFull | WriteZero)
            || error.raw_os_error() == Some(DISK)
    };
    cause.is::<Unwritten>() || cause.downcast_ref().is_some_and(full)
}

/// Prints clap's help as it is, and its errors in one line.
fn refuse(error: &clap::Error) -> ExitCode {
    if error.kind() == DisplayHelpOnMissingArgumentOrSubcommand {
        let _ = error.print();
        return ExitCode::from(2);
    }
    if !error.use_stderr() {
        let printed = error.print().and_then(|()| io::stdout().flush());
        return Status::Well.after(output::written(printed).map_err(Into::into)).into();
    }
    let text = error.to_string();
    let lines = text.lines().take_while(|line| !line.starts_with("Usage") && !line.starts_with("For more"));
    let line = lines.map(str::trim).filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ");
    let line = line.trim_start_matches("error: ").replacen(" tip: ", "; ", 1);
    let is_missing = |option: &str| error.kind() == MissingRequiredArgument && line.contains(option);
    let instead = if is_missing("--a <A>") {
        "; in place of --a there may be --epsilon, and in place of them all --scene FILE"
    } else {
        ""
    };
    complain(&format!("{line}{instead}"));
    ExitCode::from(2)
}

/// The words of this command line.
fn words() -> Vec<String> {
    std::env::args_os().map(|word| word.to_string_lossy().into_owned()).collect()
}
