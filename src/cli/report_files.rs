//! The files that a report is written to, for machines.

use std::{
    fs::{self, OpenOptions},
    path::PathBuf,
};

use anyhow::Context as _;
use chattercheck::{
    cases::generate::Named,
    gate::report::{self, Report},
};
use clap::Args;
use contract::Invalid;

#[derive(Args)]
pub(super) struct ReportFiles {
    /// Write the report as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the report as JUnit XML
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
}

impl ReportFiles {
    /// That the files can be written is found out before the work, not after it. What is in them stays.
    pub fn check(&self) -> anyhow::Result<()> {
        if let (Some(json), Some(junit)) = (&self.json, &self.junit)
            && json == junit
        {
            return Err(Invalid::new("junit", junit.display(), "another file than that of --json").into());
        }
        for path in [&self.json, &self.junit].into_iter().flatten() {
            let existed = path.exists();
            OpenOptions::new()
                .append(true)
                .create(true)
                .open(path)
                .with_context(|| format!("cannot write {}", path.display()))?;
            if !existed {
                fs::remove_file(path).with_context(|| format!("cannot write {}", path.display()))?;
            }
        }
        Ok(())
    }

    /// Writes the report.
    pub fn write(&self, report: &Report, cases: &[Named]) -> anyhow::Result<()> {
        if let Some(path) = &self.json {
            let text = serde_json::to_string_pretty(report)? + "\n";
            fs::write(path, text).with_context(|| format!("cannot write {}", path.display()))?;
        }
        if let Some(path) = &self.junit {
            fs::write(path, report::junit(report, cases)?)
                .with_context(|| format!("cannot write {}", path.display()))?;
        }
        Ok(())
    }
}
