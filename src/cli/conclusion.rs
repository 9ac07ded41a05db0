//! What a run comes to: the report is printed and written, and says what to do next.

use std::path::Path;

use anyhow::bail;
use chattercheck::{
    cases::generate::Named,
    gate::{
        outcome::Outcomes,
        report::{self, Report},
        verdict::Verdict,
    },
};
use clap::ValueEnum;

use super::{
    Status,
    report_files::{Targets, Told},
};

/// What is said of a run besides the report.
pub(super) struct Conclusion<'a> {
    /// The wide tables too.
    pub full: bool,
    /// How stdout is written.
    pub format: Format,
    /// Where replay files go.
    pub replays: &'a Path,
    /// What to do next, where that is not the usual.
    pub next: Option<String>,
}

/// How stdout is written.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Text,
    Github,
}

impl Conclusion<'_> {
    /// Finds out whether all that is asked for can be said.
    ///
    /// # Errors
    /// When stdout is for a file, and something that is printed there is asked for.
    pub fn check(&self, files: &Targets) -> anyhow::Result<()> {
        for (option, is_given) in [("--full", self.full), ("--format github", self.format == Format::Github)] {
            if is_given && files.take_stdout() {
                bail!("{option} is not used where stdout is for a file (- as FILE); it is for the report for people");
            }
        }
        Ok(())
    }

    /// Prints the report and writes its files. A check that disagreed is told by the status, even where nothing can be written.
    pub fn give(&self, report: &Report, cases: &[Named], outcomes: &Outcomes, files: &Targets) -> Status {
        let tables = if self.full { format!("\n{}", report::full(report)) } else { String::new() };
        let next = self.next.clone().unwrap_or_else(|| next(report, self.full, self.replays));
        let text = format!("{}{next}{tables}", report::text(report));
        let text = match self.format {
            Format::Text => text,
            Format::Github => report::not_obeyed(&text) + &report::annotations(report),
        };
        let status = Status::from(report.verdict).after(files.print(&text));
        status.after(files.write(&Told { report, cases, outcomes, replays: Some(self.replays) }))
    }
}

impl From<Verdict> for Status {
    fn from(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Pass => Self::Well,
            Verdict::Undecided => Self::Failed,
            Verdict::Fail => Self::Disagreed,
        }
    }
}

/// What to do next, in a line.
fn next(report: &Report, full: bool, folder: &Path) -> String {
    let tables = if full { "" } else { "; --full prints every pair, claim and law" };
    let next = report::next(report, Some(&folder.display().to_string()));
    match report.verdict {
        Verdict::Pass => format!("  next         {next}{tables}\n"),
        Verdict::Undecided => format!("next: {next}\n"),
        Verdict::Fail => format!("next: {next}{tables}\n"),
    }
}
