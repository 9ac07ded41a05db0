//! Motions of the ground that are no case, span by span: in each the acceleration is one analytic function.

use contract::{Motion, Record, Ricker, Sinusoid, Stretch};

use crate::forcing::{Change, Forcing, Wave, Wavelet};

/// A span of time in which the ground moves as one analytic function.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Span<'m> {
    /// When it ends, `tau`.
    pub until: f64,
    course: Course<'m>,
}

#[derive(Debug, Clone, Copy)]
enum Course<'m> {
    /// `value + slope (tau - start)`.
    Line {
        start: f64,
        value: f64,
        slope: f64,
    },
    Waves(&'m [Sinusoid]),
    Wavelet(&'m Ricker),
}

/// How many samples of a record a span is over at the most.
const LONGEST: usize = 1000;

impl<'m> Span<'m> {
    const STILL: Self = Self { until: f64::INFINITY, course: Course::Line { start: 0.0, value: 0.0, slope: 0.0 } };

    /// The span that `time` is in, or that begins there.
    pub fn at(motion: &'m Motion, time: f64) -> Self {
        match motion {
            Motion::Sinusoids(stretches) => Self::of_stretches(stretches, time),
            Motion::Ricker(ricker) if time < motion.duration() => {
                Self { until: motion.duration(), course: Course::Wavelet(ricker) }
            }
            Motion::Ricker(_) => Self::STILL,
            Motion::Record(record) => Self::of_record(record, time).unwrap_or(Self::STILL),
        }
    }

    fn of_stretches(stretches: &'m [Stretch], time: f64) -> Self {
        let mut left = stretches.iter().skip_while(|stretch| stretch.until <= time);
        let Some(first) = left.next() else { return Self::STILL };
        // Stretches of the same sum are one.
        let last = left.take_while(|next| next.terms == first.terms).last().unwrap_or(first);
        Self { until: last.until, course: Course::Waves(&first.terms) }
    }

    fn of_record(record: &Record, time: f64) -> Option<Self> {
        let Record { dt, scale, samples } = record;
        let at = |k: usize| k as f64 * dt;
        let sample = |k: usize| samples.get(k).map(|sample| sample * scale);
        let rise = |k: usize| Some(sample(k + 1)? - sample(k)?);
        // The quotient may be rounded to the sample after the one before `time`.
        let near = (time / dt) as usize;
        let k = if at(near) > time { near.saturating_sub(1) } else { near };
        let k = if at(k + 1) <= time { k + 1 } else { k };
        let own = rise(k)?;
        // As long as the slope is the same, it is one line; it is not looked for for ever.
        let end = (k + 1..k + LONGEST).find(|next| rise(*next) != Some(own)).unwrap_or(k + LONGEST);
        Some(Self { until: at(end), course: Course::Line { start: at(k), value: sample(k)?, slope: own / dt } })
    }

    /// What a flight of sign `i` sees that starts at `tau` in this span; `waves` is where the sums of its terms are kept.
    pub fn forcing<'w>(&self, i: f64, tau: f64, waves: &'w mut Vec<Wave>) -> Forcing<'w> {
        match self.course {
            Course::Line { start, value, slope } => {
                Forcing { excess: (i + value) + slope * (tau - start), change: Change::Line(slope) }
            }
            Course::Waves([term]) => {
                let wave = Wave::new(term, tau);
                Forcing { excess: i + wave.value, change: Change::Wave(wave) }
            }
            Course::Waves(terms) => {
                waves.clear();
                waves.extend(terms.iter().map(|term| Wave::new(term, tau)));
                let f: f64 = waves.iter().map(|wave| wave.value).sum();
                Forcing { excess: i + f, change: Change::Waves(waves) }
            }
            Course::Wavelet(ricker) => {
                let wavelet = Wavelet::new(ricker, tau);
                Forcing { excess: i + wavelet.value(), change: Change::Wavelet(wavelet) }
            }
        }
    }

    /// A bound on `|f'|`.
    fn steepest(&self) -> f64 {
        match self.course {
            Course::Line { slope, .. } => slope.abs(),
            Course::Waves(terms) => terms.iter().map(|term| (term.amplitude * term.omega).abs()).sum(),
            Course::Wavelet(ricker) => Wavelet::new(ricker, 0.0).steepest(),
        }
    }

    /// What rounding may have done to `i + f` at `tau`, and that of `tau` itself: each is a sum of terms no larger than these.
    pub fn rounding(&self, tau: f64) -> f64 {
        let size = match self.course {
            Course::Line { value, .. } => value.abs(),
            Course::Waves(terms) => terms.iter().map(|term| term.amplitude.abs()).sum(),
            Course::Wavelet(ricker) => ricker.amplitude.abs(),
        };
        8.0 * f64::EPSILON * (1.0 + size + self.steepest() * tau)
    }
}

/// A bound on `|f'|` from `time` on over a window; `None` if `f` may jump in it.
pub(crate) fn steepest(motion: &Motion, time: f64, window: f64) -> Option<f64> {
    let (mut from, mut steepest) = (time, 0.0_f64);
    loop {
        let span = Span::at(motion, from);
        steepest = steepest.max(span.steepest());
        if span.until >= time + window {
            return Some(steepest);
        }
        // A record goes on without a jump, up to its end, and there too if it ends with nothing.
        let Motion::Record(record) = motion else { return None };
        if span.until >= motion.duration() && record.samples.last().is_none_or(|last| *last != 0.0) {
            return None;
        }
        from = span.until;
    }
}

/// A bound on `|f|`.
pub(crate) fn strongest(motion: &Motion) -> f64 {
    let of_terms = |stretch: &Stretch| stretch.terms.iter().map(|term| term.amplitude.abs()).sum();
    match motion {
        Motion::Sinusoids(stretches) => stretches.iter().map(of_terms).fold(0.0, f64::max),
        Motion::Ricker(ricker) => ricker.amplitude.abs(),
        Motion::Record(record) => record.samples.iter().map(|sample| (sample * record.scale).abs()).fold(0.0, f64::max),
    }
}
