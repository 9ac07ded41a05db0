//! Numbers as a reader of a chart writes them: `0.05`, `10⁻³`, `3.1×10⁻¹²`.

/// The decimal exponents of numbers that are written without a power of ten.
const FIXED: std::ops::RangeInclusive<i32> = -3..=4;

/// `10` with a raised exponent; plain `1` for exponent 0.
pub(super) fn power_of_ten(exponent: i32) -> String {
    if exponent == 0 { "1".to_owned() } else { format!("10{}", raised(exponent)) }
}

/// `value` with at most `digits` significant digits and no trailing zeros.
pub(super) fn short(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".to_owned() } else { value.to_string() };
    }
    let digits = digits.max(1);
    let written = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = written.split_once('e').unwrap_or((&written, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if FIXED.contains(&exponent) {
        let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
        return minus(trim(&format!("{value:.decimals$}")));
    }
    match trim(mantissa) {
        "1" => power_of_ten(exponent),
        "-1" => format!("−{}", power_of_ten(exponent)),
        mantissa => format!("{}×{}", minus(mantissa), power_of_ten(exponent)),
    }
}

/// `value`, a multiple of `step`, with the digits that tell it from its neighbours, all with the same number of them; `largest` is the
/// largest magnitude among them.
pub(super) fn multiple(value: f64, step: f64, largest: f64) -> String {
    let (top, last) = (exponent(largest), exponent(step));
    let value = if value.abs() < 1e-6 * step { 0.0 } else { value };
    if !FIXED.contains(&top) && value != 0.0 {
        let decimals = usize::try_from(top - last).unwrap_or(0);
        return format!("{}×{}", minus(&format!("{:.decimals$}", value / 10_f64.powi(top))), power_of_ten(top));
    }
    let decimals = if value == 0.0 && !FIXED.contains(&top) { 0 } else { usize::try_from(-last).unwrap_or(0) };
    minus(&format!("{value:.decimals$}"))
}

/// The decimal exponent of a magnitude.
fn exponent(magnitude: f64) -> i32 {
    if magnitude > 0.0 { (magnitude.log10() + 1e-9).floor() as i32 } else { 0 }
}

fn trim(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// A hyphen at the front as a minus sign.
fn minus(text: &str) -> String {
    text.strip_prefix('-').map_or_else(|| text.to_owned(), |rest| format!("−{rest}"))
}

fn raised(exponent: i32) -> String {
    let digit = |digit| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    };
    exponent.to_string().chars().map(digit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_raised() {
        assert_eq!([-13, 0, 1, 245].map(power_of_ten), ["10⁻¹³", "1", "10¹", "10²⁴⁵"]);
    }

    #[test]
    fn short_numbers() {
        let cases = [
            (0.0, "0"),
            (0.05, "0.05"),
            (2.34567, "2.35"),
            (-0.25, "−0.25"),
            (1e-6, "10⁻⁶"),
            (3.14e-12, "3.14×10⁻¹²"),
            (2e5, "2×10⁵"),
        ];
        for (value, text) in cases {
            assert_eq!(short(value, 3), text);
        }
        assert_eq!(short(999.9, 3), "1000");
    }

    #[test]
    fn multiples_have_equal_digits() {
        assert_eq!([1.0, 1.01, 1.02].map(|value| multiple(value, 0.01, 1.02)), ["1.00", "1.01", "1.02"]);
        assert_eq!([-0.5, 0.0].map(|value| multiple(value, 0.5, 1.0)), ["−0.5", "0.0"]);
        assert_eq!([0.0, 2.5e-6].map(|value| multiple(value, 5e-7, 2.5e-6)), ["0", "2.5×10⁻⁶"]);
        assert_eq!([0.0, 20.0, 100.0].map(|value| multiple(value, 20.0, 100.0)), ["0", "20", "100"]);
    }
}
