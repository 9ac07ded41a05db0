//! A motion of the ground as the harness has it; each oracle has its own.

use contract::{Motion, RICKER_ANTISYMMETRIC_PEAK, Record, Ricker, Sinusoid, Stretch};

/// When the ground begins to push a resting block off its base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Push {
    /// When, `τ`.
    pub time: f64,
    /// To which side the block leaves, 1 or -1: against the acceleration of the ground.
    pub side: f64,
}

/// `f` at `tau`, in multiples of the threshold; where it jumps, as after the jump.
pub fn acceleration(motion: &Motion, tau: f64) -> f64 {
    if !(tau >= 0.0 && tau < motion.duration()) {
        // A record has its last sample too.
        let is_last = matches!(motion, Motion::Record(_)) && tau == motion.duration();
        if !is_last {
            return 0.0;
        }
    }
    match motion {
        Motion::Sinusoids(stretches) => {
            stretches.iter().find(|stretch| stretch.until > tau).map_or(0.0, |stretch| sum(&stretch.terms, tau).0)
        }
        Motion::Ricker(ricker) => wavelet(ricker, tau).0,
        Motion::Record(record) => {
            let k = segment(record, tau);
            let (from, to) = (sample(record, k), sample(record, k + 1));
            from + (to - from) * ((tau - k as f64 * record.dt) / record.dt)
        }
    }
}

/// When after `from`, or at it, the ground begins to push a resting block off its base: where `|f|` exceeds 1, or is about to.
pub fn next_push(motion: &Motion, from: f64) -> Option<Push> {
    match motion {
        Motion::Record(record) => next_of_record(record, from.max(0.0)),
        Motion::Sinusoids(stretches) => {
            let mut begin: f64 = 0.0;
            for Stretch { until, terms } in stretches {
                let (low, high) = (begin.max(from), *until);
                begin = *until;
                if low >= high {
                    continue;
                }
                let smooth = Smooth {
                    at: &|tau| sum(terms, tau),
                    curvature: terms.iter().map(|term| (term.amplitude * term.omega * term.omega).abs()).sum(),
                    scale: terms.iter().map(|term| term.omega).fold(0.0, f64::max).recip(),
                };
                let high = high.min(low + LONGEST * smooth.scale.min(1e12));
                if let Some(push) = smooth.next(low, high) {
                    return Some(push);
                }
            }
            None
        }
        Motion::Ricker(ricker) => {
            let scale = width(ricker);
            let (third, peak) = if ricker.antisymmetric { (6.0, RICKER_ANTISYMMETRIC_PEAK) } else { (3.0, 1.0) };
            let curvature = ricker.amplitude.abs() / peak * third / (scale * scale);
            Smooth { at: &|tau| wavelet(ricker, tau), curvature, scale }.next(from.max(0.0), 2.0 * ricker.center)
        }
    }
}

/// When after `from`, where the ground pushes, it holds a resting block down again, `|f| <= 1`; `None` if it does so at no time up to `until`.
pub fn next_gap(motion: &Motion, from: f64, until: f64) -> Option<f64> {
    let end = motion.duration().min(until);
    let above = |tau: f64| acceleration(motion, tau).abs() > 1.0;
    // What lasts less than a fiftieth of the fastest part of the motion, or a quarter of a sample, is no gap that impacts accumulate in. And just after a push the
    // threshold itself may be rounded to either side: that much of a step is passed over.
    let step = match motion {
        Motion::Record(record) => 0.25 * record.dt,
        Motion::Sinusoids(_) | Motion::Ricker(_) => 0.02 / fastest(motion).max(1e-9),
    };
    let mut low = from + 1e-3 * step;
    if !above(low) {
        return Some(low.min(end));
    }
    while low < end {
        let high = (low + step).min(end);
        if !above(high) {
            let (mut inside, mut outside) = (low, high);
            for _ in 0..60 {
                let middle = 0.5 * (inside + outside);
                if above(middle) { inside = middle } else { outside = middle }
            }
            return Some(outside);
        }
        low = high;
    }
    (motion.duration() <= until).then_some(end)
}

/// A bound on `|f|`.
pub fn strongest(motion: &Motion) -> f64 {
    match motion {
        Motion::Sinusoids(stretches) => {
            let size = |stretch: &Stretch| stretch.terms.iter().map(|term| term.amplitude.abs()).sum();
            stretches.iter().map(size).fold(0.0, f64::max)
        }
        Motion::Ricker(ricker) => ricker.amplitude.abs(),
        Motion::Record(record) => record.samples.iter().fold(0.0, |most, of| (of * record.scale).abs().max(most)),
    }
}

/// How fast a motion changes: the largest frequency that it has.
pub fn fastest(motion: &Motion) -> f64 {
    match motion {
        Motion::Sinusoids(stretches) => {
            stretches.iter().flat_map(|stretch| &stretch.terms).map(|term| term.omega).fold(0.0, f64::max)
        }
        Motion::Ricker(ricker) => ricker.omega,
        Motion::Record(record) => std::f64::consts::PI / record.dt,
    }
}

/// For how many times its shortest time scale a motion without end is searched for its next push: for as long as it may be followed.
const LONGEST: f64 = std::f64::consts::TAU * Motion::MOST_CYCLES;

/// A smooth stretch of a motion.
struct Smooth<'a> {
    /// `f` and its slope.
    at: &'a dyn Fn(f64) -> (f64, f64),
    /// A bound on `|f''|`.
    curvature: f64,
    /// The time in which it changes.
    scale: f64,
}

impl Smooth<'_> {
    fn next(&self, low: f64, high: f64) -> Option<Push> {
        let push = |time: f64, value: f64| Some(Push { time, side: -value.signum() });
        let (value, slope) = (self.at)(low);
        if value.abs() > 1.0 || value.abs() == 1.0 && value * slope > 0.0 {
            return push(low, value);
        }
        let mut from = low;
        while from < high {
            let to = (from + 0.5 * self.scale).min(high);
            if to <= from {
                return None;
            }
            if let Some((time, value)) = self.first(from, to, 1e-10 * self.scale) {
                return push(time, value);
            }
            from = to;
        }
        None
    }

    /// Where `|f|` first exceeds 1 between two times, and on which side; at the first it does not.
    fn first(&self, from: f64, to: f64, shortest: f64) -> Option<(f64, f64)> {
        let ((low, rate), (high, _)) = ((self.at)(from), (self.at)(to));
        let length = to - from;
        let bow = self.curvature * length * length / 8.0;
        if low.abs().max(high.abs()) + bow <= 1.0 {
            return None;
        }
        let is_monotone = rate.abs() > self.curvature * length;
        if is_monotone || length <= shortest {
            return (high.abs() > 1.0).then(|| (self.passes(from, to, high), high));
        }
        let middle = from + 0.5 * length;
        if middle <= from || middle >= to {
            return (high.abs() > 1.0).then_some((to, high));
        }
        self.first(from, middle, shortest).or_else(|| {
            // What passes within a part that is as short as can be is seen at its end.
            let at = (self.at)(middle).0;
            if at.abs() > 1.0 { Some((middle, at)) } else { self.first(middle, to, shortest) }
        })
    }

    /// The last time between two at which `f` has not passed the threshold on the side of `value`.
    fn passes(&self, mut from: f64, mut to: f64, value: f64) -> f64 {
        loop {
            let middle = from + 0.5 * (to - from);
            if middle <= from || middle >= to {
                return from;
            }
            if (self.at)(middle).0 * value.signum() > 1.0 { to = middle } else { from = middle }
        }
    }
}

/// A sum of sinusoids and its slope; what rounding takes from an angle is put back.
fn sum(terms: &[Sinusoid], tau: f64) -> (f64, f64) {
    terms.iter().fold((0.0, 0.0), |(value, slope), term| {
        let turned = term.omega * tau;
        let angle = turned + term.phase;
        let back = angle - turned;
        let lost = (turned - (angle - back)) + (term.phase - back) + term.omega.mul_add(tau, -turned);
        let (sin, cos) = angle.sin_cos();
        let (sin, cos) = (sin + lost * cos, cos - lost * sin);
        (value + term.amplitude * sin, slope + term.amplitude * term.omega * cos)
    })
}

/// The time over which the argument of a wavelet changes by 1.
fn width(ricker: &Ricker) -> f64 {
    if ricker.antisymmetric { 3.0_f64.sqrt() / ricker.omega } else { std::f64::consts::SQRT_2 / ricker.omega }
}

fn wavelet(ricker: &Ricker, tau: f64) -> (f64, f64) {
    let width = width(ricker);
    let y = (tau - ricker.center) / width;
    let square = y * y;
    let (gauss, amplitude) = ((-0.5 * square).exp(), ricker.amplitude);
    if ricker.antisymmetric {
        let amplitude = amplitude / RICKER_ANTISYMMETRIC_PEAK;
        let value = y * (square - 3.0) * gauss;
        (amplitude * value, amplitude * (3.0 * square - 3.0 - y * y * (square - 3.0)) * gauss / width)
    } else {
        (amplitude * (1.0 - square) * gauss, amplitude * y * (square - 3.0) * gauss / width)
    }
}

fn sample(record: &Record, k: usize) -> f64 {
    record.samples.get(k).map_or(0.0, |sample| sample * record.scale)
}

/// The number of the last sample that is not after `tau`.
fn segment(record: &Record, tau: f64) -> usize {
    let mut k = (tau / record.dt) as usize;
    while k > 0 && k as f64 * record.dt > tau {
        k -= 1;
    }
    while (k + 1) as f64 * record.dt <= tau {
        k += 1;
    }
    k
}

fn next_of_record(record: &Record, from: f64) -> Option<Push> {
    let last = record.samples.len().checked_sub(1)?;
    let mut k = segment(record, from);
    while k < last {
        let (low, high) = (sample(record, k), sample(record, k + 1));
        let (start, slope) = (k as f64 * record.dt, (high - low) / record.dt);
        let begin = start.max(from);
        let value = low + slope * (begin - start);
        if value.abs() > 1.0 {
            return Some(Push { time: begin, side: -value.signum() });
        }
        if high.abs() > 1.0 {
            let time = start + (high.signum() - low) / slope;
            return Some(Push { time: time.clamp(begin, (k + 1) as f64 * record.dt), side: -high.signum() });
        }
        k += 1;
    }
    None
}

#[cfg(test)]
mod tests;
