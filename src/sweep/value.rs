//! A value of an axis: a number, or of a scene also a whole number or a text, as that of a file.

/// A value of an axis.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A whole number, for fields that take no others.
    Whole(i64),
    /// A text.
    Text(String),
}

impl Value {
    /// The number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            Self::Whole(whole) => Some(*whole as f64),
            Self::Text(_) => None,
        }
    }

    /// Writes it as a field of a CSV.
    pub fn write(&self, row: &mut String) {
        match self {
            Self::Number(number) => write_number(row, *number),
            Self::Whole(whole) => *row += &whole.to_string(),
            Self::Text(text) if text.contains([',', '"']) => *row += &format!("\"{}\"", text.replace('"', "\"\"")),
            Self::Text(text) => row.push_str(text),
        }
    }
}

/// Writes a number as the shortest decimal that is read as the same double; nothing where it is not finite.
pub(super) fn write_number(row: &mut String, number: f64) {
    use std::fmt::Write as _;
    if number.is_finite() {
        // Writing to a string can't fail.
        let _ = write!(row, "{number:?}");
    }
}
