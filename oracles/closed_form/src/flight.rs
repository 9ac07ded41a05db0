//! One flight: from just after an impact to the first time the rotation returns to zero.

use crate::{
    UNIT,
    flow::Motion,
    forcing::{Excitation, Forcing},
    march,
    takeoff::{Landing, Outcome, Takeoff},
};

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
            // The loss is wanted at the root itself. Its slope carries it over a step that is so small that the square is nothing
            // beside the speed.
            let loss = motion.loss + step * motion.bend;
            let left_out = step * step * motion.bend.abs();
            let velocity = loss - self.speed;
            if step.abs() <= 1e-6 && left_out <= -1e-18 * velocity {
                return Some(self.landing(s, loss, left_out, motion.bend));
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
    fn landing(&self, interval: f64, loss: f64, left_out: f64, bend: f64) -> Landing {
        let Forcing { acceleration, jerk, snap, rounding } = self.forcing;
        let (s, z) = (interval, interval * interval);
        let velocity = loss - self.speed;
        // u'' = s h'' + 2 h', and s h' = u' at the impact
        let inverse = 1.0 / s;
        let off_parabola = bend * inverse;
        let acceleration_there = off_parabola + 2.0 * velocity * inverse;
        let (by_speed, by_time) = self.derivatives(s, velocity, acceleration_there);
        // The parabola, v + b s/2, is rounded twice, each time by half a unit of v. The factors of the rest of h, and of
        // the loss, are measured (see `error`).
        let (pull, push) = (acceleration.abs(), jerk.abs());
        let parabola = self.speed + 0.5 * s * pull;
        let rest = z * (self.speed + push + 0.25 * s * (pull + snap.abs())) * (1.0 / 6.0);
        let loss_size = z * (self.speed + push + 0.5 * s * (pull + snap.abs())) * (1.0 / 6.0);
        // An error of the forcing moves u by db s²/2 + dj s³/6, and the loss by db s³/12 + dj s²/6 at the most.
        let from_jerk = rounding.1 * z / 6.0;
        let deflated_error = parabola + 3.0 * rest + 0.5 * s * rounding.0 + from_jerk;
        let loss_error = 1.5 * loss_size + s * z * rounding.0 / 12.0 + from_jerk;
        Landing {
            interval,
            loss,
            velocity,
            acceleration: acceleration_there,
            off_parabola,
            by_speed,
            by_time,
            rounding: (deflated_error, loss_error + left_out / UNIT),
        }
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
