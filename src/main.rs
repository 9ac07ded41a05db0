//! The command line of chattercheck.
//!
//! `chattercheck COMMAND --help` documents each command.

mod cli;

fn main() -> std::process::ExitCode {
    cli::run()
}
