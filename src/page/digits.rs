//! Two numbers side by side, with the digits of the one that are not those of the other.

use maud::{Markup, html};

/// A number as its shortest decimal, in two pieces: what it has in common with the other, digit by digit, and the rest.
pub(super) fn split(value: f64, other: f64) -> (String, String, String) {
    let (text, beside) = (format!("{value:?}"), format!("{other:?}"));
    let (mantissa, exponent) = cut_exponent(&text);
    let (other_mantissa, other_exponent) = cut_exponent(&beside);
    let whole = |text: &str| text.split('.').next().map_or(0, str::len);
    // Digits only compare where they mean the same.
    let is_aligned = exponent == other_exponent && whole(mantissa) == whole(other_mantissa);
    let common = if is_aligned { common(mantissa, other_mantissa) } else { 0 };
    let (same, differs) = mantissa.split_at(common);
    (same.to_owned(), differs.to_owned(), exponent.to_owned())
}

/// How many letters two texts begin with alike; all are ASCII.
fn common(one: &str, other: &str) -> usize {
    one.bytes().zip(other.bytes()).take_while(|(one, other)| one == other).count()
}

fn cut_exponent(text: &str) -> (&str, &str) {
    text.find('e').map_or((text, ""), |at| text.split_at(at))
}

/// A number, or what stands for none; where it `parts` from the other, the digits that differ are marked.
pub(super) fn number(value: Option<f64>, other: Option<f64>, parts: bool) -> Markup {
    let Some(value) = value else { return html! { span .none { "not finite" } } };
    match other.filter(|_| parts) {
        Some(other) => {
            let (same, differs, exponent) = split(value, other);
            html! { (same) mark { (differs) } (exponent) }
        }
        None if parts => html! { mark { (format!("{value:?}")) } },
        None => html! { (format!("{value:?}")) },
    }
}

/// To four digits.
pub(super) fn short(value: f64) -> String {
    let rounded = format!("{value:.3e}").parse::<f64>().unwrap_or(value);
    if rounded != 0.0 && !(1e-3..1e5).contains(&rounded.abs()) { format!("{rounded:e}") } else { format!("{rounded}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_digits_that_differ_are_found() {
        for (value, other, same, differs, exponent) in [
            (0.01778540143811445, 0.017785383652730802, "0.017785", "40143811445", ""),
            (3.472901062518384e-6, 3.469926353474396e-6, "3.4", "72901062518384", "e-6"),
            (3.4e-6, 3.4e-7, "", "3.4", "e-6"),
            (12.5, 1.25, "", "12.5", ""),
            (-0.5, 0.5, "", "-0.5", ""),
            (0.25, 0.255, "0.25", "", ""),
        ] {
            let expected = (same.to_owned(), differs.to_owned(), exponent.to_owned());
            assert_eq!(split(value, other), expected, "{value} {other}");
        }
    }

    #[test]
    fn numbers_are_short_to_four_digits() {
        for (value, text) in [(0.030000000000000027, "0.03"), (1e-12, "1e-12"), (0.0, "0"), (123456.0, "1.235e5")] {
            assert_eq!(short(value), text);
        }
    }
}
