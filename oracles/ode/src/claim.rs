//! What a history claims: the difference between two runs at different tolerances, the coarser of which stands for the error of the
//! finer one.

use contract::{History, Uncertainty};

/// How much coarser the second run is.
pub(crate) const COARSER: f64 = 10.0;
/// How much of the difference is claimed. Calibrated, with the floor of each method, against Eq. 6 in 100 digits.
const SAFETY: f64 = 2.0;
/// The rounding that both runs share, relative.
const ROUNDING: f64 = 2e-14;

/// The difference of two runs, relative.
#[derive(Debug, Clone, Copy)]
struct Difference {
    time: f64,
    /// Of interval or velocity, whichever is larger: each of them passes through zero now and then, both at once they seldom do.
    shape: f64,
}

impl Difference {
    const UNKNOWN: Self = Self { time: f64::INFINITY, shape: f64::INFINITY };

    fn max(self, other: Self) -> Self {
        Self { time: self.time.max(other.time), shape: self.shape.max(other.shape) }
    }
}

/// Sets the claims of `fine`, which was run at the tolerance `rtol`, from its difference with `coarse`; `floor` times the tolerance is
/// claimed at least.
///
/// The claim at an impact is the largest difference up to it, because differences change their sign. It therefore grows with the
/// conditioning of the case, without bound near the critical amplitude. Impacts that `coarse` does not have are claimed not to be known
/// at all, and so is the last one when the two runs end differently.
pub(crate) fn claim(fine: &mut History, coarse: &History, rtol: f64, floor: f64) {
    let agreed = fine.ending == coarse.ending && fine.impacts.len() == coarse.impacts.len();
    let compared = if agreed { fine.impacts.len() } else { fine.impacts.len().saturating_sub(1) };
    let others = coarse.impacts.iter().map(Some).take(compared).chain(core::iter::repeat(None));
    let least = floor * rtol + ROUNDING;
    let mut worst = Difference { time: 0.0, shape: 0.0 };
    for (impact, other) in fine.impacts.iter_mut().zip(others) {
        worst = worst.max(other.map_or(Difference::UNKNOWN, |other| {
            let interval = (impact.interval / other.interval - 1.0).abs();
            let velocity = (impact.velocity / other.velocity - 1.0).abs();
            Difference { time: (impact.time / other.time - 1.0).abs(), shape: interval.max(velocity) }
        }));
        let shape = SAFETY * worst.shape + least;
        let time = (SAFETY * worst.time + least) * impact.time;
        impact.uncertainty = Uncertainty { time, interval: shape, velocity: shape };
    }
}
