//! One flight of the stepper.

use super::{
    Wrong,
    forcing::{Excitation, Pull},
};
use crate::measure::clock::Sum;

/// How many terms of the Taylor series are summed.
const TERMS: usize = 26;

/// What a flight starts with.
pub(super) struct Flight<'a> {
    pub excitation: &'a Excitation,
    pub wrong: &'a Wrong,
    pub side: f64,
    /// The time at which the forcing is taken.
    pub time: Sum,
    pub speed: f64,
}

/// How it ends.
pub(super) enum Landfall {
    Landing(Landing),
    Aloft,
    Overturned,
    FellThrough,
}

/// The impact.
pub(super) struct Landing {
    pub interval: f64,
    /// The speed that it lands with...
    speed: f64,
    /// ...and, if the flight was short, by how much that is less than the speed of departure, free of cancellation.
    loss: Option<f64>,
}

impl Landing {
    /// The landing speed of a flight that left with `departure`.
    pub(super) fn speed(&self, departure: Sum) -> Sum {
        match self.loss {
            Some(loss) => departure.plus(-loss),
            None => Sum::at(self.speed),
        }
    }
}

impl Flight<'_> {
    /// Follows the flight to the first time at which it comes down through the base, for `horizon` at the longest.
    pub(super) fn land(&self, horizon: f64) -> Landfall {
        let Self { excitation, wrong, side, .. } = *self;
        let reach = 1.0 / excitation.omega.max(1.0);
        let (stiffness, squared) = (1.0 - wrong.stiffness, excitation.omega * excitation.omega);
        let start = self.start();
        let (mut time, mut flown) = (self.time, Sum::default());
        let mut piece = Piece::new(start, stiffness, squared, excitation.pull(side, time).pull);
        let mut above = false;
        loop {
            if let Some(s) = piece.comes_down(reach, &mut above) {
                let late = wrong.late + wrong.slack * (flown.value() + s);
                let landed_at = s + late;
                let exact = flown.high == 0.0 && start == (0.0, self.speed);
                let (_, rate) = piece.at(landed_at);
                let (_, rate_in_time) = piece.at(s);
                return Landfall::Landing(Landing {
                    interval: flown.plus(landed_at).value(),
                    speed: -rate,
                    loss: exact.then(|| piece.loss(s) + (rate - rate_in_time)),
                });
            }
            let (rotation, velocity) = piece.at(reach);
            (time, flown) = (time.plus(reach), flown.plus(reach));
            // u + u' grows from there on whatever the forcing does.
            if rotation + velocity > 1.0 + excitation.amplitude || (wrong.brittle && rotation > 1.0) {
                return Landfall::Overturned;
            }
            if flown.value() > horizon {
                return if above { Landfall::Aloft } else { Landfall::FellThrough };
            }
            if !(rotation.is_finite() && velocity.is_finite()) || rotation < -1e3 {
                return Landfall::FellThrough;
            }
            piece = Piece::new((rotation, velocity), stiffness, squared, excitation.pull(side, time).pull);
        }
    }

    /// `u` and `u'` at the start: `0` and the speed, and what the faults in Eq. 10 add.
    fn start(&self) -> (f64, f64) {
        let Wrong { a, b, lift, .. } = self.wrong;
        let Pull { forcing: (f, rate), .. } = self.excitation.pull(self.side, self.time);
        let scale = 1.0 / (self.excitation.omega * self.excitation.omega + 1.0);
        let of_a = 0.5 * (a.forcing * f * scale - a.rate * rate * scale + a.side * self.side);
        let of_b = 0.5 * (b.forcing * f * scale + b.rate * rate * scale + b.side * self.side);
        (self.side * (of_a + of_b) + lift, self.speed + self.side * (of_b - of_a))
    }
}

/// The Taylor series of a stretch of a flight, deflated by the power of `s` that it starts with.
struct Piece {
    coefficients: [f64; TERMS],
    order: usize,
}

impl Piece {
    fn new((rotation, velocity): (f64, f64), stiffness: f64, squared: f64, [pull, rate, bend]: [f64; 3]) -> Self {
        let (mut now, mut next) = (rotation, velocity);
        let mut pull = [pull, rate, bend];
        let mut factorial = 1.0;
        let coefficients = std::array::from_fn(|k| {
            let coefficient = now / factorial;
            factorial *= (k + 1) as f64;
            let [this, rate, bend] = pull;
            (now, next) = (next, stiffness * now + this);
            // The forcing is a sinusoid about -1: each derivative from the third on is -ω² times the last but one.
            pull = [rate, bend, -squared * rate];
            coefficient
        });
        let order = coefficients.iter().position(|&c: &f64| c != 0.0).unwrap_or(0);
        Self { coefficients, order }
    }

    /// `u/s^order` and its derivative.
    fn deflated(&self, s: f64) -> (f64, f64) {
        let terms = self.coefficients.iter().skip(self.order).rev();
        terms.fold((0.0, 0.0), |(value, slope), c| (value * s + c, slope * s + value))
    }

    /// `u` and `u'`.
    fn at(&self, s: f64) -> (f64, f64) {
        self.coefficients.iter().rev().fold((0.0, 0.0), |(value, slope), c| (value * s + c, slope * s + value))
    }

    /// `u' + v` at the impact, where `u = 0`: what is left of `u' - 2u/s`.
    fn loss(&self, s: f64) -> f64 {
        let terms = self.coefficients.iter().enumerate().skip(3).rev();
        terms.fold(0.0, |sum, (k, c)| sum * s + (k - 2) as f64 * c) * s * s
    }

    /// Where `u` first comes down through zero, up to `reach`; `above` is whether it has been above, before and after.
    fn comes_down(&self, reach: f64, above: &mut bool) -> Option<f64> {
        let mut low = 0.0;
        let mut s = self.clear().min(reach);
        loop {
            let (value, _) = self.deflated(s);
            if *above && value <= 0.0 {
                return Some(self.root(low, s));
            }
            *above = value > 0.0;
            // Numbers that a fault has made zero, or no numbers, get nowhere.
            if s >= reach || s <= 0.0 || s.is_nan() {
                return None;
            }
            low = s;
            s = (1.15 * s).min(s + 0.05 * reach).min(reach);
        }
    }

    /// No root comes before this: the terms after the first add up to less than it.
    fn clear(&self) -> f64 {
        let mut rest = self.coefficients.iter().skip(self.order);
        let first = rest.next().copied().unwrap_or(0.0);
        let nearest = rest.zip(1..).map(|(c, power)| (first / c).abs().powf(1.0 / f64::from(power)));
        0.5 * nearest.fold(f64::INFINITY, f64::min)
    }

    /// The root between `low`, where `u` is above zero, and `high`, where it is not: Newton's method, bisection where that leaves the bracket.
    fn root(&self, mut low: f64, mut high: f64) -> f64 {
        let mut s = high;
        for _ in 0..200 {
            let (value, slope) = self.deflated(s);
            if value > 0.0 {
                low = s
            } else {
                high = s
            }
            let newton = s - value / slope;
            let next = if newton >= low && newton <= high { newton } else { 0.5 * (low + high) };
            if (next - s).abs() <= 0.5 * f64::EPSILON * s {
                return next;
            }
            s = next;
        }
        s
    }
}
