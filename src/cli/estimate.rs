//! A word before what takes minutes: an estimate from a small part of the work.

use std::time::{Duration, Instant};

use contract::{Case, Oracle};

use super::output::note;

/// What takes less is not worth a word.
const WORTH_A_WORD: Duration = Duration::from_secs(30);

/// How many impacts are tried.
const TRIED: usize = 500;

/// Says how long listing so many impacts will take, if that is minutes. The time of an impact is that of the first ones, so it is a lower bound for methods that
/// slow down.
pub(super) fn impacts(oracle: &dyn Oracle, case: &Case) {
    let wanted = case.max_impacts();
    if wanted <= 20 * TRIED {
        return;
    }
    let Ok(tried) = case.with_max_impacts(TRIED) else { return };
    let start = Instant::now();
    let listed = oracle.history(&tried).map_or(0, |history| history.impacts.len());
    if listed == TRIED {
        say(oracle.name(), &format!("{wanted} impacts"), start.elapsed().mul_f64(wanted as f64 / TRIED as f64));
    }
}

fn say(who: &str, what: &str, time: Duration) {
    if time >= WORTH_A_WORD {
        note(format_args!("{who}: {what} take about {} here", in_words(time)));
    }
}

/// One digit, or two: it is an estimate.
fn in_words(time: Duration) -> String {
    let minutes = time.as_secs_f64() / 60.0;
    match minutes {
        _ if minutes < 90.0 => format!("{minutes:.0} min"),
        _ if minutes < 48.0 * 60.0 => format!("{:.0} hours", minutes / 60.0),
        _ => format!("{:.0} days", minutes / 60.0 / 24.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_said_in_the_unit_that_one_would_use() {
        for (seconds, words) in [(60, "1 min"), (5000, "83 min"), (7200, "2 hours"), (400_000, "5 days")] {
            assert_eq!(in_words(Duration::from_secs(seconds)), words);
        }
    }
}
