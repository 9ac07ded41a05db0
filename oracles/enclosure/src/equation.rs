//! The equations of motion, as the Taylor coefficients of the distance `x = i φ` from the base.
//!
//! With `b(s) = 1 + i f` the pull towards the base, Eq. 4 reads `x'' = x - b`, and Eq. 2, with the excitation in multiples of the threshold
//! (`ü_g/g = tan(α) f`), reads
//!
//! ```text
//! x'' = (1/α) [ sin(αx)/cos α - sin α (tan α sin(αx) + cos(αx)) b ]
//! ```
//!
//! because `sin(α(1-x)) + (b-1) tan α cos(α(1-x))` is the negative of the bracket. Both vanish with `x` and `b`, so nothing cancels in a small
//! flight or near initiation.

use crate::{
    directed::Directed,
    functions::sin_cos,
    interval::Interval,
    pull::{Pull, PullSeries},
};

/// The equation of motion of one block.
pub struct Equation<F> {
    block: Option<Block<F>>,
}

/// What Eq. 2 needs to know of a block that is not slender.
struct Block<F> {
    alpha: Interval<F>,
    sine: Interval<F>,
    tangent: Interval<F>,
    inverse_cosine: Interval<F>,
    inverse_alpha: Interval<F>,
}

/// Where a piece of a flight starts.
#[derive(Clone)]
pub struct Start<F> {
    /// The distance from the base.
    pub distance: Interval<F>,
    /// The velocity away from it.
    pub velocity: Interval<F>,
    /// The pull.
    pub pull: Pull<F>,
}

/// The Taylor coefficients of a motion in local time, as many as have been asked for.
pub struct Coefficients<'a, F> {
    equation: &'a Equation<F>,
    /// Those of `x`.
    pub motion: Vec<Interval<F>>,
    /// Those of `b`.
    pull: PullSeries<F>,
    /// Those of `sin(αx)`, `cos(αx)` and `tan α sin(αx) + cos(αx)`, and `n` times those of `x`; empty for Eq. 4.
    trigonometric: Trigonometric<F>,
}

#[derive(Default)]
struct Trigonometric<F> {
    sine: Vec<Interval<F>>,
    cosine: Vec<Interval<F>>,
    mixed: Vec<Interval<F>>,
    weighted: Vec<Interval<F>>,
}

impl<F: Directed> Equation<F> {
    /// Eq. 4, or Eq. 2 for a block of slenderness `alpha`.
    pub fn new(alpha: Option<f64>) -> Self {
        let one = Interval::exactly(1.0);
        let block = alpha.map(|alpha| {
            let alpha = Interval::exactly(alpha);
            let (sine, cosine) = sin_cos(&alpha);
            Block {
                tangent: &sine / &cosine,
                inverse_cosine: &one / &cosine,
                inverse_alpha: &one / &alpha,
                sine,
                alpha,
            }
        });
        Self { block }
    }

    /// Whether it is Eq. 4.
    pub fn is_linear(&self) -> bool {
        self.block.is_none()
    }

    /// A bound on `|x''| - |x|`: `1 + a`, or `1 + a tan(α)/α`.
    pub fn drive(&self, amplitude: &Interval<F>) -> f64 {
        let one = Interval::exactly(1.0);
        let drive = match &self.block {
            None => &one + amplitude,
            Some(block) => &one + &(&(amplitude * &block.tangent) * &block.inverse_alpha),
        };
        drive.magnitude()
    }

    /// The coefficients from `start` on.
    pub fn coefficients(&self, start: &Start<F>) -> Coefficients<'_, F> {
        let motion = vec![start.distance.clone(), start.velocity.clone()];
        let pull = PullSeries::new(&start.pull);
        Coefficients { equation: self, motion, pull, trigonometric: Trigonometric::new() }
    }

    /// Whether the block can't come back from this distance with this velocity.
    ///
    /// Eq. 4: `z = x + x'` obeys `z' = z - b`, and `b <= 1 + a`: once `z > 1 + a` it grows for ever, while `w = x - x'` never falls below the lesser of
    /// its value and `1 - a`; so `x = (z + w)/2` stays positive. Eq. 2: with `β = α(x - 1)` the angle past the balance,
    /// `β'' = sin β - i f tan α cos β`, which is not negative for `tan β >= a tan α`: a block that moves outwards there goes on to lie on its side,
    /// `αx = π/2`.
    pub fn overturned(&self, distance: &Interval<F>, velocity: &Interval<F>, amplitude: &Interval<F>) -> bool {
        let one = Interval::exactly(1.0);
        match &self.block {
            None => distance.is_positive() && (&one + amplitude).is_below(&(distance + velocity)),
            Some(block) => {
                let past = &block.alpha * &(distance - &one);
                let (sine, cosine) = sin_cos(&past);
                let outward = (&sine - &(&(amplitude * &block.tangent) * &cosine)).is_positive();
                let on_its_side = Interval::exactly(1.6).is_below(&(&block.alpha * distance));
                past.is_positive() && velocity.is_positive() && (outward || on_its_side)
            }
        }
    }

    /// `-x''`, the acceleration towards the base, for every `x` in `distance` (which starts at 0) and every pull in `pull`, as long as `αx <= π`; past
    /// that, and long before, the interval is not positive.
    pub fn towards_base(&self, distance: &Interval<F>, pull: &Interval<F>) -> Interval<F> {
        match &self.block {
            None => pull - distance,
            Some(block) => {
                // sin y <= y, and cos y >= 1 - y²/2.
                let angle = &block.alpha * distance;
                let sine = angle.down_to_zero();
                let one = Interval::exactly(1.0);
                let fall = (&angle.squared() * &Interval::exactly(0.5)).down_to_zero();
                let cosine = Interval { lower: (&one - &fall).lower, upper: one.upper.clone() };
                let mixed = &(&block.tangent * &sine) + &cosine;
                let restoring = &(&block.sine * &mixed) * pull;
                &(&restoring - &(&sine * &block.inverse_cosine)) * &block.inverse_alpha
            }
        }
    }
}

impl<F: Directed> Trigonometric<F> {
    fn new() -> Self {
        Self { sine: Vec::new(), cosine: Vec::new(), mixed: Vec::new(), weighted: Vec::new() }
    }

    /// Adds the coefficients of degree `n`, which need those of `x` up to that degree.
    fn extend(&mut self, block: &Block<F>, motion: &[Interval<F>]) {
        let n = self.sine.len();
        let (sine, cosine) = match motion.get(n) {
            Some(distance) if n == 0 => sin_cos(&(&block.alpha * distance)),
            Some(coefficient) => {
                // sin' = α x' cos and cos' = -α x' sin
                self.weighted.push(&Interval::whole(n) * coefficient);
                let scale = &block.alpha / &Interval::whole(n);
                (
                    &scale * &convolution(&self.weighted, &self.cosine),
                    -&(&scale * &convolution(&self.weighted, &self.sine)),
                )
            }
            None => return,
        };
        self.mixed.push(&(&block.tangent * &sine) + &cosine);
        self.sine.push(sine);
        self.cosine.push(cosine);
    }
}

impl<F: Directed> Coefficients<'_, F> {
    /// Adds the next coefficient, and returns it.
    pub fn extend(&mut self) -> Interval<F> {
        let n = self.motion.len();
        let k = n.saturating_sub(2);
        let pulls = self.pull.coefficients();
        let (Some(pull), Some(distance)) = (pulls.get(k), self.motion.get(k)) else {
            return Interval::exactly(f64::NAN);
        };
        let acceleration = match &self.equation.block {
            None => distance - pull,
            Some(block) => {
                self.trigonometric.extend(block, &self.motion);
                let Trigonometric { sine, mixed, .. } = &self.trigonometric;
                let Some(sine) = sine.get(k) else { return Interval::exactly(f64::NAN) };
                let driven = &block.sine * &convolution(mixed, pulls.get(..=k).unwrap_or_default());
                &(&(sine * &block.inverse_cosine) - &driven) * &block.inverse_alpha
            }
        };
        let next = &acceleration / &Interval::whole((n - 1) * n);
        self.motion.push(next.clone());
        self.pull.extend();
        next
    }
}

/// `Σ x_j y_(n-j)` over all of two lists of the same length `n + 1`.
fn convolution<F: Directed>(one: &[Interval<F>], two: &[Interval<F>]) -> Interval<F> {
    let products = one.iter().zip(two.iter().rev()).map(|(x, y)| x * y);
    products.fold(Interval::zero(), |sum, product| &sum + &product)
}
