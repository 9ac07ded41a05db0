//! The sequence of flights and impacts (Eq. 13), with the bound on the error that each one inherits and adds.

use contract::{Case, Ending, History, Horizon, Impact, Limit, Loss, Uncertainty};

use crate::{
    UNIT,
    flight::{Landing, Outcome, Takeoff},
    flow::Flow,
    forcing::{Excitation, HalfPhase},
    rest::ProofOfRest,
    twofold::{Split, Twofold},
};

/// Below this speed the next intervals would leave the range of a double; there is nothing left to resolve.
const SLOWEST: f64 = 1e-280;

/// Bounds on the absolute errors of the time and of the speed after an impact.
#[derive(Clone, Copy)]
struct Errors {
    time: f64,
    speed: f64,
}

/// Steps through the impacts of a case that rocks.
pub(crate) fn follow(case: &Case) -> History {
    let excitation = Excitation::new(case.epsilon(), case.omega());
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
    let mut errors = Errors { time: 0.0, speed: 0.0 };
    let mut guesses = [None, None];
    let eta = Split::new(case.eta());
    let proof = ProofOfRest::new(&excitation, case.eta());
    let mut complete = false;
    let ending = loop {
        let [guess, other] = guesses;
        let takeoff = Takeoff {
            excitation: &excitation,
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
        let interval_error;
        (errors, interval_error) = inherit(&takeoff, &landing, errors, case.eta());
        speed = speed.plus(-landing.gain).times(eta);
        sign = -sign;
        forcing = excitation.forcing(sign, half);
        let departure = speed.value();
        if !(landing.interval > 0.0 && departure >= 0.0 && now.is_finite()) {
            break Ending::Lost(Loss::NotFinite);
        }
        impacts.push(Impact {
            time: now,
            interval: landing.interval,
            velocity: sign * departure,
            uncertainty: Uncertainty {
                time: errors.time + UNIT * now,
                interval: interval_error / landing.interval,
                velocity: errors.speed / departure + UNIT,
            },
        });
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

/// The errors after an impact, and that of the interval: what the flight makes of those it started with, through its
/// derivatives (that of the impact time follows from `u = 0`), and what its own rounding adds.
fn inherit(takeoff: &Takeoff, landing: &Landing, errors: Errors, eta: f64) -> (Errors, f64) {
    let (sinh, cosh) = landing.by_speed;
    let (tilt, turn) = landing.by_time;
    let slowness = -1.0 / landing.velocity.min(-f64::MIN_POSITIVE);
    let (interval_by_speed, interval_by_time) = (sinh * slowness, tilt * slowness);
    let (own_rotation, own_gain) = landing.rounding;
    let own = own_rotation * slowness + UNIT * landing.interval;
    // Moving the impact by ds changes the speed by u'' ds; an error of its own place leaves out what the parabola changes without
    // changing the gain.
    let inherited = Errors {
        time: (1.0 + interval_by_time).abs() * errors.time
            + interval_by_speed * errors.speed
            + own
            + UNIT * UNIT * takeoff.time.high,
        speed: eta
            * ((cosh + landing.acceleration * interval_by_speed).abs() * errors.speed
                + (turn + landing.acceleration * interval_by_time).abs() * errors.time
                + landing.off_parabola.abs() * own
                + own_gain
                + 4.0 * UNIT * UNIT * takeoff.speed),
    };
    (inherited, interval_by_time.abs() * errors.time + interval_by_speed * errors.speed + own)
}
