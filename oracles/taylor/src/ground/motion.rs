//! The acceleration of the ground as a power series in the time since a moment, and where that series ends.

use contract::{Motion, RICKER_ANTISYMMETRIC_PEAK, Record, Ricker, Sinusoid, Stretch};

use crate::series::ORDER;

/// Coefficients of a power series.
pub type Powers = [f64; ORDER + 1];

/// A piece of a motion that is one power series.
#[derive(Debug, Clone, Copy)]
pub struct Piece {
    /// `f` by powers of the time since the moment.
    pub powers: Powers,
    /// Until when, `τ`.
    pub end: f64,
    /// How fast it changes: its largest frequency, or that of a pulse; 0 for a straight line.
    pub rate: f64,
    /// A bound on `|f''|`.
    pub curvature: f64,
}

/// The piece that begins at `time`.
pub fn piece(motion: &Motion, time: f64) -> Piece {
    let still = Piece { powers: [0.0; ORDER + 1], end: f64::INFINITY, rate: 0.0, curvature: 0.0 };
    match motion {
        Motion::Sinusoids(stretches) => match stretches.iter().find(|stretch| stretch.until > time) {
            Some(stretch) => of_sinusoids(stretch, time),
            None => still,
        },
        Motion::Ricker(ricker) if time < 2.0 * ricker.center => of_ricker(ricker, time),
        Motion::Ricker(_) => still,
        Motion::Record(record) => of_record(record, time).unwrap_or(still),
    }
}

fn of_sinusoids(Stretch { until, terms }: &Stretch, time: f64) -> Piece {
    let mut piece = Piece { powers: [0.0; ORDER + 1], end: *until, rate: 0.0, curvature: 0.0 };
    for Sinusoid { amplitude, omega, phase } in terms {
        // What rounding takes from the angle is put back.
        let turned = omega * time;
        let angle = turned + phase;
        let back = angle - turned;
        let lost = (turned - (angle - back)) + (phase - back) + omega.mul_add(time, -turned);
        let (sin, cos) = angle.sin_cos();
        let (mut this, mut next) = (amplitude * (sin + lost * cos), amplitude * (cos - lost * sin));
        let mut power = 1.0;
        for (k, slot) in (1_u32..).zip(&mut piece.powers) {
            *slot += this * power;
            power *= omega / f64::from(k);
            (this, next) = (next, -this);
        }
        piece.rate = piece.rate.max(*omega);
        piece.curvature += (amplitude * omega * omega).abs();
    }
    piece
}

fn of_ricker(ricker: &Ricker, time: f64) -> Piece {
    let Ricker { amplitude, omega, center, antisymmetric } = *ricker;
    let (width, peak, third) = if antisymmetric {
        (3.0_f64.sqrt() / omega, RICKER_ANTISYMMETRIC_PEAK, 6.0)
    } else {
        (std::f64::consts::SQRT_2 / omega, 1.0, 3.0)
    };
    let y = (time - center) / width;
    // E = exp(-y²/2), E' = -y E, by powers of the change of y; times the polynomial about y.
    let polynomial = if antisymmetric {
        [y * (y * y - 3.0), 3.0 * y * y - 3.0, 3.0 * y, 1.0]
    } else {
        [1.0 - y * y, -2.0 * y, -1.0, 0.0]
    };
    let mut powers = [0.0; ORDER + 1];
    let (mut gauss, mut k) = ([(-0.5 * y * y).exp(), 0.0, 0.0, 0.0], 0.0);
    let mut scale = amplitude / peak;
    for slot in &mut powers {
        let product: f64 = polynomial.iter().zip(&gauss).map(|(one, other)| one * other).sum();
        *slot = scale * product;
        scale /= width;
        let next = -(y * gauss[0] + gauss[1]) / (k + 1.0);
        gauss = [next, gauss[0], gauss[1], gauss[2]];
        k += 1.0;
    }
    let curvature = amplitude.abs() / peak * third / (width * width);
    Piece { powers, end: 2.0 * center, rate: 2.0 / width, curvature }
}

fn of_record(record: &Record, time: f64) -> Option<Piece> {
    let Record { dt, scale, samples } = record;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let mut k = (time / dt) as usize;
    while k > 0 && k as f64 * dt > time {
        k -= 1;
    }
    while (k + 1) as f64 * dt <= time {
        k += 1;
    }
    let (from, to) = (samples.get(k)? * scale, samples.get(k + 1)? * scale);
    let slope = (to - from) / dt;
    let mut powers = [0.0; ORDER + 1];
    let [value, first, ..] = &mut powers;
    (*value, *first) = (from + slope * (time - k as f64 * dt), slope);
    Some(Piece { powers, end: (k + 1) as f64 * dt, rate: 0.0, curvature: 0.0 })
}

/// A bound on `|f|` from any time on.
pub fn strongest(motion: &Motion) -> f64 {
    match motion {
        Motion::Sinusoids(stretches) => {
            let size = |stretch: &Stretch| stretch.terms.iter().map(|term| term.amplitude.abs()).sum();
            stretches.iter().map(size).fold(0.0, f64::max)
        }
        Motion::Ricker(ricker) => ricker.amplitude.abs(),
        Motion::Record(Record { scale, samples, .. }) => {
            samples.iter().fold(0.0, |most: f64, sample| most.max((sample * scale).abs()))
        }
    }
}
