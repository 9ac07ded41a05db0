//! What happens, in words.

use chattercheck::motion::{
    response::{Bout, Response},
    scene::{Account, Scene},
};

/// How many times of rocking are listed.
const MOST_BOUTS: usize = 20;

/// What each column of [`rows`] is.
pub(super) const COLUMNS: [&str; 7] =
    ["from (s)", "to (s)", "give or take (s)", "impacts", "ending", "from (tau)", "to (tau)"];

/// A row for each time of rocking.
pub(super) fn rows(scene: &Scene, response: &Response) -> Vec<Vec<String>> {
    let p = scene.block.frequency_parameter();
    let row = |bout: &Bout| {
        let off = bout.uncertainty() / p;
        vec![
            format!("{:.6}", bout.begin() / p),
            format!("{:.6}", bout.end() / p),
            if off.is_finite() { format!("{off:.0e}") } else { "not known".to_owned() },
            bout.impacts().to_string(),
            bout.ending().to_owned(),
            format!("{:.6}", bout.begin()),
            format!("{:.6}", bout.end()),
        ]
    };
    response.bouts.iter().map(row).collect()
}

/// The summary: first in seconds and degrees, then in the terms of the equations.
pub(super) fn summary(scene: &Scene, account: &Account, response: &Response, by: &str) -> Vec<String> {
    let title = if scene.title.is_empty() { "(no title)".to_owned() } else { scene.title.clone() };
    let told = account.told();
    let width = told.iter().map(|(name, _)| name.len()).max().unwrap_or_default();
    let lines = told.iter().map(|(name, what)| format!("  {name:width$}  {what}"));
    let p = scene.block.frequency_parameter();
    let largest = account.largest_rotation.map_or_else(String::new, |largest| {
        format!(", largest |phi| = {:.6} at tau = {:.6}", largest.share_of_alpha, p * largest.seconds)
    });
    let terms = format!("  {:width$}  tau = {p:.6} t, phi = theta/alpha{largest}", "dimensionless");
    let method = format!("  {:width$}  {by}: {}", "method", method(response));
    [title].into_iter().chain(lines).chain([terms, method]).collect()
}

/// The summary and the list of the times of rocking.
pub(super) fn text(summary: &[String], rows: &[Vec<String>]) -> String {
    let mut lines = summary.to_vec();
    if !rows.is_empty() {
        lines.push(String::new());
        let columns = COLUMNS.map(str::to_owned).to_vec();
        let listed = [&columns].into_iter().chain(rows.iter().take(MOST_BOUTS));
        let cells = |row: &Vec<String>| row.iter().map(|cell| format!("{cell:>18}")).collect::<String>();
        lines.extend(listed.map(cells));
    }
    if rows.len() > MOST_BOUTS {
        lines.push(format!("  and {} more: --format json has them all", rows.len() - MOST_BOUTS));
    }
    lines.join("\n")
}

fn method(response: &Response) -> String {
    let impacts: usize = response.bouts.iter().map(Bout::impacts).sum();
    let Some(last) = response.bouts.last() else { return "the block never rocks".to_owned() };
    let times = response.bouts.len();
    let many = format!("{times} time{} of rocking, {impacts} impacts resolved", if times == 1 { "" } else { "s" });
    let lies = if response.lying.is_some() { ", and lies on its side" } else { "" };
    let (end, off, name) = (last.end(), last.uncertainty(), last.outcome.name());
    let first_unsure = response.bouts.iter().find(|bout| bout.is_unsure());
    match first_unsure {
        None => format!("{many}; the last one ends at tau = {end} ± {off:.0e}: {name}{lies}"),
        Some(bout) if bout.uncertainty().is_finite() => format!(
            "{many}; UNSURE: the one that begins at tau = {} ends at about {}, which may be off by {:.0e}",
            bout.begin(),
            bout.end(),
            bout.uncertainty()
        ),
        Some(bout) => format!(
            "{many}; UNSURE from tau = {} on: rounding alone changes how the rocking goes that begins there",
            bout.begin()
        ),
    }
}
