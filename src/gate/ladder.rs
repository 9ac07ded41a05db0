//! Checks that need more than one case: that a difference falls at the order at which theory says that it falls.

use contract::{Case, Invalid, Model, Normalisation, Oracle, Slenderness};
use serde::{Deserialize, Serialize};

use crate::{
    gate::tolerance::{self, Tolerance},
    measure::{
        asking::{Answer, ask},
        critical,
    },
};

/// The two ladders.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ladder {
    /// The chattering times of the nonlinear and the linear model differ by a multiple of `α²`.
    Alpha,
    /// The relative error of the paper's series is a multiple of `ε` (theory: it keeps one of two terms of the next order).
    Epsilon,
}

impl Ladder {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Alpha, Self::Epsilon];

    /// What it says, for reports.
    pub fn says(self) -> &'static str {
        match self {
            Self::Alpha => "nonlinear - linear tau_ch falls as alpha^2",
            Self::Epsilon => "the error of the series' tau_ch falls as epsilon^1, relative",
        }
    }

    fn rungs(self) -> [f64; 4] {
        match self {
            Self::Alpha => [0.2, 0.1, 0.05, 0.025],
            Self::Epsilon => [1e-3, 1e-4, 1e-5, 1e-6],
        }
    }

    fn order(self) -> (f64, &'static Tolerance) {
        match self {
            Self::Alpha => (2.0, &tolerance::ALPHA_LADDER),
            Self::Epsilon => (1.0, &tolerance::EPSILON_LADDER),
        }
    }
}

/// One ladder that was climbed down.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Descent {
    /// Which.
    pub ladder: Ladder,
    /// The two oracles.
    pub oracles: [String; 2],
    /// The frequency ratio and the restitution of all its cases.
    pub omega: f64,
    /// See `omega`.
    pub eta: f64,
    /// The small parameter on each rung, and the relative difference found there.
    pub rungs: Vec<(f64, f64)>,
    /// The order observed between the last two rungs; `None` if one of the oracles did not answer there, or the difference is not above
    /// what they claim.
    pub order: Option<f64>,
    /// The order that theory gives, and how far the observed one may be from it.
    pub expected: (f64, f64),
}

impl Descent {
    /// What was observed and expected, in one line.
    pub fn describe(&self) -> String {
        let Self { ladder, oracles: [one, two], omega, eta, expected: (order, tolerance), .. } = self;
        let observed = self.order.map_or("none that the claims can resolve".to_owned(), |order| format!("{order:.4}"));
        let says = ladder.says();
        format!(
            "{says} ({one} against {two}, omega = {omega}, eta = {eta}): observed order {observed}, expected {order} ± {tolerance}"
        )
    }

    /// Whether the observed order is the expected one. Having observed none is not.
    pub fn holds(&self) -> bool {
        self.order.is_some_and(|order| (order - self.expected.0).abs() <= self.expected.1)
    }
}

/// The `(ω, η)` at which the ladders stand, and the amplitude of the ladder of `α` as a share of `a_cr - 1`.
const PLACES: [(f64, f64, f64); 6] =
    [(2.0, 0.92, 0.8), (0.5, 0.92, 0.5), (8.0, 0.92, 0.9), (2.0, 0.6, 0.7), (1.0, 0.8, 0.6), (4.0, 0.95, 0.5)];

/// Whether an oracle can be the one that the others are held against on the ladders: the first such of a panel is.
pub fn is_stepper(oracle: &dyn Oracle, series: &str) -> bool {
    oracle.model() == Model::Linear && oracle.name() != series
}

/// Climbs down both ladders everywhere, with the first linear oracle of the panel against each nonlinear one, and against the `series`.
///
/// # Errors
/// Never for the built-in places; the contract would have to refuse one.
pub fn descend(panel: &[&dyn Oracle], series: &str) -> Result<Vec<Descent>, Invalid> {
    let Some(stepper) = panel.iter().find(|oracle| is_stepper(**oracle, series)) else { return Ok(Vec::new()) };
    let mut descents = Vec::new();
    for other in panel {
        let ladder = match other.model() {
            Model::Nonlinear => Ladder::Alpha,
            Model::Linear if other.name() == series => Ladder::Epsilon,
            Model::Linear => continue,
        };
        for (omega, eta, share) in PLACES {
            descents.push(descent(ladder, *stepper, *other, omega, eta, share)?);
        }
    }
    Ok(descents)
}

fn descent(
    ladder: Ladder,
    stepper: &dyn Oracle,
    other: &dyn Oracle,
    omega: f64,
    eta: f64,
    share: f64,
) -> Result<Descent, Invalid> {
    let mut rungs = Vec::new();
    let mut noise = Vec::new();
    for small in ladder.rungs() {
        let epsilon = if ladder == Ladder::Epsilon { small } else { share * (critical::eq77(eta) - 1.0) };
        let mut case = Case::from_epsilon(epsilon, omega, eta)?.with_max_impacts(200)?;
        if ladder == Ladder::Alpha {
            case = case.with_slenderness(Slenderness::new(small, Normalisation::Threshold)?);
        }
        let time = |answer: Answer| answer.observed()?.chattering_time;
        let (Some(exact), Some(value)) = (time(ask(stepper, &case)), time(ask(other, &case))) else { continue };
        rungs.push((small, (value.value / exact.value - 1.0).abs()));
        // The series' own claim is the very error that is measured.
        let theirs = if ladder == Ladder::Alpha { value.uncertainty } else { 0.0 };
        noise.push((exact.uncertainty + theirs) / exact.value);
    }
    let (expected, tolerance) = ladder.order();
    let order = match (rungs.as_slice(), noise.last()) {
        (&[.., (large, above), (small, below)], Some(noise))
            if rungs.len() == ladder.rungs().len() && below > 30.0 * noise =>
        {
            Some((above / below).ln() / (large / small).ln())
        }
        _ => None,
    };
    let oracles = [stepper.name().to_owned(), other.name().to_owned()];
    Ok(Descent { ladder, oracles, omega, eta, rungs, order, expected: (expected, tolerance.value) })
}

#[cfg(test)]
mod tests {
    use super::{Descent, Ladder};

    /// A difference that falls too slowly is a wrong order as one that falls too fast; having seen none is no order.
    #[test]
    fn an_order_may_be_off_to_neither_side() {
        let holds = |order: Option<f64>| {
            let oracles = ["one".to_owned(), "two".to_owned()];
            let rungs = Vec::new();
            Descent { ladder: Ladder::Alpha, oracles, omega: 2.0, eta: 0.9, rungs, order, expected: (2.0, 0.25) }
                .holds()
        };
        let orders = [1.0, 1.7, 1.75, 2.0, 2.25, 2.3, 3.0, f64::NAN];
        assert_eq!(orders.map(|order| holds(Some(order))), [false, false, true, true, true, false, false, false]);
        assert!(!holds(None));
    }
}
