//! The profile of an engine in words, and its tables.

use comfy_table::{CellAlignment, Table, presets};

use crate::gate::profile::{Depth, Errors, Profile, Said, Side};

/// A profile in a few lines.
pub fn lines(profile: &Profile) -> Vec<String> {
    let answers = profile.answers();
    if answers == 0 {
        return Vec::new();
    }
    let by = match (profile.proven, profile.stepped) {
        (_, 0) => "by proven bounds".to_owned(),
        (0, _) => "by the oracle beside it".to_owned(),
        (proven, stepped) => format!("by proven bounds in {proven}, by the oracle beside it in {stepped}"),
    };
    let mut lines = vec![format!("right in {} of {answers} answers, {by}", profile.right)];
    lines.extend(intervals(profile));
    lines.extend(endings(profile));
    let sides = [("below", &profile.sides.below), ("above", &profile.sides.above)];
    let said: Vec<String> = sides.iter().filter_map(|(name, of)| side(name, of)).collect();
    if !said.is_empty() {
        lines.push(format!("next to a_cr, in units of a_cr - 1: {}", said.join("; ")));
    }
    lines
}

fn intervals(profile: &Profile) -> Option<String> {
    let worst = profile.depth.iter().max_by(|one, two| one.intervals.worst.total_cmp(&two.intervals.worst))?;
    let all = profile.depth.iter().map(|depth| &depth.intervals);
    let half = Errors::sum(all).median()?;
    let at = |Depth { from, to, .. }: &Depth| {
        if from == to { format!("impact {from}") } else { format!("impacts {from} to {to}") }
    };
    let mut said =
        format!("intervals: half within {half:.0e}, the worst off by {:.0e}, at {}", worst.intervals.worst, at(worst));
    if let (Some(deepest), Some(smallest)) = (&profile.deepest, &profile.smallest) {
        said += &format!("; right to impact {}, and to an interval of {:.0e}", deepest.impact, smallest.interval);
    }
    Some(said)
}

/// How many endings are right; what is most often said instead.
fn endings(profile: &Profile) -> Option<String> {
    let count = |of: fn(&Said) -> usize| profile.endings.values().map(of).sum::<usize>();
    let (right, open) = (count(|said| said.right), count(|said| said.open));
    let mut text = format!("endings: {right} of {} right", profile.answers());
    if open > 0 {
        text += &format!(", {open} left open");
    }
    let wrong = profile.endings.iter().filter(|(_, said)| said.wrong > 0);
    if let Some((truth, said)) = wrong.max_by_key(|(_, said)| said.wrong) {
        let instead = said.says.iter().filter(|(says, _)| *says != truth).max_by_key(|(_, count)| **count);
        text += &match instead {
            Some((instead, count)) if 2 * count > said.wrong => {
                format!("; {} that end {truth} are said to end {instead}", said.wrong)
            }
            _ => format!("; {} that end {truth} have too few or too many impacts", said.wrong),
        };
    }
    Some(text)
}

/// How near to the critical amplitude one side is right, or from where on it is not.
fn side(name: &str, side: &Side) -> Option<String> {
    let other = if name == "below" { "said to rock on" } else { "said to come to rest" };
    match (side.farthest_turned, side.farthest_wrong, side.nearest_right) {
        (Some(turned), ..) => Some(format!("{name} it {other} as far away as {turned:.0e}")),
        (None, Some(wrong), Some(right)) if wrong < right => {
            Some(format!("{name} it right down to {right:.0e}, wrong from {wrong:.0e} on"))
        }
        (None, None, Some(right)) => Some(format!("{name} it right down to {right:.0e}")),
        // Wrong here and there, or everywhere: that has nothing to do with the critical amplitude.
        _ => None,
    }
}

/// A profile in tables.
pub(super) fn tables(name: &str, profile: &Profile) -> String {
    format!(
        "{name}: the relative error of its intervals by depth. right: with nothing wrong up to there; lacking: answers that end too early.\n{}\n\n\
         {name}: answers by the distance from the critical amplitude, over a_cr - 1; other side: said to end as on the other side.\n{}\n\n\
         {name}: how cases end, and what it says.\n{}\n",
        depth(profile),
        sides(profile),
        said(profile)
    )
}

fn table(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut table = Table::new();
    table.load_preset(presets::NOTHING);
    table.set_header(head.to_vec());
    for row in rows {
        table.add_row(row);
    }
    for (place, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, 1));
        column.set_cell_alignment(if place == 0 { CellAlignment::Left } else { CellAlignment::Right });
    }
    table.to_string()
}

fn depth(profile: &Profile) -> String {
    let row = |Depth { from, to, right, lacking, intervals }: &Depth| {
        let number = |value: Option<f64>| value.map_or("-".to_owned(), |value| format!("{value:.0e}"));
        let worst = (intervals.count > 0).then_some(intervals.worst);
        let impacts = if from == to { from.to_string() } else { format!("{from} to {to}") };
        let counts = [intervals.count, *right, *lacking].map(|count| count.to_string());
        [impacts].into_iter().chain(counts).chain([number(intervals.median()), number(worst)]).collect()
    };
    table(&["impacts", "compared", "right", "lacking", "half within", "worst"], profile.depth.iter().map(row))
}

fn sides(profile: &Profile) -> String {
    let rows =
        [("below", &profile.sides.below), ("above", &profile.sides.above)].into_iter().flat_map(|(name, side)| {
            side.by_distance.iter().rev().map(move |(decade, counts)| {
                let range = format!("{name}, 1e{decade} to 1e{}", decade + 1);
                let counts = [counts.right, counts.wrong, counts.turned].map(|count| count.to_string());
                [range].into_iter().chain(counts).collect()
            })
        });
    table(&["distance", "right", "wrong", "other side"], rows)
}

fn said(profile: &Profile) -> String {
    let rows = profile.endings.iter().map(|(truth, said)| {
        let counts = [said.count(), said.right, said.open, said.wrong].map(|count| count.to_string());
        let says: Vec<String> = said.says.iter().map(|(says, count)| format!("{count} {says}")).collect();
        [truth.clone()].into_iter().chain(counts).chain([says.join(", ")]).collect()
    });
    table(&["ends", "answers", "right", "open", "wrong", "says"], rows)
}
