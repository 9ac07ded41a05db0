use crate::flight::{Block, State};
use crate::number::Number;
use crate::series::Series;

/// One impact: the duration of the flight that it ended, and the state just after it.
#[derive(Debug, Clone)]
pub(crate) struct Impact<T> {
    pub(crate) interval: Series<T>,
    pub(crate) time: Series<T>,
    pub(crate) velocity: Series<T>,
}

/// The limit of the times of impact, `θ_ch = ω τ_ch/ε^(1/2)`.
#[derive(Debug, Clone)]
pub(crate) struct Limit<T> {
    pub(crate) value: Series<T>,
    /// How much the last column of the extrapolation changed it.
    pub(crate) change: Vec<f64>,
    /// After how many pairs of flights, and in which column.
    pub(crate) found_at: (usize, usize),
}

/// Where to look for the limit.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Search {
    /// Until the last column changes no coefficient by more than this, relative.
    Until(f64),
    /// Until it changes all coefficients together by no more than this of the first: where they are terms already.
    Together(f64),
    /// After so many pairs of flights in that column.
    At(usize, usize),
}

/// Follows the flights until the limit is found and `impacts` impacts are listed; `None` for the limit if that takes too many flights.
///
/// The times of every second impact approach the limit with errors in `η², η⁴, η⁶, ...`, coefficient by coefficient: the map over a pair of
/// flights is analytic in the velocity, and multiplies it by `η²` at rest whatever `ε` (Eq. 73). Each column of Romberg's scheme removes one.
pub(crate) fn march<T: Number>(
    block: &Block<T>,
    terms: usize,
    impacts: usize,
    search: Search,
) -> (Vec<Impact<T>>, Option<Limit<T>>) {
    let mut state = State::initiation(block, terms);
    let fly = |even| {
        let (interval, next) = state.fly(block, even);
        state = next;
        Some(Impact { interval, time: state.x.clone(), velocity: state.v.clone() })
    };
    accumulate(fly, block.eta * block.eta, impacts, search)
}

/// The same for any flights, each from the last: `fly` is told whether it is an even one. `None` for the limit also where a flight does not end.
pub(crate) fn accumulate<T: Number>(
    mut fly: impl FnMut(bool) -> Option<Impact<T>>,
    ratio: T,
    impacts: usize,
    search: Search,
) -> (Vec<Impact<T>>, Option<Limit<T>>) {
    let mut listed = Vec::new();
    let mut limit = None;
    let mut columns: Vec<Series<T>> = Vec::new();
    for pair in 1..=MOST_PAIRS.max(impacts.div_ceil(2)) {
        let [Some(even), Some(odd)] = [true, false].map(&mut fly) else { break };
        if limit.is_none() && pair <= MOST_PAIRS {
            columns = next_columns(&columns, &odd.time, ratio);
            limit = found(&columns, pair, search);
        }
        listed.extend([even, odd].into_iter().take(impacts - listed.len()));
        if listed.len() >= impacts && (limit.is_some() || pair >= MOST_PAIRS) {
            break;
        }
    }
    (listed, limit)
}

/// Far beyond what `η = 0.99` takes.
const MOST_PAIRS: usize = 2_000;
/// More columns gain nothing, and magnify rounding.
const MOST_COLUMNS: usize = 18;
/// A column that few flights made can be right by accident.
const FEWEST_PAIRS: usize = 8;

/// The next row of the table, from the one before and a new entry of its first column.
fn next_columns<T: Number>(last: &[Series<T>], entry: &Series<T>, ratio: T) -> Vec<Series<T>> {
    let mut row = vec![entry.clone()];
    let mut power = T::one();
    for early in last.iter().take(MOST_COLUMNS) {
        power = power * ratio;
        if let Some(late) = row.last() {
            let mut better = late.clone();
            better.add(power.over(T::one() - power), &late.minus(early));
            row.push(better);
        }
    }
    row
}

fn found<T: Number>(columns: &[Series<T>], pairs: usize, search: Search) -> Option<Limit<T>> {
    let mut changes = (1..).zip(columns.windows(2)).filter_map(|(column, two)| match two {
        [before, value] => Some(Limit {
            value: value.clone(),
            change: value.minus(before).0.iter().map(|change| change.rounded().abs()).collect(),
            found_at: (pairs, column),
        }),
        _ => None,
    });
    match search {
        Search::At(after, _) if pairs != after => None,
        Search::At(_, column) => changes.find(|limit| limit.found_at.1 == column),
        Search::Until(_) | Search::Together(_) if pairs < FEWEST_PAIRS => None,
        Search::Together(relative) => {
            changes.find(|limit| limit.change.iter().sum::<f64>() <= relative * limit.value.leading().rounded().abs())
        }
        Search::Until(relative) => changes.find(|limit| {
            limit.change.iter().zip(&limit.value.0).all(|(change, value)| *change <= relative * value.rounded().abs())
        }),
    }
}
