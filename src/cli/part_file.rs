//! The file that a part of a run leaves.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, anyhow, bail};
use chattercheck::{
    cases::generate::Named,
    gate::{
        partition::{KIND, Part, Partition, Request},
        report::Report,
    },
    stored::{self, Put},
};

use super::{Status, conclusion::Conclusion, files::make_folder, joined, output::note, report_files::Targets};

/// Where it goes.
pub(super) struct PartFile {
    path: PathBuf,
    partition: Partition,
}

impl PartFile {
    /// The file of this part in a folder, which is made if it is not there.
    ///
    /// # Errors
    /// When the folder can't be written to.
    pub fn new(folder: &Path, partition: Partition) -> anyhow::Result<Self> {
        make_folder("out", folder)?;
        Ok(Self { path: folder.join(partition.file_name()), partition })
    }

    /// What is there already of this part and this request; `None` where nothing is.
    ///
    /// # Errors
    /// When what is there is something else: it is not written over.
    pub fn there(&self, request: &Request) -> anyhow::Result<Option<Part>> {
        if self.path.symlink_metadata().is_err() {
            return Ok(None);
        }
        let path = self.path.display();
        let part = read(&self.path).with_context(|| {
            format!("{path} is there already and is not written over; delete it, or choose another --out")
        })?;
        if part.partition != self.partition {
            bail!(
                "{path} is there already, and is part {}, not {}; choose another --out",
                part.partition,
                self.partition
            );
        }
        if let Some((what, [there, here])) = request.difference(&part.request) {
            bail!(
                "{path} is there already, of another request; {what}: {there} there, {here} asked; delete it, or choose another --out"
            );
        }
        Ok(Some(part))
    }

    /// Puts it there. Where another process has meanwhile put the same, that stays.
    ///
    /// # Errors
    /// When it can't be written, or something else was put there meanwhile.
    pub fn put(&self, part: &Part) -> anyhow::Result<()> {
        let failed = || format!("cannot write {}", self.path.display());
        let lines = part.to_lines().map_err(|error| anyhow!(error)).with_context(failed)?;
        if stored::put(&self.path, KIND, &lines).with_context(failed)? == Put::TakenAlready {
            self.there(&part.request)?;
        }
        Ok(())
    }

    /// Keeps a part, and says what it found and where it is. One that was interrupted is not kept.
    pub fn keep(&self, part: &Part, report: Report, conclusion: &Conclusion, files: &Targets) -> Status {
        let report = report.of_part();
        let left_out = part.responses.as_ref().map_or(0, |of| of.tally.left_out.len()) + part.run.left_out.len();
        let kept = if left_out > 0 { Ok(()) } else { self.put(part) };
        let next = match &kept {
            Ok(()) if left_out == 0 => self.next(&report),
            _ => "next: run it again; this part is not kept\n".to_owned(),
        };
        // The reports on files are those of the whole: without cases there is nothing to write.
        Conclusion { next: Some(next), ..*conclusion }.give(&report, &[], &part.run.outcomes, files).after(kept)
    }

    /// Says again what a part found that is there.
    ///
    /// # Errors
    /// Never, for a part that was read.
    pub fn again(&self, part: Part, all: &[Named], conclusion: &Conclusion, files: &Targets) -> anyhow::Result<Status> {
        note(format_args!("chattercheck: {} is there, whole and of this request: not run again", self.path.display()));
        let (request, named) = (part.request.clone(), part.named.clone());
        let (report, outcomes) = joined::report(&request, &named.manifest, vec![part], all)?;
        let report = report.of_part();
        let replays = Path::new(&named.replays);
        Ok(Conclusion { next: Some(self.next(&report)), replays, ..*conclusion }.give(&report, &[], &outcomes, files))
    }

    /// Where the part is, and what to do next.
    fn next(&self, report: &Report) -> String {
        let Self { path, partition: Partition { part, parts } } = self;
        let folder = path.parent().unwrap_or(Path::new(".")).display();
        let broke = if report.broke.is_empty() { "" } else { "; an engine broke: delete the file to run it again" };
        format!(
            "  part         {part} of {parts}: {}{broke}\n  next         chattercheck merge {folder}, when all {parts} are there\n",
            path.display()
        )
    }
}

/// Reads the file of a part.
///
/// # Errors
/// What is wrong with it.
pub(super) fn read(path: &Path) -> anyhow::Result<Part> {
    let lines = stored::read(path, KIND)?;
    Part::from_lines(&lines).map_err(|error| anyhow!(error))
}
