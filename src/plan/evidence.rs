//! Random questions, for tests and measurements: always the same.

use contract::{Case, Invalid, Normalisation, Slenderness};
use proptest::{
    strategy::{Strategy, ValueTree as _},
    test_runner::{Config, RngSeed, TestRunner},
};

use super::Question;
use crate::measure::critical;

/// `many` questions from the seed: `α` from 0.02 to 0.5, `η` from 0.5 to 0.97, `ω` from 0.5 to 8, tolerances from 1e-2 to 1e-10; half of the amplitudes from the
/// threshold to `a_cr`, half from 0.9 to 1.2 times `a_cr`.
///
/// # Errors
/// Never, as far as these are in range.
pub fn questions(seed: u64, many: usize) -> Result<Vec<Question>, Invalid> {
    let mut runner = TestRunner::new(Config { rng_seed: RngSeed::Fixed(seed), ..Config::default() });
    let log_omega = 0.5_f64.ln()..8.0_f64.ln();
    let strategy = (0.0..2.0f64, log_omega, 0.5..0.97f64, 0.02..0.5f64, -10.0..-2.0f64);
    let draw = |_| {
        let tree = strategy.new_tree(&mut runner).map_err(|why| Invalid::new("seed", why, "any"))?;
        let (place, log_omega, eta, alpha, digits) = tree.current();
        let omega = log_omega.exp();
        let critical = critical::interpolated(omega, eta)?;
        let epsilon = if place < 1.0 { place * critical } else { (0.9 + 0.3 * (place - 1.0)) * (1.0 + critical) - 1.0 };
        let slenderness = Slenderness::new(alpha, Normalisation::Threshold)?;
        let case = Case::from_epsilon(epsilon, omega, eta)?.with_slenderness(slenderness);
        Ok(Question::new(case, 10.0_f64.powf(digits)))
    };
    (0..many).map(draw).collect()
}
