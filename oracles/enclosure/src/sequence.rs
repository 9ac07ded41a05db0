//! The sequence of flights and impacts (Eq. 13), to the proof of how it ends.

use contract::{Case, Horizon, Normalisation, Slenderness};

use crate::{
    directed::Directed,
    excitation::Excitation,
    functions::{pi, sin_cos},
    gap,
    interval::Interval,
    known::Known,
    piece::Motion,
    pull::Side,
    rest,
    scene::{Flown, Scene},
};

/// An impact.
pub struct Impact<F> {
    pub time: Interval<F>,
    pub interval: Interval<F>,
    /// The speed just after the impact.
    pub speed: Interval<F>,
    /// The sign of the flight that follows.
    pub side: Side,
}

/// The impacts that were asked for, and what is proven of the ending.
pub struct Sequence<F> {
    pub impacts: Vec<Impact<F>>,
    pub end: End<F>,
    /// Whether it was not followed any further because it was long, rather than because all was clear.
    pub exhausted: bool,
}

/// How the sequence ends.
pub enum End<F> {
    /// It never starts.
    NeverRocks,
    /// Infinitely many impacts follow, up to the chattering time.
    Complete(Interval<F>),
    /// The block is in the air at half a period, or is proven to be going to be.
    HalfPeriod,
    /// The block is in the air at the horizon of the case.
    Horizon,
    /// No return is possible.
    Overturned,
    /// The impacts asked for are listed, and more were followed in vain.
    Impacts,
    /// Not with these digits.
    Unclear,
}

/// What is asked of a sequence.
#[derive(Clone, Copy)]
pub struct Wanted {
    /// How many impacts are listed at the most.
    pub impacts: usize,
    /// How many are followed at the most.
    pub followed: usize,
    /// How wide the chattering time may be, relative to itself.
    pub width: f64,
}

/// Speeds below this one are not resolved: doubles bound what is left out, and that is smaller by as much as there are bits.
pub fn slowest<F: Directed>() -> f64 {
    (2.0_f64).powi(F::BITS as i32 - 960).max(1e-250)
}

/// `a - 1` in multiples of the threshold of Eq. 1. Under the slender normalisation the amplitude is `a α/tan α` thresholds.
pub fn excess<F: Directed>(case: &Case) -> Interval<F> {
    let epsilon = Interval::exactly(case.epsilon());
    let Some(slenderness) = case.slenderness().filter(|s| s.normalisation() == Normalisation::Slender) else {
        return epsilon;
    };
    let alpha = Interval::exactly(slenderness.alpha());
    let (sine, cosine) = sin_cos(&alpha);
    let one = Interval::exactly(1.0);
    &(&(&(&epsilon + &one) * &(&alpha * &cosine)) / &sine) - &one
}

/// A sequence that was followed as far as it is clear.
fn clear<F>(impacts: Vec<Impact<F>>, end: End<F>) -> Sequence<F> {
    Sequence { impacts, end, exhausted: false }
}

/// A sequence that was followed no further.
fn exhausted<F>(impacts: Vec<Impact<F>>, complete: Option<Interval<F>>, wanted: Wanted) -> Sequence<F> {
    let end = match complete {
        _ if impacts.len() < wanted.impacts => End::Unclear,
        Some(time) => End::Complete(time),
        None => End::Impacts,
    };
    Sequence { impacts, end, exhausted: true }
}

/// Follows the impacts of a case: on the nonlinear equation with a slenderness, else on the linear one.
pub fn follow<F: Directed>(case: &Case, slenderness: Option<Slenderness>, wanted: Wanted) -> Sequence<F> {
    let epsilon: Interval<F> = if slenderness.is_some() { excess(case) } else { Interval::exactly(case.epsilon()) };
    let mut impacts = Vec::new();
    if epsilon.upper <= F::exactly(0.0) {
        return clear(impacts, End::NeverRocks);
    }
    if !epsilon.is_positive() {
        return clear(impacts, End::Unclear);
    }
    let excitation = Excitation::new(&epsilon, case.omega());
    let motion = Motion::new(&excitation.amplitude, case.omega(), slenderness.map(|s| s.alpha()));
    let (horizon, beyond) = match case.horizon() {
        Horizon::HalfPeriod => (&pi() / &excitation.omega, End::HalfPeriod),
        Horizon::Until(time) => (Interval::exactly(time), End::Horizon),
    };

    let scene = Scene::new(&motion, &excitation, (case.omega(), case.eta()));
    let mut known = Known::initiation();
    let mut time = Interval::zero();
    let mut side = Side::Minus;
    let mut complete: Option<Interval<F>> = None;
    let mut followed = 0;
    loop {
        followed += 1;
        let (interval, landed) = match known.fly(&scene, side, &(&horizon - &time)) {
            Flown::Landed(interval, landed) => (interval, landed),
            Flown::Aloft => return clear(impacts, beyond),
            Flown::Overturned => return clear(impacts, End::Overturned),
            Flown::Unclear if motion.exhausted() => return exhausted(impacts, complete, wanted),
            Flown::Unclear => return clear(impacts, End::Unclear),
        };
        known = landed;
        time = known.time();
        if horizon.is_below(&time) {
            return clear(impacts, beyond);
        }
        if !time.is_below(&horizon) {
            return clear(impacts, End::Unclear);
        }
        side = side.other();
        let (phase, speed) = (known.phase(&scene), known.speed());
        if impacts.len() < wanted.impacts {
            impacts.push(Impact { time: time.clone(), interval, speed: speed.clone(), side });
        }
        if let Some(left) = rest::time_left(&motion, &excitation, &phase, side, &speed, case.eta()) {
            let closed = &time + &left;
            // Whatever was known of the chattering time before is still true.
            complete = Some(complete.map_or_else(|| closed.clone(), |before| before.and(&closed)));
            let listed = impacts.len() >= wanted.impacts || speed.upper.double_above() < slowest::<F>();
            let enough = left.width() <= wanted.width * time.middle() || left.width() <= time.width();
            if let (true, true, Some(complete)) = (listed, enough, &complete) {
                return clear(impacts, End::Complete(complete.clone()));
            }
        }
        let in_half_period = slenderness.is_none() && case.horizon() == Horizon::HalfPeriod;
        let listed = impacts.len() >= wanted.impacts;
        if in_half_period && listed && gap::is_missed(&excitation, &(&horizon - &time), side, &speed, case.eta()) {
            return clear(impacts, beyond);
        }
        if followed >= wanted.followed.max(wanted.impacts) {
            return exhausted(impacts, complete, wanted);
        }
    }
}
