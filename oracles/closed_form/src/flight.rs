//! One flight: from just after an impact to the first time the rotation returns to zero.

use crate::{
    UNIT,
    flow::{Flow, Motion},
    forcing::{Excitation, Forcing},
    march,
    twofold::Twofold,
};

/// Everything that one flight needs to know.
#[derive(Clone, Copy)]
pub(crate) struct Takeoff<'a> {
    pub excitation: &'a Excitation,
    pub flow: &'a Flow<f64>,
    /// When it starts.
    pub time: Twofold,
    /// `i`, the sign of the rotation.
    pub sign: f64,
    /// The speed away from the base, `i φ'`: zero only at initiation.
    pub speed: f64,
    /// The forcing at the start.
    pub forcing: Forcing,
    /// Where the last flight of the same sign suggests that the impact is, if there was one.
    pub guess: Option<f64>,
    /// How long the flight is followed.
    pub horizon: f64,
}

/// How a flight ends.
pub(crate) enum Outcome {
    Landing(Landing),
    /// It passes the horizon in the air.
    Aloft,
    /// No return is possible.
    Overturned,
    /// The iteration did not end; the sequence is reported as lost. Known to happen just above the threshold of very slow shaking (`ε = 5e-13`, `ω = 2e-6`).
    Stuck,
}

/// The impact, and how it responds to what the flight started with.
pub(crate) struct Landing {
    /// How long the flight lasted.
    pub interval: f64,
    /// `u' + v`: how much slower it lands than it left. Eq. 68, a first-order statement, has it zero.
    pub gain: f64,
    /// `u'` at the impact.
    pub velocity: f64,
    /// `u''` at the impact.
    pub acceleration: f64,
    /// `u'' - 2u'/s` at the impact: zero on a parabola.
    pub off_parabola: f64,
    /// The derivatives of `u` and `u'` by the speed at the start: `sinh` and `cosh` of the interval.
    pub by_speed: (f64, f64),
    /// The derivatives of `u` and `u'` by the time of the start.
    pub by_time: (f64, f64),
    /// The rounding errors of `u/s` and of the gain, absolute, in units of the unit round-off.
    pub rounding: (f64, f64),
}

/// Up to which `max(1, ω) s` two terms of the series of the derivatives are enough.
const SHORT: f64 = 0.25;

/// How often a step of Newton's method is tried before the flight is marched through instead.
const NEWTON_STEPS: usize = 12;

impl Takeoff<'_> {
    /// Follows the flight to its first impact.
    ///
    /// Newton's method finds *a* root; it is taken only with a proof that no root comes before it. Everything else, long and
    /// grazing flights, is marched through in steps that cannot pass a root.
    pub fn fly(self) -> Outcome {
        match self.newton(self.first_guess()) {
            Some(landing) if landing.interval <= self.horizon && self.is_first(&landing) => Outcome::Landing(landing),
            _ => match march::fly(self) {
                Outcome::Landing(landing) => Outcome::Landing(self.sharpened(landing)),
                outcome => outcome,
            },
        }
    }

    /// The same root to more digits, if the series reach it: the march knows which root is the first, Newton's method where it is.
    #[cold]
    #[inline(never)]
    fn sharpened(&self, landing: Landing) -> Landing {
        let same = |sharp: &Landing| (sharp.interval - landing.interval).abs() <= 1e-6 * landing.interval;
        self.newton(landing.interval).filter(same).unwrap_or(landing)
    }

    /// The root of `h = u/s` (of `u/s³` at initiation) that Newton's method, with Halley's correction, reaches, if it reaches one.
    #[inline(always)]
    fn newton(&self, guess: f64) -> Option<Landing> {
        let mut s = guess;
        for _ in 0..NEWTON_STEPS {
            if !(s > 0.0 && s <= self.flow.longest()) {
                return None;
            }
            let motion = self.flow.after_impact(s, self.speed, &self.forcing);
            // A root is crossed downwards.
            if motion.slope.is_nan() || motion.slope >= 0.0 {
                return None;
            }
            let step = halley(&motion);
            s += s * step;
            // The gain is wanted at the root itself. Its slope carries it over a step that is so small that the square is nothing
            // beside the speed.
            let gain = motion.gain + step * motion.bend;
            let left_out = step * step * motion.bend.abs();
            let velocity = gain - self.speed;
            if step.abs() <= 1e-6 && left_out <= -1e-18 * velocity {
                return Some(self.landing(s, gain, left_out, motion.bend));
            }
        }
        None
    }

    /// Where Newton's method starts.
    fn first_guess(&self) -> f64 {
        let Forcing { acceleration, jerk, snap, .. } = self.forcing;
        if self.speed == 0.0 {
            return -4.0 * jerk / snap; // Eq. 31 in u: j s³/6 + k s⁴/24 = 0
        }
        let inverse = 1.0 / acceleration;
        let parabola = -2.0 * self.speed * inverse;
        // In t = s/parabola the flight is 0 = 1 - t + e t² + d t³ + ..., with the corrections
        let e = -(self.speed + jerk) * parabola * inverse * (1.0 / 3.0);
        let d = -(acceleration + snap) * parabola * parabola * inverse * (1.0 / 12.0);
        match self.guess {
            // and by Lagrange's inversion t = 1 + e + d + 2 e² + 5 e d + 3 d² + 5 e³ + ... where they are small; where they are
            // not, the last flight of the same sign is a better guess.
            _ if parabola > 0.0 && e.abs() < 0.2 => {
                parabola
                    * (1.0 + e * (1.0 + e * (2.0 + e * (5.0 + 14.0 * e))) + d * (1.0 + 3.0 * d + e * (5.0 + 21.0 * e)))
            }
            Some(guess) => guess,
            None => parabola,
        }
    }

    /// Whether `u` has no zero between the start and this landing, proven in one of two ways.
    fn is_first(&self, landing: &Landing) -> bool {
        let Landing { interval: s, by_speed: (sinh, cosh), .. } = *landing;
        let Forcing { acceleration, jerk, snap, .. } = self.forcing;
        let Excitation { amplitude, omega, .. } = *self.excitation;
        // On the flight the jerk of the forcing stays within its value now and these two bounds.
        let (most, drift) = (omega * amplitude, omega * omega * amplitude * s);
        let rise = most.min(jerk.max(0.0) + drift);
        let fall = most.min((-jerk).max(0.0) + drift);
        // (1) u'' < 0 throughout (u < v s as long as it holds): u is concave and has one zero.
        if acceleration + s * (self.speed + rise) < 0.0 {
            return true;
        }
        // (2) u'''' = u - ω² - (ω² - 1) b(s) < 0 throughout, with b(s) = -1 - i f: by Budan and Fourier there are no more zeros
        // than sign changes in u', u'', u''', u'''' at the start. There is one unless u'' < 0 < u'''.
        let bound = self.excitation.largest_acceleration();
        let height = self.speed * sinh + bound * (cosh - 1.0);
        let lowest = (acceleration - s * fall).max(-1.0 - amplitude);
        let squared = omega * omega;
        let drive = if squared >= 1.0 { (squared - 1.0) * -lowest.min(0.0) } else { (1.0 - squared) * bound };
        snap < 0.0 && height - squared + drive < 0.0 && !(acceleration < 0.0 && self.speed + jerk > 0.0)
    }

    /// What is known at the impact.
    #[inline(always)]
    fn landing(&self, interval: f64, gain: f64, left_out: f64, bend: f64) -> Landing {
        let Forcing { acceleration, jerk, snap, rounding } = self.forcing;
        let (s, z) = (interval, interval * interval);
        let velocity = gain - self.speed;
        // u'' = s h'' + 2 h', and s h' = u' at the impact
        let inverse = 1.0 / s;
        let off_parabola = bend * inverse;
        let acceleration_there = off_parabola + 2.0 * velocity * inverse;
        let (by_speed, by_time) = self.derivatives(s, velocity, acceleration_there);
        // The parabola, v + b s/2, is rounded twice, each time by half a unit of v. The factors of the rest of h, and of
        // the gain, are measured (see `error`).
        let (pull, push) = (acceleration.abs(), jerk.abs());
        let parabola = self.speed + 0.5 * s * pull;
        let rest = z * (self.speed + push + 0.25 * s * (pull + snap.abs())) * (1.0 / 6.0);
        let gain_size = z * (self.speed + push + 0.5 * s * (pull + snap.abs())) * (1.0 / 6.0);
        // An error of the forcing moves u by db s²/2 + dj s³/6, and the gain by db s³/12 + dj s²/6 at the most.
        let from_jerk = rounding.1 * z / 6.0;
        let deflated_error = parabola + 3.0 * rest + 0.5 * s * rounding.0 + from_jerk;
        let gain_error = 1.5 * gain_size + s * z * rounding.0 / 12.0 + from_jerk;
        Landing {
            interval,
            gain,
            velocity,
            acceleration: acceleration_there,
            off_parabola,
            by_speed,
            by_time,
            rounding: (deflated_error, gain_error + left_out / UNIT),
        }
    }

    /// The derivatives of `u` and `u'` at `s` by the speed at the start, and by the time of the start. Errors are carried with them, and
    /// nearly cancel over some long flights, so they have to be right to many digits there.
    #[inline]
    pub fn derivatives(&self, s: f64, velocity: f64, acceleration: f64) -> ((f64, f64), (f64, f64)) {
        let Forcing { acceleration: pull, jerk, snap, .. } = self.forcing;
        let (z, omega) = (s * s, self.excitation.omega);
        let q = 1.0 - omega * omega;
        if s * omega.max(1.0) > SHORT {
            let growth = s.exp();
            let (sinh, cosh) = (0.5 * (growth - 1.0 / growth), 0.5 * (growth + 1.0 / growth));
            // The equation is linear: u_τ = u' - v cosh s - b sinh s, and its derivative.
            let tilt = velocity - self.speed * cosh - pull * sinh;
            return ((sinh, cosh), (tilt, acceleration - self.speed * sinh - pull * cosh));
        }
        let sinh = s * (1.0 + z * (1.0 / 6.0 + z * (1.0 / 120.0)));
        let cosh = 1.0 + z * (0.5 + z * (1.0 / 24.0 + z * (1.0 / 720.0)));
        let tilt = z * (jerk * (0.5 + q * z * (1.0 / 24.0)) + s * snap * (1.0 / 6.0 + q * z * (1.0 / 120.0)));
        let turn = s * (jerk * (1.0 + q * z * (1.0 / 6.0)) + s * snap * (0.5 + q * z * (1.0 / 24.0)));
        ((sinh, cosh), (tilt, turn))
    }
}

/// The step of Newton's method towards the root of `h`, relative to `s`, with Halley's correction: the next error is the cube of this step.
#[inline(always)]
fn halley(motion: &Motion<f64>) -> f64 {
    let inverse = 1.0 / motion.slope;
    let newton = -motion.deflated * inverse;
    newton * (1.0 - 0.5 * newton * motion.bend * inverse)
}

#[cfg(test)]
pub(crate) mod tests;
