//! The motion of the ground: its pieces, and each by value, slope and Taylor coefficients.

use std::f64::consts::SQRT_2;

use contract::{Motion, RICKER_ANTISYMMETRIC_PEAK, Ricker, Sinusoid};

/// A stretch of time in which the motion is one smooth function.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece<'a> {
    pub from: f64,
    pub to: f64,
    shape: Shape<'a>,
    /// A bound on `|f''|`.
    pub curvature: f64,
    /// What rounding may add to `f`.
    pub unsure: f64,
}

#[derive(Debug, Clone, Copy)]
enum Shape<'a> {
    Sum(&'a [Sinusoid]),
    Wavelet(&'a Ricker),
    /// `(time, value, slope)`.
    Line(f64, f64, f64),
}

/// The pieces in order, from `from` on; nothing after them.
pub(super) fn pieces(motion: &Motion, from: f64) -> Box<dyn Iterator<Item = Piece<'_>> + '_> {
    match motion {
        Motion::Sinusoids(stretches) => {
            let begins = std::iter::once(0.0).chain(stretches.iter().map(|stretch| stretch.until));
            let pieces = begins.zip(stretches).map(|(begin, stretch)| {
                let bound = |of: fn(&Sinusoid) -> f64| stretch.terms.iter().map(|term| of(term).abs()).sum::<f64>();
                let (size, curvature) =
                    (bound(|term| term.amplitude), bound(|term| term.amplitude * term.omega.powi(2)));
                let unsure = 4.0 * f64::EPSILON * (1.0 + size);
                Piece { from: begin, to: stretch.until, shape: Shape::Sum(&stretch.terms), curvature, unsure }
            });
            Box::new(pieces.skip_while(move |piece| piece.to <= from))
        }
        Motion::Ricker(ricker) => {
            // The largest of |E''''| and |E'''''| of the bell E(y) = exp(-y²/2): 3 and 5.78..
            let (most, rate, peak) = if ricker.antisymmetric {
                (5.8, ricker.omega / 3_f64.sqrt(), RICKER_ANTISYMMETRIC_PEAK)
            } else {
                (3.0, ricker.omega / SQRT_2, 1.0)
            };
            let size = ricker.amplitude.abs() / peak;
            let (to, curvature, unsure) =
                (2.0 * ricker.center, most * size * rate * rate, 16.0 * f64::EPSILON * (1.0 + size));
            let piece = Piece { from: 0.0, to, shape: Shape::Wavelet(ricker), curvature, unsure };
            Box::new(std::iter::once(piece).filter(move |piece| piece.to > from))
        }
        Motion::Record(record) => {
            let starts = move |k: usize| k as f64 * record.dt;
            // One earlier than the quotient says, which may be rounded up.
            let first = ((from / record.dt) as usize).saturating_sub(1);
            let pieces = record.samples.windows(2).enumerate().skip(first).filter_map(move |(k, pair)| {
                let [value, next] = pair else { return None };
                let (value, next) = (record.scale * value, record.scale * next);
                let slope = (next - value) / record.dt;
                let unsure = 8.0 * f64::EPSILON * (1.0 + value.abs() + next.abs());
                Some(Piece {
                    from: starts(k),
                    to: starts(k + 1),
                    shape: Shape::Line(starts(k), value, slope),
                    curvature: 0.0,
                    unsure,
                })
            });
            Box::new(pieces.skip_while(move |piece| piece.to <= from))
        }
    }
}

impl Piece<'_> {
    pub fn is_straight(&self) -> bool {
        matches!(self.shape, Shape::Line(..))
    }

    /// `f` and its derivatives at `time`, so many.
    pub fn derivatives(&self, time: f64, count: usize) -> Vec<f64> {
        match self.shape {
            Shape::Line(from, value, slope) => {
                [value + slope * (time - from), slope].into_iter().chain(std::iter::repeat(0.0)).take(count).collect()
            }
            Shape::Sum(terms) => {
                let mut sums = vec![0.0; count];
                for term in terms {
                    let (sin, cos) = angle(term, time);
                    let (mut this, mut next, mut size) = (sin, cos, term.amplitude);
                    for sum in &mut sums {
                        *sum += size * this;
                        size *= term.omega;
                        (this, next) = (next, -this);
                    }
                }
                sums
            }
            Shape::Wavelet(ricker) => of_wavelet(ricker, time, count),
        }
    }

    /// `f` and `f'`.
    pub fn at(&self, time: f64) -> (f64, f64) {
        let mut derivatives = self.derivatives(time, 2).into_iter();
        (derivatives.next().unwrap_or(0.0), derivatives.next().unwrap_or(0.0))
    }
}

/// The sine and the cosine of `ω time + phase`, with what rounding takes from the angle put back.
fn angle(term: &Sinusoid, time: f64) -> (f64, f64) {
    let turned = term.omega * time;
    let lost = term.omega.mul_add(time, -turned);
    let sum = turned + term.phase;
    let back = sum - turned;
    let rest = (turned - (sum - back)) + (term.phase - back) + lost;
    let (sin, cos) = sum.sin_cos();
    (sin + rest * cos, cos - rest * sin)
}

/// Both wavelets are derivatives of a bell, `E(y) = exp(-y²/2)`: `-E''` and `-E'''`, with `E' = -y E` and so `E^(k+1) = -(y E^(k) + k E^(k-1))`.
fn of_wavelet(&Ricker { amplitude, omega, center, antisymmetric }: &Ricker, time: f64, count: usize) -> Vec<f64> {
    let (rate, first, peak) =
        if antisymmetric { (omega / 3_f64.sqrt(), 3, RICKER_ANTISYMMETRIC_PEAK) } else { (omega / SQRT_2, 2, 1.0) };
    let y = rate * (time - center);
    let bells = (0_u32..).scan(((-0.5 * y * y).exp(), 0.0), |(this, before), k| {
        let bell = *this;
        (*this, *before) = (-(y * *this + f64::from(k) * *before), *this);
        Some(bell)
    });
    let sizes = std::iter::successors(Some(-amplitude / peak), |size| Some(size * rate));
    bells.skip(first).zip(sizes).map(|(bell, size)| size * bell).take(count).collect()
}

#[cfg(test)]
mod tests {
    use contract::Stretch;

    use super::*;

    fn motions() -> [Motion; 4] {
        let terms = vec![
            Sinusoid { amplitude: 0.7, omega: 1.3, phase: 0.4 },
            Sinusoid { amplitude: -0.5, omega: 3.1, phase: -2.0 },
        ];
        let ricker =
            |antisymmetric| Motion::ricker(Ricker { amplitude: 1.2, omega: 2.0, center: 2.5, antisymmetric }).unwrap();
        [
            Motion::sinusoids(vec![Stretch { until: 5.0, terms }]).unwrap(),
            ricker(false),
            ricker(true),
            Motion::record(0.5, 2.0, vec![0.1, 0.7, -0.2, 0.4]).unwrap(),
        ]
    }

    /// Each derivative is the slope of the one before, and the first two bounds hold.
    #[test]
    fn derivatives_are_those_of_the_motion() {
        for motion in motions() {
            for time in [0.2, 0.9, 1.3] {
                let piece = pieces(&motion, time).next().unwrap();
                let h = 1e-5;
                let [before, at, after] = [time - h, time, time + h].map(|time| piece.derivatives(time, 8));
                for k in 0..7 {
                    let slope = (after[k] - before[k]) / (2.0 * h);
                    assert!(
                        (slope - at[k + 1]).abs() < 1e-7 * (1.0 + at[k + 1].abs()) * 4f64.powi(k as i32),
                        "{motion:?} {k}: {slope} {at:?}"
                    );
                }
                assert!(at[2].abs() <= piece.curvature);
            }
        }
    }

    #[test]
    fn values_are_those_of_the_definitions() {
        let [sum, symmetric, antisymmetric, record] = motions();
        let at = |motion: &Motion, time: f64| pieces(motion, time).next().unwrap().at(time).0;
        assert!((at(&sum, 0.9) - (0.7 * 1.57_f64.sin() - 0.5 * 0.79_f64.sin())).abs() < 1e-15);
        let y = |time: f64, root: f64| 2.0 * (time - 2.5) / root.sqrt();
        let bell = |y: f64| (-0.5 * y * y).exp();
        let (one, two) = (y(1.3, 2.0), y(1.3, 3.0));
        assert!((at(&symmetric, 1.3) - 1.2 * (1.0 - one * one) * bell(one)).abs() < 1e-15);
        assert!((at(&antisymmetric, 1.3) - 1.2 / 1.3801 * (two.powi(3) - 3.0 * two) * bell(two)).abs() < 1e-15);
        assert!((at(&record, 0.6) - (1.4 - 0.2 * 1.8)).abs() < 1e-15 && pieces(&record, 1.5).next().is_none());
        assert_eq!(pieces(&record, 1.0).next().unwrap().from, 1.0);
    }
}
