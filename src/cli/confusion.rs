use anyhow::{Context as _, anyhow};
use chattercheck::{
    engines::{Entry, Started, record::Keeper},
    faults::{
        Fault,
        catalogue::of_engines,
        confusion::{self, Bench, Outcome, Row},
    },
    gate::explanation::Explanation,
};
use clap::Args;

use super::{
    Status,
    engine::sensitive,
    output::{note, print},
    rows::Format,
    seed::Seed,
};

/// Plant every mistake of the catalogue in an engine in turn, and see whether the gate names it
#[derive(Args)]
pub(super) struct Arguments {
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    seed: Seed,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let bench = Bench::new(arguments.seed.value()?);
    let faults = of_engines();
    let bar = indicatif::ProgressBar::new(faults.len() as u64);
    let mut rows = Vec::with_capacity(faults.len());
    for fault in &faults {
        let engine = planted(fault)?;
        rows.push(bench.row(fault, &engine.oracle));
        engine.oracle.into_engine().stop();
        bar.inc(1);
    }
    bar.finish_and_clear();
    let mut text = arguments.format.rows(HEAD, &rows, cells)?;
    if arguments.format == Format::Markdown {
        text += &format!("\n{}.\n", in_short(&rows));
    }
    let written = print(&text);
    let wrong: Vec<&Row> = rows.iter().filter(|row| row.outcome == Outcome::Misnamed).collect();
    for row in rows.iter().filter(|row| row.is_unnoticed()) {
        note(format_args!("chattercheck: \"{}\" in {} is not noticed at all", row.fault, row.oracle));
    }
    for row in &wrong {
        note(format_args!("chattercheck: \"{}\" in {} is taken for something else", row.fault, row.oracle));
    }
    note(format_args!("chattercheck: {}", in_short(&rows)));
    let status = if confusion::are_named(&rows) { Status::Well } else { Status::Disagreed };
    Ok(status.after(written.map_err(Into::into)))
}

/// This program as an engine with a fault.
fn planted(fault: &Fault) -> anyhow::Result<Started> {
    let program = std::env::current_exe().context("cannot find this program")?;
    let program = program.to_str().ok_or_else(|| anyhow!("the path of this program is no text"))?;
    let run = [program, "engine", "planted", fault.name, "--oracle", &fault.oracle];
    let entry = Entry::bare("planted", run, confusion::honest(fault).model());
    Started::new(&Entry { may_decline: 1.0, ..entry }, sensitive(), &Keeper::default())
        .map_err(|broke| anyhow!("{}: {broke}", fault.name))
}

/// How many of the faults with which an answer is wrong are named.
fn counts(rows: &[Row]) -> [usize; 4] {
    let count = |outcome| rows.iter().filter(|row| row.outcome == outcome).count();
    [Outcome::Named, Outcome::AmongEquals, Outcome::Missed, Outcome::Misnamed].map(count)
}

fn in_short(rows: &[Row]) -> String {
    let [named, equal, missed, misnamed] = counts(rows);
    format!(
        "of {} mistakes that make an answer wrong {named} are named, {equal} among equals, {missed} are missed and {misnamed} taken for another",
        named + equal + missed + misnamed
    )
}

const HEAD: [&str; 6] = ["fault", "oracle", "wrong", "outcome", "explained by", "left"];

fn cells(row: &Row) -> [String; 6] {
    let mut wrong = format!("{} of {}", row.wrong, row.cases);
    for (count, what) in [(row.declined, "declined"), (row.broke, "broke it")] {
        if count > 0 {
            wrong += &format!(", {count} {what}");
        }
    }
    let name = |found: &Explanation| {
        let all =
            if found.explained == found.of { String::new() } else { format!(" {} of {}", found.explained, found.of) };
        format!("{}{all}", found.fault)
    };
    let left = row.found.first().map_or_else(String::new, |first| format!("{:.0e}", first.left));
    let names: Vec<String> = row.found.iter().map(name).collect();
    [row.fault.to_owned(), row.oracle.clone(), wrong, row.outcome.says().to_owned(), names.join("; "), left]
}
