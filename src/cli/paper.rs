use std::{fs, path::PathBuf};

use anyhow::{Context as _, bail};
use chattercheck::paper;
use clap::Args;

use super::{Verdict, output::print};

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

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Verdict> {
    let Arguments { out } = arguments;
    // First, because what follows takes a while.
    fs::create_dir_all(out)
        .with_context(|| format!("out = {} is not a folder, and cannot be made one", out.display()))?;
    // Written beside where they go, and moved there when they are whole.
    let beside = tempfile::Builder::new().prefix(".paper-").tempdir_in(out);
    let beside = beside.with_context(|| format!("out = {} cannot be written to", out.display()))?;
    let bar = indicatif::ProgressBar::new_spinner();
    let files = paper::files(|| bar.inc(1))?;
    bar.finish_and_clear();
    // All that can be known to stand in the way, before anything is put in its place.
    if let Some(taken) = files.keys().map(|name| out.join(name)).find(|path| path.is_dir()) {
        bail!("out = {}: {} is a folder, and a file of that name is to be written", out.display(), taken.display());
    }
    for (name, text) in &files {
        let path = beside.path().join(name);
        fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
    }
    let mut written = String::new();
    for name in files.keys() {
        let path = out.join(name);
        fs::rename(beside.path().join(name), &path).with_context(|| format!("cannot write {}", path.display()))?;
        written += &format!("{}\n", path.display());
    }
    print(&written)?;
    Ok(Verdict::Well)
}
