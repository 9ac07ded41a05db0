use std::path::PathBuf;

use chattercheck::studies::{chart, paper};
use clap::Args;

use super::{Status, files::make_folder, output::say};

/// The paper again: its figures as tables (CSV) and charts (SVG) drawn from them, and its claims, each measured and judged
///
/// The figures have the paper's parameters and axes. The claims are judged in claims.csv and claims.md; what does not hold is a result, not
/// an error. A few seconds. Either all files are written, or none.
#[derive(Args)]
pub(super) struct Arguments {
    /// Where the files go
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let Arguments { out } = arguments;
    // First, because what follows takes a while.
    make_folder("out", out)?;
    let bar = indicatif::ProgressBar::new_spinner();
    let files = paper::files(|| bar.inc(1))?;
    bar.finish_and_clear();
    say(&chart::place(out, &files)?)?;
    Ok(Status::Well)
}
