//! What a history claims: its differences to two runs at coarser tolerances. The error of a coarse run stands for that of the finer one;
//! where it happens to be the same, and the difference small by accident, that to the coarser run is not.

use contract::{History, Impact, Uncertainty};

use crate::{Flights, Ode, Solver};

/// The rounding that both runs share, relative.
const ROUNDING: f64 = 2e-14;
/// Below this tolerance rounding begins to show, and two runs below it would differ by less than either is wrong.
const ROUNDED: f64 = 1e-11;
/// A relative difference above which the errors of the two runs are no longer small perturbations of the same sequence, so that one
/// says nothing about the other. It happens next to the critical amplitude.
const DIVERGED: f64 = 0.05;
/// After how many flights the local errors, which have a sign in common, have added up to as much again as is claimed at least.
const MANY: f64 = 100.0;
/// Twice the width to which diffsol narrows a root down on a clock that shows the time 1.
const ROOT_WIDTH: f64 = 200.0 * f64::EPSILON;

/// The tolerances of the two coarser runs, for a history at the tolerance `rtol`.
pub(crate) fn tolerances(rtol: f64) -> [f64; 2] {
    let coarse = (10.0 * rtol).max(ROUNDED);
    [coarse, 10.0 * coarse]
}

/// By how much the error of a history at the tolerance `rtol` is a smaller part of its difference to the coarse run than it is where that run is
/// ten times as coarse: errors follow the tolerance.
fn finer(rtol: f64) -> f64 {
    let [coarse, _] = tolerances(rtol);
    10.0 * rtol / coarse
}

/// How a difference becomes a claim, for one method.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Calibration {
    /// How much is claimed of the differences to runs ten and a hundred times as coarse.
    safety: [f64; 2],
    /// What is claimed at least, in units of the tolerance.
    floor: f64,
}

impl Calibration {
    /// Against proven enclosures, by `chattercheck verify --judge all`: no claim of the default run is smaller than the true error, and the median
    /// is some 30 to 90 times as large. The coarse run alone, with larger safeties, fell short in one case of 2,000.
    pub fn of(method: Solver) -> Self {
        match method {
            Solver::Tsit45 => Self { safety: [2.4, 0.24], floor: 3.2 },
            // Its order varies, so its error follows the tolerance less smoothly than the others do.
            Solver::Bdf => Self { safety: [2.5, 0.2], floor: 125.0 },
            Solver::TrBdf2 | Solver::Esdirk34 => Self { safety: [4.0, 0.6], floor: 7.0 },
        }
    }
}

/// The difference of two runs, relative.
#[derive(Debug, Clone, Copy)]
struct Difference {
    time: f64,
    /// Of interval or velocity, whichever is larger: each of them passes through zero now and then, both at once they seldom do.
    shape: f64,
}

impl Difference {
    const UNKNOWN: Self = Self { time: f64::INFINITY, shape: f64::INFINITY };

    fn between(fine: &Impact, coarse: &Impact) -> Self {
        let interval = (fine.interval / coarse.interval - 1.0).abs();
        let velocity = (fine.velocity / coarse.velocity - 1.0).abs();
        Self { time: (fine.time / coarse.time - 1.0).abs(), shape: interval.max(velocity) }
    }

    fn max(self, other: Self) -> Self {
        Self { time: self.time.max(other.time), shape: self.shape.max(other.shape) }
    }

    fn plus(self, other: Self) -> Self {
        Self { time: self.time + other.time, shape: self.shape + other.shape }
    }

    fn times(self, factor: f64) -> Self {
        Self { time: factor * self.time, shape: factor * self.shape }
    }
}

/// The differences of `fine` to a coarse run, impact by impact: the largest up to each, because differences change their sign. Unknown
/// from where the two are different sequences, and where one has no impact any more, or they end differently.
fn differences(fine: &History, coarse: &History) -> Vec<Difference> {
    let agreed = fine.ending == coarse.ending && fine.impacts.len() == coarse.impacts.len();
    let compared = if agreed { fine.impacts.len() } else { fine.impacts.len().saturating_sub(1) };
    let others = coarse.impacts.iter().map(Some).take(compared).chain(core::iter::repeat(None));
    let pairs = fine.impacts.iter().zip(others);
    pairs
        .scan(Difference { time: 0.0, shape: 0.0 }, |worst, (impact, other)| {
            let difference = other.map_or(Difference::UNKNOWN, |other| Difference::between(impact, other));
            *worst = worst.max(if difference.shape < DIVERGED { difference } else { Difference::UNKNOWN });
            Some(*worst)
        })
        .collect()
}

/// Sets the claims of `fine`, which is what `ode` found, from its differences to the two coarser runs.
///
/// A claim grows with the conditioning of the case, without bound near the critical amplitude, and never falls again.
pub(crate) fn claim(ode: &Ode, fine: &mut History, coarse: &History, coarser: &History) {
    let Calibration { safety, floor } = Calibration::of(ode.method());
    let [much, little] = safety.map(|safety| safety * finer(ode.rtol()));
    let least = |flights: f64| floor * ode.rtol() * (1.0 + flights / MANY) + ROUNDING;
    // A root on the global clock is as wide for a short flight as for a long one, at any tolerance, and what it adds to the velocity
    // stays there.
    let root_width = match ode.flights() {
        Flights::Rescaled => 0.0,
        Flights::Naive => ROOT_WIDTH,
    };
    let (to_coarse, to_coarser) = (differences(fine, coarse), differences(fine, coarser));
    let mut roots = 0.0;
    for (((impact, near), far), flights) in fine.impacts.iter_mut().zip(to_coarse).zip(to_coarser).zip(1_u32..) {
        // Where the coarser run is another sequence already it can't show an accident, and there are more of them.
        let known =
            if far.shape.is_finite() { near.times(much).plus(far.times(little)) } else { near.times(3.0 * much) };
        // A claim as wide as that is a guess.
        let total = if known.shape < DIVERGED { known } else { Difference::UNKNOWN };
        roots += root_width * impact.time / impact.interval;
        let shape = total.shape + roots + least(f64::from(flights));
        let time = (total.time + root_width + least(f64::from(flights))) * impact.time;
        impact.uncertainty = Uncertainty { time, interval: shape, velocity: shape };
    }
}

/// How many times the rounding of `epsilon` an impact is off by: its time goes with the root of `epsilon`, and its velocity with the power 3/2, and as many
/// times as much again for what the runs at coarser tolerances say of the conditioning.
const OF_EPSILON: f64 = 4.0;

/// Adds to the claims of `history` what the rounding of `epsilon` does, relative, which all runs share.
pub(crate) fn widen(history: &mut History, rounding: f64) {
    // So much is no small perturbation any more.
    let off = if rounding < DIVERGED { OF_EPSILON * rounding } else { f64::INFINITY };
    if off > 0.0 {
        for Impact { time, uncertainty: claim, .. } in &mut history.impacts {
            claim.time += off * *time;
            claim.interval += off;
            claim.velocity += off;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Equation;
    use contract::{Ending, Limit};

    fn history(intervals: &[f64], ending: Ending) -> History {
        let claimed_nothing = Uncertainty { time: f64::INFINITY, interval: f64::INFINITY, velocity: f64::INFINITY };
        let mut time = 0.0;
        let impact = |&interval: &f64| {
            time += interval;
            Impact { time, interval, velocity: interval, uncertainty: claimed_nothing }
        };
        History { impacts: intervals.iter().map(impact).collect(), ending, chattering_time: None }
    }

    fn at(method: Solver, rtol: f64) -> Ode {
        Ode::new(Equation::Linear, method).with_rtol(rtol).unwrap_or_else(|e| panic!("{e}"))
    }

    fn claims(fine: &[f64], coarse: &[f64], endings: (Ending, Ending)) -> Vec<f64> {
        let mut fine = history(fine, endings.0);
        let ode = at(Solver::Tsit45, 1e-12);
        let coarse = history(coarse, endings.1);
        claim(&ode, &mut fine, &coarse, &coarse);
        fine.impacts.iter().map(|impact| impact.uncertainty.interval).collect()
    }

    const FULL: Ending = Ending::LimitReached(Limit::Impacts);

    #[test]
    fn a_claim_never_falls_again() {
        let found = claims(&[1.0, 0.5, 0.25], &[1.0, 0.5 * (1.0 + 1e-6), 0.25], (FULL, FULL));
        assert!(matches!(found[..], [a, b, c] if a < 1e-9 && b > 1.9e-6 && c >= b), "{found:?}");
    }

    #[test]
    fn what_the_coarse_run_does_not_have_is_not_known() {
        let found = claims(&[1.0, 0.5, 0.25], &[1.0], (FULL, Ending::Incomplete));
        assert!(matches!(found[..], [a, b, c] if a < 1e-9 && b.is_infinite() && c.is_infinite()), "{found:?}");
        let found = claims(&[1.0, 0.5], &[1.0, 0.5, 0.25], (Ending::Incomplete, FULL));
        assert!(matches!(found[..], [a, b] if a < 1e-9 && b.is_infinite()), "{found:?}");
    }

    /// Time, interval and velocity of each impact, off by a part of themselves.
    fn off(history: &History, by: [f64; 3]) -> History {
        let mut other = history.clone();
        for impact in &mut other.impacts {
            impact.time /= 1.0 + by[0];
            impact.interval /= 1.0 + by[1];
            impact.velocity /= 1.0 + by[2];
        }
        other
    }

    /// What is claimed of `count` impacts of which both coarser runs are off by so much.
    fn claimed(ode: &Ode, count: usize, coarse: [f64; 3], coarser: [f64; 3]) -> Vec<Impact> {
        let mut fine = history(&vec![0.25; count], FULL);
        let others = [coarse, coarser].map(|by| off(&fine, by));
        claim(ode, &mut fine, &others[0], &others[1]);
        fine.impacts
    }

    fn is_near(a: f64, b: f64) -> bool {
        (a / b - 1.0).abs() < 1e-9
    }

    #[test]
    fn coarse_runs_are_ten_and_a_hundred_times_as_coarse_but_never_in_the_rounding() {
        let near =
            |found: [f64; 2], expected: [f64; 2]| is_near(found[0], expected[0]) && is_near(found[1], expected[1]);
        assert!(near(tolerances(1e-9), [1e-8, 1e-7]) && near(tolerances(1e-13), [1e-11, 1e-10]));
    }

    #[test]
    fn a_claim_is_made_of_both_differences() {
        for method in Solver::ALL {
            let Calibration { safety: [much, little], .. } = Calibration::of(method);
            let ode = at(method, 1e-9);
            // The larger of interval and velocity counts for both.
            for (near, far) in [([3e-3, 1e-3, 2e-3], [6e-3, 5e-3, 1e-3]), ([1e-3, -2e-3, -1e-3], [-6e-3, 1e-3, -5e-3])]
            {
                for impact in claimed(&ode, 3, near, far) {
                    let claim = impact.uncertainty;
                    let (time, shape) = (much * near[0].abs() + little * 6e-3, much * 2e-3 + little * 5e-3);
                    assert!((claim.time / impact.time / time - 1.0).abs() < 1e-3, "{claim:?}");
                    assert!(
                        (claim.interval / shape - 1.0).abs() < 1e-3 && claim.velocity == claim.interval,
                        "{claim:?}"
                    );
                }
            }
            // The coarser run is another sequence: three times as much is claimed of the coarse one. Both are: nothing is known.
            let [impact, ..] = claimed(&ode, 1, [1e-3; 3], [0.06; 3])[..] else { panic!("no impact") };
            assert!((impact.uncertainty.interval / (3.0 * much * 1e-3) - 1.0).abs() < 1e-3);
            let [impact, ..] = claimed(&ode, 1, [0.06; 3], [0.06; 3])[..] else { panic!("no impact") };
            assert!(impact.uncertainty.interval.is_infinite() && impact.uncertainty.time.is_infinite());
            // As wide as that it is a guess.
            let [impact, ..] = claimed(&ode, 1, [0.049 / much; 3], [0.049; 3])[..] else { panic!("no impact") };
            assert!(impact.uncertainty.interval.is_infinite());
        }
    }

    #[test]
    fn at_least_the_tolerance_is_claimed_and_more_after_many_flights() {
        for method in Solver::ALL {
            let ode = Ode::new(Equation::Linear, method);
            let least = Calibration::of(method).floor * ode.rtol();
            for (flights, impact) in (1_u32..).zip(claimed(&ode, 200, [0.0; 3], [0.0; 3])) {
                let expected = least * (1.0 + f64::from(flights) / 100.0) + 2e-14;
                assert!(is_near(impact.uncertainty.interval, expected), "{method} {flights}");
                assert!(is_near(impact.uncertainty.time, expected * impact.time), "{method} {flights}");
            }
        }
    }

    /// The width of a root on the clock that shows `t` is `t` times that at 1, and each flight keeps those of all before it.
    #[test]
    fn on_the_global_clock_roots_are_as_wide_as_the_clock_is_late() {
        let ode = Ode::new(Equation::Linear, Solver::Tsit45);
        let rescaled = claimed(&ode, 5, [0.0; 3], [0.0; 3]);
        let naive = claimed(&ode.with_flights(Flights::Naive), 5, [0.0; 3], [0.0; 3]);
        let mut roots = 0.0;
        for (n, (naive, rescaled)) in (1_u32..).zip(naive.iter().zip(&rescaled)) {
            // All intervals are the same here: the clock shows n of them.
            roots += 200.0 * f64::EPSILON * f64::from(n);
            let more = naive.uncertainty.interval - rescaled.uncertainty.interval;
            assert!((more / roots - 1.0).abs() < 1e-9, "{n}: {more:e} {roots:e}");
            let more = (naive.uncertainty.time - rescaled.uncertainty.time) / naive.time;
            assert!((more / (200.0 * f64::EPSILON) - 1.0).abs() < 1e-9, "{n}: {more:e}");
        }
    }

    #[test]
    fn of_a_difference_to_runs_that_are_coarser_still_less_is_claimed() {
        let claim_at = |rtol: f64| match claimed(&at(Solver::Tsit45, rtol), 1, [1e-3; 3], [2e-3; 3])[..] {
            [impact] => impact.uncertainty.interval,
            _ => panic!("one impact"),
        };
        // The coarse run is at 1e-11 for all of them.
        assert!((claim_at(4e-13) / claim_at(1e-12) - 0.4).abs() < 1e-6);
        assert!((claim_at(1e-13) / claim_at(1e-12) - 0.1).abs() < 1e-6);
        assert!((claim_at(1e-11) / claim_at(1e-12) - 1.0).abs() < 1e-6);
    }
}
