//! A few of the cases that were answered in batches are asked again, alone: a case has to have the same answer in any company.

use contract::Case;

use crate::{
    answer::{Answer, Outcome},
    pool::Pool,
    round::{Round, is_answer},
    verdict::{Breakdown, Verdict},
};

/// How many are asked again.
const SAMPLE: u64 = 8;

/// Asks a sample of these cases alone. If one of them has another answer then, no batch is trusted, and all are asked alone.
pub fn check(pool: &Pool, cases: &[Case], round: &mut Round) {
    let Some(mut slot) = pool.slot(0) else { return };
    let mut compare = |round: &mut Round, at: usize| -> bool {
        let Some((case, answer)) = cases.get(at).zip(round.answers.get_mut(at)).filter(|(_, answer)| is_answer(answer))
        else {
            return true;
        };
        if round.spent > pool.launch().restarts {
            return true;
        }
        let alone = pool.alone(&mut slot, case);
        round.spent += alone.breaks;
        if alone.answer.says_the_same(answer) {
            return true;
        }
        *answer = differs(answer, alone.answer);
        false
    };
    let sample = places(cases.len());
    let other = sample.iter().filter(|&&at| !compare(round, at)).count();
    if other > 0 {
        for at in (0..cases.len()).filter(|at| !sample.contains(at)) {
            compare(round, at);
        }
    }
}

/// Spread over all places, and over all places in a batch: multiples of the golden ratio.
fn places(count: usize) -> Vec<usize> {
    let mut places: Vec<usize> = (1..=SAMPLE)
        .filter_map(|k| {
            let share = k.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32;
            usize::try_from((share * u64::try_from(count).ok()?) >> 32).ok()
        })
        .collect();
    places.sort_unstable();
    places.dedup();
    places
}

/// What is said of a case whose answer is another one alone.
fn differs(in_batch: &Answer, alone: Answer) -> Answer {
    match (&in_batch.outcome, &alone.outcome) {
        // It broke: that is the verdict.
        (_, Outcome::Broke(_)) => alone,
        (Outcome::History(batch), Outcome::History(single)) => {
            let pairs = batch.impacts.iter().zip(&single.impacts);
            let bits = |impact: &contract::Impact| [impact.time, impact.interval, impact.velocity].map(f64::to_bits);
            let happened = match (1..).zip(pairs).find(|(_, (one, other))| bits(one) != bits(other)) {
                Some((n, (one, other))) => format!(
                    "impact {n} is at {:?} with velocity {:?} in a batch, at {:?} with {:?} alone",
                    one.time, one.velocity, other.time, other.velocity
                ),
                None => format!(
                    "{} impacts, {} in a batch; {} impacts, {} alone",
                    batch.impacts.len(),
                    batch.ending,
                    single.impacts.len(),
                    single.ending
                ),
            };
            Answer::without(Outcome::Broke(Breakdown::new(Verdict::DiffersAlone, happened)))
        }
        (Outcome::Declined(one), Outcome::Declined(other)) => {
            Answer::broke(Verdict::DiffersAlone, format!("declined in a batch ({one}), and alone ({other})"))
        }
        (Outcome::Declined(one), _) => {
            Answer::broke(Verdict::DiffersAlone, format!("declined in a batch ({one}), answered alone"))
        }
        (_, Outcome::Declined(other)) => {
            Answer::broke(Verdict::DiffersAlone, format!("answered in a batch, declined alone ({other})"))
        }
        _ => alone,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sample is of different places of a batch, whatever the number of cases.
    #[test]
    fn the_sample_is_spread() {
        for count in [2, 8, 64, 449, 513, 100_000] {
            let places = places(count);
            assert!(places.iter().all(|place| *place < count));
            let mut in_batch: Vec<usize> = places.iter().map(|place| place % 64).collect();
            in_batch.sort_unstable();
            in_batch.dedup();
            assert!(in_batch.len() >= 5.min(count / 2), "{count}: {places:?}");
        }
        assert!(places(0).is_empty() || places(0) == [0]);
    }
}
