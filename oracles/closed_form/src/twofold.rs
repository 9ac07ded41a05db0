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
    use proptest::prelude::*;

    /// Whole numbers that a double holds, most of them with all of its 53 bits.
    fn whole() -> impl Strategy<Value = f64> {
        (-(1i64 << 53)..=1i64 << 53).prop_map(|whole| whole as f64)
    }

    fn exact(sum: Twofold) -> i128 {
        sum.high as i128 + sum.low as i128
    }

    proptest! {
        /// In whole numbers, of which 128 bits hold every sum and product.
        #[test]
        fn sums_and_products_are_exact(x in whole(), y in whole(), shift in 0..60i32) {
            let scale = 2f64.powi(shift);
            let sum = Twofold::sum(scale * x, y);
            prop_assert_eq!(exact(sum), ((scale * x) as i128) + y as i128);
            prop_assert_eq!(sum.high, scale * x + y);
            prop_assert_eq!(exact(Twofold::sum(y, scale * x)), exact(sum));
            let product = Twofold::product(x, Split::new(y));
            prop_assert_eq!(exact(product), (x as i128) * (y as i128));
            prop_assert_eq!(product.high, x * y);
        }

        /// What is in the low part already is carried along.
        #[test]
        fn the_low_part_is_added_to_and_multiplied(x in whole(), y in whole(), low in -256i32..256) {
            let low = f64::from(low);
            let sum = Twofold { high: x, low }.plus(y);
            prop_assert_eq!(exact(sum), x as i128 + low as i128 + y as i128);
            let factor = (y % 4096.0).trunc();
            let product = Twofold { high: x, low }.times(Split::new(factor));
            prop_assert_eq!(exact(product), (x as i128 + low as i128) * factor as i128);
            prop_assert_eq!(Twofold { high: x, low }.value(), (x as i128 + low as i128) as f64);
        }
    }

    #[test]
    fn the_rounding_error_of_a_sum_and_of_a_product_is_kept() {
        let sum = Twofold::sum(1.0, 1e-20);
        assert_eq!((sum.high, sum.low), (1.0, 1e-20));
        let x = 1.0 + f64::EPSILON;
        let product = Twofold::product(x, Split::new(x)); // 1 + 2u + u^2 exactly
        assert_eq!((product.high, product.low), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
    }
}
