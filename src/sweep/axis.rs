//! An axis: one field, and the values that it takes.

use super::Value;

/// One field, and the values that it takes.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The field: one of a case, or one of a scene with dots between the names of its tables.
    pub name: String,
    /// Its values.
    pub spread: Spread,
}

/// How values are spread.
#[derive(Debug, Clone, PartialEq)]
pub enum Spread {
    /// As they are listed.
    List(Vec<Value>),
    /// Evenly, with both ends.
    Linear(Range),
    /// Evenly by the logarithm, with both ends.
    Log(Range),
    /// At random, evenly.
    Random(Range),
    /// At random, evenly by the logarithm.
    RandomLog(Range),
}

/// From where to where, and how many.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// How many values.
    pub count: usize,
}

impl Spread {
    /// How many values there are.
    pub fn count(&self) -> usize {
        match self {
            Self::List(values) => values.len(),
            Self::Linear(range) | Self::Log(range) | Self::Random(range) | Self::RandomLog(range) => range.count,
        }
    }

    /// Whether the values are drawn.
    pub fn is_random(&self) -> bool {
        matches!(self, Self::Random(_) | Self::RandomLog(_))
    }

    /// Whether they are spread by the logarithm.
    pub fn is_log(&self) -> bool {
        matches!(self, Self::Log(_) | Self::RandomLog(_))
    }

    /// The values that bound all others, or all of them where none does.
    pub fn extremes(&self) -> Vec<Value> {
        match self {
            Self::List(values) => values.clone(),
            Self::Linear(Range { low, high, .. })
            | Self::Log(Range { low, high, .. })
            | Self::Random(Range { low, high, .. })
            | Self::RandomLog(Range { low, high, .. }) => vec![Value::Number(*low), Value::Number(*high)],
        }
    }
}

impl Axis {
    /// The value at a place, the first being 0; `seed` is that of the random ones.
    pub fn value(&self, place: usize, seed: u64) -> Value {
        match &self.spread {
            // A place is below the count.
            Spread::List(values) => values.get(place).cloned().unwrap_or(Value::Number(f64::NAN)),
            Spread::Linear(range) => Value::Number(range.even(place)),
            Spread::Log(range) => Value::Number(range.even_by_log(place)),
            Spread::Random(range) => Value::Number(range.linear(drawn(seed, &self.name, place))),
            Spread::RandomLog(range) => Value::Number(range.log(drawn(seed, &self.name, place))),
        }
    }
}

impl Range {
    /// The number of the last place, the first being 0.
    fn last(&self) -> f64 {
        (self.count.max(2) - 1) as f64
    }

    fn even(&self, place: usize) -> f64 {
        let share = place as f64 / self.last();
        self.with_ends(share, rounded(self.low * (1.0 - share) + self.high * share))
    }

    fn even_by_log(&self, place: usize) -> f64 {
        let share = place as f64 / self.last();
        self.with_ends(share, rounded(self.log(share)))
    }

    /// Both ends exactly, and nothing beyond them.
    fn with_ends(&self, share: f64, between: f64) -> f64 {
        match share {
            0.0 => self.low,
            1.0 => self.high,
            _ => between.clamp(self.low, self.high),
        }
    }

    fn linear(&self, share: f64) -> f64 {
        (self.low * (1.0 - share) + self.high * share).clamp(self.low, self.high)
    }

    fn log(&self, share: f64) -> f64 {
        (self.low * (self.high / self.low).powf(share)).clamp(self.low, self.high)
    }
}

/// To 15 digits: 0.35 and not 0.35000000000000003.
fn rounded(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

/// A number from 0 on and below 1: a function of the seed, the axis and the place, and of nothing else. It is the first 53 bits of the SHA-256 of
/// `SEED/AXIS/PLACE`, so that any program can draw the same.
fn drawn(seed: u64, axis: &str, place: usize) -> f64 {
    use sha2::{Digest as _, Sha256};
    let digest = Sha256::digest(format!("{seed}/{axis}/{place}"));
    let bits = digest.iter().take(8).fold(0_u64, |bits, byte| bits << 8 | u64::from(*byte)) >> 11;
    bits as f64 / (1_u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(spread: Spread) -> Axis {
        Axis { name: "a".to_owned(), spread }
    }

    fn numbers(spread: Spread) -> Vec<f64> {
        let axis = axis(spread);
        (0..axis.spread.count()).filter_map(|place| axis.value(place, 1).number()).collect()
    }

    #[test]
    fn both_ends_are_exact_and_the_rest_is_even() {
        let range = Range { low: 1.1, high: 1.7, count: 7 };
        let linear = numbers(Spread::Linear(range));
        assert_eq!((linear[0], linear[6], linear.len()), (1.1, 1.7, 7));
        assert!(linear.windows(2).all(|two| (two[1] - two[0] - 0.1).abs() < 1e-15));
        let log = numbers(Spread::Log(Range { low: 0.5, high: 8.0, count: 5 }));
        let round = numbers(Spread::Linear(Range { low: 0.3, high: 0.7, count: 9 }));
        assert_eq!(round, [0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7]);
        assert!(log.iter().zip([0.5, 1.0, 2.0, 4.0, 8.0]).all(|(value, expected)| (value - expected).abs() < 1e-15));
    }

    #[test]
    fn drawn_values_are_inside_even_and_those_that_another_program_draws() {
        // python3 -c 'import hashlib; print(int(hashlib.sha256(b"1/a/0").hexdigest()[:16], 16) / 2**64)'
        assert!((drawn(1, "a", 0) - PYTHON).abs() < 1e-15, "{}", drawn(1, "a", 0));
        let range = Range { low: 2.0, high: 6.0, count: 10_000 };
        let values = numbers(Spread::Random(range));
        assert!(values.iter().all(|value| (2.0..6.0).contains(value)));
        for quarter in 0..4 {
            let from = 2.0 + f64::from(quarter);
            let share = values.iter().filter(|value| (from..from + 1.0).contains(*value)).count();
            assert!((2300..2700).contains(&share), "{share}");
        }
        assert_ne!(drawn(1, "a", 0), drawn(2, "a", 0));
        assert_ne!(drawn(1, "a", 0), drawn(1, "b", 0));
        assert_ne!(drawn(1, "a", 0), drawn(1, "a", 1));
    }

    const PYTHON: f64 = 0.04900233120093287;
}
