//! What only the nonlinear model can get wrong.

use contract::{Case, Invalid, Normalisation, Slenderness};

use super::{Fault, NONLINEAR, amount, whole, within};
use crate::faults::plant::Plant::{Answer, Question};

/// The case with a slenderness angle of another size.
fn angle(case: &Case, change: impl Fn(f64) -> f64) -> Result<Case, Invalid> {
    let Some(slenderness) = case.slenderness() else { return Ok(*case) };
    Ok(case.with_slenderness(Slenderness::new(change(slenderness.alpha()), slenderness.normalisation())?))
}

/// The case with an amplitude that is `factor` of the right one.
fn amplitude(case: &Case, factor: f64) -> Result<Case, Invalid> {
    let Some(slenderness) = case.slenderness() else { return Ok(*case) };
    let epsilon = case.epsilon() * factor + (factor - 1.0);
    let new = Case::from_epsilon(epsilon, case.omega(), case.eta())?.with_slenderness(slenderness);
    new.with_max_impacts(case.max_impacts())?.with_horizon(case.horizon())
}

pub(super) fn all() -> Vec<Fault> {
    let all = vec![
        whole(
            "swapped normalisation",
            "the amplitude were measured in g alpha in place of g tan(alpha)",
            Question(|case, _| match case.slenderness() {
                Some(slenderness) => {
                    Ok(case.with_slenderness(Slenderness::new(slenderness.alpha(), Normalisation::Slender)?))
                }
                None => Ok(*case),
            }),
        ),
        amount(
            "alpha is off",
            "the slenderness angle were rounded or mistyped",
            "relative error",
            1e-3,
            Question(|case, size| angle(case, |alpha| alpha * (1.0 + size))),
        ),
        amount(
            "tan(alpha) for alpha",
            "alpha were the ratio of the sides, tan(alpha), and not the angle",
            "share of the difference",
            1.0,
            Question(|case, size| angle(case, |alpha| alpha + size * (alpha.tan() - alpha))),
        ),
        amount(
            "sin(alpha) for tan(alpha)",
            "sin(alpha) stood where tan(alpha) belongs, the ground acceleration of Eq. 2 having lost its cosine at the base",
            "share of the difference, as an exponent of cos(alpha)",
            1.0,
            Question(|case, size| {
                let cos = case.slenderness().map_or(1.0, |slenderness| slenderness.alpha().cos());
                amplitude(case, cos.powf(-size))
            }),
        ),
        amount(
            "velocity without sin(alpha)/alpha",
            "velocities lacked the factor sin(alpha)/alpha, as in the linear model",
            "share of the factor, as an exponent",
            1.0,
            Answer(|case, size, history| {
                let factor = case.slenderness().map_or(1.0, |s| (s.alpha() / s.alpha().sin()).powf(size));
                history.impacts.iter_mut().for_each(|impact| impact.velocity *= factor);
            }),
        ),
    ];
    let ladder = Fault {
        name: "alpha is off where it is small",
        as_if: "the slenderness angle were off below 0.03 only",
        ..amount(
            "",
            "",
            "relative error below alpha = 0.03",
            0.2,
            Question(|case, size| angle(case, |alpha| if alpha < 0.03 { alpha * (1.0 + size) } else { alpha })),
        )
    };
    all.into_iter().chain([ladder]).map(|fault| within(NONLINEAR, fault)).collect()
}
