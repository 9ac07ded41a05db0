//! The profile of an engine: how large its errors are at which depth, how near to the critical amplitude it is right, and how well it knows the end.

use maud::{Markup, html};

use crate::gate::{
    profile::{Depth, Profile, Said, Side},
    report::profile_lines,
};

pub(super) fn profile(name: &str, profile: &Profile) -> Markup {
    if profile.answers() == 0 {
        return html! {};
    }
    html! {
        ul .profile { @for line in profile_lines(profile) { li { (line) } } }
        (errors(name, profile))
        details {
            summary { "Next to the critical amplitude, and how cases end" }
            (sides(name, profile))
            (endings(name, profile))
        }
    }
}

/// The drawing, and the area of its plot, in its own units.
const WIDTH: f64 = 460.0;
const HEIGHT: f64 = 220.0;
const LEFT: f64 = 46.0;
const RIGHT: f64 = 10.0;
const TOP: f64 = 10.0;
const BOTTOM: f64 = 40.0;

/// The errors of the intervals against the depth: a column for each range of depths, shaded by how many have which power of ten.
fn errors(name: &str, profile: &Profile) -> Markup {
    let columns: Vec<&Depth> = profile.depth.iter().filter(|depth| depth.intervals.count > 0).collect();
    let decades = || columns.iter().flat_map(|depth| depth.intervals.decades.keys().copied());
    let (Some(low), Some(high)) = (decades().min(), decades().max()) else { return html! {} };
    let wide = (WIDTH - LEFT - RIGHT) / columns.len() as f64;
    let tall = (HEIGHT - TOP - BOTTOM) / f64::from(high - low + 1);
    let px = |value: f64| format!("{value:.1}");
    let left = |column: usize| LEFT + column as f64 * wide;
    let top = |decade: i32| TOP + f64::from(high - decade) * tall;
    // At most eight labels on either axis.
    let (every_column, every_decade) = (columns.len().div_ceil(8), ((high - low) / 8 + 1).max(1));
    html! {
        figure {
            figcaption { "Relative error of the intervals by the number of the impact; the darker, the more of them" }
            svg .map .errors viewBox={ "0 0 " (WIDTH) " " (HEIGHT) } role="img" aria-label={ "errors of " (name) " against depth" } {
                @for decade in (low..=high).filter(|decade| (high - decade) % every_decade == 0) {
                    line .grid x1=(px(LEFT)) x2=(px(WIDTH - RIGHT)) y1=(px(top(decade))) y2=(px(top(decade))) {}
                    text .end x=(px(LEFT - 6.0)) y=(px(top(decade) + 4.0)) { "1e" (decade) }
                }
                @for (column, depth) in columns.iter().enumerate() {
                    @if column % every_column == 0 {
                        text .middle x=(px(left(column) + 0.5 * wide)) y=(px(HEIGHT - BOTTOM + 15.0)) { (depth.from) }
                    }
                    @for (decade, count) in &depth.intervals.decades {
                        @let share = *count as f64 / depth.intervals.count as f64;
                        rect .cell x=(px(left(column) + 0.5)) y=(px(top(*decade))) width=(px(wide - 1.0)) height=(px(tall))
                            fill-opacity=(format!("{:.2}", 0.12 + 0.88 * share)) {
                            title { (range(depth)) ": " (count) " of " (depth.intervals.count) " up to 1e" (decade) }
                        }
                    }
                }
                text .middle .axis x=(px(0.5 * (LEFT + WIDTH - RIGHT))) y=(px(HEIGHT - 8.0)) { "impact" }
            }
        }
    }
}

fn range(Depth { from, to, .. }: &Depth) -> String {
    if from == to { format!("impact {from}") } else { format!("impacts {from} to {to}") }
}

fn sides(name: &str, profile: &Profile) -> Markup {
    let rows = |word: &'static str, side: &Side| {
        let all: Vec<_> = side.by_distance.iter().rev().map(|(decade, counts)| (*decade, *counts)).collect();
        html! {
            @for (decade, counts) in all {
                tr {
                    th scope="row" { (word) ", 1e" (decade) " to 1e" (decade + 1) }
                    td .number { (counts.right) } td .number { (counts.wrong) } td .number { (counts.turned) }
                }
            }
        }
    };
    html! {
        div .scroll tabindex="0" role="region" aria-label={ (name) " next to the critical amplitude" } {
            table {
                thead { tr {
                    th scope="col" { "distance from a_cr, over a_cr − 1" }
                    th scope="col" { "right" } th scope="col" { "wrong" } th scope="col" { "ends as on the other side" }
                } }
                tbody { (rows("below", &profile.sides.below)) (rows("above", &profile.sides.above)) }
            }
        }
    }
}

fn endings(name: &str, profile: &Profile) -> Markup {
    let says =
        |said: &Said| said.says.iter().map(|(says, count)| format!("{count} {says}")).collect::<Vec<_>>().join(", ");
    html! {
        div .scroll tabindex="0" role="region" aria-label={ "endings by " (name) } {
            table {
                thead { tr {
                    th scope="col" { "ends" } th scope="col" { "right" } th scope="col" { "open" } th scope="col" { "wrong" }
                    th scope="col" { "what it says" }
                } }
                tbody {
                    @for (truth, said) in &profile.endings {
                        tr {
                            th scope="row" { (truth) }
                            td .number { (said.right) } td .number { (said.open) } td .number { (said.wrong) }
                            td { (says(said)) }
                        }
                    }
                }
            }
        }
    }
}
