use std::path::{Path, PathBuf};

use anyhow::{anyhow, bail};
use clap::Args;

use super::{
    Status,
    conclusion::{Conclusion, Format},
    joined,
    output::note,
    part_files::{self, Parts},
    report_files::ReportFiles,
    run_cases::Chosen,
};

/// Make one run of its parts, and judge it again
#[derive(Args)]
pub(super) struct Arguments {
    /// The folder with the files that `verify --partition K/N --out DIR` left; the folders in it are looked into as well
    folder: PathBuf,
    #[command(flatten)]
    files: ReportFiles,
    /// How stdout is written: for people, or for a workflow of GitHub, with commands that it shows as annotations
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Print the wide tables too: every pair, every claim, every law
    #[arg(long)]
    full: bool,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let found = part_files::files(&arguments.folder)?;
    let taken: Vec<_> =
        found.iter().map(|path| ("it has to be another file than a part of the run", path.as_path())).collect();
    let files = arguments.files.check(&taken)?;
    let conclusion = Conclusion { full: arguments.full, format: arguments.format, replays: Path::new(""), next: None };
    conclusion.check(&files)?;
    let folder = arguments.folder.display();
    let Parts { parts, wrong } = part_files::all(&arguments.folder, found);
    if parts.is_empty() && wrong.is_empty() {
        note(format_args!("chattercheck: nothing ran: there is no part-K-of-N.jsonl in {folder}"));
        return Ok(Status::Nothing);
    }
    if !wrong.is_empty() {
        wrong.iter().for_each(|wrong| note(format_args!("chattercheck: {wrong}")));
        bail!("{folder} is not merged: see above");
    }
    let first = parts.first().ok_or_else(|| anyhow!("{folder} has no part"))?;
    let (request, named) = (first.request.clone(), first.named.clone());
    let all = Chosen::new(request.selection(), request.own.clone()).all;
    let (report, outcomes) = joined::report(&request, &named.manifest, parts, &all)?;
    Ok(Conclusion { replays: Path::new(&named.replays), ..conclusion }.give(&report, &all, &outcomes, &files))
}
