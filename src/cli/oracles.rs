use chattercheck::panel;
use clap::Args;

use super::{Status, output::print};

/// List the oracles, and which of them `verify` asks by default
#[derive(Args)]
pub(super) struct Arguments {}

pub(super) fn run(_: &Arguments) -> anyhow::Result<Status> {
    let default = panel::default();
    let mut text = String::new();
    for oracle in panel::all() {
        let asked = if default.iter().any(|other| other.name() == oracle.name()) { "default" } else { "by name" };
        text += &format!("{:24} {:10} {asked}\n", oracle.name(), format!("{:?}", oracle.model()).to_lowercase());
    }
    print(&text)?;
    Ok(Status::Well)
}
