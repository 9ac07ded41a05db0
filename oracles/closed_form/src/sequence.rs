//! The sequence of flights and impacts (Eq. 13), with the error that each one inherits and adds.

use contract::{Case, Ending, History, Horizon, Impact, Limit, Loss, Uncertainty};

use crate::{
    UNIT,
    error::Errors,
    flow::Flow,
    forcing::{Excitation, HalfPhase},
    rest::ProofOfRest,
    takeoff::{Outcome, Takeoff},
    twofold::{Split, Twofold},
};

/// Below this speed the next intervals would leave the range of a double; there is nothing left to resolve.
pub(crate) const SLOWEST: f64 = 1e-280;

/// What is shown every flight that ends in an impact of the list.
pub(crate) trait Follower {
    /// Follows one more flight, from its takeoff to its landing.
    fn land(&mut self, takeoff: &Takeoff, interval: f64);
}

/// Steps through the impacts of a case that rocks, and shows them to a `follower`.
pub(crate) fn follow(case: &Case, excitation: &Excitation, mut follower: Option<&mut dyn Follower>) -> History {
    let flow = Flow::new(case.omega());
    let half_period = core::f64::consts::PI / case.omega();
    let (horizon, beyond) = match case.horizon() {
        Horizon::HalfPeriod => (half_period, Ending::Incomplete),
        Horizon::Until(time) => (time, Ending::LimitReached(Limit::Time)),
    };

    let mut impacts = Vec::with_capacity(case.max_impacts().min(1024));
    let mut time = Twofold::ZERO;
    let mut speed = Twofold::ZERO;
    let mut sign = -1.0;
    let mut forcing = excitation.forcing(sign, HalfPhase { sin: 0.0, cos: 1.0 });
    let mut errors = Errors::NONE;
    let mut guesses = [None, None];
    let eta = Split::new(case.eta());
    let proof = ProofOfRest::new(excitation, case.eta());
    let mut complete = false;
    let ending = loop {
        let [guess, other] = guesses;
        let takeoff = Takeoff {
            excitation,
            flow: &flow,
            time,
            sign,
            speed: speed.value(),
            forcing,
            guess,
            horizon: horizon - time.value(),
        };
        let landing = match takeoff.fly() {
            Outcome::Landing(landing) => landing,
            Outcome::Aloft => break beyond,
            Outcome::Overturned => break Ending::Overturned,
            Outcome::Stuck => break Ending::Lost(Loss::SolverFailed),
        };
        time = time.plus(landing.interval);
        let half = excitation.half_phase(time);
        // At T/2 half the phase is π/2: its cosine tells on which side of it an impact lies that the time alone can't tell from it.
        let now = time.value();
        let past = case.horizon() == Horizon::HalfPeriod && half.cos <= 0.0;
        if past || now >= horizon {
            break beyond;
        }
        let interval_variance;
        (errors, interval_variance) = errors.after(&takeoff, &landing);
        speed = speed.plus(-landing.loss).times(eta);
        sign = -sign;
        forcing = excitation.forcing(sign, half);
        let departure = speed.value();
        if !(landing.interval > 0.0 && departure >= 0.0 && now.is_finite()) {
            break Ending::Lost(Loss::NotFinite);
        }
        let [time_error, interval_error, speed_error] = errors.claims(interval_variance);
        impacts.push(Impact {
            time: now,
            interval: landing.interval,
            velocity: sign * departure,
            uncertainty: Uncertainty {
                time: time_error + UNIT * now,
                interval: interval_error,
                velocity: speed_error + UNIT,
            },
        });
        if let Some(follower) = follower.as_deref_mut() {
            follower.land(&takeoff, landing.interval);
        }
        guesses = [other, Some(landing.interval)];
        complete = complete || proof.holds(&forcing, departure);
        if departure < SLOWEST {
            break if complete { Ending::AtRest } else { Ending::Lost(Loss::NotFinite) };
        }
        if impacts.len() >= case.max_impacts() {
            break if complete { Ending::AtRest } else { Ending::LimitReached(Limit::Impacts) };
        }
    };
    History { impacts, ending, chattering_time: None }
}
