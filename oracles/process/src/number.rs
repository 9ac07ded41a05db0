//! A double as a message has it: a decimal, a hexadecimal float as a string, or the name of one that JSON has no number for.

use std::fmt;

use serde::{Deserialize, Deserializer, de};

/// A double of any kind, not a number and the infinities too.
#[derive(Debug, Clone, Copy, Default)]
pub struct Number(pub f64);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Reader)
    }
}

/// A whole number from 0. Those who have doubles only may write `7.0`.
#[derive(Debug, Clone, Copy, Default)]
pub struct Whole(pub u64);

impl<'de> Deserialize<'de> for Whole {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader;

        impl de::Visitor<'_> for Reader {
            type Value = Whole;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a whole number from 0")
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Whole, E> {
                Ok(Whole(value))
            }

            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // Only what is one, below 2^53, is converted.
            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Whole, E> {
                let is_whole = value.fract() == 0.0 && (0.0..9_007_199_254_740_992.0).contains(&value);
                is_whole
                    .then_some(Whole(value as u64))
                    .ok_or_else(|| E::invalid_value(de::Unexpected::Float(value), &self))
            }
        }

        deserializer.deserialize_any(Reader)
    }
}

struct Reader;

impl de::Visitor<'_> for Reader {
    type Value = Number;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, a hexadecimal float as a string, \"nan\", \"inf\" or \"-inf\"")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Number, E> {
        Ok(Number(value))
    }

    #[allow(clippy::cast_precision_loss)] // An integer of JSON stands for the nearest double, as a decimal does.
    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Number, E> {
        Ok(Number(value as f64))
    }

    #[allow(clippy::cast_precision_loss)]
    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Number, E> {
        Ok(Number(value as f64))
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Number, E> {
        named(text)
            .or_else(|| hexadecimal(text))
            .map(Number)
            .ok_or_else(|| E::invalid_value(de::Unexpected::Str(shortened(text)), &self))
    }
}

/// As much of a text as an error message should repeat.
fn shortened(text: &str) -> &str {
    text.char_indices().nth(40).and_then(|(at, _)| text.get(..at)).unwrap_or(text)
}

/// Not a number, or infinity, in the spellings of the usual languages.
fn named(text: &str) -> Option<f64> {
    let (sign, name) = signed(text);
    let value = match name.to_ascii_lowercase().as_str() {
        "nan" => f64::NAN,
        "inf" | "infinity" => f64::INFINITY,
        _ => return None,
    };
    Some(sign * value)
}

/// The sign in front, and the rest.
fn signed(text: &str) -> (f64, &str) {
    match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    }
}

/// A hexadecimal float as C's `%a` and Python's `float.hex` write it. One that is no double is refused, not rounded.
fn hexadecimal(text: &str) -> Option<f64> {
    let (sign, rest) = signed(text);
    let rest = rest.strip_prefix("0x").or_else(|| rest.strip_prefix("0X"))?;
    let (digits, exponent) = rest.split_once(['p', 'P'])?;
    let exponent: i32 = exponent.parse().ok().filter(|exponent: &i32| exponent.abs() < 1 << 20)?;
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let fraction = fraction.trim_end_matches('0');
    let digits = format!("{whole}{fraction}");
    if whole.is_empty() || digits.len() > 64 || !digits.chars().all(|digit| digit.is_ascii_hexdigit()) {
        return None;
    }
    let digits = digits.trim_start_matches('0');
    if digits.is_empty() {
        return Some(sign * 0.0);
    }
    // More than sixteen digits that matter are no double.
    let mantissa = u64::from_str_radix(digits, 16).ok()?;
    let after_point = i32::try_from(fraction.len()).ok()?;
    scaled(mantissa, exponent - 4 * after_point).map(|value| sign * value)
}

/// `mantissa · 2^exponent`, if that is a double. The mantissa is not zero.
fn scaled(mantissa: u64, exponent: i32) -> Option<f64> {
    let zeros = mantissa.trailing_zeros();
    let mantissa = mantissa >> zeros;
    let exponent = exponent + i32::try_from(zeros).ok()?;
    let bits = u64::BITS - mantissa.leading_zeros();
    let leading = exponent + i32::try_from(bits).ok()? - 1;
    if bits > 53 || leading > 1023 || exponent < -1074 {
        return None;
    }
    if leading < -1022 {
        return Some(f64::from_bits(mantissa << u32::try_from(exponent + 1074).ok()?));
    }
    let fraction = (mantissa << (53 - bits)) & ((1 << 52) - 1);
    let biased = u64::try_from(leading + 1023).ok()?;
    Some(f64::from_bits(biased << 52 | fraction))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(json: &str) -> Option<f64> {
        serde_json::from_str::<Number>(json).ok().map(|number| number.0)
    }

    /// The double that is written is the double that is read, in every spelling, at the ends of the range too.
    #[test]
    fn every_spelling_is_read_bit_for_bit() {
        for (text, value) in [
            ("0.1", 0.1),
            ("-0.0", -0.0),
            ("5e-324", 5e-324),
            ("1.7976931348623157e308", f64::MAX),
            ("3", 3.0),
            ("-3", -3.0),
            ("\"0x1.999999999999ap-4\"", 0.1),
            ("\"0x1.999999999999A0p-4\"", 0.1),
            ("\"-0x0p+0\"", -0.0),
            ("\"0x0.0000000000001p-1022\"", 5e-324),
            ("\"0x1p-1074\"", 5e-324),
            ("\"0x1.fffffffffffffp+1023\"", f64::MAX),
            ("\"0X18P-3\"", 3.0),
            ("\"0x0.8p2\"", 2.0),
            ("\"0x1.0p-1022\"", f64::MIN_POSITIVE),
            ("\"-Infinity\"", f64::NEG_INFINITY),
            ("\"inf\"", f64::INFINITY),
        ] {
            assert_eq!(read(text).map(f64::to_bits), Some(value.to_bits()), "{text}");
        }
        assert!(read("\"NaN\"").unwrap().is_nan());
    }

    /// A whole number may have a point, and nothing behind it.
    #[test]
    fn whole_numbers_may_have_a_point() {
        let read = |json: &str| serde_json::from_str::<Whole>(json).ok().map(|whole| whole.0);
        assert_eq!(
            [read("7"), read("7.0"), read("7e0"), read("18446744073709551615")],
            [Some(7), Some(7), Some(7), Some(u64::MAX)]
        );
        for text in ["7.5", "-1", "-1.0", "1e300", "\"7\"", "null"] {
            assert_eq!(read(text), None, "{text}");
        }
    }

    /// What is no double is refused and not rounded.
    #[test]
    fn what_is_no_double_is_refused() {
        for text in [
            "\"0.1\"",
            "\"\"",
            "\"0x\"",
            "\"0x1\"",
            "\"0x.8p1\"",
            "\"0x1.8\"",
            "\"0x1.00000000000008p0\"",
            "\"0x1p1024\"",
            "\"0x1p-1075\"",
            "\"0x1p99999999999\"",
            "\"0x+1p0\"",
            "true",
            "null",
            "[1]",
            "1e999",
        ] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
