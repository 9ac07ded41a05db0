use std::f64::consts::PI;

use contract::{
    Body, Bout, Case, Decline, Ending, Estimate, Followed, History, Horizon, Impact, Invalid, Limit, Loss, Model,
    Motion, Oracle,
};

use crate::expansion::Expansion;
use crate::paper;
use crate::resummed::{RESUMMED_TERMS, Resummed};
use crate::truncated::BEYOND;
use crate::weak;

/// How far the series is carried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// As the paper does: Eq. 65.
    Paper,
    /// So many terms of `ω τ_ch = ε^(1/2) (c₀ + c₁ ε + ...)`, and of the series of each impact. One term is the first sum of Eq. 65.
    Terms(usize),
    /// All terms that are computed, with the singularity at the critical amplitude summed by itself. Impacts are of order 92.
    Resummed,
}

/// The asymptotic series of the paper's section 3.
#[derive(Debug, Clone, PartialEq)]
pub struct Asymptotic {
    order: Order,
    tolerance: f64,
    name: String,
}

/// The largest order that can be asked for: [`Expansion::MOST_TERMS`] less those that tell the error.
pub const MOST_ORDER: usize = Expansion::MOST_TERMS - BEYOND;

/// Below it products of velocities come near to the smallest double.
const LEAST_EPSILON: f64 = 1e-60;
/// As many as take no longer than the chattering time itself.
const CHEAP_IMPACTS: usize = 200;

/// Beyond this claimed relative error of the chattering time nothing of an approximation is left.
const MOST_CLAIMED: f64 = 0.5;

impl Default for Asymptotic {
    fn default() -> Self {
        Self { order: Order::Paper, tolerance: MOST_CLAIMED, name: "asymptotic/paper".to_owned() }
    }
}

impl Asymptotic {
    /// The series to the order of the paper.
    pub fn new() -> Self {
        Self::default()
    }

    /// The same to another order.
    ///
    /// # Errors
    /// When the number of terms is 0 or more than [`MOST_ORDER`].
    pub fn with_order(self, order: Order) -> Result<Self, Invalid> {
        let name = match order {
            Order::Paper => "asymptotic/paper".to_owned(),
            Order::Resummed => "asymptotic/resummed".to_owned(),
            Order::Terms(terms) if (1..=MOST_ORDER).contains(&terms) => format!("asymptotic/order-{terms}"),
            Order::Terms(terms) => return Err(Invalid::new("order", terms, "paper, 1 to 92, or resummed")),
        };
        Ok(Self { order, name, ..self })
    }

    /// The same, but it declines where the error that it claims for the chattering time, relative, is more than `tolerance`.
    ///
    /// # Errors
    /// When the tolerance is not within (0, 0.5].
    pub fn with_tolerance(self, tolerance: f64) -> Result<Self, Invalid> {
        if !(tolerance > 0.0 && tolerance <= MOST_CLAIMED) {
            return Err(Invalid::new("tolerance", tolerance, "above 0, up to 0.5"));
        }
        Ok(Self { tolerance, ..self })
    }
}

impl Oracle for Asymptotic {
    fn name(&self) -> &str {
        &self.name
    }

    fn model(&self) -> Model {
        Model::Linear
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        if case.epsilon() <= 0.0 {
            return Ok(History { impacts: Vec::new(), ending: Ending::NeverRocks, chattering_time: None });
        }
        match self.order {
            Order::Paper => {
                let (chattering_time, impacts) = paper::answer(case)?;
                self.stand_by(case, chattering_time)?;
                Ok(listed(case, chattering_time, impacts))
            }
            Order::Terms(order) => self.to_any_order(case, order, order + BEYOND, |expansion| {
                Ok(expansion.chattering_time(order, case.epsilon()))
            }),
            Order::Resummed => self.to_any_order(case, RESUMMED_TERMS - BEYOND, RESUMMED_TERMS, |expansion| {
                Ok(Resummed::new(expansion)?.chattering_time(case.epsilon()))
            }),
        }
    }

    /// By the law of weak excitation, to two terms (relative errors of the order of `ε^(3/2)`) or as many as were asked for; impacts are not listed.
    fn bouts_on(&self, body: &Body, motion: &Motion, asked: &Followed) -> Result<Vec<Bout>, Decline> {
        let order = match self.order {
            Order::Paper => 2,
            Order::Terms(order) => order,
            Order::Resummed => {
                return Err(Decline::Unsupported { what: "resumming on other motions than the sinusoid of a case" });
            }
        };
        weak::bouts(body, motion, asked, weak::Wanted { order, tolerance: self.tolerance })
    }
}

impl Asymptotic {
    /// A history from `terms` terms, of which each impact takes the first `order`, and the chattering time what `time` says.
    fn to_any_order(
        &self,
        case: &Case,
        order: usize,
        terms: usize,
        time: impl Fn(&Expansion) -> Result<Option<Estimate>, Decline>,
    ) -> Result<History, Decline> {
        let (epsilon, impacts) = (case.epsilon(), most_impacts(case)?);
        if epsilon < LEAST_EPSILON {
            return Err(Decline::OutOfRange { field: "epsilon", value: epsilon, allowed: "1e-60 <= epsilon" });
        }
        // Many impacts take long: first whether there is a chattering time to stand by.
        let first = if impacts > CHEAP_IMPACTS { 0 } else { impacts };
        let mut expansion = Expansion::new(case.omega(), case.eta(), terms, first)?;
        let chattering_time = time(&expansion)?.ok_or_else(|| Decline::NotConvergent {
            why: format!("the series does not converge at epsilon = {epsilon:.4e}: past the critical amplitude"),
        })?;
        self.stand_by(case, chattering_time)?;
        if first < impacts {
            expansion = Expansion::new(case.omega(), case.eta(), terms, impacts)?;
        }
        let impacts: Option<Vec<Impact>> = expansion.impacts(order, epsilon).collect();
        let impacts = impacts.ok_or_else(|| Decline::NotConvergent {
            why: format!(
                "tau_ch is known, but the series of an impact does not converge at epsilon = {epsilon:.4e}; fewer impacts may do"
            ),
        })?;
        Ok(listed(case, chattering_time, impacts.into_iter()))
    }

    /// Whether the error that is claimed leaves something of the value.
    fn stand_by(&self, case: &Case, time: Estimate) -> Result<(), Decline> {
        let Estimate { value, uncertainty } = time;
        let half_period = PI / case.omega();
        // The negation declines NaN as well.
        if !(uncertainty <= self.tolerance * value && value + uncertainty < half_period) {
            return Err(Decline::NotConvergent {
                why: format!(
                    "it gives tau_ch = {:.4} T/2 with a relative error of up to {:.2e} at epsilon = {:.4e}; at most {:.1e} is accepted, and no \
                     more than leaves tau_ch below T/2",
                    value / half_period,
                    uncertainty / value,
                    case.epsilon(),
                    self.tolerance,
                ),
            });
        }
        Ok(())
    }
}

/// How many impacts the case asks for, if they are not too many to have series of their own.
fn most_impacts(case: &Case) -> Result<usize, Decline> {
    const MOST: usize = 5_000;
    let impacts = case.max_impacts();
    if impacts > MOST {
        let allowed = "up to 5000 for the series to any order";
        return Err(Decline::OutOfRange { field: "impacts", value: impacts as f64, allowed });
    }
    Ok(impacts)
}

/// The impacts that the case asks for, and why there are no more.
fn listed(case: &Case, chattering_time: Estimate, known: impl Iterator<Item = Impact>) -> History {
    let horizon = match case.horizon() {
        Horizon::HalfPeriod => f64::INFINITY,
        Horizon::Until(time) => time,
    };
    let mut impacts = Vec::new();
    let mut ending = if chattering_time.value > horizon { Ending::LimitReached(Limit::Time) } else { Ending::AtRest };
    for impact in known.take(case.max_impacts()) {
        if impact.time > horizon {
            ending = Ending::LimitReached(Limit::Time);
            break;
        }
        if !(impact.interval.is_normal() && impact.velocity.is_normal()) {
            ending = Ending::Lost(Loss::NotFinite);
            break;
        }
        impacts.push(impact);
    }
    History { impacts, ending, chattering_time: Some(chattering_time) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_impacts_as_are_allowed_are_given() {
        let case =
            |impacts| Case::from_amplitude(1.03, 2.0, 0.92).and_then(|case| case.with_max_impacts(impacts)).unwrap();
        assert_eq!(most_impacts(&case(5000)), Ok(5000));
        assert!(matches!(most_impacts(&case(5001)), Err(Decline::OutOfRange { field: "impacts", value: 5001.0, .. })));
    }
}
