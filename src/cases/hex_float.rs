//! Doubles in the hexadecimal notation of C99, which shows every bit: `0x1.91eb851eb851fp-6`.

/// Writes a finite double.
pub fn format(value: f64) -> String {
    let bits = value.to_bits();
    let sign = if value.is_sign_negative() { "-" } else { "" };
    let mantissa = bits & ((1 << 52) - 1);
    let (lead, exponent) = match (bits >> 52) & 0x7ff {
        0 if mantissa == 0 => return format!("{sign}0x0p+0"),
        0 => (0, -1022),
        biased => (1, biased as i64 - 1023),
    };
    let digits = format!("{mantissa:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{lead}{point}{digits}p{exponent:+}")
}

/// Reads what [`format()`] writes; `None` for anything else.
pub fn parse(text: &str) -> Option<f64> {
    let (negative, rest) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let (mantissa, exponent) = rest.strip_prefix("0x")?.split_once('p')?;
    let (lead, digits) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent: i64 = exponent.parse().ok()?;
    let fraction = if digits.is_empty() { 0 } else { u64::from_str_radix(digits, 16).ok()? };
    let biased = match (lead, exponent) {
        ("1", -1022..=1023) => u64::try_from(exponent + 1023).ok()?,
        ("0", -1022) => 0,
        ("0", 0) if fraction == 0 => 0,
        _ => return None,
    };
    let shift = 52_usize.checked_sub(4 * digits.len())?;
    let sign = if negative { 1 << 63 } else { 0 };
    Some(f64::from_bits(sign | biased << 52 | fraction << shift))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_finite_double_comes_back(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite());
            prop_assert_eq!(super::parse(&super::format(value)).map(f64::to_bits), Some(bits));
        }
    }

    #[test]
    fn known_values() {
        assert_eq!(super::format(1.03), "0x1.07ae147ae147bp+0");
        assert_eq!(super::format(-0.5), "-0x1p-1");
        assert_eq!(super::parse("0x1.8p+1"), Some(3.0));
        for bad in ["", "1.5", "0x2p+0", "0x1.p", "0x1.00000000000000p+0", "0x1p+1024", "nan"] {
            assert_eq!(super::parse(bad), None, "{bad}");
        }
    }
}
