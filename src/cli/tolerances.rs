use chattercheck::tolerance::TABLE;
use clap::Args;

use super::Verdict;

/// Print the table of what is allowed beyond the oracles' own claims, and why
#[derive(Args)]
pub(super) struct Arguments {}

pub(super) fn run(_: &Arguments) -> anyhow::Result<Verdict> {
    println!("| applies to | value | what it is | reason |\n| --- | --- | --- | --- |");
    for entry in TABLE {
        println!("| {} | {:?} | {} | {} |", entry.applies_to, entry.value, entry.meaning, entry.reason);
    }
    Ok(Verdict::Well)
}
