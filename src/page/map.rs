//! A map of the cases: where in the parameters they are, and where something is wrong.

use maud::{Markup, html};

use super::{
    sample::{Fates, Sample, Shown},
    scale::Scale,
};

/// The drawing, and the area of its plot, in its own units.
const WIDTH: f64 = 460.0;
const HEIGHT: f64 = 300.0;
const LEFT: f64 = 46.0;
const RIGHT: f64 = 12.0;
const TOP: f64 = 12.0;
const BOTTOM: f64 = 44.0;
/// Left of the plot, for what has no place on a logarithmic axis.
const STRIP: f64 = 18.0;

pub(super) fn section(sample: &Sample) -> Markup {
    let epsilon = |shown: &Shown| shown.case.named.case.epsilon();
    let omega = |shown: &Shown| shown.case.named.case.omega();
    let maps = [map(sample, "a − 1", "a ≤ 1", &epsilon), map(sample, "ω", "", &omega)];
    if maps.iter().all(Option::is_none) {
        return html! {};
    }
    html! {
        section #map {
            h2 { "Where" }
            (symbols())
            div .maps { @for map in maps.into_iter().flatten() { (map) } }
            (legend(sample))
        }
    }
}

/// A parameter against `η`.
fn map(sample: &Sample, name: &str, below: &str, value: &dyn Fn(&Shown) -> f64) -> Option<Markup> {
    let eta = |shown: &Shown| shown.case.named.case.eta();
    let x = Scale::log(sample.shown.iter().map(value))?;
    let y = Scale::linear(sample.shown.iter().map(eta))?;
    let strip = if below.is_empty() { 0.0 } else { STRIP };
    let from = LEFT + strip;
    let at_x = |share: f64| from + share * (WIDTH - from - RIGHT);
    let at_y = |share: f64| HEIGHT - BOTTOM - share * (HEIGHT - TOP - BOTTOM);
    let place = |shown: &Shown| {
        let share = x.share(value(shown));
        let across = if share < 0.0 { LEFT + 0.5 * strip } else { at_x(share) };
        (format!("{across:.1}"), format!("{:.1}", at_y(y.share(eta(shown)))))
    };
    let px = |value: f64| format!("{value:.1}");
    // What is wrong lies on top.
    let layers = sample.counts.keys().rev();
    let of = |fate: Fates| sample.shown.iter().filter(move |shown| Fates::from(&shown.fate) == fate);
    Some(html! {
        svg .map viewBox={ "0 0 " (WIDTH) " " (HEIGHT) } role="img" aria-label={ "cases by " (name) " and η" } {
            @for (text, share) in x.ticks() {
                line .grid x1=(px(at_x(share))) x2=(px(at_x(share))) y1=(px(TOP)) y2=(px(HEIGHT - BOTTOM)) {}
                text .middle x=(px(at_x(share))) y=(px(HEIGHT - BOTTOM + 16.0)) { (text) }
            }
            @for (text, share) in y.ticks() {
                line .grid x1=(px(LEFT)) x2=(px(WIDTH - RIGHT)) y1=(px(at_y(share))) y2=(px(at_y(share))) {}
                text .end x=(px(LEFT - 6.0)) y=(px(at_y(share) + 4.0)) { (text) }
            }
            @if !below.is_empty() { text .middle x=(px(LEFT + 0.5 * strip - 4.0)) y=(px(HEIGHT - BOTTOM + 32.0)) { (below) } }
            text .middle .axis x=(px(at_x(0.5))) y=(px(HEIGHT - 10.0)) { (name) }
            text .middle .axis x="12" y=(px(at_y(0.5))) { "η" }
            @for fate in layers {
                g .(fate.class()) {
                    @for shown in of(*fate) {
                        @let (across, up) = place(shown);
                        @if matches!(fate, Fates::Wrong | Fates::Broke) {
                            a href={ "#case-" (shown.place) } tabindex="-1" {
                                title { (shown.case.name) ": " (fate.says()) }
                                use href={ "#mark-" (fate.class()) } x=(across) y=(up) {}
                            }
                        } @else {
                            use href={ "#mark-" (fate.class()) } x=(across) y=(up) {}
                        }
                    }
                }
            }
        }
    })
}

/// One mark for each fate, told apart by their shapes too.
fn symbols() -> Markup {
    html! {
        svg .symbols aria-hidden="true" width="0" height="0" {
            defs {
                circle #mark-passed r="2.2" {}
                path #mark-wrong d="M-4.5-4.5L4.5 4.5M-4.5 4.5L4.5-4.5" {}
                path #mark-broke d="M0-5L4.6 3.2H-4.6Z" {}
                rect #mark-declined x="-2.6" y="-2.6" width="5.2" height="5.2" {}
                path #mark-known d="M0-4.4L4.4 0L0 4.4L-4.4 0Z" {}
                path #mark-left-out d="M-4 0H4" {}
            }
        }
    }
}

fn legend(sample: &Sample) -> Markup {
    html! {
        ul .legend {
            @for (fate, (shown, _)) in &sample.counts {
                li {
                    svg .(fate.class()) viewBox="-7 -7 14 14" width="14" height="14" aria-hidden="true" {
                        use href={ "#mark-" (fate.class()) } {}
                    }
                    " " (shown) " " (fate.says())
                }
            }
        }
    }
}
