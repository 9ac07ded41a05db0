//! The files that a report is written to, for machines.

use std::{
    fs,
    path::{Path, PathBuf},
};

use chattercheck::{
    cases::generate::Named,
    gate::report::{self, Report},
};
use clap::Args;
use contract::Invalid;

use super::{files::Target, output};

#[derive(Args)]
pub(super) struct ReportFiles {
    /// Write the report as JSON; - is stdout, in place of the text
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the report as JUnit XML; - is stdout, in place of the text
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
}

/// Files that can be written.
pub(super) struct Targets {
    json: Option<Target>,
    junit: Option<Target>,
}

impl ReportFiles {
    /// That the files can be written is found out before the work, not after it. What is in them stays.
    ///
    /// # Errors
    /// When one can't be written, or both are the same, or one is the file that is `read`.
    pub fn check(&self, read: Option<&Path>) -> anyhow::Result<Targets> {
        let target = |path: &Option<PathBuf>| path.as_deref().map(Target::new).transpose();
        let (json, junit) = (target(&self.json)?, target(&self.junit)?);
        if let (Some(json), Some(junit)) = (&json, &junit)
            && json.is(junit)
        {
            let allowed = "another file than that of --json";
            return Err(Invalid::new("junit", junit.given.display(), allowed).into());
        }
        // A report over it would be the end of it.
        let read = read.and_then(|read| fs::canonicalize(read).ok());
        for (option, target) in [("json", &json), ("junit", &junit)] {
            if let Some(target) =
                target.as_ref().filter(|target| read.as_deref().is_some_and(|read| target.is_at(read)))
            {
                return Err(
                    Invalid::new(option, target.given.display(), "another file than the one that is read").into()
                );
            }
        }
        Ok(Targets { json, junit })
    }
}

impl Targets {
    /// Whether stdout is for the report of machines.
    pub fn take_stdout(&self) -> bool {
        [&self.json, &self.junit].into_iter().flatten().any(Target::is_stdout)
    }

    /// Prints the report for people, unless stdout is for that of machines.
    ///
    /// # Errors
    /// When stdout can't be written to.
    pub fn print(&self, text: &str) -> anyhow::Result<()> {
        if self.take_stdout() { Ok(()) } else { Ok(output::say(text)?) }
    }

    /// Writes the report: each file whole, or not at all.
    ///
    /// # Errors
    /// When one can't be written; the other one is all the same.
    pub fn write(&self, report: &Report, cases: &[Named]) -> anyhow::Result<()> {
        let json =
            self.json.as_ref().map_or(Ok(()), |file| file.write(&(serde_json::to_string_pretty(report)? + "\n")));
        let junit = self.junit.as_ref().map_or(Ok(()), |file| file.write(&report::junit(report, cases)?));
        json.and(junit)
    }
}
