//! The files that a response is drawn into.

use std::path::{Path, PathBuf};

use chattercheck::{
    motion::scene::Account,
    page::{self, Answer},
};
use clap::Args;

use super::{
    super::files::{FileOption, Target, targets},
    told::COLUMNS,
};

#[derive(Args)]
pub(super) struct Drawings {
    /// Draw the ground and the rotation one above the other, with the rests shaded and the chattering before one magnified, as SVG; - is stdout
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// Write the drawing, the summary and the list of the times of rocking as one HTML file that needs nothing else; - is stdout
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
}

#[derive(Clone, Copy)]
enum Content {
    Svg,
    Html,
}

/// Files that can be written.
pub(super) struct Files(Vec<(Content, Target)>);

impl Drawings {
    /// That the files can be written is found out before the work.
    ///
    /// # Errors
    /// When one can't be, or is among those that are `taken`.
    pub fn check(&self, taken: &[(&'static str, &Path)]) -> anyhow::Result<Files> {
        let option = |name, beside, path| FileOption { name, beside, path };
        let options = [
            (Content::Svg, option("svg", "it has to be another file than that of --svg", self.svg.as_deref())),
            (Content::Html, option("html", "it has to be another file than that of --html", self.html.as_deref())),
        ];
        Ok(Files(targets(options, taken)?))
    }
}

impl Files {
    /// Whether nothing is drawn.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether stdout is for one of these files.
    pub fn take_stdout(&self) -> bool {
        self.0.iter().any(|(_, target)| target.is_stdout())
    }

    /// Writes them, each whole or not at all.
    ///
    /// # Errors
    /// When one can't be written.
    pub fn write(
        &self,
        title: &str,
        svg: &str,
        account: &Account,
        rows: &[Vec<String>],
        foot: &str,
    ) -> anyhow::Result<()> {
        self.0.iter().try_for_each(|(content, target)| match content {
            Content::Svg => target.write(svg),
            Content::Html => {
                let title = if title.is_empty() { "Response of a block" } else { title };
                let (facts, caption) = (&account.told(), "Times of rocking");
                target.write(&page::answer(&Answer { title, facts, svg, caption, columns: &COLUMNS, rows, foot }))
            }
        })
    }
}
