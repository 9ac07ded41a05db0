//! Sums and products whose rounding error is kept (Dekker, Knuth). A time or velocity that is updated thousands of
//! times is held as an unevaluated sum of two doubles.

/// `high + low`, with `low` as large as the rounding errors that it is the sum of. Nothing is carried from it to `high`, which
/// therefore is known, and can be used, before `low` is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Twofold {
    pub high: f64,
    pub low: f64,
}

impl Twofold {
    pub const ZERO: Self = Self { high: 0.0, low: 0.0 };

    /// The exact sum of two doubles.
    pub fn sum(x: f64, y: f64) -> Self {
        let high = x + y;
        let y_part = high - x;
        Self { high, low: (x - (high - y_part)) + (y - y_part) }
    }

    /// The exact product of two doubles that neither overflow nor underflow (Veltkamp's splitting; a fused
    /// multiply-add is a slow call where the machine's baseline lacks it).
    fn product(x: f64, factor: Split) -> Self {
        let Split { whole: x, high: x1, low: x2 } = Split::new(x);
        let Split { whole: y, high: y1, low: y2 } = factor;
        let high = x * y;
        Self { high, low: ((x1 * y1 - high) + x1 * y2 + x2 * y1) + x2 * y2 }
    }

    /// This plus a double.
    pub fn plus(self, x: f64) -> Self {
        let sum = Self::sum(self.high, x);
        Self { high: sum.high, low: sum.low + self.low }
    }

    /// This times a double.
    pub fn times(self, factor: Split) -> Self {
        let product = Self::product(self.high, factor);
        Self { high: product.high, low: product.low + self.low * factor.whole }
    }

    /// The nearest double.
    pub fn value(self) -> f64 {
        self.high + self.low
    }
}

/// A double, and the same as a sum of two doubles of 26 bits each. A factor that is used again and again is split once.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Split {
    whole: f64,
    high: f64,
    low: f64,
}

impl Split {
    pub fn new(whole: f64) -> Self {
        const FACTOR: f64 = 134_217_729.0; // 2^27 + 1
        let scaled = FACTOR * whole;
        let high = scaled - (scaled - whole);
        Self { whole, high, low: whole - high }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rounding_error_of_a_sum_and_of_a_product_is_kept() {
        let sum = Twofold::sum(1.0, 1e-20);
        assert_eq!((sum.high, sum.low), (1.0, 1e-20));
        let x = 1.0 + f64::EPSILON;
        let product = Twofold::product(x, Split::new(x)); // 1 + 2u + u^2 exactly
        assert_eq!((product.high, product.low), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
    }
}
