//! Sections 2.1 and 2.2: the threshold of rocking, and what the slender approximation costs.

use contract::{Case, Ending, Model, Normalisation, Oracle as _, Slenderness};

use super::{Measured, Measurement};
use crate::studies::{
    diagnose::truth::FEW_DIGITS,
    paper::{Error, limits::order, missing},
};

pub(super) const ALL: &[Measurement] = &[
    ("eq-1", threshold),
    ("eq-1-slender", slender_threshold),
    ("eq-3", linearisation),
    ("eq-5-slender", slender_amplitude),
];

/// The block of the figures.
const ALPHA: f64 = 0.2;
const OMEGA: f64 = 2.0;
const ETA: f64 = 0.92;
const EPSILON: f64 = 0.03;

/// The smallest amplitude over `g α` at which a block of this slenderness rocks, by bisection.
fn least_amplitude(alpha: f64) -> Result<f64, Error> {
    let slenderness = Slenderness::new(alpha, Normalisation::Slender)?;
    // Whether it rocks, not when it rests.
    let enclosure = enclosure::Enclosure::new(Model::Nonlinear).with_digits(FEW_DIGITS)?;
    let (mut low, mut high) = (0.5, 4.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let case = Case::from_amplitude(middle, OMEGA, ETA)?.with_slenderness(slenderness).with_max_impacts(1)?;
        let history = enclosure.history(&case)?;
        if history.ending == Ending::NeverRocks { low = middle } else { high = middle }
    }
    Ok(high)
}

fn threshold() -> Result<Measured, Error> {
    let mut worst: f64 = 0.0;
    for alpha in [0.05, 0.1, ALPHA, 0.5] {
        worst = worst.max((least_amplitude(alpha)? * alpha / alpha.tan() - 1.0).abs());
    }
    Ok(Measured::to_digits(worst, 12, "blocks with α from 0.05 to 0.5 begin to rock at g tan α"))
}

fn slender_threshold() -> Result<Measured, Error> {
    let (at_tenth, at_fifth) = (least_amplitude(0.1)? - 1.0, least_amplitude(ALPHA)? - 1.0);
    let found = format!(
        "the threshold is {:.2} % above g α at α = 0.1 and {:.2} % at α = 0.2: {:.0} % of a − 1 in Figs 2 and 9",
        100.0 * at_tenth,
        100.0 * at_fifth,
        100.0 * at_fifth / EPSILON
    );
    Ok(Measured::new(at_fifth, found))
}

/// The proven chattering time of the case of Fig. 2; of the linear model without a slenderness.
fn chattering_time(slenderness: Option<Slenderness>) -> Result<f64, Error> {
    let case = Case::from_epsilon(EPSILON, OMEGA, ETA)?.with_max_impacts(80)?;
    let (model, case) = match slenderness {
        Some(slenderness) => (Model::Nonlinear, case.with_slenderness(slenderness)),
        None => (Model::Linear, case),
    };
    let enclosed = enclosure::Enclosure::new(model).enclose(&case)?;
    let bounds = enclosed.chattering_time.ok_or_else(|| missing("the chattering time of Fig. 2"))?;
    Ok(bounds.middle().0)
}

/// How much the nonlinear chattering time differs from the linear one, relative.
fn difference(alpha: f64, normalisation: Normalisation) -> Result<f64, Error> {
    let nonlinear = chattering_time(Some(Slenderness::new(alpha, normalisation)?))?;
    Ok(nonlinear / chattering_time(None)? - 1.0)
}

fn linearisation() -> Result<Measured, Error> {
    let of = |alpha| difference(alpha, Normalisation::Threshold);
    let (at_tenth, at_fifth) = (of(0.1)?, of(ALPHA)?);
    let found = format!(
        "with a in units of the true threshold, g tan α, τ_ch of Fig. 2 differs by {:.4} % at α = 0.1 and {:.4} % at α = 0.2, as α^{:.2}",
        100.0 * at_tenth,
        100.0 * at_fifth,
        order(of, ALPHA)?
    );
    Ok(Measured::new(at_fifth.abs(), found))
}

fn slender_amplitude() -> Result<Measured, Error> {
    let of = |alpha| difference(alpha, Normalisation::Slender);
    let (at_tenth, at_fifth) = (of(0.1)?, of(ALPHA)?);
    let found = format!(
        "with a in units of g α (Eq. 5) the block of Fig. 2 comes to rest {:.1} % earlier at α = 0.1 and {:.1} % earlier at α = 0.2 than Eq. 4 says, \
         because everything scales with a − 1",
        -100.0 * at_tenth,
        -100.0 * at_fifth
    );
    Ok(Measured::new(at_fifth.abs(), found))
}
