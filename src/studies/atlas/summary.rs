//! What each method did over all cases.

use super::{AtlasRow, measure::is_wrong};

const HEADER: [&str; 12] = [
    "method",
    "setting",
    "complete judged rightly",
    "incomplete judged rightly",
    "median error of `τ_ch`",
    "worst error of `τ_ch`",
    "incomplete, and the response off by more than 1 %",
    "shortest interval resolved",
    "silent",
    "loud",
    "hangs",
    "fails most often",
];

/// A line for each method, as a Markdown table.
pub fn markdown(rows: &[AtlasRow]) -> String {
    let mut table = markdown_line(HEADER.map(str::to_owned)) + &markdown_line(HEADER.map(|_| "---".to_owned()));
    let mut seen: Vec<(&str, &str)> = Vec::new();
    for row in rows {
        let method = (row.family.as_str(), row.setting.as_str());
        if !seen.contains(&method) {
            seen.push(method);
            let of_it = rows.iter().filter(|other| (other.family.as_str(), other.setting.as_str()) == method);
            table += &markdown_line(line(method, &of_it.collect::<Vec<_>>()));
        }
    }
    table
}

fn markdown_line(cells: [String; 12]) -> String {
    format!("| {} |\n", cells.join(" | "))
}

fn line((family, setting): (&str, &str), rows: &[&AtlasRow]) -> [String; 12] {
    let judged = |truth: &str| {
        let of_it = rows.iter().filter(|row| row.truth == truth);
        format!("{} of {}", of_it.clone().filter(|row| row.verdict == Some(truth)).count(), of_it.count())
    };
    let mut errors: Vec<f64> = rows.iter().filter_map(|row| row.tau_ch_error).collect();
    errors.sort_by(f64::total_cmp);
    let number = |error: Option<&f64>| error.map_or("-".to_owned(), |error| format!("{error:.0e}"));
    let off = rows.iter().filter(|row| row.truth == "rocks" && row.response_error.is_some_and(is_wrong));
    let shortest = rows.iter().filter_map(|row| row.shortest).fold(f64::INFINITY, f64::min);
    let fails = |how: &str| rows.iter().filter(|row| row.failure == how).count().to_string();
    [
        family.to_owned(),
        setting.to_owned(),
        judged("rests"),
        judged("rocks"),
        number(errors.get(errors.len() / 2)),
        number(errors.last()),
        off.count().to_string(),
        if shortest.is_finite() { format!("{shortest:.0e}") } else { "-".to_owned() },
        fails("silent"),
        fails("loud"),
        fails("hang"),
        most_often(rows),
    ]
}

/// The words that describe most of its failures.
fn most_often(rows: &[&AtlasRow]) -> String {
    let mut counts: Vec<(&str, usize)> = Vec::new();
    for row in rows.iter().filter(|row| row.failure != "none") {
        match counts.iter_mut().find(|(how, _)| *how == row.how) {
            Some((_, count)) => *count += 1,
            None => counts.push((&row.how, 1)),
        }
    }
    // The first of several that are as many.
    let most = counts.iter().rev().max_by_key(|(_, count)| *count);
    most.map_or(String::new(), |(how, _)| (*how).to_owned())
}
