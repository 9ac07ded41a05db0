//! The chattering time from as many impacts as sharpen it.

use contract::{Case, Decline, Ending, Oracle};

use super::observables::Observed;

/// How many impacts are asked for first.
pub const FIRST_IMPACTS: usize = 64;
/// Even at a relative distance of 1e-15 to the critical amplitude this many are enough.
const MOST_IMPACTS: usize = 16_384;

/// What an oracle says of a case, with as many impacts as sharpen the chattering time and it can do, from those of the case on; and the case with so many.
///
/// # Errors
/// When it declines.
pub fn observe(oracle: &dyn Oracle, case: &Case) -> Result<(Case, Observed), Decline> {
    let ask = |case: &Case| oracle.history(case).map(|history| Observed::new(case, history));
    // An oracle with a sum of its own may know the chattering time where it does not know so many impacts.
    let is_answer = |observed: &Observed| !matches!(observed.history.ending, Ending::LimitReached(_));
    let fewest = || ask(&case.with_max_impacts(1).ok()?).ok().filter(is_answer);
    let mut observed = ask(case).or_else(|decline| fewest().ok_or(decline))?;
    let (mut case, mut impacts) = (*case, case.max_impacts());
    while impacts < MOST_IMPACTS && gains_from_more(&observed, impacts) {
        impacts *= 2;
        let Ok(longer) = case.with_max_impacts(impacts) else { break };
        case = longer;
        match ask(&case) {
            Ok(sharper) => observed = sharper,
            Err(_) => break,
        }
    }
    Ok((case, observed))
}

/// Whether the outcome is still open, or the error of closing the sum exceeds what the impacts themselves are uncertain by.
fn gains_from_more(observed: &Observed, impacts: usize) -> bool {
    let history = &observed.history;
    let listed_all = history.impacts.len() < impacts;
    let own = history.impacts.last().map_or(0.0, |last| last.uncertainty.time);
    let closed = observed.chattering_time.is_some_and(|time| time.uncertainty <= 2.0 * own);
    !listed_all && history.chattering_time.is_none() && !closed
}
