//! One flight: from just after an impact to the first time the rotation returns to zero.

use crate::{
    UNIT,
    flow::{Flow, Motion, Sums},
    forcing::{Excitation, Forcing},
    march,
    twofold::Twofold,
};

/// Everything that one flight needs to know.
pub(crate) struct Takeoff<'a> {
    pub excitation: &'a Excitation,
    pub flow: &'a Flow,
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
    /// The iteration did not end. Not known to happen; the sequence is reported as lost.
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
    /// `sinh`, `cosh` of the interval: the derivatives of `u`, `u'` by the speed at the start.
    pub by_speed: (f64, f64),
    /// The derivatives of `u` and `u'` by the time of the start.
    pub by_time: (f64, f64),
    /// Bounds on the rounding errors of the interval and of the gain, absolute.
    pub rounding: (f64, f64),
}

/// How often a step of Newton's method is tried before the flight is marched through instead.
const NEWTON_STEPS: usize = 12;

impl Takeoff<'_> {
    /// Follows the flight to its first impact.
    ///
    /// Newton's method finds *a* root; it is taken only with a proof that no root comes before it. Everything else, long and
    /// grazing flights, is marched through in steps that cannot pass a root.
    pub fn fly(&self) -> Outcome {
        match self.newton() {
            Some((sums, landing)) if landing.interval <= self.horizon && self.is_first(landing.interval, &sums) => {
                Outcome::Landing(landing)
            }
            _ => march::fly(self),
        }
    }

    /// The root of `h = u/s` (of `u/s³` at initiation) that Newton's method reaches, if it reaches one.
    fn newton(&self) -> Option<(Sums, Landing)> {
        let Forcing { acceleration, jerk, snap, .. } = self.forcing;
        let smallest = 1e-16 * self.flow.longest() * self.flow.longest();
        let mut s = self.first_guess();
        for _ in 0..NEWTON_STEPS {
            if !(s > 0.0 && s <= self.flow.longest()) {
                return None;
            }
            let (sums, motion) = self.at(s);
            // s h' = u' - h; a root is crossed downwards.
            let slope = motion.velocity - motion.deflated;
            if slope.is_nan() || slope >= 0.0 {
                return None;
            }
            // Halley's correction, with s² h'' to its lowest orders, makes the next error the cube of this step.
            let newton = -motion.deflated / slope;
            let bend = s * s * ((self.speed + jerk) / 3.0 + 0.25 * s * (acceleration + snap));
            let step = newton * (1.0 - 0.5 * newton * bend / slope);
            s += s * step;
            // The gain is wanted at the root itself; its slope carries it over a small step if the flight is short.
            if step.abs() <= 1e-8 && step.abs() * s * s <= smallest {
                let motion = Motion { gain: motion.gain + step * motion.gain_slope, ..motion };
                return Some((sums, self.landing(s, &sums, &motion)));
            }
        }
        None
    }

    /// The motion at local time `s`.
    fn at(&self, s: f64) -> (Sums, Motion) {
        let sums = self.flow.sums(s);
        (sums, sums.after_impact(self.speed, &self.forcing))
    }

    /// Where Newton's method starts.
    fn first_guess(&self) -> f64 {
        let Forcing { acceleration, jerk, snap, .. } = self.forcing;
        if self.speed == 0.0 {
            return -4.0 * jerk / snap; // Eq. 31 in u: j s³/6 + k s⁴/24 = 0
        }
        let parabola = -2.0 * self.speed / acceleration;
        // j s/3b is the first correction to the parabola; where it is large the last flight of the same sign is a better guess.
        let correction = jerk * parabola / (3.0 * acceleration);
        match self.guess {
            // The root of 1 - t + e t² with e the correction: t = 1 - e + 2 e² - ...
            _ if parabola > 0.0 && correction.abs() < 0.25 => parabola * (1.0 - correction * (1.0 - 2.0 * correction)),
            Some(guess) => guess,
            None => parabola,
        }
    }

    /// Whether `u` has no zero between the start and the root at the end of `sums`, proven in one of two ways.
    fn is_first(&self, s: f64, sums: &Sums) -> bool {
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
        let height = self.speed * sums.sinh() + bound * (sums.cosh() - 1.0).max(0.0);
        let lowest = (acceleration - s * fall).max(-1.0 - amplitude);
        let squared = omega * omega;
        let drive = if squared >= 1.0 { (squared - 1.0) * -lowest.min(0.0) } else { (1.0 - squared) * bound };
        snap < 0.0 && height - squared + drive < 0.0 && !(acceleration < 0.0 && self.speed + jerk > 0.0)
    }

    /// What is known at the impact.
    fn landing(&self, interval: f64, sums: &Sums, motion: &Motion) -> Landing {
        let Forcing { acceleration, jerk, snap, rounding } = self.forcing;
        let velocity = motion.gain - self.speed;
        let tilt = sums.tilt(&self.forcing);
        let (sinh, cosh) = (sums.sinh(), sums.cosh());
        // u'' = d/ds of u' = v cosh s + b sinh s + tilt; the last part's derivative to the order that a bound needs.
        let turn = interval * (jerk + 0.5 * interval * snap);
        // An error of the forcing moves u by db s²/2 + dj s³/6, and the gain by db s³/12 + dj s²/6 at the most.
        let from_jerk = rounding.1 * interval * interval / 6.0;
        let deflated = 2.0 * motion.size + 0.5 * interval * rounding.0 + from_jerk;
        let gain = 2.0 * motion.gain_size + interval.powi(3) * rounding.0 / 12.0 + from_jerk;
        Landing {
            interval,
            gain: motion.gain,
            velocity,
            acceleration: self.speed * sinh + acceleration * cosh + turn,
            by_speed: (sinh, cosh),
            by_time: (tilt, turn),
            rounding: (UNIT * interval * (deflated / velocity.abs() + 1.0), UNIT * gain),
        }
    }
}
