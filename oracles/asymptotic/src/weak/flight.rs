//! One flight after another under a weak push, every quantity a series in the root of how weak it is.

use crate::march::Impact;
use crate::series::Series;

/// What pushes the block out of rest, in the units in which it is of order 1: `y'' = W + lift y` on the side it pushes to, with `W = (|f| - 1)/level`, time in units of
/// `unit` and rotation in those of `level unit²`. On the other side `y'' = lift y - 2/level - W`, and flights last of the order of `level`.
///
/// Each entry of a series is a term as it is; its place is the power of what is small.
#[derive(Debug, Clone)]
pub(super) struct Push {
    /// `W` at the start, and its derivatives.
    pub derivatives: Vec<Series<f64>>,
    /// Times after the start at which the slope of `W` changes, in order, and by how much; all of them in the first flight, while `W > 0`.
    pub kinks: Vec<(f64, f64)>,
    /// `unit²`: what the rotation itself adds.
    pub lift: Series<f64>,
    /// `level`.
    pub level: Series<f64>,
}

/// The block after an impact.
#[derive(Debug, Clone)]
pub(super) struct Flights {
    eta: f64,
    lift: Series<f64>,
    level: Series<f64>,
    kinks: Vec<(f64, f64)>,
    /// Time since the start.
    time: Series<f64>,
    speed: Series<f64>,
    /// `W` now, and its derivatives.
    derivatives: Vec<Series<f64>>,
}

impl Flights {
    pub fn new(Push { derivatives, kinks, lift, level }: Push, eta: f64) -> Self {
        let zero = Series::constant(0.0, level.terms());
        Self { eta, lift, level, kinks, time: zero.clone(), speed: zero, derivatives }
    }

    /// The next flight, on the side of the push if it is an even one; `None` if it does not end.
    pub fn fly(&mut self, even: bool) -> Option<Impact<f64>> {
        let zero = Series::constant(0.0, self.time.terms());
        let before = self.time.clone();
        let mut rotation = zero.clone();
        // To the last kink, all of which are in the first flight.
        for (at, change) in std::mem::take(&mut self.kinks) {
            let to = Series::constant(at, zero.terms()).minus(&self.time);
            let heights = heights(&rotation, &self.speed, &self.lift, &self.derivatives);
            let (height, speed) = at_time(&heights, &to);
            (rotation, self.speed) = (height, speed);
            self.advance(&to);
            if let Some(slope) = self.derivatives.get_mut(1) {
                slope.add(1.0, &Series::constant(change, zero.terms()));
            }
        }
        let other = (!even).then(|| self.on_the_other_side());
        let (lift, pushes) = other.as_ref().map_or((&self.lift, &self.derivatives), |(lift, pushes)| (lift, pushes));
        let heights = heights(&rotation, &self.speed, lift, pushes);
        let duration = land(&heights)?;
        self.speed = at_time(&heights, &duration).1.scaled(-self.eta);
        let duration = if even { duration } else { duration.times(&self.level) };
        self.advance(&duration);
        Some(Impact { interval: self.time.minus(&before), time: self.time.clone(), velocity: self.speed.clone() })
    }

    /// The lift and the push on the other side, with time in units of the level.
    fn on_the_other_side(&self) -> (Series<f64>, Vec<Series<f64>>) {
        let mut unit = self.level.clone();
        let mut pushes = Vec::with_capacity(self.derivatives.len());
        for derivative in &self.derivatives {
            pushes.push(derivative.times(&unit).scaled(-1.0));
            unit = unit.times(&self.level);
        }
        if let Some(pull) = pushes.first_mut() {
            pull.add(1.0, &Series::constant(-2.0, self.level.terms()));
        }
        (self.lift.times(&self.level).times(&self.level), pushes)
    }

    /// The push a duration later.
    fn advance(&mut self, duration: &Series<f64>) {
        let mut powers = vec![Series::constant(1.0, duration.terms())];
        for k in 1..self.derivatives.len() {
            let next = powers.last().map(|power| duration.times(power).scaled(1.0 / k as f64));
            powers.extend(next);
        }
        let later = |k: usize| {
            let left = self.derivatives.iter().skip(k).zip(&powers);
            left.fold(Series::constant(0.0, duration.terms()), |sum, (derivative, power)| {
                sum.plus(&derivative.times(power))
            })
        };
        self.derivatives = (0..self.derivatives.len()).map(later).collect();
        self.time = self.time.plus(duration);
    }
}

/// The coefficients of `y` by the powers of the time since the start: `(k+1)(k+2) y_{k+2} = lift y_k + W_k/k!`.
fn heights(
    rotation: &Series<f64>,
    speed: &Series<f64>,
    lift: &Series<f64>,
    derivatives: &[Series<f64>],
) -> Vec<Series<f64>> {
    let mut heights = vec![rotation.clone(), speed.clone()];
    let mut factorial = 1.0;
    // Two more powers of time are two more of what is small.
    for k in 0..derivatives.len().max(rotation.terms() + 4) {
        factorial *= (k as f64).max(1.0);
        let Some(height) = heights.get(k) else { break };
        let mut next = lift.times(height);
        if let Some(derivative) = derivatives.get(k) {
            next.add(1.0 / factorial, derivative);
        }
        heights.push(next.scaled(1.0 / ((k + 1) as f64 * (k + 2) as f64)));
    }
    heights
}

/// The rotation and the velocity at a time.
fn at_time(heights: &[Series<f64>], time: &Series<f64>) -> (Series<f64>, Series<f64>) {
    let zero = Series::constant(0.0, time.terms());
    let (mut height, mut speed) = (zero.clone(), zero);
    for coefficient in heights.iter().rev() {
        speed = speed.times(time).plus(&height);
        height = height.times(time).plus(coefficient);
    }
    (height, speed)
}

/// When the rotation is 0 again.
fn land(heights: &[Series<f64>]) -> Option<Series<f64>> {
    // From the base the root at the start is divided out.
    let from_the_base = heights.first().is_some_and(|first| first.0.iter().all(|term| *term == 0.0));
    let heights = heights.get(usize::from(from_the_base)..)?;
    let leading: Vec<f64> = heights.iter().map(Series::leading).collect();
    let terms = heights.first()?.terms();
    let mut duration = Series::constant(first_root(&leading)?, terms);
    // Each step of Newton's method doubles how many terms are right.
    for _ in 0..=terms.ilog2() + 1 {
        let (height, speed) = at_time(heights, &duration);
        duration = duration.minus(&height.over(&speed));
    }
    Some(duration)
}

/// The positive root of a polynomial whose coefficients change their sign once, from plus to minus; `None` of another.
fn first_root(coefficients: &[f64]) -> Option<f64> {
    let signs: Vec<bool> = coefficients.iter().filter(|value| **value != 0.0).map(|value| *value > 0.0).collect();
    let changes = signs.windows(2).filter(|pair| pair.first() != pair.last()).count();
    if changes != 1 || signs.first() != Some(&true) {
        return None;
    }
    let at = |time: f64| {
        coefficients
            .iter()
            .rev()
            .fold((0.0, 0.0), |(value, slope), coefficient| (value * time + coefficient, slope * time + value))
    };
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    while at(high).0 > 0.0 {
        (low, high) = (high, 2.0 * high);
        if !high.is_finite() {
            return None;
        }
    }
    while low == 0.0 {
        let half = 0.5 * high;
        if at(half).0 > 0.0 {
            low = half
        } else {
            high = half
        }
        if half == 0.0 {
            return None;
        }
    }
    // Newton's method, halving where it leaves the bracket.
    let mut root = high;
    for _ in 0..200 {
        let (value, slope) = at(root);
        if value > 0.0 {
            low = root
        } else {
            high = root
        }
        let next = root - value / slope;
        let next = if next > low && next < high { next } else { 0.5 * (low + high) };
        if (next - root).abs() <= f64::EPSILON * root {
            return Some(next);
        }
        root = next;
    }
    Some(root)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_root_is_found_at_every_scale() {
        for root in [1e-200, 1e-9, 0.3, 1.0, 7.5, 1e9] {
            // (r - t)(1 + t + t²).
            let found = first_root(&[root, root - 1.0, root - 1.0, -1.0]).unwrap();
            assert!((found / root - 1.0).abs() < 4e-16, "{root}: {found}");
        }
        assert_eq!(
            [first_root(&[1.0, 1.0]), first_root(&[-1.0, 1.0]), first_root(&[1.0, -3.0, 1.0]), first_root(&[])],
            [None; 4]
        );
    }
}
