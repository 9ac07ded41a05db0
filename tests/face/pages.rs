//! The pages that people read: the README, the guide, and what is said of the data.

use std::path::{Path, PathBuf};

/// A page, and where it is in the repository.
pub struct Page {
    pub path: PathBuf,
    pub text: String,
}

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

pub fn read(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap()
}

/// The Markdown files in a folder, and below it.
fn below(folder: &Path, pages: &mut Vec<Page>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            below(&path, pages);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            pages.push(Page { text: std::fs::read_to_string(&path).unwrap(), path });
        }
    }
}

/// Every page.
pub fn all() -> Vec<Page> {
    let mut pages = vec![Page { path: root().join("README.md"), text: read("README.md") }];
    for folder in ["src/guide", "data", "benches"] {
        below(&root().join(folder), &mut pages);
    }
    assert!(pages.len() >= 20, "{} pages", pages.len());
    pages
}

impl Page {
    /// What stands in single backticks outside of code blocks.
    pub fn spans(&self) -> Vec<&str> {
        self.prose().flat_map(|line| line.split('`').skip(1).step_by(2)).collect()
    }

    /// The lines outside of code blocks.
    pub fn prose(&self) -> impl Iterator<Item = &str> {
        self.text.split("```").step_by(2).flat_map(str::lines)
    }

    /// The shell sessions: each command, and the lines that it is shown to print.
    pub fn sessions(&self) -> Vec<(&str, Vec<&str>)> {
        let blocks = self.text.split("```").skip(1).step_by(2).filter_map(|block| block.strip_prefix("console\n"));
        let mut sessions: Vec<(&str, Vec<&str>)> = Vec::new();
        for line in blocks.flat_map(str::lines).filter(|line| !line.trim().is_empty()) {
            match (line.trim_start().strip_prefix("$ "), sessions.last_mut()) {
                (Some(command), _) => sessions.push((command.split(" #").next().unwrap().trim(), Vec::new())),
                (None, Some((_, printed))) => printed.push(line),
                (None, None) => panic!("{}: a session that begins with {line}", self.path.display()),
            }
        }
        sessions
    }
}
