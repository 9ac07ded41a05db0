use std::cell::RefCell;

use astro_float::{BigFloat, Consts, Radix, RoundingMode, Sign};
use contract::Decline;

const ROUNDING: RoundingMode = RoundingMode::ToEven;

/// Floating-point numbers with a chosen number of bits. A failure of any operation is NaN.
pub(crate) struct Arithmetic {
    bits: usize,
    // The library computes π, ln 2 and the like once for each precision and keeps them here.
    constants: RefCell<Consts>,
}

impl Arithmetic {
    pub(crate) fn new(bits: usize) -> Result<Self, Decline> {
        let constants = Consts::new()
            .map_err(|_| Decline::Unsupported { what: "numbers of this many digits in this little memory" })?;
        Ok(Self { bits, constants: RefCell::new(constants) })
    }

    /// Exact.
    pub(crate) fn number(&self, value: f64) -> BigFloat {
        BigFloat::from_f64(value, self.bits)
    }

    pub(crate) fn add(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.add(b, self.bits, ROUNDING)
    }

    pub(crate) fn sub(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.sub(b, self.bits, ROUNDING)
    }

    pub(crate) fn mul(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.mul(b, self.bits, ROUNDING)
    }

    pub(crate) fn div(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.div(b, self.bits, ROUNDING)
    }

    pub(crate) fn scale(&self, a: &BigFloat, factor: f64) -> BigFloat {
        self.mul(a, &self.number(factor))
    }

    pub(crate) fn exp(&self, a: &BigFloat) -> BigFloat {
        a.exp(self.bits, ROUNDING, &mut self.constants.borrow_mut())
    }

    pub(crate) fn sin(&self, a: &BigFloat) -> BigFloat {
        a.sin(self.bits, ROUNDING, &mut self.constants.borrow_mut())
    }

    pub(crate) fn cos(&self, a: &BigFloat) -> BigFloat {
        a.cos(self.bits, ROUNDING, &mut self.constants.borrow_mut())
    }

    pub(crate) fn asin(&self, a: &BigFloat) -> BigFloat {
        a.asin(self.bits, ROUNDING, &mut self.constants.borrow_mut())
    }

    pub(crate) fn pi(&self) -> BigFloat {
        self.constants.borrow_mut().pi(self.bits, ROUNDING)
    }

    /// `value` rounded to `digits` significant decimals, as `1.25`, `0.00125` or `1.25e-9`. `None` for what is not a finite number.
    pub(crate) fn decimal(&self, value: &BigFloat, digits: usize) -> Option<String> {
        if value.is_zero() {
            return Some("0".to_owned());
        }
        let (sign, mantissa, exponent) =
            value.convert_to_radix(Radix::Dec, ROUNDING, &mut self.constants.borrow_mut()).ok()?;
        // The value is 0.d₁d₂d₃... times 10^exponent.
        let (mut digits, carried) = rounded(&mantissa, digits.max(1));
        let exponent = exponent + i32::from(carried) - 1;
        let sign = if sign == Sign::Neg { "-" } else { "" };
        if (-4..0).contains(&exponent) {
            let zeros = "0".repeat(exponent.unsigned_abs() as usize - 1);
            return Some(format!("{sign}0.{zeros}{digits}"));
        }
        let whole = if (0..=6).contains(&exponent) { exponent as usize + 1 } else { 1 };
        while digits.len() < whole {
            digits.push('0');
        }
        let (before, after) = digits.split_at(whole);
        let point = if after.is_empty() { "" } else { "." };
        let power = if (0..=6).contains(&exponent) { String::new() } else { format!("e{exponent}") };
        Some(format!("{sign}{before}{point}{after}{power}"))
    }
}

/// The first `count` digits, the last of them rounded; and whether that made one digit more, as in 0.99 to 1.0.
fn rounded(mantissa: &[u8], count: usize) -> (String, bool) {
    let mut digits: Vec<u8> = mantissa.iter().copied().take(count).collect();
    let mut carry = mantissa.get(count).is_some_and(|next| *next >= 5);
    for digit in digits.iter_mut().rev() {
        if !carry {
            break;
        }
        carry = *digit == 9;
        *digit = if carry { 0 } else { *digit + 1 };
    }
    if carry {
        digits.insert(0, 1);
        digits.truncate(count);
    }
    (digits.iter().map(|digit| char::from(b'0' + digit)).collect(), carry)
}

/// The double next to `value`, to half a unit in the last place and a 2^-11 part of that. NaN for what is not a finite number.
pub(crate) fn double(value: &BigFloat) -> f64 {
    if value.is_zero() {
        return 0.0;
    }
    let Some((&[.., top], _, sign, exponent, _)) = value.as_raw_parts() else { return f64::NAN };
    // The mantissa is a fraction in [1/2, 1) with its leading bit in the leading word. Two factors, because one can underflow.
    let power = exponent - 64;
    let magnitude = top as f64 * 2_f64.powi(power / 2) * 2_f64.powi(power - power / 2);
    if sign == Sign::Neg { -magnitude } else { magnitude }
}

/// How many decimals `a` and `b` agree in, relative to `b`.
pub(crate) fn agreement(ar: &Arithmetic, a: &BigFloat, b: &BigFloat) -> usize {
    let difference = ar.sub(a, b);
    if difference.is_zero() {
        return usize::MAX;
    }
    match (difference.exponent(), b.exponent()) {
        (Some(of_difference), Some(of_b)) => {
            // Exponents are right to a bit each.
            let bits = f64::from(of_b) - f64::from(of_difference) - 1.0;
            (bits * std::f64::consts::LOG10_2).max(0.0) as usize
        }
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_numbers_agree_in_at_least_as_many_decimals_as_is_said() {
        let ar = Arithmetic::new(256).unwrap();
        for value in [1.0, 1.5, 1.999, 3.0] {
            for relative in [1e-3, 2e-4, 0.9 / 1024.0, 0.99 / 4096.0, 1e-9, 3e-12, 1.0 / 3.0] {
                let [a, b] = [value * (1.0 + relative), value].map(|x| ar.number(x));
                let agreed = agreement(&ar, &a, &b);
                let decimals = -f64::log10(relative);
                assert!(agreed as f64 <= decimals && agreed as f64 + 1.61 > decimals, "{value} {relative}: {agreed}");
            }
        }
    }

    #[test]
    fn decimals_are_rounded_and_placed() {
        let ar = Arithmetic::new(256).unwrap();
        for (value, digits, expected) in [
            (1.125, 4, "1.125"),
            (1.125, 2, "1.1"),
            (-0.03125, 3, "-0.0313"),
            (0.9999, 2, "1.0"),
            (9.75, 1, "10"),
            (3.0517578125e-5, 4, "3.052e-5"),
            (1048576.0, 3, "1050000"),
            (1048576.0, 7, "1048576"),
            (12345678.0, 3, "1.23e7"),
            (12345678.0, 1, "1e7"),
            (2.5e-4, 2, "0.00025"),
            (9.99e-5, 2, "0.00010"),
            (-9.96e-5, 3, "-9.96e-5"),
            (0.5, 0, "0.5"),
            (0.0, 5, "0"),
        ] {
            assert_eq!(ar.decimal(&ar.number(value), digits).unwrap(), expected, "{value} to {digits}");
        }
        assert_eq!(ar.decimal(&ar.div(&ar.number(1.0), &ar.number(0.0)), 5), None);
    }

    #[test]
    fn doubles_come_back() {
        let ar = Arithmetic::new(320).unwrap();
        for value in
            [1.0, -0.1, 1e-300, 2.5e250, 0.0, std::f64::consts::PI, 1.0 + f64::EPSILON, f64::MIN_POSITIVE, f64::MAX]
        {
            assert_eq!(double(&ar.number(value)), value);
        }
        assert!(double(&ar.div(&ar.number(0.0), &ar.number(0.0))).is_nan());
    }

    #[test]
    fn agreement_counts_the_decimals_that_two_numbers_share() {
        let ar = Arithmetic::new(512).unwrap();
        for value in [1.0, -3.0, 7e-40, 5e80] {
            let number = ar.number(value);
            assert_eq!(agreement(&ar, &number, &number), usize::MAX);
            for decimals in [1, 5, 20, 100] {
                // A relative difference of 10^-decimals; the measure is right to two bits, and never promises too much.
                let ten = ar.number(10.0);
                let off = (0..decimals).fold(number.clone(), |off, _| ar.div(&off, &ten));
                for other in [ar.add(&number, &off), ar.sub(&number, &off)] {
                    let found = agreement(&ar, &other, &number);
                    assert!(found == decimals || found + 1 == decimals, "{found} of {decimals} for {value}");
                }
            }
            assert_eq!(agreement(&ar, &ar.scale(&number, 1e9), &number), 0);
            assert_eq!(agreement(&ar, &ar.number(f64::NAN), &number), 0);
        }
    }
}
