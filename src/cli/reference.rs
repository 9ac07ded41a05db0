use std::{collections::BTreeMap, path::PathBuf};

use anyhow::anyhow;
use chattercheck::studies::{
    chart::{csv_text, place},
    reference,
};
use clap::Args;

use super::{
    Status,
    files::make_folder,
    output::{note, say},
};

/// Make the reference tables: 60 digits from the printed equations; 25 proven digits of both models; critical amplitudes,
/// certified ones and an interpolant
#[derive(Args)]
pub(super) struct Arguments {
    /// Where the tables go
    #[arg(long, value_name = "DIR", default_value = "data/reference")]
    out: PathBuf,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    // First, because what follows takes a while.
    make_folder("out", &arguments.out)?;
    let bar = indicatif::ProgressBar::new_spinner();
    let (impacts, times) = reference::tables(|| bar.inc(1)).map_err(|decline| anyhow!("{decline}"))?;
    let (proven_impacts, proven_times) =
        reference::proven_tables(|| bar.inc(1)).map_err(|decline| anyhow!("{decline}"))?;
    let critical = reference::critical_amplitudes(|| bar.inc(1)).map_err(|decline| anyhow!("{decline}"))?;
    let interpolant = reference::critical_interpolant(|| bar.inc(1)).map_err(|decline| anyhow!("{decline}"))?;
    bar.finish_and_clear();
    let tables = [
        ("linear_impacts.csv", csv_text(&impacts)?),
        ("linear_chattering_times.csv", csv_text(&times)?),
        ("proven_impacts.csv", csv_text(&proven_impacts)?),
        ("proven_chattering_times.csv", csv_text(&proven_times)?),
        ("critical_amplitudes.csv", csv_text(&critical)?),
        ("critical_interpolant.csv", csv_text(&interpolant)?),
    ];
    for (name, text) in &tables {
        note(format_args!("{name}: {} rows", text.lines().count().saturating_sub(1)));
    }
    let tables: BTreeMap<String, String> = tables.map(|(name, text)| (name.to_owned(), text)).into();
    say(&place(&arguments.out, &tables)?)?;
    Ok(Status::Well)
}
