//! Numbers as Fortran prints and reads them: `.123E-2`, `-.5`, `5.`, `0.1D-03`, and `1.234-5`, whose exponent has no letter (J3/24-007, 13.7.2).

use super::{RecordError, error::shown};

/// What a field of a file is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Field<'a> {
    /// A number, and what touches it: the next number, with its sign.
    Number(f64, &'a [u8]),
    /// Meant as a number, but not one that can be used: asterisks, NaN, infinite, hexadecimal.
    Unusable,
    /// Something else.
    Other,
}

/// Reads the number that a field begins with.
pub fn field(text: &[u8]) -> Field<'_> {
    // Most are printed as the standard library reads them.
    let parsed = std::str::from_utf8(text).ok().and_then(|text| text.parse::<f64>().ok());
    match parsed.filter(|value| value.is_finite()) {
        Some(value) => Field::Number(value, &[]),
        None => fortran(text),
    }
}

/// Reads the number that a field begins with, in any form that Fortran has.
fn fortran(text: &[u8]) -> Field<'_> {
    let Some(extent) = Extent::of(text) else {
        return if is_unusable(text) { Field::Unusable } else { Field::Other };
    };
    let (Some(number), Some(rest)) = (text.get(..extent.end), text.get(extent.end..)) else { return Field::Other };
    // Numbers touch only with a sign between them, and only where both have a point: a date is no number.
    let touches = extent.has_point
        && matches!(rest.first(), Some(b'+' | b'-'))
        && Extent::of(rest).is_some_and(|next| next.has_point);
    if !rest.is_empty() && !touches {
        return if is_unusable(text) { Field::Unusable } else { Field::Other };
    }
    match extent.value(number) {
        Some(value) if value.is_finite() => Field::Number(value, rest),
        _ => Field::Unusable,
    }
}

/// The number that a whole field is, if it is one.
pub fn value(text: &[u8]) -> Option<f64> {
    match field(text) {
        Field::Number(value, []) => Some(value),
        _ => None,
    }
}

/// How many digits are printed after the point, and the exponent if one is printed.
pub fn decimals(text: &[u8]) -> (i32, Option<i32>) {
    let Some(extent) = Extent::of(text) else { return (0, None) };
    let exponent = text.get(extent.exponent..extent.end).filter(|exponent| !exponent.is_empty()).map(exponent_of);
    (i32::try_from(extent.decimals).unwrap_or(i32::MAX), exponent)
}

/// What is wrong with a field that should be a number.
pub fn error(line: usize, text: &[u8]) -> RecordError {
    let why = match text {
        [b'*', ..] => ": a number that did not fit into its column",
        _ if is_hexadecimal(text) => ": a hexadecimal number",
        _ if field(text) == Field::Unusable => ": not a number that can be used",
        _ => "",
    };
    RecordError::at(line, format!("`{}`{why}; expected is a finite number such as -0.0123 or -.123E-01", shown(text)))
}

/// Where the parts of a number are.
struct Extent {
    /// Where the exponent begins, its letter included.
    exponent: usize,
    end: usize,
    has_point: bool,
    decimals: usize,
    /// Whether the standard library would not read it so.
    is_fortran: bool,
}

impl Extent {
    fn of(text: &[u8]) -> Option<Self> {
        let at = |place: usize| text.get(place).copied().unwrap_or_default();
        let digits = |from: usize| text.iter().skip(from).take_while(|byte| byte.is_ascii_digit()).count();
        let start = usize::from(matches!(at(0), b'+' | b'-'));
        let whole = digits(start);
        let has_point = at(start + whole) == b'.';
        let decimals = if has_point { digits(start + whole + 1) } else { 0 };
        if whole + decimals == 0 {
            return None;
        }
        let exponent = start + whole + usize::from(has_point) + decimals;
        let letter = matches!(at(exponent), b'e' | b'E' | b'd' | b'D');
        let sign = matches!(at(exponent + usize::from(letter)), b'+' | b'-');
        let power = digits(exponent + usize::from(letter) + usize::from(sign));
        let end = exponent + usize::from(letter) + usize::from(sign) + power;
        // Without a letter it is an exponent only after a point, and only if it is not itself a number with a point.
        let is_exponent = power > 0 && (letter || (sign && has_point && at(end) != b'.'));
        let is_fortran = is_exponent && !matches!(at(exponent), b'e' | b'E');
        Some(Self { exponent, end: if is_exponent { end } else { exponent }, has_point, decimals, is_fortran })
    }

    fn value(&self, number: &[u8]) -> Option<f64> {
        if !self.is_fortran {
            return std::str::from_utf8(number).ok()?.parse().ok();
        }
        let mantissa = std::str::from_utf8(number.get(..self.exponent)?).ok()?;
        format!("{mantissa}e{}", exponent_of(number.get(self.exponent..)?)).parse().ok()
    }
}

/// The value of an exponent as typed, with or without its letter.
fn exponent_of(text: &[u8]) -> i32 {
    let digits = text.strip_prefix(b"e").or(text.strip_prefix(b"E")).or(text.strip_prefix(b"d"));
    let digits = digits.or(text.strip_prefix(b"D")).unwrap_or(text);
    let value = std::str::from_utf8(digits).ok().and_then(|digits| digits.parse::<i64>().ok());
    // What is longer than that is beyond every double, one way or the other.
    value
        .unwrap_or(if digits.starts_with(b"-") { -9999 } else { i64::from(!digits.is_empty()) * 9999 })
        .clamp(-9999, 9999) as i32
}

/// Whether a field looks like a hexadecimal number: `0x1F`, `3FB9`.
pub fn is_hexadecimal(text: &[u8]) -> bool {
    let digits = text.get(2..).filter(|_| text.get(..2).is_some_and(|start| start.eq_ignore_ascii_case(b"0x")));
    let has_both = || text.iter().any(u8::is_ascii_digit) && text.iter().any(u8::is_ascii_alphabetic);
    let digits = digits.or_else(|| Some(text).filter(|_| has_both()));
    digits.is_some_and(|digits| !digits.is_empty() && digits.iter().all(u8::is_ascii_hexdigit))
}

/// Whether a field is meant as a number that can't be used.
fn is_unusable(text: &[u8]) -> bool {
    let text = text.strip_prefix(b"-").or(text.strip_prefix(b"+")).unwrap_or(text);
    let is = |word: &str| text.eq_ignore_ascii_case(word.as_bytes());
    let hexadecimal = text.len() > 2 && text.get(..2).is_some_and(|start| start.eq_ignore_ascii_case(b"0x"));
    let overflow = !text.is_empty() && text.iter().all(|byte| *byte == b'*');
    overflow || hexadecimal || ["nan", "nanq", "nans", "inf", "infinity"].iter().any(|word| is(word))
}
