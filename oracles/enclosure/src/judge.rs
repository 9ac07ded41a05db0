//! The judge itself: which equation, and how many digits.

use contract::{Decline, Invalid, Model};

/// The oracle whose claims are proven.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Enclosure {
    pub(crate) model: Model,
    pub(crate) digits: u32,
    pub(crate) patience: usize,
}

impl Enclosure {
    /// How many digits a user may ask for.
    pub const MOST_DIGITS: u32 = 100;

    /// Digits enough for the rounding to doubles to be the largest part of what is claimed.
    const ENOUGH_FOR_DOUBLES: u32 = 17;

    /// The oracle for one of the two equations.
    pub fn new(model: Model) -> Self {
        Self { model, digits: Self::ENOUGH_FOR_DOUBLES, patience: 1 }
    }

    /// The same oracle, with this many correct digits in every number; fewer in a chattering time that would take too many impacts.
    ///
    /// # Errors
    /// When `digits` is below 1 or above [`Enclosure::MOST_DIGITS`].
    pub fn with_digits(self, digits: impl Into<i64>) -> Result<Self, Invalid> {
        let digits = digits.into();
        match u32::try_from(digits) {
            Ok(digits @ 1..=Self::MOST_DIGITS) => Ok(Self { digits, ..self }),
            _ => Err(Invalid::new("digits", digits, "1 <= digits <= 100")),
        }
    }

    /// The same oracle, which spends ten times as long on a whole response before it leaves it undecided: for someone who waits for this answer alone.
    pub fn patient(self) -> Self {
        Self { patience: 10, ..self }
    }

    /// How many digits are asked of it.
    pub fn digits(&self) -> u32 {
        self.digits
    }
}

/// Refuses what the judge can't do.
pub(crate) fn within(
    field: &'static str,
    value: f64,
    least: f64,
    most: f64,
    allowed: &'static str,
) -> Result<(), Decline> {
    if (least..=most).contains(&value) { Ok(()) } else { Err(Decline::OutOfRange { field, value, allowed }) }
}
