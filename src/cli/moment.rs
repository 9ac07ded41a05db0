//! A time as it is typed: `τ`, or seconds.

use std::{fmt, str::FromStr};

use super::numbers::number;

/// A time of the command line, as `2.5`, which is `τ`, or as `2.5s`, in seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moment {
    value: f64,
    in_seconds: bool,
}

impl Moment {
    /// It in `τ`, for a block with this frequency parameter.
    pub fn tau(self, frequency_parameter: f64) -> f64 {
        if self.in_seconds { self.value * frequency_parameter } else { self.value }
    }
}

impl FromStr for Moment {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let seconds = text.strip_suffix('s').map(|seconds| seconds.strip_suffix(' ').unwrap_or(seconds));
        let Some(seconds) = seconds else { return Ok(Self { value: number(text)?, in_seconds: false }) };
        let value = number(seconds).map_err(|_| "allowed is a time in tau as in 2.5, or in seconds as in 2.5s")?;
        if value.is_finite() && value >= 0.0 {
            Ok(Self { value, in_seconds: true })
        } else {
            Err("allowed is a time that is not negative, in seconds as in 2.5s")
        }
    }
}

impl fmt::Display for Moment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.value, if self.in_seconds { "s" } else { "" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_in_tau_or_in_seconds() {
        let tau = |text: &str| text.parse::<Moment>().map(|moment| moment.tau(2.0));
        assert_eq!([tau("3"), tau("3s"), tau("1e-3 s"), tau("-1")], [Ok(3.0), Ok(6.0), Ok(2e-3), Ok(-1.0)]);
        for wrong in ["s", "3ms", "-3s", "infs", "nans", "3 sec", "three", "3m"] {
            assert!(tau(wrong).is_err(), "{wrong}");
        }
        assert_eq!("0.5s".parse::<Moment>().unwrap().to_string(), "0.5s");
    }
}
