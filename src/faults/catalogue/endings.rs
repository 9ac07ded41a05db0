//! Rest declared too early, too late, or wrongly; lists of the wrong length; cases refused.

use contract::{Ending, Limit, Loss};

use super::{Fault, amount, whole};
use crate::faults::plant::Plant::{Answer, Refusal};

pub(super) fn all() -> Vec<Fault> {
    [thresholds(), verdicts(), lengths()].concat()
}

fn thresholds() -> Vec<Fault> {
    vec![
        amount(
            "velocity threshold",
            "rest were declared below a velocity, as VelTol does (Fig. 8b)",
            "velocity phi'",
            5e-10,
            Answer(|_, size, history| {
                if let Some(n) = history.impacts.iter().position(|impact| impact.velocity.abs() < size) {
                    history.impacts.truncate(n + 1);
                    history.ending = Ending::AtRest;
                }
            }),
        ),
        amount(
            "interval threshold",
            "rest were declared below an interval",
            "interval in tau",
            1e-8,
            Answer(|_, size, history| {
                if let Some(n) = history.impacts.iter().position(|impact| impact.interval < size) {
                    history.impacts.truncate(n + 1);
                    history.ending = Ending::AtRest;
                }
            }),
        ),
    ]
}

fn verdicts() -> Vec<Fault> {
    vec![
        whole(
            "incomplete called complete",
            "a block that still rocks at half a period were said to be at rest",
            Answer(|_, _, history| {
                if history.ending == Ending::Incomplete {
                    history.ending = Ending::AtRest;
                }
            }),
        ),
        whole(
            "complete called incomplete",
            "a block that comes to rest were said to rock on",
            Answer(|_, _, history| {
                if history.ending == Ending::AtRest {
                    history.ending = Ending::Incomplete;
                }
            }),
        ),
        whole(
            "never at rest",
            "the list of a block that comes to rest just ended",
            Answer(|_, _, history| {
                if history.ending == Ending::AtRest {
                    history.ending = Ending::LimitReached(Limit::Impacts);
                }
            }),
        ),
        whole(
            "rest below the threshold missed",
            "a block that never rocks were said to come to rest",
            Answer(|_, _, history| {
                if history.ending == Ending::NeverRocks {
                    history.ending = Ending::AtRest;
                }
            }),
        ),
        whole(
            "incomplete called overturned",
            "a block that still rocks at half a period were said to overturn",
            Answer(|_, _, history| {
                if history.ending == Ending::Incomplete {
                    history.ending = Ending::Overturned;
                }
            }),
        ),
        whole(
            "lost, and says so",
            "the sequence were lost after impact 30",
            Answer(|_, _, history| {
                if history.impacts.len() > 30 {
                    history.impacts.truncate(30);
                    history.ending = Ending::Lost(Loss::FellThrough);
                }
            }),
        ),
    ]
}

fn lengths() -> Vec<Fault> {
    vec![
        whole(
            "one impact too few",
            "the list ended one impact early",
            Answer(|_, _, history| {
                history.impacts.pop();
            }),
        ),
        whole(
            "one impact too many",
            "the list were one impact longer than asked for",
            Answer(|case, _, history| {
                if let Some(last) =
                    history.impacts.last().copied().filter(|_| history.impacts.len() == case.max_impacts())
                {
                    let interval = last.interval * case.eta();
                    let next = contract::Impact {
                        time: last.time + interval,
                        interval,
                        velocity: -last.velocity * case.eta(),
                        ..last
                    };
                    history.impacts.push(next);
                }
            }),
        ),
        whole("refuses a fifth", "cases with eta above 0.93 were refused", Refusal(|case| case.eta() > 0.93)),
        whole("refuses everything", "every case were refused", Refusal(|_| true)),
    ]
}
