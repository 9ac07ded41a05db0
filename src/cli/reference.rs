use std::{fs, path::PathBuf};

use anyhow::{Context as _, anyhow};
use chattercheck::studies::reference;
use clap::Args;
use serde::Serialize;

use super::Status;

/// Make the reference tables: 60 digits from the printed equations; 25 proven digits of both models; critical amplitudes,
/// certified ones and an interpolant
#[derive(Args)]
pub(super) struct Arguments {
    /// Where the tables go
    #[arg(long, value_name = "DIR", default_value = "data/reference")]
    out: PathBuf,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let folder = &arguments.out;
    let bar = indicatif::ProgressBar::new_spinner();
    let (impacts, times) = reference::tables(|| bar.inc(1)).map_err(|decline| anyhow!("{decline}"))?;
    let (proven_impacts, proven_times) =
        reference::proven_tables(|| bar.inc(1)).map_err(|decline| anyhow!("{decline}"))?;
    let critical = reference::critical_amplitudes(|| bar.inc(1)).map_err(|decline| anyhow!("{decline}"))?;
    let interpolant = reference::critical_interpolant(|| bar.inc(1)).map_err(|decline| anyhow!("{decline}"))?;
    bar.finish_and_clear();
    fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    write(&folder.join("linear_impacts.csv"), &impacts)?;
    write(&folder.join("linear_chattering_times.csv"), &times)?;
    write(&folder.join("proven_impacts.csv"), &proven_impacts)?;
    write(&folder.join("proven_chattering_times.csv"), &proven_times)?;
    write(&folder.join("critical_amplitudes.csv"), &critical)?;
    write(&folder.join("critical_interpolant.csv"), &interpolant)?;
    Ok(Status::Well)
}

fn write<Row: Serialize>(path: &PathBuf, rows: &[Row]) -> anyhow::Result<()> {
    let mut csv = csv::Writer::from_path(path).with_context(|| format!("cannot write {}", path.display()))?;
    rows.iter().try_for_each(|row| csv.serialize(row))?;
    csv.flush()?;
    eprintln!("{}: {} rows", path.display(), rows.len());
    Ok(())
}
