//! Commands about engines: simulators of somebody else, run as processes.

mod ask;
mod check;
mod new;
mod planted;

use std::path::{Path, PathBuf};

use chattercheck::panel::{self, Role};
use clap::{Args, Subcommand};
use contract::Oracle;

use super::Status;

/// Look at an engine, a simulator of your own in any language; ask it a case; begin a new one
#[derive(Args)]
#[command(arg_required_else_help = true)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Check(check::Arguments),
    Ask(ask::Arguments),
    New(new::Arguments),
    Planted(planted::Arguments),
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    match &arguments.command {
        Command::Check(arguments) => check::run(arguments),
        Command::Ask(arguments) => ask::run(arguments),
        Command::New(arguments) => new::run(arguments),
        Command::Planted(arguments) => planted::run(arguments),
    }
}

/// The manifest where none is named.
const MANIFEST: &str = "engines.toml";

#[derive(Args)]
struct ManifestFlag {
    /// The manifest that the engine is in
    #[arg(long, value_name = "FILE", default_value = MANIFEST)]
    engines: PathBuf,
}

impl ManifestFlag {
    fn path(&self) -> &Path {
        &self.engines
    }
}

/// An oracle that has derivatives.
pub(super) fn sensitive() -> Box<dyn Oracle> {
    panel::with_role(Role::Sensitivities).into_iter().next().unwrap_or_else(panel::stepper)
}
