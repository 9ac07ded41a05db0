//! What holds in every response whoever made it, read off the response and the ground alone.

use serde::{Deserialize, Serialize};

use super::{
    problem::Problem,
    whole::{BoutEnding, Row, State, Whole},
};

/// How closely the ground acceleration is looked at.
const NEAR: f64 = 1e-9;
/// At how many moments of a rest.
const LOOKS: u32 = 32;

/// A law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Law {
    /// Time never decreases: impacts, bouts and rows come in order.
    Order,
    /// Bouts and rests fill the response, from its start to its end.
    Tiling,
    /// The response ends where nothing can happen any more, or at the latest when it was asked to.
    End,
    /// A block rests while the ground acceleration is below the threshold, and no longer.
    Threshold,
    /// An impact leaves `η` of the speed.
    Restitution,
    /// The two rows of an impact share one time.
    OneTime,
    /// The ground acceleration in the rows is that of the ground.
    Ground,
    /// A block that rests is on its base.
    AtRest,
    /// A block that rocks or falls is above the floor, and one that lies is on it.
    Floor,
}

impl Law {
    /// What is wrong, in words.
    pub fn broken(self) -> &'static str {
        match self {
            Self::Order => "time decreases",
            Self::Tiling => "bouts and rests do not fill the response",
            Self::End => "the response does not end when it has to",
            Self::Threshold => "the block rests above the threshold, or starts to rock below it",
            Self::Restitution => "an impact does not leave eta of the speed",
            Self::OneTime => "the two rows of an impact have two times",
            Self::Ground => "the ground acceleration in the table is not that of the ground",
            Self::AtRest => "a block at rest is not on its base",
            Self::Floor => "a block that rocks or falls is in the floor, or one that lies is not on it",
        }
    }
}

/// The first law that is broken, and when.
pub(super) fn broken(whole: &Whole, problem: &Problem) -> Option<(Law, f64)> {
    order(whole)
        .or_else(|| tiling(whole))
        .or_else(|| end(whole, problem))
        .or_else(|| threshold(whole, problem))
        .or_else(|| restitution(whole, problem))
        .or_else(|| rows(whole, problem))
}

fn order(whole: &Whole) -> Option<(Law, f64)> {
    let of_bouts = whole.bouts.iter().flat_map(|bout| {
        let impacts = bout.impacts.iter().map(|impact| impact.time);
        [bout.begin].into_iter().chain(impacts).chain([bout.end])
    });
    let end = [whole.end];
    let found = decreases(of_bouts.chain(end)).or_else(|| decreases(whole.rows.iter().map(|row| row.time).chain(end)));
    found.map(|time| (Law::Order, time))
}

/// The first time that is not at or after the one before it.
fn decreases(times: impl IntoIterator<Item = f64>) -> Option<f64> {
    let mut last = 0.0;
    times.into_iter().find(|&time| {
        let ordered = time >= last;
        last = time;
        !ordered
    })
}

fn tiling(whole: &Whole) -> Option<(Law, f64)> {
    let mut rested = true;
    let mut expected = Vec::new();
    let mut now = 0.0;
    for bout in &whole.bouts {
        expected.push((now, bout.begin));
        now = bout.end;
        rested = bout.outcome == BoutEnding::Rest;
    }
    if rested {
        expected.push((now, whole.end));
    }
    expected.retain(|(from, to)| to > from);
    let same = expected == whole.rests;
    (!same).then_some((Law::Tiling, now))
}

fn end(whole: &Whole, problem: &Problem) -> Option<(Law, f64)> {
    if whole.told_until.is_some() {
        return None;
    }
    let last = whole.bouts.last().map_or(BoutEnding::Rest, |bout| bout.outcome);
    let due = match last {
        BoutEnding::Rest => problem.until.min(problem.lasts),
        BoutEnding::Cut => problem.until,
        BoutEnding::Overturned | BoutEnding::GivenUp => 0.0,
    };
    let in_time = whole.end >= due * (1.0 - NEAR) && whole.end <= problem.until * (1.0 + NEAR);
    (!in_time).then_some((Law::End, whole.end))
}

fn threshold(whole: &Whole, problem: &Problem) -> Option<(Law, f64)> {
    let slack = NEAR * (1.0 + problem.amplitude(0.0) + problem.slope(0.0));
    let during = whole
        .rests
        .iter()
        .flat_map(|(from, to)| (1..LOOKS).map(move |look| from + (to - from) * f64::from(look) / f64::from(LOOKS)));
    let too_long = during.filter(|time| problem.ground(*time).abs() > 1.0 + slack);
    // A block that moves at first rocks without being pushed.
    let begins = whole.bouts.iter().map(|bout| bout.begin).skip(usize::from(problem.start != (0.0, 0.0)));
    let too_early = begins.filter(|begin| problem.ground(*begin).abs() < 1.0 - slack);
    too_long.chain(too_early).next().map(|time| (Law::Threshold, time))
}

fn restitution(whole: &Whole, problem: &Problem) -> Option<(Law, f64)> {
    let impacts = whole.bouts.iter().flat_map(|bout| &bout.impacts);
    let mut wrong = impacts.filter(|impact| {
        impact.after.is_some_and(|after| {
            let right = problem.eta * impact.before;
            let near = (after - right).abs() <= 4.0 * f64::EPSILON * right;
            !near
        })
    });
    wrong.next().map(|impact| (Law::Restitution, impact.time))
}

fn rows(whole: &Whole, problem: &Problem) -> Option<(Law, f64)> {
    let wrong = whole.rows.iter().find_map(|row| row_breaks(row, problem).map(|law| (law, row.time)));
    let two_times = whole.rows.windows(2).find_map(|pair| match pair {
        [one, two] => {
            let on_the_base = |row: &Row| row.state == State::Rocking && row.rotation == 0.0 && row.velocity != 0.0;
            let apart = two.time != one.time && two.time - one.time < NEAR;
            (on_the_base(one) && on_the_base(two) && apart).then_some((Law::OneTime, two.time))
        }
        _ => None,
    });
    wrong.or(two_times)
}

fn row_breaks(row: &Row, problem: &Problem) -> Option<Law> {
    let slack = NEAR * (1.0 + problem.amplitude(0.0) + problem.slope(0.0)) * (1.0 + row.time);
    // Where the ground jumps, or comes to rest, it is a matter of rounding on which side of that a row is.
    let is_near = |change: f64| (row.time - change).abs() <= NEAR;
    let at_the_end = is_near(problem.lasts) || is_near(problem.change(row.time - 2.0 * NEAR));
    let right = (row.ground - problem.ground(row.time)).abs() <= slack;
    if !right && !at_the_end {
        return Some(Law::Ground);
    }
    match row.state {
        State::Rest => {
            let above = problem.ground(row.time).abs() > 1.0 + slack && !at_the_end;
            if row.rotation != 0.0 || row.velocity != 0.0 { Some(Law::AtRest) } else { above.then_some(Law::Threshold) }
        }
        State::Rocking | State::Overturned => {
            (row.rotation.abs() > problem.lies_at * (1.0 + NEAR)).then_some(Law::Floor)
        }
        State::Lying => {
            let lies = row.rotation.abs() >= problem.lies_at * (1.0 - NEAR) && row.velocity == 0.0;
            (!lies).then_some(Law::Floor)
        }
    }
}
