//! Closing a sequence from one impact: the sum of the series, what it may be wrong by, and when it must not be trusted.

use contract::{Body, Closure, Decline, Departure, Estimate, Ground, Motion};

use crate::{
    bounds,
    equation::{Equation, POWERS},
    flight::Flight,
    ground::Piece,
    heights::Scaled,
    pair::Pair,
    series::coefficients,
};

/// How many terms are computed beside those that are summed: what they are is what the sum may be wrong by.
const MORE: usize = 2;
/// The highest order.
pub const MOST_ORDER: usize = 16;
/// Each term has to be less than this share of the one before it.
const FALLS: f64 = 0.1;
/// What multiples of them are claimed: those that follow are less than a tenth of the second, or a hundredth of the first, and so on.
const WEIGHTS: [f64; MORE] = [1.03, 1.5];
/// What rounding leaves in the sum, relative to all of its terms, times `1/(1 - η²)` at the most, in multiples of what it leaves in the pull.
const ROUNDING: f64 = 8.0;

/// The series of a block under a motion of the ground.
#[derive(Debug, Clone)]
pub struct Series {
    motion: Motion,
    eta: f64,
    alpha: Option<f64>,
    equation: Equation,
    order: usize,
}

/// The terms `r_n v^n` of the time that is left after one impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Terms {
    terms: [f64; MOST_ORDER + MORE],
    len: usize,
}

impl Terms {
    /// From the first on: as many as the order of the series, and two more.
    pub fn as_slice(&self) -> &[f64] {
        self.terms.get(..self.len).unwrap_or_default()
    }

    /// The number of the first term that is not less than a tenth of the one before it, nor a hundredth of the one before that (on ground that does not move every
    /// second one is 0), and its share of the one before it.
    pub fn first_that_does_not_fall(&self) -> Option<(usize, f64)> {
        let terms = self.as_slice();
        let size = |place: Option<usize>| place.and_then(|place| terms.get(place)).map_or(0.0, |term| term.abs());
        (1..terms.len()).find_map(|place| {
            let (term, one, two) = (size(Some(place)), size(place.checked_sub(1)), size(place.checked_sub(2)));
            let falls = term < FALLS * one || term < FALLS * FALLS * two || term == 0.0 && one.is_finite();
            (!falls).then_some((place + 1, term / one))
        })
    }
}

impl Series {
    pub(crate) fn new(body: &Body, motion: &Motion, order: usize) -> Self {
        let alpha = body.alpha();
        let equation = alpha.map_or_else(Equation::linear, Equation::nonlinear);
        Self { motion: motion.clone(), eta: body.eta(), alpha, equation, order }
    }

    /// The terms of the series after an impact, whether they fall or not.
    ///
    /// # Errors
    /// Where the block does not leave its base, or the ground does not hold it down.
    pub fn terms(&self, departure: &Departure) -> Result<Terms, Decline> {
        let piece = self.piece(departure)?;
        Ok(self.terms_on(&piece, departure))
    }

    fn piece(&self, departure: &Departure) -> Result<Piece, Decline> {
        let Departure { ground, time, rotation, velocity, .. } = *departure;
        if rotation != 0.0 {
            return Err(Decline::Unsupported { what: "flights that do not begin at the base" });
        }
        if !(velocity > 0.0 && velocity.is_finite()) {
            return Err(Decline::OutOfRange {
                field: "velocity",
                value: velocity,
                allowed: "above 0: after an impact",
            });
        }
        if !time.is_finite() {
            return Err(Decline::OutOfRange { field: "time", value: time, allowed: "a number" });
        }
        let piece = match ground {
            Ground::Shaking => Piece::at(&self.motion, time),
            Ground::Still => Piece::STILL,
        };
        if !piece.pulls.iter().all(|pull| *pull > 0.0) {
            let allowed = "-1 to 1: beyond the threshold nothing accumulates";
            return Err(Decline::OutOfRange { field: "ground acceleration", value: piece.value, allowed });
        }
        Ok(piece)
    }

    fn terms_on(&self, piece: &Piece, departure: &Departure) -> Terms {
        // Two sizes, so that the usual order does not carry the room of the highest.
        const SMALL: usize = 8;
        if self.order <= SMALL {
            self.terms_in::<{ SMALL + MORE + 2 }>(piece, departure)
        } else {
            self.terms_in::<{ MOST_ORDER + MORE + 2 }>(piece, departure)
        }
    }

    fn terms_in<const M: usize>(&self, piece: &Piece, departure: &Departure) -> Terms {
        let (v, len) = (departure.velocity, self.order + MORE);
        let weakest = piece.pulls.iter().copied().fold(f64::INFINITY, f64::min);
        // In this unit of time the pull on the weaker side is 1.
        let unit = v / (weakest * self.equation.at_the_base());
        let scaled = scaled::<M>(piece, &self.equation, v, unit);
        let found = coefficients(&Flight::new(&scaled, len), self.eta, len);
        let place = place(departure);
        let mut terms = [0.0; MOST_ORDER + MORE];
        for (term, Pair(coefficient)) in terms.iter_mut().zip(found.iter().skip(1)) {
            *term = unit * coefficient.get(place).copied().unwrap_or(f64::NAN);
        }
        Terms { terms, len }
    }

    fn between(&self, piece: &Piece, departure: &Departure) -> Result<(f64, f64), Decline> {
        let Departure { time, velocity, .. } = *departure;
        let proven = bounds::time_left(piece, place(departure), velocity, self.eta, self.alpha);
        let (least, most) = proven.ok_or_else(|| {
            let [own, other] = piece.pulls;
            let why = format!(
                "at tau = {time} it is not proven that the block comes to rest: it leaves its base with {velocity:?}, and is pulled back to it with {:?} on the weaker side",
                own.min(other)
            );
            Decline::NotConvergent { why }
        })?;
        if time + most < piece.end { Ok((least, most)) } else { Err(changes(time + most, piece.end)) }
    }
}

impl Closure for Series {
    fn time_left(&self, departure: &Departure) -> Result<Estimate, Decline> {
        let piece = self.piece(departure)?;
        let Departure { time, velocity, .. } = *departure;
        let eta = self.eta;
        // The first term: where it alone is far too long, the others are not asked.
        let [one, two] = piece.pulls;
        let (own, other) = if place(departure) == 0 { (one, two) } else { (two, one) };
        let first = 2.0 * velocity * (1.0 / own + eta / other) / ((1.0 - eta * eta) * self.equation.at_the_base());
        if time + 0.5 * first >= piece.end {
            return Err(changes(time + first, piece.end));
        }
        let terms = self.terms_on(&piece, departure);
        if let Some((n, ratio)) = terms.first_that_does_not_fall() {
            let why = format!(
                "the terms of the series do not fall at tau = {time}: term {n} is {ratio:.2} of the one before it; more impacts have to be followed"
            );
            return Err(Decline::NotConvergent { why });
        }
        self.between(&piece, departure)?;
        let (summed, next) = terms.as_slice().split_at_checked(self.order).unwrap_or_default();
        let rounding = ROUNDING * piece.unsure / (1.0 - eta * eta) * summed.iter().map(|term| term.abs()).sum::<f64>();
        let left: f64 = next.iter().zip(WEIGHTS).map(|(term, weight)| weight * term.abs()).sum();
        // From the smallest on.
        Ok(Estimate { value: summed.iter().rev().sum(), uncertainty: left + rounding })
    }

    fn bounds(&self, departure: &Departure) -> Result<(f64, f64), Decline> {
        self.between(&self.piece(departure)?, departure)
    }
}

/// The place of the side of a departure.
fn place(departure: &Departure) -> usize {
    usize::from(departure.side < 0.0)
}

fn changes(rest: f64, end: f64) -> Decline {
    let why = format!(
        "the block may be rocking until tau = {rest}, and the motion of the ground changes at {end}: the series ends there"
    );
    Decline::NotConvergent { why }
}

/// In units of the speed `v` and the time `unit`.
fn scaled<const M: usize>(piece: &Piece, equation: &Equation, v: f64, unit: f64) -> Scaled<M> {
    let mut pull = [Pair(piece.pulls); M];
    let mut power = 1.0;
    for (slot, coefficient) in pull.iter_mut().skip(1).zip(piece.powers.iter().chain(std::iter::repeat(&0.0))) {
        power *= unit;
        *slot = Pair([coefficient * power, -coefficient * power]);
    }
    let mut scale = unit / v;
    let mut scaled = Equation { free: [0.0; POWERS], pulled: [0.0; POWERS] };
    let from = equation.free.iter().zip(&equation.pulled);
    for ((free, pulled), (of_free, of_pulled)) in scaled.free.iter_mut().zip(&mut scaled.pulled).zip(from) {
        (*free, *pulled) = (of_free * scale, of_pulled * scale);
        scale *= v * unit;
    }
    Scaled { pull, equation: scaled }
}
