//! What one part leaves.

use serde::{Deserialize, Serialize};

use super::{Partition, Request};
use crate::{
    gate::{responses, run::Run},
    stored::{from_line, to_line},
};

/// What the file of a part calls itself.
pub const KIND: &str = "part";

/// What one part of a run found, with all that a report needs.
#[derive(Debug, Clone)]
pub struct Part {
    /// Which part.
    pub partition: Partition,
    /// What the run was asked.
    pub request: Request,
    /// What the text of a report names.
    pub named: Names,
    /// What was found in cases.
    pub run: Run,
    /// What was found in whole responses, where any were run.
    pub responses: Option<responses::Report>,
}

/// Where things are, as they were given: they are named in the text, and nothing depends on them.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Names {
    /// The manifest of engines; empty without.
    pub manifest: String,
    /// The folder of replay files.
    pub replays: String,
}

/// The first line of content.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Head {
    part: usize,
    parts: usize,
    request: Request,
    named: Names,
}

impl Part {
    /// The lines of its file.
    ///
    /// # Errors
    /// When something in it can't be written as JSON.
    pub fn to_lines(&self) -> Result<Vec<String>, String> {
        let Partition { part, parts } = self.partition;
        let head = Head { part, parts, request: self.request.clone(), named: self.named.clone() };
        Ok(vec![to_line(&head)?, to_line(&self.run)?, to_line(&self.responses)?])
    }

    /// Reads the lines of a file.
    ///
    /// # Errors
    /// When they are not those of a part of this version.
    pub fn from_lines(lines: &[String]) -> Result<Self, String> {
        /// What tells the version, whatever else there is.
        #[derive(Deserialize)]
        struct Written {
            request: Version,
        }
        #[derive(Deserialize)]
        struct Version {
            version: String,
        }
        const OURS: &str = env!("CARGO_PKG_VERSION");
        let [head, run, responses] = lines else { return Err(format!("{} lines, 3 expected", lines.len())) };
        let Written { request: Version { version } } = from_line(head)?;
        if version != OURS {
            return Err(format!("version {version} wrote it, this is version {OURS}: use that one, or run it again"));
        }
        let Head { part, parts, request, named } = from_line(head)?;
        if !(1..=parts).contains(&part) {
            return Err(format!("it is part {part} of {parts}"));
        }
        let (run, responses) = (from_line(run)?, from_line(responses)?);
        Ok(Self { partition: Partition { part, parts }, request, named, run, responses })
    }
}
