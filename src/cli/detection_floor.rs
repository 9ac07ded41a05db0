use chattercheck::{
    faults::{
        catalogue::catalogue,
        floor::{self, Row, Smallest},
        trial::Trial,
    },
    panel,
};
use clap::Args;

use super::{
    Status,
    output::{note, print},
    rows::Format,
    seed::Seed,
};

/// Plant every fault of the catalogue in turn, and find the smallest size at which the gate is red
#[derive(Args)]
pub(super) struct Arguments {
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    seed: Seed,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let trial = Trial::new(panel::default(), arguments.seed.value()?);
    let faults = catalogue(trial.oracles());
    let bar = indicatif::ProgressBar::new(faults.len() as u64);
    let rows = floor::table(&trial, &faults, || bar.inc(1))?;
    bar.finish_and_clear();
    let written = print(&arguments.format.rows(HEAD, &rows, cells)?);
    let escaped: Vec<&Row> = rows.iter().filter(|row| row.escapes()).collect();
    for row in &escaped {
        note(format_args!("chattercheck: the gate stays green with \"{}\" in {}", row.fault, row.oracle));
    }
    let status = if escaped.is_empty() { Status::Well } else { Status::Disagreed };
    Ok(status.after(written.map_err(Into::into)))
}

const HEAD: [&str; 6] = ["fault", "oracle", "size is", "natural", "smallest caught", "by"];

fn cells(row: &Row) -> [String; 6] {
    let natural = row.natural.map_or_else(String::new, |natural| match row.smallest {
        Smallest::EveryDepth | Smallest::EscapesAt(_) => format!("1 to {natural}"),
        _ => number(natural),
    });
    let smallest = match &row.smallest {
        Smallest::Amount(size) => number(*size),
        Smallest::Any(_) => "any size".to_owned(),
        Smallest::EveryDepth => "every one".to_owned(),
        Smallest::Seen => "caught".to_owned(),
        Smallest::Escapes => "ESCAPES".to_owned(),
        Smallest::EscapesAt(depths) => format!("ESCAPES at {depths:?}"),
    };
    let by = row.caught_by.clone().unwrap_or_default();
    [row.fault.to_owned(), row.oracle.clone(), row.size.to_owned(), natural, smallest, by]
}

/// Two digits: the floor is not known better.
fn number(size: f64) -> String {
    if (0.01..100.0).contains(&size) { format!("{:.2}", size) } else { format!("{size:.1e}") }
}
