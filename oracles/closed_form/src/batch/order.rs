//! Which cases are side by side in the lanes.

use super::{CHUNK, Work, motion::SHORT};

/// How many cases that become short at the same impact of the first side are put in the order of the other side.
const STRIP: usize = 32;

/// The cases in the order in which they are put into lanes: those whose flights become short at about the same impacts side by side, because lanes whose
/// flights ask for different numbers of terms wait for each other.
///
/// Of the flights to the first side the first lasts `4c/ω` with `c = sqrt(2ε)` (Eq. 31). It lands with the speed `8c³/(3ω)`, and the second flight, against twice the
/// pull of gravity, lasts as long as that times `η`. In the end those to a side fall by `η²` from one to the next. That this is not so at first
/// changes little in their order.
pub(super) fn alike(work: &Work) -> [u16; CHUNK] {
    let mut keys = [u64::MAX; CHUNK];
    let cases = work.epsilon.iter().zip(work.omega).zip(work.eta).zip(0u64..);
    for (key, (((epsilon, omega), eta), case)) in keys.iter_mut().zip(cases) {
        // max(1, ω) times an interval tells which is short.
        let slow = omega.min(1.0);
        let cosine_squared = 2.0 * epsilon;
        let first = rough_log2(16.0 * cosine_squared / (SHORT.1 * slow * SHORT.1 * slow));
        let second = rough_log2(8.0 / 3.0 * eta / (SHORT.1 * slow)) + 1.5 * rough_log2(cosine_squared);
        let fall = -rough_log2(*eta);
        *key = whole(first / fall) << 40 | whole(second / fall) << 16 | case;
    }
    keys.sort_unstable();
    for strip in keys.chunks_mut(STRIP) {
        strip.sort_unstable_by_key(|key| key & 0xff_ffff_ffff);
    }
    keys.map(|key| (key & 0xffff) as u16)
}

/// A measure of a number of impacts, of 24 bits at the most.
fn whole(impacts: f64) -> u64 {
    (16.0 * impacts.clamp(0.0, 1e6)) as u64
}

/// The logarithm of a positive number to within 0.09: the exponent, and the fraction for the rest.
fn rough_log2(x: f64) -> f64 {
    x.to_bits() as f64 * (-52f64).exp2() - 1023.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::{Batch, Rows, Sequence};

    const IMPACTS: usize = 60;

    /// Cases all over the workload, without any order.
    fn cases() -> [Vec<f64>; 3] {
        let spread = |low: f64, high: f64, step: f64| -> Vec<f64> {
            (0..CHUNK).map(|case| low + (high - low) * (case as f64 * step).fract()).collect()
        };
        [spread(0.005, 0.035, 0.754_877), spread(0.5, 8.0, 0.569_840), spread(0.8, 0.95, 0.618_034)]
    }

    /// At which impact of each side a case becomes short.
    fn short_from([epsilon, omega, eta]: &[Vec<f64>; 3]) -> Vec<[usize; 2]> {
        let mut interval = vec![0.0; CHUNK * IMPACTS];
        let (mut time, mut velocity) = (interval.clone(), interval.clone());
        let rows = Rows {
            time: &mut time,
            interval: &mut interval,
            velocity: &mut velocity,
            sequences: &mut [Sequence::default(); CHUNK],
        };
        Batch::new(epsilon, omega, eta, IMPACTS).unwrap().run(rows).unwrap();
        let rows = interval.chunks(IMPACTS).zip(omega);
        rows.map(|(row, omega)| {
            [0, 1].map(|side| {
                let mut flights = row.iter().skip(side).step_by(2);
                flights.position(|interval| omega.max(1.0) * interval < SHORT.1).unwrap_or(IMPACTS / 2)
            })
        })
        .collect()
    }

    /// How many impacts of a side lanes next to each other are apart, in the mean.
    fn distance(order: &[u16], short_from: &[[usize; 2]], side: usize) -> f64 {
        let lanes = order.chunks(4).map(|lanes| {
            let impacts = lanes.iter().map(|case| short_from[usize::from(*case)][side]);
            (impacts.clone().max().unwrap() - impacts.min().unwrap()) as f64
        });
        lanes.sum::<f64>() / (order.len() / 4) as f64
    }

    #[test]
    fn cases_side_by_side_become_short_at_about_the_same_impact() {
        let cases = cases();
        let short_from = short_from(&cases);
        let [epsilon, omega, eta] = &cases;
        let ordered = alike(&Work { epsilon, omega, eta, impacts: IMPACTS });
        let unordered: Vec<u16> = (0..CHUNK as u16).collect();
        for side in [0, 1] {
            let [with, without] = [&ordered[..], &unordered].map(|order| distance(order, &short_from, side));
            assert!(with < 0.3 * without, "side {side}: {with} instead of {without}");
        }
    }

    #[test]
    fn every_case_is_taken_once() {
        let [epsilon, omega, mut eta] = cases();
        let eta = &mut eta;
        for (case, eta) in eta.iter_mut().enumerate() {
            *eta = if case % 3 == 0 { 1e-300 } else { 1.0 - f64::EPSILON / 2.0 };
        }
        let mut order = alike(&Work { epsilon: &epsilon, omega: &omega, eta, impacts: 1 });
        order.sort_unstable();
        assert!(order.iter().copied().eq(0..CHUNK as u16));
    }

    #[test]
    fn a_logarithm_from_the_bits_is_right_to_a_tenth() {
        for x in [1e-9, 0.3, 0.5, 1.0, 1.4, 3.0, 1e10] {
            assert!((rough_log2(x) - f64::log2(x)).abs() < 0.09, "{x}");
        }
    }
}
