//! The cases of a verification run: how many random ones, the user's own, and the list of them all.

use std::{
    collections::HashMap,
    path::{Path, PathBuf},
};

use anyhow::{Context as _, bail};
use chattercheck::{
    cases::{
        case_file, case_list,
        generate::{Generator, Named},
    },
    gate::{
        judge::Judges,
        partition::{Partition, cost_of_case},
        run::{self, Placed, Selection},
    },
    panel,
};
use clap::Args;
use contract::Invalid;

use super::{Status, case_flags::read_text, numbers::count, output, seed::Seed};

#[derive(Args)]
pub(super) struct RunCases {
    /// How many random cases, beside those of the other generators; 0 with --case-file runs the cases of these files and no others
    #[arg(long, value_name = "N", default_value_t = Selection::DEFAULT_CASES, allow_negative_numbers = true, value_parser = count::<0, { Selection::MOST_CASES }>)]
    cases: usize,
    /// A file of cases of your own, TOML with a table [[case]] for each, to be run too; may be given more than once
    #[arg(long, value_name = "FILE")]
    case_file: Vec<PathBuf>,
    #[command(flatten)]
    seed: Seed,
}

/// The cases of a run.
pub(super) struct Chosen {
    pub selection: Selection,
    /// The user's own.
    pub own: Vec<Named>,
    /// Every case, in order.
    pub all: Vec<Named>,
    /// Whether the built-in cases are among them, so that the run has to prove something by itself.
    pub whole: bool,
}

impl RunCases {
    /// # Errors
    /// When there are too many, the seed is none, or a file has something wrong in it.
    pub fn chosen(&self) -> anyhow::Result<Chosen> {
        if self.cases > Selection::MOST_CASES {
            return Err(Invalid::new("cases", self.cases, "at most 1000000").into());
        }
        let selection = Selection { cases: self.cases, seed: self.seed.value()? };
        Ok(Chosen::new(selection, own(&self.case_file)?))
    }

    /// The case files that are read.
    pub fn files(&self) -> Vec<&Path> {
        self.case_file.iter().map(PathBuf::as_path).collect()
    }
}

impl Chosen {
    /// The user's cases first. Without random ones they are all: who wants only them does not wait for others.
    pub fn new(selection: Selection, own: Vec<Named>) -> Self {
        let whole = selection.cases > 0 || own.is_empty();
        let built_in = if whole { run::cases(&selection, panel::stepper().as_ref()) } else { Vec::new() };
        let all = own.iter().cloned().chain(built_in).collect();
        Self { selection, own, all, whole }
    }

    /// Those that fall to a part, each with its place among all.
    pub fn part(&self, judges: &Judges, partition: Partition) -> Vec<Placed> {
        let all = Placed::all(&self.all);
        let cost = |Placed { place, named }: &Placed| cost_of_case(named, judges.asks(*place, named));
        let costs: Vec<f64> = all.iter().map(cost).collect();
        partition.of(all, &costs)
    }
}

/// The cases of these files.
fn own(files: &[PathBuf]) -> anyhow::Result<Vec<Named>> {
    let mut found: HashMap<String, &Path> = HashMap::new();
    let mut cases = Vec::new();
    for path in files {
        let file = path.display();
        let listed = case_list::read(&read_text(path)?).with_context(|| file.to_string())?;
        if listed.is_empty() {
            bail!("{file}: no case is in it; one begins with [[case]]");
        }
        for case_list::Listed { name, case, line, .. } in listed {
            if let Some(other) = found.insert(name.clone(), path) {
                bail!("{file}: line {line}: name = {name:?} is that of a case in {}", other.display());
            }
            cases.push(Named { generator: Generator::Own, name, case });
        }
    }
    Ok(cases)
}

/// Prints cases, one a line: the name, a tab, and the flags that ask for it in other commands.
///
/// # Errors
/// When stdout can't be written to.
pub(super) fn print(cases: &[Placed], partition: Partition) -> anyhow::Result<Status> {
    if cases.is_empty() {
        output::note(format_args!("chattercheck: nothing is listed: nothing of the run falls to part {partition}"));
        return Ok(Status::Nothing);
    }
    let lines = cases.iter().map(|Placed { named, .. }| format!("{named}\t{}\n", case_file::flags(&named.case)));
    output::print(&lines.collect::<String>())?;
    Ok(Status::Well)
}
