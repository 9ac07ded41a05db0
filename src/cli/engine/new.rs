use std::{
    fs,
    path::{Path, PathBuf},
};

use anyhow::{Context as _, bail};
use chattercheck::engines::starter::{self, Starter};
use clap::Args;

use super::MANIFEST;
use crate::cli::{Status, files::write_new, output::say};

/// Write a small engine that works, and its manifest, to begin with
#[derive(Args)]
pub(super) struct Arguments {
    /// The language that it is written in
    #[arg(value_name = "python|c|cpp|julia|octave|rust")]
    language: String,
    /// The folder for it; it is made if it is not there, and no file in it is replaced
    directory: PathBuf,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let Some(starter) = Starter::named(&arguments.language) else {
        let known: Vec<&str> = starter::ALL.iter().map(|starter| starter.language).collect();
        bail!(
            "language = {} is outside the allowed range: {}; for another language see the chapter on engines in the guide",
            arguments.language,
            known.join(", ")
        );
    };
    let folder = &arguments.directory;
    let files = [(MANIFEST, starter.manifest()), (starter.file, starter.text.to_owned())];
    for (name, _) in &files {
        let path = folder.join(name);
        if path.symlink_metadata().is_ok() {
            bail!("directory = {}: {} is there already", folder.display(), path.display());
        }
    }
    fs::create_dir_all(folder).with_context(|| format!("directory = {} can't be made", folder.display()))?;
    for (name, text) in &files {
        let path = folder.join(name);
        write_new(&path, text).with_context(|| format!("cannot write {}", path.display()))?;
    }
    say(&next(starter, folder))?;
    Ok(Status::Well)
}

/// What was written, and what to do with it.
fn next(starter: &Starter, folder: &Path) -> String {
    let show = |name: &str| folder.join(name).display().to_string();
    let manifest = show(MANIFEST);
    let mut lines = vec![format!("wrote {} and {manifest}", show(starter.file))];
    if let Some(build) = starter.build {
        lines.push(format!("build it: (cd {} && {build})", folder.display()));
    }
    lines.push(format!("look at it: chattercheck engine check {manifest}"));
    lines.push(format!("put it under the gate: chattercheck verify --engines {manifest} --cases 50"));
    lines.join("\n") + "\n"
}
