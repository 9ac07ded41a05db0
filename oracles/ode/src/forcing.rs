//! The ground as a flight sees it: `g = i + f` as its value at the start and what is added to it since, which is formed as such and never as a difference of
//! two values of `f`.

use contract::{RICKER_ANTISYMMETRIC_PEAK, Ricker, Sinusoid};

/// The ground in the local time `s` of a flight, as far as it is one analytic function.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Forcing<'a> {
    /// `i + f` at `s = 0`.
    pub excess: f64,
    /// What is added to it since.
    pub change: Change<'a>,
}

/// What `f` changes by since the start of a flight.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Change<'a> {
    /// A straight line of this slope; 0 on still ground.
    Line(f64),
    /// A sinusoid.
    Wave(Wave),
    /// A sum of them.
    Waves(&'a [Wave]),
    /// A wavelet of Ricker.
    Wavelet(Wavelet),
}

impl Forcing<'_> {
    /// On still ground, for a flight of sign `i`.
    pub fn still(i: f64) -> Self {
        Self { excess: i, change: Change::Line(0.0) }
    }

    /// `i + f` at `s`.
    #[inline]
    pub fn at(&self, s: f64) -> f64 {
        let change = match self.change {
            // The sinusoid of a case is asked for most, and is small enough to be inlined alone.
            Change::Wave(wave) => wave.change(s),
            _ => self.other_change(s),
        };
        self.excess + change
    }

    #[inline(never)]
    fn other_change(&self, s: f64) -> f64 {
        match self.change {
            Change::Line(slope) => slope * s,
            Change::Wave(wave) => wave.change(s),
            Change::Waves(waves) => waves.iter().map(|wave| wave.change(s)).sum(),
            Change::Wavelet(wavelet) => wavelet.change(s),
        }
    }

    /// `f'` and `f''` at `s = 0`.
    pub fn derivatives(&self) -> (f64, f64) {
        match self.change {
            Change::Line(slope) => (slope, 0.0),
            Change::Wave(wave) => wave.derivatives(),
            Change::Waves(waves) => {
                waves.iter().map(Wave::derivatives).fold((0.0, 0.0), |(a, b), (c, d)| (a + c, b + d))
            }
            Change::Wavelet(wavelet) => wavelet.derivatives(),
        }
    }

    /// How fast it changes: the largest `omega`.
    pub fn rate(&self) -> f64 {
        match self.change {
            Change::Line(_) => 0.0,
            Change::Wave(wave) => 2.0 * wave.half_omega,
            Change::Waves(waves) => waves.iter().map(|wave| 2.0 * wave.half_omega).fold(0.0, f64::max),
            Change::Wavelet(wavelet) => 2.0 / wavelet.width,
        }
    }
}

/// `a sin(theta + omega s)`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wave {
    /// `a sin(theta)`.
    pub value: f64,
    /// `a cos(theta)`.
    pub quadrature: f64,
    pub half_omega: f64,
}

impl Wave {
    /// What is left of a term from `tau` on.
    pub fn new(term: &Sinusoid, tau: f64) -> Self {
        let Sinusoid { amplitude, omega, phase } = *term;
        let product = omega * tau;
        let angle = product + phase;
        // What the product and the sum lost to rounding, which late in a long motion is more than the last digits.
        let kept = angle - phase;
        let lost = omega.mul_add(tau, -product) + (product - kept) + (phase - (angle - kept));
        let (sin, cos) = angle.sin_cos();
        Self {
            value: amplitude * (sin + lost * cos),
            quadrature: amplitude * (cos - lost * sin),
            half_omega: 0.5 * omega,
        }
    }

    /// `a sin(theta + omega s) - a sin(theta) = 2 sin(omega s/2) [a cos(theta) cos(omega s/2) - a sin(theta) sin(omega s/2)]`.
    #[inline]
    fn change(&self, s: f64) -> f64 {
        let (sin, cos) = (self.half_omega * s).sin_cos();
        2.0 * sin * (self.quadrature * cos - self.value * sin)
    }

    fn derivatives(&self) -> (f64, f64) {
        let omega = 2.0 * self.half_omega;
        (omega * self.quadrature, -omega * omega * self.value)
    }
}

/// `P(y) exp(-y^2/2)` with `y = y_0 + s/width`, a polynomial `P`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wavelet {
    /// `y` at `s = 0`.
    y: f64,
    width: f64,
    /// What multiplies it.
    scale: f64,
    antisymmetric: bool,
}

impl Wavelet {
    /// What is left of a wavelet from `tau` on.
    pub fn new(ricker: &Ricker, tau: f64) -> Self {
        let Ricker { amplitude, omega, center, antisymmetric } = *ricker;
        let (square, peak) = if antisymmetric { (3.0_f64, RICKER_ANTISYMMETRIC_PEAK) } else { (2.0, 1.0) };
        let width = square.sqrt() / omega;
        Self { y: (tau - center) / width, width, scale: amplitude / peak, antisymmetric }
    }

    /// `f` at `s = 0`.
    pub fn value(&self) -> f64 {
        self.value_at(self.y)
    }

    /// No `f'` anywhere is larger: `|P' - y P| exp(-y^2/2)` is at most 1.3801 for the symmetric wavelet, whose derivative is the other one, and 3 at the middle
    /// of that.
    pub fn steepest(&self) -> f64 {
        self.scale.abs() / self.width * if self.antisymmetric { 3.0 } else { 1.381 }
    }

    fn value_at(&self, y: f64) -> f64 {
        self.scale * self.polynomial(y)[0] * (-0.5 * y * y).exp()
    }

    /// `P`, `P'` and `P''`.
    fn polynomial(&self, y: f64) -> [f64; 3] {
        if self.antisymmetric {
            [y * (y * y - 3.0), 3.0 * (y * y - 1.0), 6.0 * y]
        } else {
            [1.0 - y * y, -2.0 * y, -2.0]
        }
    }

    fn change(&self, s: f64) -> f64 {
        let (y, h) = (self.y, s / self.width);
        let exponent = -h * (y + 0.5 * h);
        if exponent.abs() > 1.0 {
            // Two values far apart, of which one may be too small for a double.
            return self.value_at(y + h) - self.value();
        }
        // P(y + h) E(y + h) - P(y) E(y) with E(y + h) = E(y) (1 + grown).
        let grown = exponent.exp_m1();
        let step = if self.antisymmetric { h * (3.0 * (y * (y + h) - 1.0) + h * h) } else { -h * (2.0 * y + h) };
        let [p, ..] = self.polynomial(y);
        self.scale * (-0.5 * y * y).exp() * (step * (1.0 + grown) + p * grown)
    }

    fn derivatives(&self) -> (f64, f64) {
        let y = self.y;
        let [p, dp, ddp] = self.polynomial(y);
        let unit = self.scale * (-0.5 * y * y).exp() / self.width;
        (unit * (dp - y * p), unit / self.width * (ddp - 2.0 * y * dp + (y * y - 1.0) * p))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Derivatives are those of the values, values those of the formulas of the contract.
    #[test]
    fn what_a_flight_sees_is_the_motion() {
        let term = Sinusoid { amplitude: 1.3, omega: 2.5, phase: -0.7 };
        let other = Sinusoid { amplitude: -0.4, omega: 6.0, phase: 1.9 };
        let ricker = |antisymmetric| Ricker { amplitude: 1.2, omega: 3.0, center: 2.0, antisymmetric };
        let sum = |tau: f64| 1.3 * (2.5 * tau - 0.7).sin() - 0.4 * (6.0 * tau + 1.9).sin();
        let wavelet = |tau: f64, antisymmetric| {
            let y = 3.0 * (tau - 2.0) / if antisymmetric { 3.0_f64 } else { 2.0 }.sqrt();
            let p = if antisymmetric { (y.powi(3) - 3.0 * y) / 1.3801 } else { 1.0 - y * y };
            1.2 * p * (-0.5 * y * y).exp()
        };
        for tau in [0.0, 0.9, 1.7, 2.4, 3.9] {
            let waves = [Wave::new(&term, tau), Wave::new(&other, tau)];
            let [symmetric, antisymmetric] = [false, true].map(|of| Wavelet::new(&ricker(of), tau));
            let value: f64 = waves.iter().map(|wave| wave.value).sum();
            let seen = |value: f64, change| Forcing { excess: 1.0 + value, change };
            for (forcing, f) in [
                (seen(value, Change::Waves(&waves)), &sum as &dyn Fn(f64) -> f64),
                (seen(symmetric.value(), Change::Wavelet(symmetric)), &|tau| wavelet(tau, false)),
                (seen(antisymmetric.value(), Change::Wavelet(antisymmetric)), &|tau| wavelet(tau, true)),
            ] {
                for s in [0.0, 1e-3, 0.4, 1.5, 3.0] {
                    assert!((forcing.at(s) - 1.0 - f(tau + s)).abs() < 1e-14, "{forcing:?} {s}");
                }
                let (slope, curvature) = forcing.derivatives();
                let h = 1e-4;
                let (before, now, after) = (f(tau - h), f(tau), f(tau + h));
                assert!(((after - before) / (2.0 * h) - slope).abs() < 1e-6 && forcing.rate() > 1.0, "{forcing:?}");
                assert!(((after - 2.0 * now + before) / (h * h) - curvature).abs() < 1e-5, "{forcing:?}");
                // Nothing is lost where hardly anything is added.
                let (tiny, whole) = (1e-12, forcing.at(1e-12) - forcing.excess);
                assert!((whole - slope * tiny).abs() < 3e-16, "{forcing:?}");
                let change = Forcing { excess: 0.0, ..forcing }.at(tiny);
                assert!((change / (slope * tiny) - 1.0).abs() < 1e-10, "{forcing:?}");
            }
        }
    }

    /// Far out the wavelet is nothing, and becomes what it is.
    #[test]
    fn a_wavelet_is_seen_from_far_away() {
        for antisymmetric in [false, true] {
            let ricker = Ricker { amplitude: 2.0, omega: 100.0, center: 30.0, antisymmetric };
            let (early, near) = (Wavelet::new(&ricker, 0.0), Wavelet::new(&ricker, 30.01));
            assert_eq!(early.value(), 0.0);
            assert!((early.change(30.01) - near.value()).abs() < 1e-12 && near.value().abs() > 0.1);
        }
    }

    #[test]
    fn a_wavelet_is_no_steeper_than_that() {
        for antisymmetric in [false, true] {
            let ricker = Ricker { amplitude: 1.0, omega: 1.0, center: 8.0, antisymmetric };
            let slopes = (0..16_000).map(|k| Wavelet::new(&ricker, 1e-3 * f64::from(k)).derivatives().0.abs());
            let (steepest, bound) = (slopes.fold(0.0, f64::max), Wavelet::new(&ricker, 0.0).steepest());
            assert!(steepest <= bound && bound < 1.001 * steepest, "{steepest} {bound}");
        }
    }
}
