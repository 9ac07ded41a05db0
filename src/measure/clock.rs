//! The one clock of the harness: a time to which intervals are added that are soon far smaller than its last digit.

/// A sum, and the rounding error that was made in it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Sum {
    /// The sum, rounded.
    pub high: f64,
    /// What rounding took from it.
    pub low: f64,
}

impl Sum {
    /// A sum that starts with `value`.
    pub fn at(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// The nearest double.
    pub fn value(self) -> f64 {
        self.high + self.low
    }

    /// This plus a double, without an error but that of `low` (Knuth's two-sum).
    #[must_use]
    pub fn plus(self, x: f64) -> Self {
        let high = self.high + x;
        let part = high - self.high;
        Self { high, low: self.low + ((self.high - (high - part)) + (x - part)) }
    }

    /// This times a double.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        let high = self.high * factor;
        Self { high, low: self.high.mul_add(factor, -high) + self.low * factor }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Intervals that are far below the last digit of the time add up all the same, and what is added may be larger than what is there.
    #[test]
    fn nothing_is_lost_that_does_not_show() {
        let tick = 2_f64.powi(-60);
        let clock = (0..256).fold(Sum::at(1.0), |clock, _| clock.plus(tick));
        assert_eq!((clock.high, clock.low, clock.value()), (1.0, 256.0 * tick, 1.0 + f64::EPSILON));
        let clock = Sum::at(tick).plus(4.0);
        assert_eq!((clock.high, clock.low), (4.0, tick));
        assert_eq!(Sum::at(1.0).plus(-1.0).value(), 0.0);
    }

    #[test]
    fn a_product_keeps_its_rounding_error() {
        let x = 1.0 + f64::EPSILON;
        let product = Sum { high: x, low: 1e-30 }.times(x);
        assert_eq!((product.high, product.low), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON + 1e-30 * x));
    }
}
