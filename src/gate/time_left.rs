//! What is left after an impact, by the local series from that impact alone, against where the whole list of impacts says that they accumulate.

use contract::{Case, Closure, Ending, Estimate, Horizon, Oracle};

use crate::{
    gate::{
        compare::Figure,
        laws::{Breach, Checked, Law},
    },
    measure::{
        asking::Answer,
        closing::{chattering_time, departure, of_case},
        observables::Observed,
    },
};

/// At how many impacts of a list it is looked, from the first at which the series is trusted to the last.
const LOOKS: usize = 4;

/// Holds every answer that ends with rest against what `closing` says, and adds what came out to what the other laws say.
pub fn check(closing: &dyn Oracle, case: &Case, answers: &[Answer], checked: &mut [Checked]) {
    if case.horizon() != Horizon::HalfPeriod {
        return;
    }
    for (answer, checked) in answers.iter().zip(checked).filter(|(_, checked)| checked.breach.is_none()) {
        let Some(observed) = answer.observed().filter(|observed| observed.history.ending == Ending::AtRest) else {
            continue;
        };
        let Ok(closure) = of_case(closing, case, answer.model) else { continue };
        checked.left = worst(closure.as_ref(), case.eta(), observed);
        checked.breach = checked.left.filter(|figure| figure.share().is_nan() || figure.share() > 1.0).map(|figure| Breach {
            law: Law::TimeLeft,
            impact: figure.impact,
            how: format!(
                "the series of what is left, from this impact alone, gives another chattering time, off by {:.3e}, allowed {:.3e}",
                figure.difference, figure.allowed
            ),
        });
    }
}

/// The figure that uses most of what is allowed; `None` where the list has no chattering time, or the series is trusted nowhere.
fn worst(closure: &dyn Closure, eta: f64, observed: &Observed) -> Option<Figure> {
    let expected = observed.chattering_time?;
    let impacts = &observed.history.impacts;
    let at = |place: usize| impacts.get(place).and_then(|impact| chattering_time(closure, impact, eta).ok());
    // From some impact on all are trusted.
    let last = impacts.len().checked_sub(1)?;
    let first = impacts.partition_point(|impact| closure.time_left(&departure(impact)).is_err());
    let places = (0..LOOKS).map(|look| first + (last.saturating_sub(first)) * look / (LOOKS - 1));
    let figures = places.filter_map(|place| Some(figure(place, at(place)?, expected)));
    figures.max_by(|one, other| one.share().total_cmp(&other.share()))
}

fn figure(place: usize, closed: Estimate, expected: Estimate) -> Figure {
    Figure {
        impact: place + 1,
        difference: (closed.value - expected.value).abs(),
        allowed: closed.uncertainty + expected.uncertainty,
    }
}
