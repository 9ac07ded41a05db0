//! Which cases are side by side in the lanes.

use super::{CHUNK, Work, motion::SHORT};

/// How many bits tell the cases of a chunk apart.
const BITS: u32 = CHUNK.ilog2();

/// The cases in the order in which they are put into lanes: those of similar length side by side, because lanes whose flights ask for different
/// numbers of terms wait for each other. Intervals fall from `4 sqrt(2ε + ε²)/ω` by about `η` an impact, so that the number of impacts until a flight
/// is short goes as `log(32ε max(1, 1/ω²)/SHORT²)/log(1/η²)`.
pub(super) fn alike(work: &Work) -> [u16; CHUNK] {
    let mut keys = [u32::MAX; CHUNK];
    let cases = work.epsilon.iter().zip(work.omega).zip(work.eta).zip(0u32..);
    for (key, (((epsilon, omega), eta), case)) in keys.iter_mut().zip(cases) {
        let first = rough_log2(32.0 * epsilon / (SHORT.1 * SHORT.1)) - 2.0 * rough_log2(omega.min(1.0));
        let length = first / -rough_log2(eta * eta);
        *key = (((16.0 * length.clamp(0.0, 100_000.0)) as u32) << BITS) | case;
    }
    keys.sort_unstable();
    keys.map(|key| (key & ((1 << BITS) - 1)) as u16)
}

/// The logarithm of a positive number to within 0.09: the exponent, and the fraction for the rest.
fn rough_log2(x: f64) -> f64 {
    x.to_bits() as f64 * (-52f64).exp2() - 1023.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shorter_cases_are_taken_first() {
        let (epsilon, omega, eta) =
            ([0.03, 0.01, 0.02, -0.5, 0.02], [2.0, 2.0, 0.5, 2.0, 2.0], [0.9, 0.8, 0.95, 0.9, 0.6]);
        let order = alike(&Work { epsilon: &epsilon, omega: &omega, eta: &eta, impacts: 60 });
        // What never rocks is last.
        assert_eq!(order[..5], [4, 1, 0, 2, 3]);
    }

    #[test]
    fn a_logarithm_from_the_bits_is_right_to_a_tenth() {
        for x in [1e-9, 0.3, 0.5, 1.0, 1.4, 3.0, 1e10] {
            assert!((rough_log2(x) - f64::log2(x)).abs() < 0.09, "{x}");
        }
    }
}
