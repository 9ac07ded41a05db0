use astro_float::BigFloat;
use contract::{Case, Ending, Horizon, Limit, Loss};

use crate::arithmetic::{Arithmetic, double};
use crate::motion::{Excitation, Flight};
use crate::rest;

/// One impact, as long as the arithmetic makes it.
pub(crate) struct LongImpact {
    pub(crate) time: BigFloat,
    pub(crate) interval: BigFloat,
    pub(crate) velocity: BigFloat,
}

/// Where a history ends: `T/2`, or the horizon of the case when that is earlier.
struct End {
    time: BigFloat,
    ending: Ending,
}

impl End {
    fn new(ar: &Arithmetic, case: &Case, excitation: &Excitation) -> Self {
        let half_period = excitation.half_period(ar);
        if let Horizon::Until(time) = case.horizon() {
            let time = ar.number(time);
            if is_before(&time, &half_period) {
                return Self { time, ending: Ending::LimitReached(Limit::Time) };
            }
        }
        Self { time: half_period, ending: Ending::Incomplete }
    }
}

/// The impacts before `T/2`, `most` of them at the most, and why there are no more: Eqs 6-13, flight after flight.
pub(crate) fn follow(ar: &Arithmetic, case: &Case, most: usize) -> (Vec<LongImpact>, Ending) {
    let excitation = Excitation::new(ar, case);
    let end = End::new(ar, case, &excitation);
    let eta = ar.number(case.eta());
    let (mut tau, mut velocity, mut sign) = (ar.number(0.0), ar.number(0.0), -1.0);
    let mut impacts = Vec::new();
    while impacts.len() < most {
        let flight = Flight::from_impact(ar, &excitation, sign, &tau, &velocity);
        // A lower bound of the duration, so that the search starts inside the flight.
        let shortest = if impacts.is_empty() {
            // The root is near 4√2 ε^(1/2)/ω (Eq. 31), sooner for a slow excitation but never by as much as this.
            case.epsilon().sqrt().min(1.0) / case.omega().max(1.0)
        } else {
            // The acceleration towards the base is at most 1 + a, so the flight lasts at least 2 |φ'|/(1 + a).
            double(&velocity).abs() / (1.0 + case.amplitude())
        };
        let next = match impact_time(ar, &excitation, &flight, &tau, shortest, &end) {
            Search::Found(next) => next,
            Search::Ended(ending) => return (impacts, ending),
        };
        let interval = ar.sub(&next, &tau);
        // Eq. 13.
        velocity = ar.mul(&eta, &flight.velocity(ar, &excitation, &next));
        // The flight that follows has the other sign, and leaves the base with it.
        if !(interval.is_positive() && !interval.is_zero() && double(&velocity) * sign < 0.0) {
            return (impacts, Ending::Lost(Loss::NotFinite));
        }
        tau = next;
        sign = -sign;
        impacts.push(LongImpact { time: tau.clone(), interval, velocity: velocity.clone() });
    }
    let forcing = double(&excitation.forcing(ar, &tau));
    let left = double(&ar.sub(&end.time, &tau));
    let complete = rest::is_certain(case, forcing, double(&velocity), left);
    (impacts, if complete { Ending::AtRest } else { Ending::LimitReached(Limit::Impacts) })
}

pub(crate) enum Search {
    Found(BigFloat),
    Ended(Ending),
}

/// By how much the search grows its step each time. The rotation is sampled this densely on the way to the impact; only a graze shorter
/// than this part of the flight could pass unseen, and below the critical amplitude there is none.
const GROWTH: f64 = 1.15;

/// The impact that ends `flight`: the first sign change of `φ` after `τ_n + shortest`.
fn impact_time(
    ar: &Arithmetic,
    excitation: &Excitation,
    flight: &Flight,
    tau_n: &BigFloat,
    shortest: f64,
    end: &End,
) -> Search {
    let mut before = tau_n.clone();
    let mut step = ar.number(shortest);
    loop {
        let mut after = ar.add(tau_n, &step);
        let last = !is_before(&after, &end.time);
        if last {
            after = end.time.clone();
        }
        let rotation = flight.rotation(ar, excitation, &after);
        if rotation.is_nan() || step.is_zero() {
            return Search::Ended(Ending::Lost(Loss::NotFinite));
        }
        if !flight.is_off_base(&rotation) {
            if !is_before(tau_n, &before) && !last {
                // The very first sample lies inside the flight, and has to have its sign.
                return Search::Ended(Ending::Lost(Loss::FellThrough));
            }
            return root(ar, excitation, flight, before, after);
        }
        if last {
            return Search::Ended(outcome(ar, excitation, flight, end));
        }
        before = after;
        step = ar.scale(&step, GROWTH);
    }
}

fn is_before(a: &BigFloat, b: &BigFloat) -> bool {
    a.cmp(b).is_some_and(|order| order < 0)
}

/// The root of `φ` between `low`, in flight, and `high`, past the impact: Newton's method from `high`, where rotation and acceleration
/// have the same sign, so that it falls to the root from one side. Where a step leaves the bracket nevertheless, the bracket is halved,
/// until the steps are so small that only quadratic convergence is left, and then rounding: then they do not become shorter any more.
pub(crate) fn root(
    ar: &Arithmetic,
    excitation: &Excitation,
    flight: &Flight,
    mut low: BigFloat,
    mut high: BigFloat,
) -> Search {
    let near = ar.scale(&ar.sub(&high, &low), NEAR);
    let mut tau = high.clone();
    let mut last_step: Option<BigFloat> = None;
    for _ in 0..MOST_STEPS {
        let rotation = flight.rotation(ar, excitation, &tau);
        let step = ar.div(&rotation, &flight.velocity(ar, excitation, &tau));
        let next = ar.sub(&tau, &step);
        if is_shorter(&step, &near) {
            if step.is_zero() || last_step.as_ref().is_some_and(|last| !is_shorter(&step, last)) {
                return Search::Found(tau);
            }
            tau = next;
            last_step = Some(step);
            continue;
        }
        if flight.is_off_base(&rotation) {
            low = tau
        } else {
            high = tau
        }
        let inside = is_before(&low, &next) && is_before(&next, &high);
        tau = if inside { next } else { ar.scale(&ar.add(&low, &high), 0.5) };
    }
    Search::Ended(Ending::Lost(Loss::SolverFailed))
}

fn is_shorter(a: &BigFloat, b: &BigFloat) -> bool {
    a.abs_cmp(b).is_some_and(|order| order < 0)
}

/// Newton steps below this part of the bracket are not held to it any more.
const NEAR: f64 = 1e-6;

/// Newton's method needs about `log2` of the bits; the rest is for bisections.
const MOST_STEPS: usize = 60;

/// A flight that reaches the end: overturned when its growing mode already outweighs everything that could bring it back,
/// `i B e^τ + 1 > |A| e^-τ + a/(ω² + 1)`, else still rocking.
fn outcome(ar: &Arithmetic, excitation: &Excitation, flight: &Flight, end: &End) -> Ending {
    let (growing, falling) = flight.modes(ar, &end.time);
    let outward = double(&growing) * flight.sign;
    let back = double(&falling).abs() + double(excitation.largest_xi());
    if outward > 0.0 && outward + 1.0 > back { Ending::Overturned } else { end.ending }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `i B e^τ + 1 > |A| e^-τ + a/(ω² + 1)`, where `a/(ω² + 1) = 0.2` here, and outwards at all.
    #[test]
    fn overturned_is_what_nothing_can_bring_back() {
        let ar = Arithmetic::new(256).unwrap();
        let case = Case::from_amplitude(1.0 + 1.0 / 16.0, (69.0_f64 / 16.0).sqrt(), 0.9).unwrap();
        let excitation = Excitation::new(&ar, &case);
        for (tau, growing, falling, overturned) in [
            (0.0, 0.5, 1.29, true),
            (0.0, 0.5, 1.31, false),
            (0.0, 0.5, -1.29, true),
            (0.0, 0.5, -1.31, false),
            (0.0, 7.0, 7.79, true),
            (0.0, 7.0, 7.81, false),
            (0.0, -0.1, 0.0, false),
            (0.0, 0.01, 0.0, true),
            // At another time the modes have grown and fallen.
            (2.0, 0.5, 33.0, true),
            (2.0, 0.5, 36.0, false),
        ] {
            for sign in [1.0, -1.0] {
                let flight = Flight { sign, falling: ar.number(falling), growing: ar.number(sign * growing) };
                let end = End { time: ar.number(tau), ending: Ending::Incomplete };
                let expected = if overturned { Ending::Overturned } else { Ending::Incomplete };
                assert_eq!(outcome(&ar, &excitation, &flight, &end), expected, "{tau} {growing} {falling} {sign}");
            }
        }
    }

    /// A search that starts behind the impact has not missed it silently; one that starts before it finds it.
    #[test]
    fn a_search_that_starts_below_the_base_has_fallen_through() {
        let ar = Arithmetic::new(256).unwrap();
        let case = Case::from_amplitude(1.03, 2.0, 0.92).unwrap();
        let excitation = Excitation::new(&ar, &case);
        let end = End::new(&ar, &case, &excitation);
        let zero = ar.number(0.0);
        let flight = Flight::from_impact(&ar, &excitation, -1.0, &zero, &zero);
        // The first impact is at 0.48776.
        for (shortest, found) in [(0.1, true), (0.48, true), (0.49, false), (0.6, false), (1.0, false)] {
            match impact_time(&ar, &excitation, &flight, &zero, shortest, &end) {
                Search::Found(time) => assert!(found && (double(&time) - 0.487_764_79).abs() < 1e-8, "{shortest}"),
                Search::Ended(ending) => assert!(!found && ending == Ending::Lost(Loss::FellThrough), "{shortest}"),
            }
        }
    }
}
