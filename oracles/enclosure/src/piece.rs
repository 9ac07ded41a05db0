//! A piece of a flight: a Taylor polynomial with a proven bound on what it leaves out, its first root, and what holds at its end.

use core::cell::Cell;

use crate::{
    directed::Directed,
    equation::{Coefficients, Equation, Start},
    interval::Interval,
    pull::Pull,
    twofold::Twofold,
};

/// A block in motion with everything that its pieces need to know, in the format of the state and in doubles.
pub struct Motion<F> {
    pub equation: Equation<F>,
    /// Doubles are enough for bounds.
    pub coarse: Equation<f64>,
    /// A bound on `|x''| - |x|`.
    drive: f64,
    /// No piece is longer.
    pub longest: f64,
    /// The squares of the degrees of all pieces so far: what they cost.
    effort: Cell<usize>,
    most_effort: usize,
}

/// `x(s) = Σ c_k s^k` for `0 <= s <= length`, where the last coefficient stands for all that is left out.
pub struct Piece<F> {
    /// `c_d`, `c_(d+1)`, ... with `d` the deflation: lower coefficients are exactly zero.
    coefficients: Vec<Interval<F>>,
    /// A bound on the last coefficient, that of Lagrange's remainder.
    remainder: f64,
    /// The order of the zero at the start: 3 at initiation, 1 after an impact, 0 in the air.
    deflation: usize,
    /// How far the remainder holds.
    pub length: f64,
}

/// What can be said of the roots of a piece.
pub enum FirstRoot {
    /// The motion has exactly one root in this interval, downwards, and none before it.
    In(f64, f64),
    /// The motion has no root on the piece.
    None,
    /// Not with these digits.
    Unclear,
}

/// How much effort, times bits, is spent in arbitrary precision: some seconds.
const MOST_EFFORT: usize = 400_000_000;

/// How often a piece is halved before it is given up.
const MOST_HALVINGS: usize = 40;

/// How often a bracket is narrowed; each time at least by half, and soon to the square.
const MOST_NARROWINGS: usize = 200;

/// How many cells the search for the first root looks at.
const MOST_CELLS: usize = 4000;

impl<F: Directed> Motion<F> {
    /// The motion of a block of slenderness `alpha` (or a slender one) on ground of no more than this `amplitude`, which changes at this `rate`.
    pub fn new(amplitude: &Interval<F>, rate: f64, alpha: Option<f64>) -> Self {
        let (equation, coarse) = (Equation::new(alpha), Equation::new(alpha));
        let drive = coarse.drive(&amplitude.convert());
        Self { equation, coarse, drive, longest: (4.0 / rate).min(2.0), effort: Cell::new(0), most_effort: MOST_EFFORT }
    }

    /// The same, with this many times the effort.
    pub fn patient(self, times: usize) -> Self {
        Self { most_effort: times * MOST_EFFORT, ..self }
    }

    /// Whether to go on with these digits, or with more of them, would take too long.
    pub fn exhausted(&self) -> bool {
        F::BITS > Twofold::BITS && self.effort.get() > self.most_effort / F::BITS as usize
    }

    /// Everything that a piece of this length can meet: by comparison with `y'' = y + drive`, `|x| <= y` and `|x'| <= y'`.
    fn reach(&self, start: &Start<F>, any_pull: Pull<f64>, length: f64) -> Start<f64> {
        let (h, drive) = (Interval::<f64>::exactly(length), Interval::exactly(self.drive));
        let distance = Interval::exactly(start.distance.magnitude());
        let velocity = Interval::exactly(start.velocity.magnitude());
        // sinh h <= h cosh h, and cosh h - 1 <= (h²/2) cosh h.
        let square = h.squared();
        let cosh = cosh_above(&square);
        let half = Interval::exactly(0.5);
        let grown = &(&distance + &(&velocity * &h)) + &(&(&drive * &square) * &half);
        let faster = &(&velocity + &(&distance * &h)) + &(&drive * &h);
        Start {
            distance: Interval::within((&cosh * &grown).magnitude()),
            velocity: Interval::within((&cosh * &faster).magnitude()),
            pull: any_pull,
        }
    }

    /// The piece from `start` on, of the length given or shorter, where `any_pull` contains every pull within a time. `None` if none can be made.
    pub fn piece(
        &self,
        start: &Start<F>,
        any_pull: &dyn Fn(f64) -> Pull<f64>,
        deflation: usize,
        length: f64,
    ) -> Option<Piece<F>> {
        if self.exhausted() {
            return None;
        }
        let mut fine = self.equation.coefficients(start);
        while fine.motion.len() < deflation + 3 {
            fine.extend();
        }
        let leading = fine.motion.get(deflation)?.convert::<f64>();
        let needed = leading.lower * (2.0_f64).powi(-(F::BITS as i32) - 3);
        if !(needed > 0.0) {
            return None;
        }
        let mut length = self.suggested_length(&fine, deflation).min(length);
        for _ in 0..MOST_HALVINGS {
            if let Some((degree, remainder)) = self.degree(start, any_pull(length), deflation, length, needed) {
                while fine.motion.len() < degree {
                    fine.extend();
                }
                self.effort.set(self.effort.get() + degree * degree);
                let mut coefficients = fine.motion.split_off(deflation);
                coefficients.truncate(degree - deflation);
                return Some(Piece { coefficients, remainder, deflation, length });
            }
            length *= 0.5;
        }
        None
    }

    /// A little more than the length of the flight, where its first coefficients tell.
    fn suggested_length(&self, fine: &Coefficients<F>, deflation: usize) -> f64 {
        let mut first = fine.motion.iter().skip(deflation).map(Interval::middle);
        match (first.next(), first.next(), first.next()) {
            (Some(c0), Some(c1), Some(c2)) if c1 < 0.0 && deflation > 0 => {
                let parabola = -c0 / c1;
                let correction = c2 * parabola * parabola / c0;
                (1.1 * parabola * (1.0 + 1.5 * correction.clamp(0.0, 1.0))).min(self.longest)
            }
            _ => self.longest,
        }
    }

    /// The least degree whose remainder is small enough, and a bound on its coefficient on the whole piece.
    fn degree(
        &self,
        start: &Start<F>,
        any_pull: Pull<f64>,
        deflation: usize,
        length: f64,
        needed: f64,
    ) -> Option<(usize, f64)> {
        let reach = self.reach(start, any_pull, length);
        let mut bounds = self.coarse.coefficients(&reach);
        let length = Interval::<f64>::exactly(length);
        // The length to the power of the degree less the deflation.
        let mut power = if deflation == 0 { length.clone() } else { Interval::exactly(1.0) };
        for degree in 2..24 + F::BITS as usize / 3 {
            let bound = bounds.extend().magnitude();
            if degree > deflation {
                power = &power * &length;
            }
            // Two coefficients at least are needed to see the flight come down.
            if degree >= deflation + 3 && (&Interval::exactly(bound) * &power).magnitude() <= needed {
                return Some((degree, bound));
            }
        }
        None
    }
}

/// A bound on `cosh h` from above for `h <= 2`, from `h²`: `1 + h²/2 + h⁴/24 + cosh(2) h⁶/720`, with `1/24` and `cosh(2)/720` rounded up.
fn cosh_above(square: &Interval<f64>) -> Interval<f64> {
    [0.006, 0.042, 0.5, 1.0].iter().fold(Interval::zero(), |sum, &c| &(&sum * square) + &Interval::exactly(c))
}

impl<F: Directed> Piece<F> {
    /// The same piece in doubles.
    fn coarse(&self) -> Piece<f64> {
        Piece {
            coefficients: self.coefficients.iter().map(Interval::convert).collect(),
            remainder: self.remainder,
            deflation: self.deflation,
            length: self.length,
        }
    }

    /// `x/s^d`.
    fn deflated(&self, s: &Interval<F>) -> Interval<F> {
        let remainder = Interval::within(self.remainder);
        self.coefficients.iter().rev().fold(remainder, |sum, c| &(&sum * s) + c)
    }

    /// The derivative of `x/s^d`. It is `x'/s^d - d x/s^(d+1)`, and the remainders of `x` and `x'` are two different numbers within the same
    /// bound.
    fn slope(&self, s: &Interval<F>) -> Interval<F> {
        let degree = self.coefficients.len() + self.deflation;
        let remainder = &Interval::within(self.remainder) * &Interval::whole(degree + self.deflation);
        let rest = self.coefficients.iter().enumerate().skip(1).rev();
        rest.fold(remainder, |sum, (k, c)| &(&sum * s) + &(c * &Interval::whole(k)))
    }

    /// The first root of the motion on the piece, if there is one: sought in doubles, and with all digits where doubles can't tell.
    pub fn first_root(&self) -> FirstRoot {
        match self.coarse().search() {
            FirstRoot::Unclear if F::BITS > <f64 as Directed>::BITS => self.search(),
            clear => clear,
        }
    }

    /// Looks at ever smaller cells from the left: on each the deflated motion is proven to be positive, or to be monotone and so to have no
    /// root or exactly one.
    fn search(&self) -> FirstRoot {
        if !self.deflated(&Interval::zero()).is_positive() {
            return FirstRoot::Unclear;
        }
        let mut cells = vec![(0.0, self.length)];
        for _ in 0..MOST_CELLS {
            let Some((left, right)) = cells.pop() else { return FirstRoot::None };
            let cell = Interval::between(left, right);
            if self.deflated(&cell).is_positive() {
                continue;
            }
            let slope = self.slope(&cell);
            if slope.is_positive() {
                continue;
            }
            if slope.is_negative() {
                let end = self.deflated(&Interval::exactly(right));
                if end.is_negative() {
                    return FirstRoot::In(left, right);
                }
                if end.is_positive() {
                    continue;
                }
            }
            // Not in the middle, where a root may be that the last halving was made for.
            let between = left + 0.46 * (right - left);
            if !(between > left && between < right) {
                return FirstRoot::Unclear;
            }
            cells.push((between, right));
            cells.push((left, between));
        }
        FirstRoot::Unclear
    }

    /// The root in a bracket that `first_root` returned, as narrow as the digits allow (interval Newton).
    pub fn narrow(&self, left: f64, right: f64) -> Interval<F> {
        let coarse = self.coarse().newton(Interval::between(left, right));
        self.newton(coarse.convert())
    }

    fn newton(&self, mut bracket: Interval<F>) -> Interval<F> {
        for _ in 0..MOST_NARROWINGS {
            let centre = bracket.centre();
            let root = &centre - &(&self.deflated(&centre) / &self.slope(&bracket));
            let narrower = root.and(&bracket);
            // Also where something is not a number.
            if !(narrower.width() < 0.5 * bracket.width()) {
                return if narrower.width() <= bracket.width() { narrower } else { bracket };
            }
            bracket = narrower;
        }
        bracket
    }

    /// `x'` at a root: there it is `s^d (x/s^d)'`.
    pub fn velocity_at_root(&self, root: &Interval<F>) -> Interval<F> {
        &power(root, self.deflation) * &self.slope(root)
    }

    /// Distance and velocity at a time that is not after the end of the piece.
    pub fn at(&self, s: &Interval<F>) -> (Interval<F>, Interval<F>) {
        let (value, slope) = (self.deflated(s), self.slope(s));
        let distance = &power(s, self.deflation) * &value;
        let velocity = match self.deflation {
            0 => slope,
            d => &power(s, d - 1) * &(&(&Interval::whole(d) * &value) + &(s * &slope)),
        };
        (distance, velocity)
    }
}

fn power<F: Directed>(x: &Interval<F>, n: usize) -> Interval<F> {
    (0..n).fold(Interval::exactly(1.0), |power, _| &power * x)
}

#[cfg(test)]
mod tests;
