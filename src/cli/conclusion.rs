//! What a run comes to: the report is printed and written, and says what to do next.

use std::path::Path;

use chattercheck::{
    cases::generate::Named,
    gate::{
        report::{self, Report},
        verdict::Verdict,
    },
};

use super::{Status, report_files::Targets};

/// What is said of a run besides the report.
pub(super) struct Conclusion<'a> {
    /// The wide tables too.
    pub full: bool,
    /// Where replay files go.
    pub replays: &'a Path,
    /// What to do next, where that is not the usual.
    pub next: Option<String>,
}

impl Conclusion<'_> {
    /// Prints the report and writes its files. A check that disagreed is told by the status, even where nothing can be written.
    pub fn give(&self, report: &Report, cases: &[Named], files: &Targets) -> Status {
        let tables = if self.full { format!("\n{}", report::full(report)) } else { String::new() };
        let next = self.next.clone().unwrap_or_else(|| next(report, self.full, self.replays));
        let status =
            Status::from(report.verdict).after(files.print(&format!("{}{next}{tables}", report::text(report))));
        status.after(files.write(report, cases))
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
    let failed = report.failures.len() + report.responses.as_ref().map_or(0, |of| of.failures.len());
    match report.verdict {
        Verdict::Pass => format!("  next         another seed: --seed {}{tables}\n", report.seed.wrapping_add(1)),
        Verdict::Undecided if !report.broke.is_empty() => {
            "next: mend what broke the engine; `chattercheck engine ask` shows the talk about a case\n".to_owned()
        }
        Verdict::Undecided => "next: run it again to its end; --partition K/N runs a share of the cases\n".to_owned(),
        Verdict::Fail if failed == 0 => format!("next: see which oracles the shortfalls name{tables}\n"),
        Verdict::Fail => {
            let folder = folder.display();
            format!(
                "next: the smallest cases that still fail go to {folder}; run them again with `chattercheck replay`, scenes with `chattercheck response`{tables}\n"
            )
        }
    }
}
