//! What can be read off the answers of an engine without any simulation: numbers that have few digits, times on a grid, a shortest interval. What an engine
//! computes with shows in them, where no fault of the catalogue is like what it does.

use contract::Impact;

use crate::gate::samples::Sample;

/// So many numbers are needed until it is no chance that all of them are alike.
const ENOUGH: usize = 12;
/// In so many answers the shortest interval has to be the same.
const ANSWERS: usize = 3;
/// A number of as many digits was cut: a double has up to 17.
const FEW_DIGITS: usize = 9;

/// What is seen in the answers, in words.
pub(super) fn signs(samples: &[Sample]) -> Vec<String> {
    let lists: Vec<&[Impact]> =
        samples.iter().filter_map(|sample| sample.answer.as_ref()).map(|answer| answer.impacts.as_slice()).collect();
    let column = |of: fn(&Impact) -> f64| -> Vec<f64> {
        let all = lists.iter().flat_map(|list| list.iter().map(of));
        all.filter(|value| value.is_finite() && *value != 0.0).collect()
    };
    let columns = [
        ("times", column(|impact| impact.time)),
        ("intervals", column(|impact| impact.interval)),
        ("velocities", column(|impact| impact.velocity)),
    ];
    let columns: Vec<_> = columns.into_iter().filter(|(_, all)| all.len() >= ENOUGH).collect();
    let with = |holds: fn(f64) -> bool| {
        let all = columns.iter().filter(|(_, all)| all.iter().all(|value| holds(*value)));
        all.map(|(name, _)| *name).collect::<Vec<_>>().join(" and ")
    };
    let (single, short) = (with(is_single), with(|value| digits(value) <= FEW_DIGITS));
    let mut signs = Vec::new();
    if !short.is_empty() {
        signs.push(format!("all its {short} have {FEW_DIGITS} digits at the most: are they printed in full (%.17g)?"));
    }
    if !single.is_empty() && single != short {
        signs.push(format!("all its {single} are numbers of single precision"));
    }
    let times = columns.iter().find(|(name, _)| *name == "times").filter(|_| short.is_empty());
    if let Some(step) = times.and_then(|(_, times)| grid(times)) {
        signs.push(format!(
            "all its times are multiples of {step:e}: is an impact taken to be at the end of a time step, and not where phi = 0?"
        ));
    } else if let Some((shortest, count)) = dead_time(&lists) {
        signs.push(format!(
            "the shortest interval is {shortest:.4e} in {count} of its answers: are impacts not looked for so soon after the last?"
        ));
    }
    signs
}

fn is_single(value: f64) -> bool {
    f64::from(value as f32) == value
}

/// How many decimal digits it takes to write a number.
fn digits(value: f64) -> usize {
    format!("{value:e}").split('e').next().map_or(0, |written| written.chars().filter(char::is_ascii_digit).count())
}

/// The largest of the usual steps that all are multiples of.
fn grid(times: &[f64]) -> Option<f64> {
    const OFF: f64 = 1e-5;
    let decades = (1..=6).map(|power| 10.0_f64.powi(-power));
    let mut steps = decades.flat_map(|decade| [5.0 * decade, 2.5 * decade, 2.0 * decade, decade]);
    let is_multiple = |time: f64, step: f64| ((time / step) - (time / step).round()).abs() < OFF && time > 0.5 * step;
    steps.find(|step| times.iter().all(|time| is_multiple(*time, *step)))
}

/// The shortest interval of all answers, if it is that of several, and of how many.
fn dead_time(lists: &[&[Impact]]) -> Option<(f64, usize)> {
    const SAME: f64 = 1e-6;
    let of_each = lists.iter().filter_map(|list| list.iter().map(|impact| impact.interval).min_by(f64::total_cmp));
    let shortest: Vec<f64> = of_each.filter(|interval| *interval > 0.0).collect();
    let least = shortest.iter().copied().min_by(f64::total_cmp)?;
    let count = shortest.iter().filter(|interval| **interval <= least * (1.0 + SAME)).count();
    (count >= ANSWERS).then_some((least, count))
}

#[cfg(test)]
mod tests {
    use contract::{Case, History};

    use super::*;
    use crate::panel;

    /// Some answers of the stepper, changed in this way.
    fn seen(change: impl Fn(&mut Impact)) -> Vec<String> {
        let stepper = panel::stepper();
        let sample = |eta: f64| {
            let case = Case::from_epsilon(0.02, 2.0, eta).unwrap().with_max_impacts(12).unwrap();
            let mut answer: History = stepper.history(&case).unwrap();
            answer.impacts.iter_mut().for_each(&change);
            Sample { case, answer: Some(answer), is_wrong: true, is_ending_wrong: false }
        };
        signs(&[0.7, 0.8, 0.85, 0.9].map(sample))
    }

    #[test]
    fn what_shows_in_the_numbers_is_said_and_nothing_else() {
        assert_eq!(seen(|_| ()), [""; 0]);
        let single = |value: f64| f64::from(value as f32);
        let of_time = seen(|impact| impact.time = single(impact.time));
        assert_eq!(of_time, ["all its times are numbers of single precision"]);
        let short = seen(|impact| impact.velocity = format!("{:.6e}", impact.velocity).parse().unwrap());
        assert!(short.len() == 1 && short[0].starts_with("all its velocities have 9 digits at the most"), "{short:?}");
        let steps = seen(|impact| impact.time = 1e-4 * (impact.time / 1e-4).ceil() * (1.0 + 1e-15));
        assert!(steps.len() == 1 && steps[0].starts_with("all its times are multiples of 1e-4:"), "{steps:?}");
        let dead = seen(|impact| impact.interval = impact.interval.max(2e-2));
        assert!(dead.len() == 1 && dead[0].starts_with("the shortest interval is 2.0000e-2 in "), "{dead:?}");
    }
}
