//! The table of claims, as Markdown and as CSV.

use std::fmt::Write as _;

use serde::Serialize;

use super::{Judged, Standing};
use crate::studies::{chart::csv_text, paper::Error};

/// The table for people.
pub fn markdown(judged: &[Judged]) -> String {
    rows(judged.iter())
}

/// How many claims hold, and the table of those that do not.
pub fn summary(judged: &[Judged]) -> String {
    let count = |is: fn(&Standing) -> bool| judged.iter().filter(|one| is(&one.verdict)).count();
    let wrong = judged.iter().filter(|one| matches!(one.verdict, Standing::DoesNotHold(_)));
    format!(
        "Of {} claims {} hold, {} hold within a number, and {} do not:\n\n{}",
        judged.len(),
        count(|verdict| *verdict == Standing::Holds),
        count(|verdict| matches!(verdict, Standing::HoldsWithin(_))),
        count(|verdict| matches!(verdict, Standing::DoesNotHold(_))),
        rows(wrong)
    )
}

fn rows<'a>(judged: impl Iterator<Item = &'a Judged>) -> String {
    let mut out = String::from("| In the paper | It says | Found | Verdict |\n| --- | --- | --- | --- |\n");
    for Judged { claim, measured, verdict } in judged {
        let cells = [claim.place.as_str(), &claim.statement, &measured.found, &verdict.to_string()];
        let [place, statement, found, verdict] = cells.map(|cell| cell.replace('|', "\\|"));
        // Writing to a string can't fail.
        let _ = writeln!(out, "| {place} | {statement} | {found} | {verdict} |");
    }
    out
}

/// A row of the table for programs.
#[derive(Serialize)]
struct Row<'a> {
    id: &'a str,
    place: &'a str,
    statement: &'a str,
    measured: &'a str,
    truth: &'a str,
    found: &'a str,
    deviation: f64,
    holds: f64,
    within: f64,
    verdict: String,
}

/// The table for programs.
pub(in crate::studies::paper) fn csv(judged: &[Judged]) -> Result<String, Error> {
    let rows: Vec<Row> = judged
        .iter()
        .map(|Judged { claim, measured, verdict }| Row {
            id: &claim.id,
            place: &claim.place,
            statement: &claim.statement,
            measured: &claim.measured,
            truth: &claim.truth,
            found: &measured.found,
            deviation: measured.deviation,
            holds: claim.holds,
            within: claim.within,
            verdict: verdict.to_string(),
        })
        .collect();
    Ok(csv_text(&rows)?)
}
