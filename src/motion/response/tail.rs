//! The end of chattering: when infinitely many impacts have accumulated.

use contract::{Departure, Ending, Estimate, FlightSolver, Ground, History, Impact, Uncertainty};

use crate::measure::zeno;

/// A sum is closed once its error is at most this, relative to the time since the threshold.
const ACCURACY: f64 = 1e-13;
/// Impacts are resolved until what is left to the accumulation is this share of the time since the threshold: less is not seen in any picture.
const RESOLVED: f64 = 1e-9;
/// Or until so many have followed since it has been certain that the block comes to rest: more do not help.
const MOST_CERTAIN: usize = 2000;
/// Or so many of which it is known when they end.
const MOST_KNOWN: usize = 250_000;
/// Impacts that closing a sum can use.
const USEFUL_IMPACTS: usize = 64;
/// What a flight solver leaves of rounding in each interval, relative; only for the error estimate of a closed sum.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The last impacts under one kind of ground motion.
#[derive(Default)]
pub(super) struct Tail {
    impacts: Vec<Impact>,
    /// How many impacts there were since rest was certain.
    certain: usize,
    /// When the block rests, where its solver knows without following it.
    known: Option<Estimate>,
}

impl Tail {
    /// When the block rests, once that is certain and known well enough, after an impact at `now` that ended a flight of duration `interval` and left the block
    /// with `departure`. It is certain to be not later than `latest`.
    pub(super) fn rest(
        &mut self,
        solver: &dyn FlightSolver,
        (departure, interval, now): (&Departure, f64, f64),
        eta: f64,
        latest: f64,
    ) -> Option<Estimate> {
        self.push(departure, interval, now);
        if !solver.rests(departure) {
            return None;
        }
        if departure.ground == Ground::Shaking
            && let Some(left) = solver.time_to_rest(departure)
        {
            // Between bounds that close in as the block slows down: no sum of those before, which may have been under another motion.
            let off = left.uncertainty + f64::EPSILON * now;
            let enough = left.value <= RESOLVED * now && off <= ACCURACY * now || self.certain >= MOST_CERTAIN;
            self.certain += 1;
            return enough.then_some(Estimate { value: now + left.value, uncertainty: off });
        }
        let is_exact = |known: &Estimate| known.uncertainty <= ACCURACY * known.value;
        if departure.ground == Ground::Still && (self.certain == 0 || self.known.is_some_and(|known| !is_exact(&known)))
        {
            // Next to the balance it hangs on the last digit of the speed: a later impact knows better.
            let left = solver.time_to_rest(departure);
            let again = left
                .map(|left| Estimate { value: now + left.value, uncertainty: left.uncertainty + f64::EPSILON * now });
            let first = self.known;
            self.known =
                again.filter(|again| first.is_none_or(|first| again.uncertainty < first.uncertainty)).or(first);
        }
        self.certain += 1;
        if let Some(known) = self.known {
            let resolved = known.value - now <= RESOLVED * now || self.certain >= MOST_KNOWN;
            return resolved.then_some(Estimate { value: known.value.max(now), ..known });
        }
        let most = self.certain >= MOST_CERTAIN;
        if !most && self.left(eta) > RESOLVED * now {
            return None;
        }
        let sum = self.close(eta)?;
        let enough = sum.uncertainty <= ACCURACY * sum.value || most;
        enough.then(|| within(sum, now, latest))
    }

    fn push(&mut self, departure: &Departure, interval: f64, time: f64) {
        if self.impacts.len() >= 2 * USEFUL_IMPACTS {
            self.impacts.drain(..USEFUL_IMPACTS);
        }
        let uncertainty = Uncertainty { time: f64::EPSILON * time, interval: ROUNDING, velocity: ROUNDING };
        self.impacts.push(Impact { time, interval, velocity: departure.side * departure.velocity, uncertainty });
    }

    /// What is about left, by Eq. 75.
    fn left(&self, eta: f64) -> f64 {
        let last: f64 = self.impacts.iter().rev().take(2).map(|impact| impact.interval).sum();
        last * eta * eta / (1.0 - eta * eta)
    }

    /// When the infinitely many impacts accumulate.
    fn close(&mut self, eta: f64) -> Option<Estimate> {
        let impacts = std::mem::take(&mut self.impacts);
        let history = History { impacts, ending: Ending::AtRest, chattering_time: None };
        let sum = zeno::close(&history, eta);
        self.impacts = history.impacts;
        sum
    }
}

/// A sum whose estimate may be far off is at least where it is certain to be.
fn within(sum: Estimate, now: f64, latest: f64) -> Estimate {
    if sum.value >= now && sum.value <= latest {
        return sum;
    }
    let value = if sum.value > latest { latest } else { now };
    Estimate { value, uncertainty: sum.uncertainty.max(latest - now) }
}

#[cfg(test)]
mod tests {
    use contract::Arrival;

    use super::*;

    /// A solver that knows when free rocking ends, by the speed of an impact.
    struct Knows(fn(f64) -> Estimate);

    impl FlightSolver for Knows {
        fn fly(&self, _: &Departure, _: f64) -> Arrival {
            Arrival::Lost(contract::Loss::Stalled)
        }

        fn motion(&self, _: &Departure, _: f64) -> (f64, f64) {
            (0.0, 0.0)
        }

        fn rests(&self, _: &Departure) -> bool {
            true
        }

        fn time_to_rest(&self, departure: &Departure) -> Option<Estimate> {
            Some((self.0)(departure.velocity))
        }
    }

    /// 2 after any impact, to a thousandth.
    const ROUGHLY: Estimate = Estimate { value: 2.0, uncertainty: 1e-3 };

    /// An estimate next to the balance, which may be far too late, is not waited for: the impacts would be followed until nothing is left of their speed.
    #[test]
    fn a_later_impact_may_know_better() {
        let fast = Departure { ground: Ground::Still, time: 0.0, side: 1.0, rotation: 0.0, velocity: 0.999 };
        let slow = Departure { velocity: 0.1, ..fast };
        let learns = Knows(|speed| if speed < 0.5 { Estimate { value: 1e-11, uncertainty: 1e-25 } } else { ROUGHLY });
        let mut tail = Tail::default();
        assert_eq!(tail.rest(&learns, (&fast, 1.0, 3.0), 0.9, f64::INFINITY), None);
        let rest = tail.rest(&learns, (&slow, 1.0, 4.0), 0.9, f64::INFINITY).unwrap();
        assert!(rest.value >= 4.0 && rest.value < 4.1 && rest.uncertainty < 1e-14, "{rest:?}");
    }

    /// What the solver claims for its sum is claimed for the end of the bout, from the first impact that it is certain of, and no less later on.
    #[test]
    fn the_sum_of_free_rocking_keeps_its_claim() {
        let departure = Departure { ground: Ground::Still, time: 0.0, side: 1.0, rotation: 0.0, velocity: 1e-3 };
        let knows = Knows(|_| ROUGHLY);
        let mut tail = Tail::default();
        assert_eq!(
            tail.rest(&knows, (&departure, 1.0, 3.0), 0.9, f64::INFINITY),
            None,
            "impacts are followed until nothing is left to be seen"
        );
        let rest = tail.rest(&knows, (&departure, 1.0, 5.0), 0.9, f64::INFINITY);
        assert!(rest.is_some_and(|rest| rest.value == 5.0 && (1e-3..1.001e-3).contains(&rest.uncertainty)), "{rest:?}");
    }
}
