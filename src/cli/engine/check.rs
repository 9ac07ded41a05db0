use std::path::PathBuf;

use chattercheck::{
    engines::{
        Entry, Manifest,
        checkup::{Mark, Step, checkup},
    },
    gate::judge::Judges,
    panel,
};
use clap::Args;
use serde::Serialize;

use super::sensitive;
use crate::cli::{Status, output::Format};

/// Start every engine of a manifest, and see whether it says what it has to and is right on easy cases
///
/// Exit status 1: an answer is wrong; 3: an engine broke; 4: one declined every easy case, so that nothing is known of it.
#[derive(Args)]
pub(super) struct Arguments {
    /// The manifest, see the chapter on engines in the guide
    file: PathBuf,
    /// This engine only
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// What was seen of an engine.
#[derive(Serialize)]
struct Seen {
    name: String,
    steps: Vec<Step>,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let manifest = Manifest::read(&arguments.file)?;
    let entries: Vec<&Entry> = match &arguments.only {
        Some(name) => vec![manifest.engine(name)?],
        None => manifest.engines.iter().collect(),
    };
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: 1, closing: None };
    let mut seen = Vec::new();
    for entry in entries {
        let steps = checkup(entry, sensitive(), &judges)?;
        seen.push(Seen { name: entry.launch.name.clone(), steps });
    }
    let file = arguments.file.display().to_string();
    arguments.format.print(&seen, |seen| text(seen, &file))?;
    Ok(match seen.iter().map(worst).max().unwrap_or(Mark::Well) {
        Mark::Well | Mark::Hint => Status::Well,
        Mark::Nothing => Status::Nothing,
        Mark::Wrong => Status::Disagreed,
        Mark::Broke => Status::Failed,
    })
}

fn worst(seen: &Seen) -> Mark {
    seen.steps.iter().map(|step| step.mark).max().unwrap_or(Mark::Well)
}

fn text(all: &[Seen], file: &str) -> String {
    let mut lines = Vec::new();
    for seen in all {
        lines.push(seen.name.clone());
        for Step { name, mark, says, stderr } in &seen.steps {
            let mark = match mark {
                Mark::Well => "ok",
                Mark::Hint => "hint",
                Mark::Nothing => "NONE",
                Mark::Wrong => "WRONG",
                Mark::Broke => "BROKE",
            };
            lines.push(format!("  {mark:5} {name:9} {says}"));
            lines.extend(stderr.iter().map(|line| format!("        | {line}")));
        }
        let name = &seen.name;
        lines.push(match worst(seen) {
            Mark::Well | Mark::Hint => {
                format!("next: chattercheck verify --engines {file} --only {name} --cases 50")
            }
            Mark::Nothing => "next: let it answer one of these cases".to_owned(),
            Mark::Wrong => format!(
                "next: see its answers with chattercheck engine ask {name} --engines {file} and the flags of the case"
            ),
            Mark::Broke => format!("next: mend that; chattercheck engine ask {name} --engines {file} shows the talk"),
        });
    }
    lines.join("\n")
}
