use alloc::{
    format,
    string::{String, ToString},
};
use core::fmt;

/// A value that was refused: which field, what it was, and what would have been allowed.
#[derive(Debug, Clone, PartialEq)]
pub struct Invalid {
    /// The name of the field, as the user wrote it.
    pub field: &'static str,
    /// The refused value, printed.
    pub value: String,
    /// The allowed range, in words.
    pub allowed: &'static str,
}

impl Invalid {
    /// The error for `field`, which was `value` and has to be `allowed`.
    pub fn new(field: &'static str, value: impl ToString, allowed: &'static str) -> Self {
        Self { field, value: value.to_string(), allowed }
    }

    /// `value` itself if `holds`, else the error. A value that is not finite never holds.
    pub(crate) fn unless(holds: bool, field: &'static str, value: f64, allowed: &'static str) -> Result<f64, Self> {
        if holds && value.is_finite() { Ok(value) } else { Err(Self::new(field, format!("{value:?}"), allowed)) }
    }
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = if self.value.is_empty() { "(empty)" } else { &self.value };
        write!(f, "{} = {value} is outside the allowed range: {}", self.field, self.allowed)
    }
}

impl core::error::Error for Invalid {}
