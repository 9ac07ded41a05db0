//! A case as the key of a memory.

use contract::{Case, Horizon, Normalisation};

/// Equal for the same case, bit for bit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Key {
    numbers: [u64; 3],
    slenderness: Option<(u64, Normalisation)>,
    impacts: usize,
    until: Option<u64>,
}

impl From<&Case> for Key {
    fn from(case: &Case) -> Self {
        Self {
            numbers: [case.epsilon(), case.omega(), case.eta()].map(f64::to_bits),
            slenderness: case.slenderness().map(|block| (block.alpha().to_bits(), block.normalisation())),
            impacts: case.max_impacts(),
            until: match case.horizon() {
                Horizon::HalfPeriod => None,
                Horizon::Until(time) => Some(time.to_bits()),
            },
        }
    }
}
