use chattercheck::gate::tolerance::TABLE;
use clap::Args;

use super::{Status, output::print};

/// Print the table of what is allowed beyond the oracles' own claims, and why
#[derive(Args)]
pub(super) struct Arguments {}

pub(super) fn run(_: &Arguments) -> anyhow::Result<Status> {
    let mut text = "| applies to | value | what it is | reason |\n| --- | --- | --- | --- |\n".to_owned();
    for entry in TABLE {
        text += &format!("| {} | {:?} | {} | {} |\n", entry.applies_to, entry.value, entry.meaning, entry.reason);
    }
    print(&text)?;
    Ok(Status::Well)
}
