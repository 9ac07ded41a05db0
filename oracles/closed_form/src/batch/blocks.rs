//! One rocking block in each lane, from one impact to the next.

use super::{
    lanes::{Lanes, Twofold},
    motion::{FEW, REACH, SOME, Start, Step, TERMS, step},
};

/// How many steps are tried before a flight is left to the scalar code.
const STEPS: usize = 8;

/// Below this speed there is nothing left to resolve; see `sequence`.
const SLOWEST: f64 = 1e-280;

/// The blocks after an impact, each with its case.
#[derive(Clone, Copy)]
pub(super) struct Blocks<L: Lanes> {
    /// Where there is a case.
    pub busy: L::Mask,
    pub epsilon: L,
    pub omega: L,
    pub eta: L,
    /// `a cos ψ = sqrt(2ε + ε²)`.
    pub cosine: L,
    /// `T/2`.
    pub half_period: L,
    /// `max(1, ω)`.
    pub rate: L,
    /// The `q` of `flow`.
    pub series: [L; TERMS],
    /// What `rest` needs of the case: `x (1 - x)(1 - η²)/(2 exp(x/(2(1 - x))))`.
    pub room: L,
    /// Where the first flight ends, nearly.
    pub first: L,
    pub time: Twofold<L>,
    pub speed: Twofold<L>,
    /// Sine and cosine of half the phase.
    pub sin: Twofold<L>,
    pub cos: Twofold<L>,
    /// `-1 - i f` on the side to which the block leaves.
    pub acceleration: L,
    /// `-i f'` there.
    pub jerk: L,
    /// 1 where the rest of the sequence is certain.
    pub complete: L,
}

/// What a flight ends with.
pub(super) struct Landed<L: Lanes> {
    pub time: L,
    pub interval: L,
    pub velocity: L,
    /// Where it is not sure that this is the first impact, and everywhere else that the lanes are not made for.
    pub unsure: L::Mask,
    /// Time and speed at the start of the flight.
    pub before: [Twofold<L>; 2],
}

/// `-1 - i f` and `-i f'`, on the side of the first flight or on the other; see `forcing`.
#[inline(always)]
pub(super) fn forcing<L: Lanes, const FIRST_SIDE: bool>(cosine: L, omega: L, sin: L, cos: L) -> [L; 2] {
    let rate = omega * (cosine * ((cos - sin) * (cos + sin)) - (sin + sin) * cos);
    if FIRST_SIDE { [(sin + sin) * (cosine * cos - sin), rate] } else { [-((cos + cos) * (cos + cosine * sin)), -rate] }
}

impl<L: Lanes> Blocks<L> {
    /// One flight of each block, all to the same side.
    #[inline(always)]
    pub fn fly<const FIRST_SIDE: bool>(&mut self) -> Landed<L> {
        let (one, zero) = (self.omega.all(1.0), self.omega.all(0.0));
        let squared = self.omega * self.omega;
        let start = Start {
            speed: self.speed.value(),
            acceleration: self.acceleration,
            jerk: self.jerk,
            snap: -(squared * (one + self.acceleration)),
        };
        let (landing, found) = self.land(&start);
        let first = self.is_first(&start, squared, landing.interval);

        let before = [self.time, self.speed];
        self.time = self.time.plus(landing.interval);
        self.speed = self.speed.plus(-landing.gain).times(self.eta);
        let [up, down] = landing.turn;
        self.sin = self.sin.plus(up);
        self.cos = self.cos.plus(-down);
        let (time, speed, cos) = (self.time.value(), self.speed.value(), self.cos.value());
        let [acceleration, jerk] = if FIRST_SIDE {
            forcing::<L, false>(self.cosine, self.omega, self.sin.value(), cos)
        } else {
            forcing::<L, true>(self.cosine, self.omega, self.sin.value(), cos)
        };
        (self.acceleration, self.jerk) = (acceleration, jerk);
        self.complete = one.or(self.rests(speed), self.complete);
        let sure = found
            & first
            & zero.below(cos)
            & time.below(self.half_period)
            & zero.below(landing.interval)
            & speed.all(SLOWEST).below(speed);
        Landed {
            time,
            interval: landing.interval,
            velocity: if FIRST_SIDE { speed } else { -speed },
            unsure: self.busy & !sure,
            before,
        }
    }

    /// The impact that the flight comes to, and where one is found.
    #[inline(always)]
    fn land(&self, start: &Start<L>) -> (Step<L>, L::Mask) {
        let nothing = self.omega.all(0.0);
        let mut here = Step { interval: self.guess(start), gain: nothing, turn: [nothing; 2] };
        let mut open = self.busy;
        let mut found = open & !open;
        let mut steps = 0;
        while steps < STEPS && L::any(open) {
            steps += 1;
            let s = here.interval;
            let x = self.rate * s;
            // As many terms as each lane's own flight asks for, and never more: the answer of a lane must not depend on the others.
            open = open & nothing.below(s) & x.below(x.all(REACH));
            let (few, some) = (x.below(x.all(FEW.1)), x.below(x.all(SOME.1)));
            let mut last = found;
            let mask = open & few;
            if L::any(mask) {
                let (next, done) = step::<L, { FEW.0 }>(self, start, s);
                (here, last) = (next.or(mask, here), last | (mask & done));
            }
            let mask = open & some & !few;
            if L::any(mask) {
                let (next, done) = step::<L, { SOME.0 }>(self, start, s);
                (here, last) = (next.or(mask, here), last | (mask & done));
            }
            let mask = open & !some;
            if L::any(mask) {
                let (next, done) = step::<L, TERMS>(self, start, s);
                (here, last) = (next.or(mask, here), last | (mask & done));
            }
            found = last;
            open = open & !found;
        }
        (here, found)
    }

    /// Where the flight may end; see `flight`.
    #[inline(always)]
    fn guess(&self, start: &Start<L>) -> L {
        let Start { speed, acceleration, jerk, snap } = *start;
        let one = speed.all(1.0);
        let inverse = one / acceleration;
        let inverse_squared = inverse * inverse;
        let parabola = (speed * inverse).by(-2.0);
        let e = ((speed + jerk) * speed).by(2.0 / 3.0) * inverse_squared;
        let d = ((acceleration + snap) * (speed * speed)).by(-1.0 / 3.0) * (inverse_squared * inverse);
        let e_squared = e * e;
        let near = (e.plus(1.0) + e_squared * (e.by(5.0).plus(2.0) + e_squared.by(14.0)))
            + d * (e.by(5.0).plus(1.0) + (d.by(3.0) + e_squared.by(21.0)));
        let falls = self.speed.high.all(0.0).below(parabola);
        let small = e.abs().below(e.all(0.12));
        let far = self.busy & falls & !small;
        let mut stretch = near;
        if L::any(far) {
            // 1 - t + e t² + d t³ = 0 by Newton's method
            let mut t = one.plus(0.4);
            let mut steps = 0;
            while steps < 4 {
                steps += 1;
                let value = (one - t) + (t * t) * (e + d * t);
                let slope = (t * (e + e + (d * t).by(3.0))).plus(-1.0);
                t = t - value / slope;
            }
            stretch = t.or(far, near);
        }
        (parabola * stretch).or(falls, self.first)
    }

    /// Where it is proven that no impact comes before the one found, in one of the two ways of `flight`.
    #[inline(always)]
    fn is_first(&self, start: &Start<L>, squared: L, s: L) -> L::Mask {
        let Start { speed, acceleration, jerk, snap } = *start;
        let zero = s.all(0.0);
        let most = self.omega + self.omega * self.epsilon;
        let drift = self.omega * most * s;
        let rise = (jerk.max(zero) + drift).min(most);
        let concave = (acceleration + s * (speed + rise)).below(zero);
        let mut proven = concave;
        if L::any(self.busy & !concave) {
            let fall = ((-jerk).max(zero) + drift).min(most);
            // Bounds on sinh s and on cosh s - 1, for s <= 2.
            let z = s * s;
            let sinh = s * ((z * (z * (z.by(1.2 / 42.0)).plus(1.0)).by(1.0 / 20.0).plus(1.0)).by(1.0 / 6.0)).plus(1.0);
            let cosh = z * ((z * (z * (z.by(1.2 / 56.0)).plus(1.0)).by(1.0 / 30.0).plus(1.0)).by(1.0 / 12.0)).plus(1.0);
            let height = speed * sinh + (self.epsilon * cosh).by(0.5);
            let lowest = (acceleration - s * fall).max(-(self.epsilon.plus(2.0)));
            let excess = squared.plus(-1.0);
            let drive = (-(excess * self.epsilon)).or(excess.below(zero), excess * (-lowest).max(zero));
            let bounded = snap.below(zero) & ((height - squared) + drive).below(zero);
            let turns = acceleration.below(zero) & zero.below(speed + jerk);
            proven = proven | (bounded & !turns);
        }
        proven
    }

    /// Where the rest of the sequence is certain after an impact that is left with this speed; see `rest`.
    #[inline(always)]
    fn rests(&self, speed: L) -> L::Mask {
        let zero = speed.all(0.0);
        let this = -self.acceleration;
        let other = speed.all(2.0) - this;
        let fastest = self.omega + self.omega * self.epsilon;
        let flights = speed * (other + self.eta * this) * (fastest + (speed + speed));
        let fit = !(self.room * this.min(other) * this * other).below(flights);
        zero.below(this) & zero.below(other) & fit
    }
}
