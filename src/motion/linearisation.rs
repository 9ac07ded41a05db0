//! What the linear model leaves out, and the linear model corrected by it.
//!
//! Under threshold normalisation, and but for the factor `sin α/α` of every rotation, the impacts of Eq. 2 depend on the slenderness through
//! `μ = 2(1/cos α - 1) = α² + 5α⁴/12 + ...` alone, and are those of Eq. 4 for `μ = 0`. An oracle that knows how its impacts move with `μ` along the
//! linear solution ([`Oracle::slenderness_shifts`]) gives
//!
//! ```text
//! x(μ) = x(0) + c₁ μ + c₂ μ² + c₃ μ³ + O(μ⁴)
//! ```
//!
//! for each time, interval and velocity, and through the closure of the infinite sum for the chattering time. The first-order term is the error of
//! the linear model; with it added, the error falls as `α⁴`. (In powers of `α²` it does as well, but for weak excitation, where the
//! rotation is small and the block only stiffer by `1/cos α`, the `c₂` of the powers of `μ` nearly vanish.)
//!
//! [`Flights`] puts the same first order back into each flight as it is made, which leaves less near `a_cr` and costs little, but tells nothing of the terms
//! after it.
//!
//! What is left is estimated, not bounded by proof: `c₂` and `c₃` are derived as `c₁` is, with the curvature of the response in them that grows
//! without bound towards `a_cr`; what the terms after them add is calibrated.

mod corrected;
mod flights;
mod threshold;

use contract::{Case, Decline, Estimate, History, Impact, Oracle, SlendernessShift, Uncertainty};

pub use corrected::Corrected;
pub use flights::Flights;

use crate::measure::{observables::Observed, zeno};

/// What the linear model leaves out of one number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shift {
    /// The derivative by `α²` at `α = 0`.
    pub derivative: f64,
    /// The first-order term `c₁ μ`: what the number of the linear model has to be changed by.
    pub first_order: f64,
    /// The largest error expected after that change. It is without bound where the terms do not fall.
    pub left: f64,
}

/// What it leaves out of one impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactShift {
    /// Of the time, absolute in `τ`.
    pub time: Shift,
    /// Of the interval, relative.
    pub interval: Shift,
    /// Of the velocity, relative, apart from the factor `sin α/α`.
    pub velocity: Shift,
}

/// The error of the linear model on one case.
#[derive(Debug, Clone, PartialEq)]
pub struct Linearisation {
    /// The linear model of the same threshold: under slender normalisation the amplitude is not that of the case.
    pub linear: Observed,
    /// What it leaves out of each of its impacts.
    pub impacts: Vec<ImpactShift>,
    /// What it leaves out of the chattering time, absolute in `τ`, where the linear model has one.
    pub chattering_time: Option<Shift>,
    /// `sin α/α`, which multiplies every velocity.
    pub velocity_scale: f64,
}

/// Up to which ratio of the second term to the first what is left is estimated. Beyond, the terms do not fall fast enough.
const LARGEST_RATIO: f64 = 0.5;

/// The largest error expected after the first-order term, from the largest coefficients up to an impact and the largest ratio `ρ` of the second term
/// to the first in any observable.
///
/// `c₂ μ²` and `c₃ μ³` are derived. The factor on them stands for the terms that follow, which fall the more slowly the nearer a singularity is (the
/// critical amplitude, a grazing impact), as `ρ` tells. It is calibrated: see `tests/gate/linearisation.rs`.
fn left(mu: f64, [_, second, third]: [f64; 3], ratio: f64) -> f64 {
    if ratio.is_nan() || ratio >= LARGEST_RATIO {
        return f64::INFINITY;
    }
    let slack = 1.0 - ratio;
    1.5 * mu * mu * (second + mu * third) / (slack * slack)
}

/// The largest coefficients so far of one observable.
#[derive(Clone, Copy, Default)]
struct Largest([f64; 3]);

impl Largest {
    fn with(self, coefficients: [f64; 3]) -> Self {
        let mut largest = self.0;
        for (largest, new) in largest.iter_mut().zip(coefficients) {
            *largest = larger(*largest, new.abs());
        }
        Self(largest)
    }

    /// The ratio of the second term to the first.
    fn ratio(self, mu: f64) -> f64 {
        let Self([first, second, _]) = self;
        if first == 0.0 && second == 0.0 { 0.0 } else { mu * second / first }
    }

    fn shift(self, mu: f64, [derivative, ..]: [f64; 3], ratio: f64) -> Shift {
        Shift { derivative, first_order: mu * derivative, left: left(mu, self.0, ratio) }
    }
}

impl Linearisation {
    /// The error of the linear oracle `stepper` on a case with slenderness.
    ///
    /// # Errors
    /// A [`Decline`] when the case has no slenderness, or the oracle declines it or does not know how its impacts move.
    pub fn new(stepper: &dyn Oracle, case: &Case) -> Result<Self, Decline> {
        let slenderness = case.slenderness().ok_or(Decline::NeedsSlenderness)?;
        let (linear, history) = threshold::linear(stepper, case, slenderness)?;
        let observed = Observed::new(&linear, history);
        let shifts = stepper.slenderness_shifts(&linear).filter(|of| of.len() == observed.history.impacts.len());
        let shifts = shifts.ok_or(Decline::Unsupported { what: "the effect of the slenderness" })?;
        Ok(Self::from_shifts(&linear, slenderness.alpha(), observed, &shifts))
    }

    /// The same from how each impact of the linear history `observed` moves.
    pub fn from_shifts(case: &Case, alpha: f64, observed: Observed, shifts: &[SlendernessShift]) -> Self {
        let mu = parameter(alpha);
        let mut largest = [Largest::default(); 3];
        let impacts = shifts.iter().map(|of| {
            let coefficients = [of.time, of.interval, of.velocity];
            largest.iter_mut().zip(coefficients).for_each(|(largest, of)| *largest = largest.with(of));
            let ratio = ratio(&largest, mu);
            let [time, interval, velocity] = largest;
            ImpactShift {
                time: time.shift(mu, of.time, ratio),
                interval: interval.shift(mu, of.interval, ratio),
                velocity: velocity.shift(mu, of.velocity, ratio),
            }
        });
        let impacts = impacts.collect();
        let closed = observed.chattering_time.and_then(|_| {
            let [first, second, third] = [0, 1, 2].map(|power| closed(&observed.history, shifts, power, case.eta()));
            Some([first?, second?, third?])
        });
        let chattering_time = closed.map(|closed| {
            let [time, ..] = largest;
            let ratio = ratio(&largest, mu);
            time.with(closed).shift(mu, closed, ratio)
        });
        Self { linear: observed, impacts, chattering_time, velocity_scale: alpha.sin() / alpha }
    }

    /// The impacts of the linear model with the first-order terms added, with what is left on top of what the oracle claims.
    pub fn corrected(&self) -> Vec<Impact> {
        let impacts = self.linear.history.impacts.iter().zip(&self.impacts);
        let corrected = impacts.map(|(impact, ImpactShift { time, interval, velocity })| {
            // An error relative to the linear number, in one relative to the corrected one.
            let relative = |claim: f64, shift: &Shift| claim + shift.left / (1.0 + shift.first_order).abs();
            Impact {
                time: impact.time + time.first_order,
                interval: impact.interval * (1.0 + interval.first_order),
                velocity: self.velocity_scale * impact.velocity * (1.0 + velocity.first_order),
                uncertainty: Uncertainty {
                    time: impact.uncertainty.time + time.left,
                    interval: relative(impact.uncertainty.interval, interval),
                    velocity: relative(impact.uncertainty.velocity, velocity),
                },
            }
        });
        corrected.collect()
    }

    /// The chattering time with its first-order term added, where the linear model has one.
    pub fn corrected_chattering_time(&self) -> Option<Estimate> {
        let (linear, shift) = self.linear.chattering_time.zip(self.chattering_time)?;
        Some(Estimate { value: linear.value + shift.first_order, uncertainty: linear.uncertainty + shift.left })
    }
}

/// `μ = 2(1/cos α - 1)`, the parameter by whose powers the effect of the slenderness `alpha` goes.
pub fn parameter(alpha: f64) -> f64 {
    let half = (0.5 * alpha).sin();
    4.0 * half * half / alpha.cos()
}

/// The largest ratio of the second term to the first of any observable.
fn ratio(largest: &[Largest], mu: f64) -> f64 {
    largest.iter().map(|of| of.ratio(mu)).fold(0.0, larger)
}

/// The larger of two, or the one that is lost: not `max`, which would drop it.
fn larger(one: f64, other: f64) -> f64 {
    if one.is_nan() || other <= one { one } else { other }
}

/// The coefficient of a power of `μ` (0 for the first) of the chattering time.
fn closed(history: &History, shifts: &[SlendernessShift], power: usize, eta: f64) -> Option<f64> {
    let of = |coefficients: [f64; 3]| coefficients.get(power).copied().unwrap_or(0.0);
    let intervals = history.impacts.iter().zip(shifts).map(|(impact, shift)| impact.interval * of(shift.interval));
    zeno::shift(history, of(shifts.last()?.time), intervals, eta)
}

#[cfg(test)]
mod tests;
