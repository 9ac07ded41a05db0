//! One rocking block in each lane, from one impact to the next.

use crate::{rest::SHARE, sequence::SLOWEST};

use super::{
    lanes::Lanes,
    motion::{FEW, REACH, SHORT, SOME, step},
    state::{Blocks, Step, TERMS},
};

/// How many steps are tried before a flight is left to the scalar code.
const STEPS: usize = 8;

/// Below this cosine of half the phase `T/2` is so near that the scalar code has to tell on which side of it an impact is.
const NEARLY_OVER: f64 = 1e-9;

/// An impact in each lane.
#[derive(Clone, Copy)]
pub(super) struct Impact<L> {
    pub time: L,
    pub interval: L,
    pub velocity: L,
}

/// `-1 - i f` and `-i f'`, on the side of the first flight or on the other; see `forcing`.
#[inline(always)]
pub(super) fn forcing<L: Lanes, const FIRST_SIDE: bool>(cosine: L, omega: L, sin: L, cos: L) -> [L; 2] {
    let (by_cosine, by_one) = (cosine * ((cos - sin) * (cos + sin)), (sin + sin) * cos);
    if FIRST_SIDE {
        [(sin + sin) * cosine.mul_add(cos, -sin), omega * (by_cosine - by_one)]
    } else {
        [-(cos + cos) * cosine.mul_add(sin, cos), omega * (by_one - by_cosine)]
    }
}

/// `1 + a z (1 + b z (1 + c z))`
#[inline(always)]
fn nested<L: Lanes>(z: L, [a, b, c]: [f64; 3]) -> L {
    (z * (z * (z.by(c).plus(1.0)).by(b)).plus(1.0).by(a)).plus(1.0)
}

/// Bounds from above on `sinh s/s` and on `2 (cosh s - 1)/s²` as nested polynomials of `s²`, up to `s = REACH`: the last factor makes up for what is left out.
const SINH: [f64; 3] = [1.0 / 6.0, 1.0 / 20.0, 1.2 / 42.0];
const COSH: [f64; 3] = [1.0 / 12.0, 1.0 / 30.0, 1.2 / 56.0];

/// One step more by `N` terms, where the mask holds.
#[inline(always)]
fn further<L: Lanes, const N: usize>(
    blocks: &Blocks<L>,
    s: L,
    mask: L::Mask,
    (here, found): (Step<L>, L::Mask),
) -> (Step<L>, L::Mask) {
    if !L::any(mask) {
        return (here, found);
    }
    let (next, last) = step::<L, N>(blocks, s);
    (next.select(mask, here), found | (last & mask))
}

impl<L: Lanes> Blocks<L> {
    /// What drives the flight that each block is about to make, and where it may end.
    #[inline(always)]
    pub fn take_off(&mut self) {
        self.departure = self.speed.value();
        self.snap = self.squared * (self.omega.splat(-1.0) - self.acceleration);
        self.guess = self.guess();
    }

    /// The impact that the flight comes to.
    #[inline(always)]
    pub fn land(&mut self) {
        (self.landing, self.found) = self.landing();
    }

    /// The blocks after the impact that ends their flights, all to the same side; and whether it is not sure in any lane.
    #[inline(always)]
    pub fn hit<const FIRST_SIDE: bool>(&mut self) -> (Impact<L>, bool) {
        let (one, zero) = (self.omega.splat(1.0), self.omega.splat(0.0));
        let busy = zero.below(self.busy);
        let Step { interval, loss, turn: [up, down] } = self.landing;
        let speed = self.speed.less(loss).times(self.eta);
        let departure = speed.value();
        let mut sure = self.found & speed.high.splat(SLOWEST).below(departure);
        let bounded = self.is_bounded(interval);
        let open = self.complete.below(one);
        let any_open = L::any(busy & open);
        let first = if any_open { (open & self.is_first(interval)) | (bounded & !open) } else { bounded };

        self.sin = self.sin.plus(up);
        self.cos = self.cos.less(down);
        let (sin, cos) = (self.sin.value(), self.cos.value());
        [self.acceleration, self.jerk] = if FIRST_SIDE {
            forcing::<L, false>(self.cosine, self.omega, sin, cos)
        } else {
            forcing::<L, true>(self.cosine, self.omega, sin, cos)
        };
        sure = sure & first;
        if any_open {
            sure = sure & (cos.splat(NEARLY_OVER).below(cos) | !open);
            self.complete = one.select(self.rests(departure) & sure, self.complete);
        }
        let (mut time, mut speed) = (self.time.plus(interval), speed);
        self.unsure = busy & !sure;
        let any_unsure = L::any(self.unsure);
        if any_unsure {
            time = self.time.select(self.unsure, time);
            speed = self.speed.select(self.unsure, speed);
        }
        (self.time, self.speed) = (time, speed);
        let velocity = if FIRST_SIDE { departure } else { -departure };
        (Impact { time: time.value(), interval, velocity }, any_unsure)
    }

    /// The impact that the flight comes to, and where one is found.
    #[inline(always)]
    fn landing(&self) -> (Step<L>, L::Mask) {
        let nothing = self.omega.splat(0.0);
        let (busy, s) = (nothing.below(self.busy), self.guess);
        let x = self.rate * s;
        let ahead = nothing.below(s);
        let short = x.below(x.splat(SHORT.1));
        let (mut here, mut found) = (Step { interval: s, loss: s, turn: [s; 2] }, ahead & !ahead);
        let mut open = busy;
        let mut steps = 0;
        // Most flights are short, and need one step.
        if !L::any(busy & !(ahead & short)) {
            steps = 1;
            (here, found) = step::<L, { SHORT.0 }>(self, s);
            open = busy & !found;
        } else if !L::any(busy & !(ahead & x.below(x.splat(FEW.1)) & !short)) {
            steps = 1;
            (here, found) = step::<L, { FEW.0 }>(self, s);
            open = busy & !found;
        }
        while L::any(open) && steps < STEPS {
            steps += 1;
            let s = here.interval;
            let x = self.rate * s;
            open = open & nothing.below(s) & x.below(x.splat(REACH));
            // As many terms as each lane's own flight asks for, and never more: the answer of a lane must not depend on the others.
            let (short, few, some) = (x.below(x.splat(SHORT.1)), x.below(x.splat(FEW.1)), x.below(x.splat(SOME.1)));
            (here, found) = further::<L, { SHORT.0 }>(self, s, open & short, (here, found));
            (here, found) = further::<L, { FEW.0 }>(self, s, open & few & !short, (here, found));
            (here, found) = further::<L, { SOME.0 }>(self, s, open & some & !few, (here, found));
            (here, found) = further::<L, TERMS>(self, s, open & !some, (here, found));
            open = open & !found;
        }
        (here, found)
    }

    /// Where the flight may end: the series of `flight` in `e = 2/3 E` and `d = -1/3 D`, with all that it is multiplied by in its coefficients, and with
    /// one term more: `e` times that of `t⁴`, `(v + q j) parabola⁴/(120 v)`, nearly.
    #[inline(always)]
    fn guess(&self) -> L {
        let Self { departure: speed, acceleration, jerk, snap, .. } = *self;
        let (one, zero) = (speed.splat(1.0), speed.splat(0.0));
        let inverse = one / acceleration;
        // -1/2 of the parabola's length
        let half = speed * inverse;
        let lift = half * inverse;
        let (e, d) = ((speed + jerk) * lift, ((acceleration + snap) * half) * lift);
        let e_squared = e * e;
        let [_, q, ..] = self.series;
        let first = (q * (half * half)).mul_add(e.splat(-4.0 / 15.0), e.splat(-4.0 / 3.0));
        let second = e.mul_add(e.splat(-80.0 / 27.0), e.splat(-16.0 / 9.0));
        let fourth = e.mul_add(e.splat(-896.0 / 81.0), e.splat(-448.0 / 81.0));
        let mixed = e.mul_add(e.splat(20.0 / 9.0), e.splat(2.0 / 3.0));
        let mixed = d.mul_add(e.splat(-2.0 / 3.0), e_squared.mul_add(e.splat(56.0 / 9.0), mixed));
        let near = e_squared.mul_add(e_squared.mul_add(fourth, second), e.mul_add(first, e.splat(-2.0)));
        let mut stretch = d.mul_add(mixed, near);
        let falls = half.below(zero);
        let far = zero.below(self.busy) & falls & !e.abs().below(e.splat(0.18));
        if L::any(far) {
            // 1 - t + e t² + d t³ = 0 by Newton's method
            let (e, d) = (e.by(2.0 / 3.0), d.by(-1.0 / 3.0));
            let mut t = one.plus(0.4);
            let mut steps = 0;
            while steps < 4 {
                steps += 1;
                let value = (one - t) + (t * t) * (e + d * t);
                let slope = (t * (e + e + (d * t).by(3.0))).plus(-1.0);
                t = t - value / slope;
            }
            stretch = t.by(-2.0).select(far, stretch);
        }
        (half * stretch).select(falls, self.first)
    }

    /// Where a flight after the proof of rest is no longer than `2v/((1 - x) g)`, with the pull `g` of now. No impact comes before the one found then.
    ///
    /// In the window of `rest`, into which the bounds `2v/((1 - x) g)` of all flights fit with the pull at its start, no pull falls below `1 - x` of that. So this
    /// flight ends within `1/(1 - x)` of the window; and it takes `1/x` of it until the forcing can push the block off the base. Before, a motion that has come
    /// down through zero does not come back. That `1/(1 - x)` is the smaller of the two needs an `x` of 1/2 at the most.
    #[inline(always)]
    fn is_bounded(&self, s: L) -> L::Mask {
        const { assert!(SHARE <= 0.5) }
        (self.acceleration * s).by(-0.5 * (1.0 - SHARE)).below(self.departure)
    }

    /// Where it is proven that no impact comes before the one found, in one of the two ways of `flight`.
    ///
    /// The forcing is `b(s) = b + j sin(ωs)/ω + k (1 - cos ωs)/ω²`, so `b + min(j, 0) s + min(k, 0) s²/2` is below it, and with `max` above.
    #[inline(always)]
    fn is_first(&self, s: L) -> L::Mask {
        let Self { departure: speed, acceleration, jerk, snap, .. } = *self;
        let zero = s.splat(0.0);
        let busy = zero.below(self.busy);
        let rise = jerk.max(zero) + s * snap.max(zero).by(0.5);
        let concave = (acceleration + s * (speed + rise)).below(zero);
        let mut proven = concave;
        if L::any(busy & !concave) {
            let fall = jerk.min(zero) + s * snap.min(zero).by(0.5);
            let lowest = acceleration + s * fall;
            let z = s * s;
            let (sinh, cosh) = (s * nested(z, SINH), z * nested(z, COSH));
            let height = speed * sinh + (self.epsilon * cosh).by(0.5);
            let excess = self.squared.plus(-1.0);
            let drive = (-(excess * self.epsilon)).select(excess.below(zero), excess * (-lowest).max(zero));
            let bounded = snap.below(zero) & ((height - self.squared) + drive).below(zero);
            let turns = acceleration.below(zero) & zero.below(speed + jerk);
            proven = proven | (bounded & !turns);
        }
        proven
    }

    /// Where the rest of the sequence is certain after an impact that is left with this speed; see `rest`.
    #[inline(always)]
    fn rests(&self, speed: L) -> L::Mask {
        let zero = speed.splat(0.0);
        let this = -self.acceleration;
        let other = speed.splat(2.0) - this;
        let fastest = self.omega + self.omega * self.epsilon;
        let flights = speed * (other + self.eta * this) * (fastest + (speed + speed));
        let fit = !(self.room * this.min(other) * this * other).below(flights);
        zero.below(this) & zero.below(other) & fit
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// They are bounds as far as the series reach, and not much wider than what they bound.
    #[test]
    fn the_bounds_of_the_proof_are_above_the_functions() {
        for k in 1..=2300 {
            let s = REACH * f64::from(k) / 2300.0;
            let half = (0.5 * s).sinh();
            for (bound, function) in
                [(s * nested(s * s, SINH), s.sinh()), (s * s * nested(s * s, COSH), 4.0 * half * half)]
            {
                assert!((-1e-15..6e-3).contains(&(bound / function - 1.0)), "{s}: {bound} {function}");
            }
        }
    }
}
