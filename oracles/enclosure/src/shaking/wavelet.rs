//! Ricker wavelets: `a P(y) exp(-y²/2)` with `y = (τ - center)/width`, where `P` is `1 - y²` and the width `√2/ω`, or `(y³ - 3y)/1.3801` and `√3/ω`.

use super::Acceleration;
use crate::{
    directed::Directed,
    functions::gauss,
    interval::Interval,
    pull::{Bend, Pull, Side, Wavelet},
};

pub struct Ricker<F> {
    of: contract::Ricker,
    amplitude: Interval<F>,
    center: Interval<F>,
    /// `1/width`.
    rate: Interval<F>,
}

impl<F: Directed> Ricker<F> {
    pub fn new(of: &contract::Ricker) -> Self {
        // 1.3801 is a decimal, which no double is.
        let decimal = || &Interval::exactly(13801.0) / &Interval::exactly(1e4);
        let (square, peak) = if of.antisymmetric { (3.0, decimal()) } else { (2.0, Interval::exactly(1.0)) };
        Self {
            of: *of,
            amplitude: &Interval::exactly(of.amplitude) / &peak,
            center: Interval::exactly(of.center),
            rate: &Interval::exactly(of.omega) / &Interval::exactly(square).root(),
        }
    }

    /// The same in doubles.
    pub fn coarse(&self) -> Ricker<f64> {
        Ricker::new(&self.of)
    }

    pub fn end(&self) -> Interval<F> {
        &Interval::exactly(2.0) * &self.center
    }

    /// `P` about `y`, by powers of what `y` changes by.
    fn polynomial(&self, y: &Interval<F>) -> [Interval<F>; 4] {
        let (square, three) = (y.squared(), Interval::exactly(3.0));
        if self.of.antisymmetric {
            let three_square = &three * &square;
            [y * &(&square - &three), &three_square - &three, &three * y, Interval::exactly(1.0)]
        } else {
            let one = Interval::exactly(1.0);
            [&one - &square, &Interval::exactly(-2.0) * y, -&one, Interval::zero()]
        }
    }

    fn wavelet(&self, time: &Interval<F>) -> Wavelet<F> {
        let middle = &(time - &self.center) * &self.rate;
        let polynomial = self.polynomial(&middle).map(|power| &self.amplitude * &power);
        Wavelet { polynomial, gauss: gauss(&middle), middle, rate: self.rate.clone() }
    }

    pub fn acceleration(&self, time: &Interval<F>) -> Acceleration<F> {
        let Wavelet { polynomial: [value, slope, ..], gauss, middle, rate } = self.wavelet(time);
        // (P E)' = (P' - y P) E
        let slope = &(&(&slope - &(&middle * &value)) * &gauss) * &rate;
        Acceleration { value: &value * &gauss, slope }
    }

    pub fn pull(&self, time: &Interval<F>, side: Side) -> Pull<F> {
        let of = self.wavelet(time);
        let Acceleration { value, slope } = self.acceleration(time);
        let polynomial = of.polynomial.each_ref().map(|power| side.of(power));
        Pull {
            value: &Interval::exactly(1.0) + &side.of(&value),
            slope: side.of(&slope),
            bend: Bend::Wavelet(Wavelet { polynomial, ..of }),
        }
    }

    /// `f''` is `-a He₄(y) exp(-y²/2)/width²`, largest at 0, where `He₄` is 3; or `a He₅(y) exp(-y²/2)/width²`, below 6.
    pub fn bend(&self) -> Interval<F> {
        let most = Interval::exactly(if self.of.antisymmetric { 6.0 } else { 3.0 });
        &(&most * &Interval::exactly(self.amplitude.magnitude())) * &self.rate.squared()
    }

    /// The largest of `|f|`: `P(y) exp(-y²/2)` is 1 at 0, or below 1.3802 as it is rounded.
    pub fn strongest(&self) -> Interval<F> {
        let most = Interval::exactly(if self.of.antisymmetric { 1.3802 } else { 1.0 });
        &most * &Interval::exactly(self.amplitude.magnitude())
    }
}
