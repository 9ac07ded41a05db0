//! What a simulator of somebody else gets wrong and none of the oracles here could: other words for the same thing, another equation, another method. They
//! are hypotheses about engines, and are planted in engines.

use contract::{Case, Invalid, Model, Slenderness};

use super::{Fault, NONLINEAR, parameters, whole, within};
use crate::{
    faults::plant::Plant::{Answer, Instead, Question},
    panel::{self, SERIES, Settings},
};

/// All of them.
pub(super) fn all() -> Vec<Fault> {
    [words(), others(), slender()].concat()
}

fn words() -> Vec<Fault> {
    vec![
        whole(
            "velocities of the other sign",
            "velocities had the other sign",
            Answer(|_, _, history| history.impacts.iter_mut().for_each(|impact| impact.velocity = -impact.velocity)),
        ),
        whole(
            "times as phases",
            "times were counted in radians of the shaking, omega tau in place of tau",
            Answer(|case, _, history| {
                for impact in &mut history.impacts {
                    impact.time *= case.omega();
                    impact.interval *= case.omega();
                }
            }),
        ),
        whole(
            "clock from phase zero",
            "times were counted from where the shaking passes zero, and not from where it starts the rocking",
            Answer(|case, _, history| {
                let delay = (1.0 / case.amplitude()).asin() / case.omega();
                if let Some(first) = history.impacts.first_mut() {
                    first.interval += delay;
                }
                history.impacts.iter_mut().for_each(|impact| impact.time += delay);
            }),
        ),
        whole(
            "omega turned over",
            "the frequency ratio were turned over, p/omega in place of omega/p",
            Question(|case, _| parameters::with(case, case.epsilon(), 1.0 / case.omega(), case.eta())),
        ),
    ]
}

fn others() -> Vec<Fault> {
    vec![
        whole(
            "a - 1 from a",
            "a - 1 were computed from the amplitude a in double precision, which has lost the digits of a - 1 by then",
            Question(|case, _| parameters::with(case, case.amplitude() - 1.0, case.omega(), case.eta())),
        ),
        whole(
            "the series for the motion",
            "the paper's series to its order, with which Eq. 65 is made, were the motion itself",
            Instead(|| panel::one(SERIES, &Settings::default(), "linear").unwrap_or_else(|_| panel::stepper())),
        ),
        within(
            NONLINEAR,
            whole(
                "Eq. 4 for Eq. 2",
                "the block were slender: Eq. 4 is solved in place of Eq. 2",
                Instead(|| panel::stepper_of(Model::Linear)),
            ),
        ),
    ]
}

fn slender() -> Vec<Fault> {
    let all = [
        whole(
            "alpha in degrees",
            "the slenderness angle were taken for degrees",
            Question(|case, _| match case.slenderness() {
                Some(of) => Ok(case.with_slenderness(Slenderness::new(of.alpha().to_radians(), of.normalisation())?)),
                None => Ok(*case),
            }),
        ),
        whole("amplitude in g", "the amplitude were in multiples of g", Question(in_g)),
        whole(
            "velocities of theta",
            "velocities were those of the rotation theta in radians, and not of phi = theta/alpha",
            Answer(|case, _, history| {
                let alpha = case.slenderness().map_or(1.0, |slenderness| slenderness.alpha());
                history.impacts.iter_mut().for_each(|impact| impact.velocity *= alpha);
            }),
        ),
    ];
    all.into_iter().map(|fault| within(NONLINEAR, fault)).collect()
}

fn in_g(case: &Case, _: f64) -> Result<Case, Invalid> {
    // Without a slenderness there is no such mistake, nor a rounding of it.
    let Some(slenderness) = case.slenderness() else { return Ok(*case) };
    parameters::with(case, case.amplitude() / slenderness.alpha().tan() - 1.0, case.omega(), case.eta())
}
