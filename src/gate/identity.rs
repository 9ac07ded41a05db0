//! Which cases were run: a count and a hash, so that a case that got lost on the way is noticed.

use contract::{Case, Horizon, Normalisation};
use serde::{Deserialize, Serialize};

use crate::cases::generate::Named;

/// How many cases, and a hash of their names and numbers that does not depend on their order: those of partitions add up to that of the whole.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Identity {
    /// How many.
    pub cases: usize,
    /// The sum of the hashes of each.
    #[serde(with = "hexadecimal")]
    pub hash: u64,
}

impl Identity {
    /// Of one case.
    pub fn of(named: &Named) -> Self {
        let mut hash = FNV_OFFSET;
        let mut eat =
            |bytes: &[u8]| bytes.iter().for_each(|&byte| hash = (hash ^ u64::from(byte)).wrapping_mul(FNV_PRIME));
        eat(named.to_string().as_bytes());
        numbers(&named.case).into_iter().for_each(|number| eat(&number.to_le_bytes()));
        Self { cases: 1, hash }
    }

    /// Of several.
    pub fn of_all<'a>(cases: impl IntoIterator<Item = &'a Named>) -> Self {
        let mut all = Self::default();
        cases.into_iter().for_each(|named| all.add(Self::of(named)));
        all
    }

    /// Adds others.
    pub fn add(&mut self, other: Self) {
        self.cases += other.cases;
        self.hash = self.hash.wrapping_add(other.hash);
    }
}

/// Fowler, Noll and Vo's hash (FNV-1a) of 64 bits.
const FNV_OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const FNV_PRIME: u64 = 0x0100_0000_01b3;

fn numbers(case: &Case) -> [u64; 7] {
    let slenderness = case.slenderness();
    let until = match case.horizon() {
        Horizon::HalfPeriod => f64::NEG_INFINITY,
        Horizon::Until(time) => time,
    };
    [
        case.epsilon().to_bits(),
        case.omega().to_bits(),
        case.eta().to_bits(),
        slenderness.map_or(0, |slenderness| slenderness.alpha().to_bits()),
        u64::from(slenderness.is_some_and(|slenderness| slenderness.normalisation() == Normalisation::Slender)),
        case.max_impacts() as u64,
        until.to_bits(),
    ]
}

/// As text, since JSON's numbers lose the digits of 64 bits in many readers.
mod hexadecimal {
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    pub fn serialize<S: Serializer>(hash: &u64, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(&format!("{hash:016x}"))
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<u64, D::Error> {
        u64::from_str_radix(&String::deserialize(from)?, 16).map_err(D::Error::custom)
    }
}
