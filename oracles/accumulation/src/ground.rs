//! The motion of the ground about one moment: the pull towards the base on both sides, its derivatives, and where they end.

use contract::{Motion, RICKER_ANTISYMMETRIC_PEAK, Record, Ricker, Sinusoid, Stretch};

use crate::extended::Extended;

/// How many derivatives are known at the most.
pub const MOST: usize = 20;

/// A stretch of time in which the motion is one power series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// `f` now.
    pub value: f64,
    /// `1 + f` and `1 - f` now, formed before anything is rounded: next to a threshold one of them is small.
    pub pulls: [f64; 2],
    /// The coefficients of `s, s², ...` of `f` a time `s` later.
    pub powers: [f64; MOST],
    /// When it ends, `τ`.
    pub end: f64,
    /// A bound on `|f''|`.
    pub curvature: f64,
    /// A bound on the terms that `f'` is the sum of: what its rounding is relative to.
    pub steepness: f64,
    /// By how much the weaker pull may be wrong, relative.
    pub unsure: f64,
}

impl Piece {
    /// Of ground at rest.
    pub const STILL: Self = Self {
        value: 0.0,
        pulls: [1.0; 2],
        powers: [0.0; MOST],
        end: f64::INFINITY,
        curvature: 0.0,
        steepness: 0.0,
        unsure: f64::EPSILON,
    };

    /// From `f`, a sum of terms of this `size`.
    fn new(value: Extended, size: f64, end: f64) -> Self {
        // Of the digits of two doubles.
        const ROUNDING: f64 = 1e-29;
        let one = Extended::new(1.0);
        let pulls = [(one + value).rounded(), (one - value).rounded()];
        let [one, other] = pulls;
        let unsure = f64::EPSILON + ROUNDING * (1.0 + size) / one.min(other).max(0.0);
        Self { value: value.rounded(), pulls, end, unsure, ..Self::STILL }
    }

    /// The one that `time` is in; after the motion the ground is at rest.
    pub fn at(motion: &Motion, time: f64) -> Self {
        let piece = match motion {
            Motion::Sinusoids(stretches) => {
                stretches.iter().find(|stretch| stretch.until > time).map(|stretch| of_sinusoids(stretch, time))
            }
            Motion::Ricker(ricker) => (time < 2.0 * ricker.center).then(|| of_wavelet(ricker, time)),
            Motion::Record(record) => of_record(record, time),
        };
        piece.unwrap_or(Self::STILL)
    }

    /// `f'`.
    pub fn slope(&self) -> f64 {
        let [slope, ..] = self.powers;
        slope
    }
}

fn of_sinusoids(Stretch { until, terms }: &Stretch, time: f64) -> Piece {
    let mut value = Extended::new(0.0);
    let (mut powers, mut curvature, mut steepness, mut size) = ([0.0; MOST], 0.0, 0.0, 0.0);
    for &Sinusoid { amplitude, omega, phase } in terms {
        let angle = Extended::new(omega) * Extended::new(time) + Extended::new(phase);
        let (sin, cos) = angle.sin_cos();
        value = value + Extended::new(amplitude) * sin;
        let (mut this, mut next) = (amplitude * cos, -amplitude * sin.rounded());
        let mut power = omega;
        for (slot, k) in powers.iter_mut().zip(2_u32..) {
            *slot += power * this;
            power *= omega / f64::from(k);
            (this, next) = (next, -this);
        }
        size += amplitude.abs();
        steepness += (amplitude * omega).abs();
        curvature += (amplitude * omega * omega).abs();
    }
    Piece { powers, curvature, steepness, ..Piece::new(value, size, *until) }
}

/// Both wavelets are derivatives of a bell, `E(y) = exp(-y²/2)`: `-E'' = (1 - y²) E`, and `-E''' = (y³ - 3y) E`.
fn of_wavelet(&Ricker { amplitude, omega, center, antisymmetric }: &Ricker, time: f64) -> Piece {
    let one = Extended::new(1.0);
    let (rate, derivative, peak) = if antisymmetric {
        (Extended::new(omega) / Extended::root(3.0), 3, RICKER_ANTISYMMETRIC_PEAK)
    } else {
        (Extended::new(omega) / Extended::root(2.0), 2, 1.0)
    };
    let y = (Extended::new(time) - Extended::new(center)) * rate;
    let square = y * y;
    let bell = (square * Extended::new(0.5)).exp_of_minus();
    let shape = if antisymmetric { y * (square - Extended::new(3.0)) } else { one - square };
    let amplitude = Extended::new(amplitude) / Extended::new(peak);
    // The coefficients of the bell about y, times k!: E' = -y E, so E^(k+1) = -(y E^(k) + k E^(k-1)).
    let (y, rate, size) = (y.rounded(), rate.rounded(), amplitude.rounded());
    let (mut this, mut before) = (bell.rounded(), 0.0);
    let mut k = 0;
    let mut differentiate = || {
        (this, before) = (-(y * this + f64::from(k) * before), this);
        k += 1;
        this
    };
    for _ in 0..derivative {
        differentiate();
    }
    let mut powers = [0.0; MOST];
    let mut power = -size;
    for (slot, k) in powers.iter_mut().zip(1_u32..) {
        power *= rate / f64::from(k);
        *slot = power * differentiate();
    }
    // The largest of |E'''|, |E''''| and |E'''''|: 1.3801.., 3 and 5.78..
    let (steepest, most) = if antisymmetric { (3.0, 5.8) } else { (1.381, 3.0) };
    Piece {
        powers,
        curvature: most * size.abs() * rate * rate,
        steepness: steepest * size.abs() * rate,
        ..Piece::new(amplitude * shape * bell, 10.0 * size.abs(), 2.0 * center)
    }
}

fn of_record(Record { dt, scale, samples }: &Record, time: f64) -> Option<Piece> {
    let start = |k: usize| k as f64 * dt;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    // A time before the record is in its first piece.
    let mut k = (time / dt) as usize;
    while k > 0 && start(k) > time {
        k -= 1;
    }
    while start(k + 1) <= time {
        k += 1;
    }
    let [step, scale] = [*dt, *scale].map(Extended::new);
    let [from, to] = [Extended::new(*samples.get(k)?) * scale, Extended::new(*samples.get(k + 1)?) * scale];
    let slope = (to - from) / step;
    let since = Extended::new(time) - step * Extended::new(k as f64);
    let size = from.rounded().abs() + to.rounded().abs();
    let mut piece = Piece::new(from + slope * since, size, start(k + 1));
    if let Some(first) = piece.powers.first_mut() {
        *first = slope.rounded();
    }
    Some(Piece { steepness: slope.rounded().abs(), ..piece })
}
