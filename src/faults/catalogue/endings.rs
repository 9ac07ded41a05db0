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
            "Rest is declared below a velocity (VelTol, Fig. 8b; 5e-10 in Figs 10 and 11)",
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
            "Rest is declared below an interval",
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
            "Rest is declared at T/2",
            Answer(|_, _, history| {
                if history.ending == Ending::Incomplete {
                    history.ending = Ending::AtRest;
                }
            }),
        ),
        whole(
            "complete called incomplete",
            "The block is said to rock on",
            Answer(|_, _, history| {
                if history.ending == Ending::AtRest {
                    history.ending = Ending::Incomplete;
                }
            }),
        ),
        whole(
            "never at rest",
            "The list of a complete case just ends",
            Answer(|_, _, history| {
                if history.ending == Ending::AtRest {
                    history.ending = Ending::LimitReached(Limit::Impacts);
                }
            }),
        ),
        whole(
            "rest below the threshold missed",
            "A block that does not rock is said to come to rest",
            Answer(|_, _, history| {
                if history.ending == Ending::NeverRocks {
                    history.ending = Ending::AtRest;
                }
            }),
        ),
        whole(
            "incomplete called overturned",
            "The block is given up at T/2",
            Answer(|_, _, history| {
                if history.ending == Ending::Incomplete {
                    history.ending = Ending::Overturned;
                }
            }),
        ),
        whole(
            "lost, and says so",
            "The sequence is lost after impact 30",
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
            "The list ends one impact early",
            Answer(|_, _, history| {
                history.impacts.pop();
            }),
        ),
        whole(
            "one impact too many",
            "The list is one longer than asked for",
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
        whole("refuses a fifth", "Cases with eta above 0.93 are declined", Refusal(|case| case.eta() > 0.93)),
        whole("refuses everything", "Every case is declined", Refusal(|_| true)),
    ]
}
