//! Sums and products whose rounding error is kept (Dekker, Knuth). A time or velocity that is updated thousands of
//! times is held as an unevaluated sum of two doubles.

/// `high + low`, with `low` at most half a unit in the last place of `high`.
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
    pub fn product(x: f64, y: f64) -> Self {
        let (x1, x2) = split(x);
        let (y1, y2) = split(y);
        let high = x * y;
        Self { high, low: ((x1 * y1 - high) + x1 * y2 + x2 * y1) + x2 * y2 }
    }

    /// This plus a double.
    pub fn plus(self, x: f64) -> Self {
        let sum = Self::sum(self.high, x);
        Self::sum(sum.high, sum.low + self.low)
    }

    /// This times a double.
    pub fn times(self, x: f64) -> Self {
        let product = Self::product(self.high, x);
        Self::sum(product.high, product.low + self.low * x)
    }
}

/// `x` as a sum of two doubles of 26 bits each.
fn split(x: f64) -> (f64, f64) {
    const FACTOR: f64 = 134_217_729.0; // 2^27 + 1
    let scaled = FACTOR * x;
    let high = scaled - (scaled - x);
    (high, x - high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rounding_error_of_a_sum_and_of_a_product_is_kept() {
        let sum = Twofold::sum(1.0, 1e-20);
        assert_eq!((sum.high, sum.low), (1.0, 1e-20));
        let x = 1.0 + f64::EPSILON;
        let product = Twofold::product(x, x); // 1 + 2u + u^2 exactly
        assert_eq!((product.high, product.low), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
    }
}
