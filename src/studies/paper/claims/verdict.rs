use std::fmt;

use serde::Deserialize;

use super::Claim;

/// What a measurement says of a claim.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Standing {
    /// The statement is right to the digits in which it is made.
    Holds,
    /// It is right within this deviation.
    HoldsWithin(Deviation),
    /// It is wrong, by this deviation.
    DoesNotHold(Deviation),
}

/// In what a deviation is counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unit {
    /// Relative to what is right, printed in per cent.
    Relative,
    /// In the unit of the quantity itself.
    Absolute,
    /// Cases that contradict.
    Cases,
}

/// A deviation that can be printed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// How much.
    pub value: f64,
    /// Of what.
    pub unit: Unit,
}

impl Standing {
    /// The verdict on a claim, by the numbers in the claim. A deviation that is not a number does not hold.
    pub fn of(claim: &Claim, deviation: f64) -> Self {
        let printed = Deviation { value: deviation, unit: claim.unit };
        if deviation <= claim.holds {
            Self::Holds
        } else if deviation <= claim.within {
            Self::HoldsWithin(printed)
        } else {
            Self::DoesNotHold(printed)
        }
    }
}

impl fmt::Display for Standing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Holds => f.write_str("holds"),
            Self::HoldsWithin(deviation) => write!(f, "holds within {deviation}"),
            Self::DoesNotHold(Deviation { value, unit: Unit::Cases }) => {
                write!(f, "does not hold: {value} cases against it")
            }
            Self::DoesNotHold(deviation) => write!(f, "does not hold: off by {deviation}"),
        }
    }
}

impl fmt::Display for Deviation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.unit {
            Unit::Relative => write!(f, "{} %", rounded(100.0 * self.value)),
            Unit::Absolute => f.write_str(&rounded(self.value)),
            Unit::Cases => write!(f, "{} cases", self.value),
        }
    }
}

/// Two significant digits.
pub(super) fn rounded(value: f64) -> String {
    let exponent = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    if (-4.0..=3.0).contains(&exponent) {
        let decimals = (1.0 - exponent).max(0.0) as usize;
        let step = 10.0_f64.powi(1 - exponent as i32);
        let value = if exponent > 1.0 { (value * step).round() / step } else { value };
        format!("{value:.decimals$}")
    } else {
        format!("{value:.1e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn claim(unit: Unit) -> Claim {
        let text = String::new;
        let (id, place, statement, measured, truth) = (text(), text(), text(), text(), text());
        Claim { id, place, statement, measured, truth, unit, holds: 1e-9, within: 0.05 }
    }

    #[test]
    fn the_numbers_of_the_claim_decide() {
        let verdict = |deviation| Standing::of(&claim(Unit::Relative), deviation).to_string();
        assert_eq!(verdict(1e-9), "holds");
        assert_eq!(verdict(0.0052), "holds within 0.52 %");
        assert_eq!(verdict(0.051), "does not hold: off by 5.1 %");
        assert_eq!(verdict(f64::NAN), "does not hold: off by NaN %");
        assert_eq!(Standing::of(&claim(Unit::Cases), 7.0).to_string(), "does not hold: 7 cases against it");
        assert_eq!(Standing::of(&claim(Unit::Absolute), 0.012).to_string(), "holds within 0.012");
    }

    #[test]
    fn two_digits_of_everything() {
        for (value, text) in
            [(0.0, "0.0"), (1.234e-7, "1.2e-7"), (0.01234, "0.012"), (1.26, "1.3"), (12.6, "13"), (1264.0, "1300")]
        {
            assert_eq!(rounded(value), text);
        }
    }
}
