//! The files that a report is written to, for machines and for pages.

use std::path::{Path, PathBuf};

use chattercheck::{
    cases::generate::Named,
    gate::{
        outcome::Outcomes,
        report::{self, Report},
    },
    page,
};
use clap::Args;

use super::{
    files::{FileOption, Target, targets},
    output,
};

#[derive(Args)]
pub(super) struct ReportFiles {
    /// Write the report as JSON; - is stdout, in place of the text
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the report as JUnit XML; - is stdout, in place of the text
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Write the report as one HTML file that needs nothing else; - is stdout, in place of the text
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Write the report as Markdown, for the page of a CI job; - is stdout, in place of the text
    #[arg(long, value_name = "FILE")]
    summary: Option<PathBuf>,
}

/// Files that can be written, each with what goes into it.
pub(super) struct Targets(Vec<(Content, Target)>);

#[derive(Clone, Copy)]
enum Content {
    Json,
    Junit,
    Html,
    Summary,
}

/// What is written.
pub(super) struct Told<'a> {
    pub report: &'a Report,
    pub cases: &'a [Named],
    pub outcomes: &'a Outcomes,
    /// The folder that replay files go to, if there are any.
    pub replays: Option<&'a Path>,
}

impl Content {
    /// The option that asks for it.
    fn option(self, path: Option<&Path>) -> FileOption<'_> {
        let (name, beside) = match self {
            Self::Json => ("json", "it has to be another file than that of --json"),
            Self::Junit => ("junit", "it has to be another file than that of --junit"),
            Self::Html => ("html", "it has to be another file than that of --html"),
            Self::Summary => ("summary", "it has to be another file than that of --summary"),
        };
        FileOption { name, beside, path }
    }

    fn text(self, told: &Told) -> anyhow::Result<String> {
        let Told { report, cases, outcomes, replays } = told;
        let replays = replays.map(|folder| folder.display().to_string());
        Ok(match self {
            Self::Json => serde_json::to_string_pretty(report)? + "\n",
            Self::Junit => report::junit(report, cases, outcomes)?,
            Self::Html => page::html(report, cases, outcomes, replays.as_deref()),
            Self::Summary => report::summary(report, replays.as_deref()),
        })
    }
}

impl ReportFiles {
    /// That the files can be written is found out before the work, not after it. What is in them stays.
    ///
    /// # Errors
    /// When one can't be written, or two are the same, or one is among the files that are `taken`: what is allowed then, and the path.
    pub fn check(&self, taken: &[(&'static str, &Path)]) -> anyhow::Result<Targets> {
        let given = [
            (Content::Json, &self.json),
            (Content::Junit, &self.junit),
            (Content::Html, &self.html),
            (Content::Summary, &self.summary),
        ];
        let options = given.map(|(content, path)| (content, content.option(path.as_deref())));
        Ok(Targets(targets(options, taken)?))
    }
}

impl Targets {
    /// Whether stdout is for one of these files.
    pub fn take_stdout(&self) -> bool {
        self.0.iter().any(|(_, target)| target.is_stdout())
    }

    /// Prints the report for people, unless stdout is for one of these files.
    ///
    /// # Errors
    /// When stdout can't be written to.
    pub fn print(&self, text: &str) -> anyhow::Result<()> {
        if self.take_stdout() { Ok(()) } else { Ok(output::say(text)?) }
    }

    /// Writes the report: each file whole, or not at all.
    ///
    /// # Errors
    /// When one can't be written; the others are all the same.
    pub fn write(&self, told: &Told) -> anyhow::Result<()> {
        let written = self.0.iter().map(|(content, target)| target.write(&content.text(told)?));
        // All of them, before the first error is looked at.
        written.collect::<Vec<_>>().into_iter().collect()
    }
}
