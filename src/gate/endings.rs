//! Endings that differ without contradicting each other are asked about again: "at rest" against "limit of impacts reached", "overturned"
//! against "still rocking at half a period".

use contract::{Case, Ending, Horizon, Limit, Oracle};

use crate::{
    gate::laws::{Breach, Law},
    measure::{
        asking::{Answer, ask},
        excitation::{half_period, horizon},
    },
};

/// How many times more impacts an oracle is asked for that says that the block comes to rest.
const MORE: usize = 4;

/// What is wrong with the ending of the answer at `place`, if anything. Only those at the places that `is_sound` says bear witness against it.
pub fn breach(
    panel: &[&dyn Oracle],
    case: &Case,
    answers: &[Answer],
    place: usize,
    is_sound: impl Fn(usize) -> bool,
) -> Option<Breach> {
    let (oracle, answer) = (panel.get(place)?, answers.get(place)?);
    let history = &answer.observed()?.history;
    match history.ending {
        Ending::AtRest if ending_of_another(answers, answer, |_, ending| ending != Ending::AtRest).is_some() => {
            let again = ask(*oracle, &case.with_max_impacts(MORE.saturating_mul(case.max_impacts())).ok()?);
            let ending = again.observed()?.history.ending;
            let how = format!("at rest after {} impacts, but {ending} when asked for more", history.impacts.len());
            (ending != Ending::AtRest).then_some(Breach { law: Law::RestStays, impact: 0, how })
        }
        Ending::Overturned => {
            let rocks = |place: usize, ending| {
                is_sound(place) && matches!(ending, Ending::Incomplete | Ending::LimitReached(Limit::Time))
            };
            let other = ending_of_another(answers, answer, rocks)?;
            let later = Horizon::Until(horizon(case) + 2.0 * half_period(case.omega()));
            let followed = ask(*panel.get(other)?, &case.with_horizon(later).ok()?);
            let landed = followed.observed()?.history.impacts.get(history.impacts.len())?;
            let how = format!("but {} finds another impact at {:?}", followed.oracle, landed.time);
            (landed.uncertainty.time < 0.1 * landed.time).then_some(Breach {
                law: Law::OverturnedStays,
                impact: history.impacts.len() + 1,
                how,
            })
        }
        _ => None,
    }
}

/// The place of another answer for the same model whose ending is as wanted.
fn ending_of_another(answers: &[Answer], this: &Answer, wanted: impl Fn(usize, Ending) -> bool) -> Option<usize> {
    let is_other = |(place, other): &(usize, &Answer)| {
        other.oracle != this.oracle
            && other.model == this.model
            && other.observed().is_some_and(|observed| wanted(*place, observed.history.ending))
    };
    answers.iter().enumerate().find(is_other).map(|(place, _)| place)
}
