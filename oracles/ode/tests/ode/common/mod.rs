//! What the tests share: cases, and a generator for them that is the same everywhere.
#![allow(dead_code, reason = "each test file uses a part of it")]

use contract::{Case, History};
use ode::{Equation, Ode, Solver};

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        low + (high - low) * ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A case of weak excitation, where most chattering is complete.
    pub fn case(&mut self) -> Case {
        case(self.between(1.005, 1.035), self.between(0.5, 8.0), self.between(0.80, 0.95))
    }
}

pub fn case(a: f64, omega: f64, eta: f64) -> Case {
    Case::from_amplitude(a, omega, eta).unwrap_or_else(|e| panic!("{e}"))
}

pub fn linear(method: Solver) -> Ode {
    Ode::new(Equation::Linear, method)
}

pub fn impacts(ode: &Ode, case: &Case) -> History {
    ode.impacts(case).unwrap_or_else(|decline| panic!("{decline}"))
}
