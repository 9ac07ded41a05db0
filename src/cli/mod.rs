//! The command line: one file a command; each parses, calls the library and prints.

mod case_flags;
mod chart;
mod chattering_time;
mod critical_amplitude;
mod detection_floor;
mod diagnose;
mod oracle_flags;
mod oracles;
mod output;
mod paper;
mod plan;
mod reference;
mod replay;
mod report_files;
mod response;
mod scene;
mod simulate;
mod tolerances;
mod verify;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Differential verification of the chattering of a rocking rigid block.
///
/// Data goes to stdout, progress and diagnostics to stderr. Exit status: 0 all is well; 1 a check disagreed; 2 the request was wrong.
#[derive(Parser)]
#[command(version, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Verify(verify::Arguments),
    Replay(replay::Arguments),
    Simulate(simulate::Arguments),
    ChatteringTime(chattering_time::Arguments),
    CriticalAmplitude(critical_amplitude::Arguments),
    Oracles(oracles::Arguments),
    Reference(reference::Arguments),
    Tolerances(tolerances::Arguments),
    DetectionFloor(detection_floor::Arguments),
    Diagnose(diagnose::Arguments),
    Chart(chart::Arguments),
    Paper(paper::Arguments),
    Scene(scene::Arguments),
    Response(response::Arguments),
    Plan(plan::Arguments),
}

/// What a command that ran came to.
pub(crate) enum Status {
    /// All is well.
    Well,
    /// A check disagreed.
    Disagreed,
}

/// Parses the command line and runs the command.
pub(crate) fn run() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return refuse(&error),
    };
    let result = match cli.command {
        Command::Verify(arguments) => verify::run(&arguments),
        Command::Replay(arguments) => replay::run(&arguments),
        Command::Simulate(arguments) => simulate::run(&arguments),
        Command::ChatteringTime(arguments) => chattering_time::run(&arguments),
        Command::CriticalAmplitude(arguments) => critical_amplitude::run(&arguments),
        Command::Oracles(arguments) => oracles::run(&arguments),
        Command::Reference(arguments) => reference::run(&arguments),
        Command::Tolerances(arguments) => tolerances::run(&arguments),
        Command::DetectionFloor(arguments) => detection_floor::run(&arguments),
        Command::Diagnose(arguments) => diagnose::run(&arguments),
        Command::Chart(arguments) => chart::run(&arguments),
        Command::Paper(arguments) => paper::run(&arguments),
        Command::Scene(arguments) => scene::run(&arguments),
        Command::Response(arguments) => response::run(&arguments),
        Command::Plan(arguments) => plan::run(&arguments),
    };
    match result {
        Ok(Status::Well) => ExitCode::SUCCESS,
        Ok(Status::Disagreed) => ExitCode::from(1),
        // A reader that has seen enough, as in `chattercheck simulate | head`, is no error.
        Err(error) if is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("chattercheck: {error:#}");
            ExitCode::from(2)
        }
    }
}

/// Prints clap's help as it is, and its errors in one line.
fn refuse(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() || error.kind() == clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        let _ = error.print();
        return if error.use_stderr() { ExitCode::from(2) } else { ExitCode::SUCCESS };
    }
    let text = error.to_string();
    let lines = text.lines().take_while(|line| !line.starts_with("Usage") && !line.starts_with("For more"));
    let line = lines.map(str::trim).filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ");
    eprintln!("chattercheck: {}", line.trim_start_matches("error: "));
    ExitCode::from(2)
}

fn is_broken_pipe(error: &anyhow::Error) -> bool {
    let io = error.chain().filter_map(|cause| cause.downcast_ref::<std::io::Error>());
    let of_csv = error.chain().filter_map(|cause| match cause.downcast_ref::<csv::Error>()?.kind() {
        csv::ErrorKind::Io(io) => Some(io),
        _ => None,
    });
    io.chain(of_csv).any(|io| io.kind() == std::io::ErrorKind::BrokenPipe)
}
