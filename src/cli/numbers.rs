//! Numbers as they are typed. Whether a value is allowed is for the contract to say; that it is the number that was meant is said here.

use std::fmt::Display;

/// A number of the command line.
pub(super) fn number(text: &str) -> Result<f64, &'static str> {
    const NOT_ONE: &str = "not a number; allowed is one as in 1.03 or 1e-3";
    let value: f64 = text.parse().map_err(|_| NOT_ONE)?;
    let mantissa = text.split(['e', 'E']).next().unwrap_or_default();
    if value == 0.0 && mantissa.contains(|digit: char| digit.is_ascii_digit() && digit != '0') {
        return Err("too small for a double, which would be 0; allowed is 0, or 5e-324 and more");
    }
    if value.is_infinite() && mantissa.contains(|digit: char| digit.is_ascii_digit()) {
        return Err("too large for a double; allowed is up to 1.7e308");
    }
    Ok(value)
}

/// A whole number of the command line. Its range is named here; what is outside of it is refused where the others of its kind are.
pub(super) fn whole<const LOWEST: i64, const HIGHEST: i64>(text: &str) -> Result<i64, String> {
    text.parse().map_err(|_| not_whole(LOWEST, HIGHEST))
}

/// How many, see [`whole`].
pub(super) fn count<const LOWEST: usize, const HIGHEST: usize>(text: &str) -> Result<usize, String> {
    text.parse().map_err(|_| not_whole(LOWEST, HIGHEST))
}

fn not_whole(lowest: impl Display, highest: impl Display) -> String {
    format!("not a whole number, or too large; allowed is {lowest} to {highest}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_the_one_that_was_typed_or_none() {
        for (text, value) in [("1.03", 1.03), ("-0", 0.0), ("0e-999", 0.0), ("5e-324", 5e-324), ("+1", 1.0)] {
            assert_eq!(number(text), Ok(value), "{text}");
        }
        assert_eq!(number("inf"), Ok(f64::INFINITY));
        for text in ["1e400", "1e-400", "-1e-400", "0.0001e-330", "1,03", "", " 1", "0x1", "\u{2212}1", "1_000"] {
            assert!(number(text).is_err(), "{text}");
        }
    }
}
