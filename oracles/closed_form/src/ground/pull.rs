//! The pull towards the base, `c = 1 + i f`, as a flight sees it: what it is at its start, and what is added to it later.

use contract::{Decline, Motion, Record, Sinusoid, Stretch};

/// A wave in the pull: `value (cos(ωr) - 1) + rate sin(ωr)/ω`, with `r` from where it starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    pub value: f64,
    pub rate: f64,
    pub omega: f64,
}

/// What is added to the pull from a time on, until the pull changes again.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// From when, since the start of the flight.
    pub at: f64,
    /// A jump.
    pub level: f64,
    /// A change of the slope.
    pub slope: f64,
    pub waves: Vec<Wave>,
    /// A bound on `|c''|` from here on; 0 for a straight line.
    pub curvature: f64,
    /// The fastest wave from here on, at least 1, the rate of the block itself.
    pub rate: f64,
}

/// A motion that this method can do.
pub enum Ground {
    Sinusoids(Vec<Stretch>),
    /// With the strongest sample from each on.
    Record(Record, Vec<f64>),
}

impl Ground {
    pub fn new(motion: &Motion) -> Result<Self, Decline> {
        match motion {
            Motion::Sinusoids(stretches) => Ok(Self::Sinusoids(stretches.clone())),
            Motion::Record(record) => {
                let mut strongest: Vec<f64> =
                    record.samples.iter().map(|sample| (sample * record.scale).abs()).collect();
                let mut most: f64 = 0.0;
                for size in strongest.iter_mut().rev() {
                    most = most.max(*size);
                    *size = most;
                }
                Ok(Self::Record(record.clone(), strongest))
            }
            Motion::Ricker(_) => Err(Decline::Unsupported { what: "a Ricker wavelet, which has no closed form" }),
        }
    }

    /// The pull at `time` on the side `side`, and all that changes in it up to `horizon` later, in order.
    pub fn pull(&self, side: f64, time: f64, horizon: f64) -> Vec<Change> {
        match self {
            Self::Sinusoids(stretches) => of_sinusoids(stretches, side, time, horizon),
            Self::Record(record, _) => of_record(record, side, time, horizon).collect(),
        }
    }

    /// The same, one after the other: those of a record are made as they are asked for.
    pub fn changes(&self, side: f64, time: f64, horizon: f64) -> Box<dyn Iterator<Item = Change> + '_> {
        match self {
            Self::Sinusoids(stretches) => Box::new(of_sinusoids(stretches, side, time, horizon).into_iter()),
            Self::Record(record, _) => Box::new(of_record(record, side, time, horizon)),
        }
    }

    /// The pull at `time` on the side `side`, as after a jump there.
    pub fn level(&self, side: f64, time: f64) -> f64 {
        self.changes(side, time, 0.0).next().map_or(0.0, |change| change.level)
    }

    /// A bound on `|f|` from `time` on.
    pub fn strongest(&self, time: f64) -> f64 {
        match self {
            Self::Sinusoids(stretches) => {
                let left = stretches.iter().filter(|stretch| stretch.until > time);
                let size = |stretch: &Stretch| stretch.terms.iter().map(|term| term.amplitude.abs()).sum();
                left.map(size).fold(0.0, f64::max)
            }
            Self::Record(record, strongest) => strongest.get((time / record.dt) as usize).copied().unwrap_or(0.0),
        }
    }
}

fn of_sinusoids(stretches: &[Stretch], side: f64, time: f64, horizon: f64) -> Vec<Change> {
    let mut now: &[Sinusoid] = &[];
    let mut left = stretches.iter().skip_while(|stretch| stretch.until <= time);
    let mut next = left.next();
    let mut changes = Vec::new();
    if let Some(stretch) = next {
        now = &stretch.terms;
    }
    let mut first = change(0.0, side, time, &[], now);
    first.level += 1.0;
    changes.push(first);
    while let Some(stretch) = next.filter(|stretch| stretch.until - time < horizon) {
        let (before, end) = (now, stretch.until);
        next = left.next();
        now = next.map_or(&[], |stretch| &stretch.terms);
        changes.push(change(end - time, side, end, before, now));
    }
    changes
}

/// What changes where one sum gives way to another at `time`; terms that go on are left as they are.
fn change(at: f64, side: f64, time: f64, before: &[Sinusoid], after: &[Sinusoid]) -> Change {
    let mut waves = Vec::new();
    let mut level = 0.0;
    let mut add = |sign: f64, term: &Sinusoid| {
        let (sin, cos) = angle(term, time);
        let (value, rate) = (sign * side * term.amplitude * sin, sign * side * term.amplitude * term.omega * cos);
        level += value;
        waves.push(Wave { value, rate, omega: term.omega });
    };
    before.iter().filter(|term| !after.contains(term)).for_each(|term| add(-1.0, term));
    after.iter().filter(|term| !before.contains(term)).for_each(|term| add(1.0, term));
    let curvature = after.iter().map(|term| (term.amplitude * term.omega * term.omega).abs()).sum();
    let rate = after.iter().map(|term| term.omega).fold(1.0, f64::max);
    Change { at, level, slope: 0.0, waves, curvature, rate }
}

/// The sine and the cosine of `ω time + phase`, with what rounding takes from the angle put back.
fn angle(term: &Sinusoid, time: f64) -> (f64, f64) {
    let turned = term.omega * time;
    let lost = term.omega.mul_add(time, -turned);
    let sum = turned + term.phase;
    let back = sum - turned;
    let rest = (turned - (sum - back)) + (term.phase - back) + lost;
    let (sin, cos) = sum.sin_cos();
    (sin + rest * cos, cos - rest * sin)
}

fn of_record(record: &Record, side: f64, time: f64, horizon: f64) -> impl Iterator<Item = Change> + '_ {
    let Record { dt, scale, samples } = record;
    let last = samples.len().saturating_sub(1);
    let sample = move |k: usize| samples.get(k).map_or(0.0, |sample| sample * scale);
    let straight =
        |at: f64, level: f64, slope: f64| Change { at, level, slope, waves: Vec::new(), curvature: 0.0, rate: 1.0 };
    // The piece that `time` is in: the last one that does not start after it.
    let mut k = (time / dt) as usize;
    while k as f64 * dt > time && k > 0 {
        k -= 1;
    }
    while (k + 1) as f64 * dt <= time {
        k += 1;
    }
    let slope_of = move |k: usize| if k < last { side * ((sample(k + 1) - sample(k)) / dt) } else { 0.0 };
    let first = if k < last {
        let slope = slope_of(k);
        straight(0.0, (1.0 + side * sample(k)) + slope * (time - k as f64 * dt), slope)
    } else {
        straight(0.0, 1.0, 0.0)
    };
    let mut before = first.slope;
    let later = (k + 1..=last).map_while(move |k| {
        let at = k as f64 * dt - time;
        let slope = slope_of(k);
        let jump = if k == last { -side * sample(last) } else { 0.0 };
        let change = straight(at, jump, slope - before);
        let is_none = slope == before && jump == 0.0;
        before = slope;
        (at < horizon).then_some((change, is_none))
    });
    std::iter::once(first).chain(later.filter(|(_, is_none)| !is_none).map(|(change, _)| change))
}
