//! Any motion, by its formulas.

use contract::{Motion, RICKER_ANTISYMMETRIC_PEAK, Record, Ricker, Sinusoid, Stretch};

/// In how many steps of the time in which a motion changes its pushes are looked for.
const LOOKS: f64 = 200.0;

/// The formula that holds at `tau`, at `tau + s`.
pub fn at(motion: &Motion, tau: f64, s: f64) -> f64 {
    let time = tau + s;
    match motion {
        Motion::Sinusoids(stretches) => stretches.iter().find(|stretch| tau < stretch.until).map_or(0.0, |stretch| {
            stretch.terms.iter().map(|term| term.amplitude * (term.omega * time + term.phase).sin()).sum()
        }),
        Motion::Ricker(ricker) => wavelet(ricker, time),
        Motion::Record(record) => {
            let Record { dt, scale, samples } = record;
            let k = segment(record, tau);
            let sample = |k: usize| samples.get(k).map_or(0.0, |sample| scale * sample);
            if k + 1 >= samples.len() {
                return 0.0;
            }
            let slope = (sample(k + 1) - sample(k)) / dt;
            // Since the start of the segment; `s` for itself, so that a short time is not lost beside a long one.
            sample(k) + slope * (tau - k as f64 * dt) + slope * s
        }
    }
}

/// `a (1 - y²) exp(-y²/2)` with `y = ω(τ - center)/√2`, or `a/1.3801 (y³ - 3y) exp(-y²/2)` with `y = ω(τ - center)/√3`.
fn wavelet(Ricker { amplitude, omega, center, antisymmetric }: &Ricker, tau: f64) -> f64 {
    if *antisymmetric {
        let y = omega * (tau - center) / 3.0_f64.sqrt();
        amplitude / RICKER_ANTISYMMETRIC_PEAK * (y.powi(3) - 3.0 * y) * (-0.5 * y * y).exp()
    } else {
        let y = omega * (tau - center) / 2.0_f64.sqrt();
        amplitude * (1.0 - y * y) * (-0.5 * y * y).exp()
    }
}

/// The number of the segment of a record that `tau` is in.
fn segment(record: &Record, tau: f64) -> usize {
    let k = (tau / record.dt).floor().max(0.0) as usize;
    // The quotient may be rounded to the wrong side of a sample.
    let starts = |k: usize| k as f64 * record.dt;
    if starts(k + 1) <= tau {
        k + 1
    } else if starts(k) > tau {
        k.saturating_sub(1)
    } else {
        k
    }
}

pub fn change(motion: &Motion, tau: f64) -> f64 {
    match motion {
        Motion::Sinusoids(stretches) => {
            stretches.iter().map(|stretch| stretch.until).find(|until| tau < *until).unwrap_or(f64::INFINITY)
        }
        Motion::Ricker(_) => f64::INFINITY,
        Motion::Record(record) => {
            let next = segment(record, tau) + 1;
            if next < record.samples.len() { next as f64 * record.dt } else { f64::INFINITY }
        }
    }
}

fn terms(motion: &Motion) -> impl Iterator<Item = &Sinusoid> {
    let stretches: &[Stretch] = if let Motion::Sinusoids(stretches) = motion { stretches } else { &[] };
    stretches.iter().flat_map(|stretch| &stretch.terms)
}

pub fn amplitude(motion: &Motion) -> f64 {
    match motion {
        // Of all stretches together, which is too much where there are several.
        Motion::Sinusoids(_) => terms(motion).map(|term| term.amplitude.abs()).sum(),
        Motion::Ricker(ricker) => 1.001 * ricker.amplitude.abs(),
        Motion::Record(Record { scale, samples, .. }) => {
            samples.iter().map(|sample| (scale * sample).abs()).fold(0.0, f64::max)
        }
    }
}

pub fn slope(motion: &Motion) -> f64 {
    match motion {
        Motion::Sinusoids(_) => terms(motion).map(|term| (term.amplitude * term.omega).abs()).sum(),
        // |y³ - 3y| exp(-y²/2) is below 1.39, and |-y⁴ + 6y² - 3| exp(-y²/2) not above 3.
        Motion::Ricker(Ricker { amplitude, omega, .. }) => 2.0 * (amplitude * omega).abs(),
        Motion::Record(Record { dt, scale, samples }) => {
            let steps = samples.windows(2).map(|pair| match pair {
                [one, two] => (scale * (two - one) / dt).abs(),
                _ => 0.0,
            });
            steps.fold(0.0, f64::max)
        }
    }
}

pub fn rate(motion: &Motion) -> f64 {
    match motion {
        Motion::Sinusoids(_) => terms(motion).map(|term| term.omega).fold(0.0, f64::max),
        Motion::Ricker(ricker) => 2.0 * ricker.omega,
        Motion::Record(_) => 0.0,
    }
}

/// The time in which a motion changes.
fn scale(motion: &Motion) -> f64 {
    match motion {
        Motion::Record(record) => record.dt,
        Motion::Sinusoids(_) | Motion::Ricker(_) => rate(motion).max(1e-6).recip(),
    }
}

/// By looking often. What begins between two looks is halved down to the last digit.
pub fn next_start(motion: &Motion, tau: f64, until: f64) -> Option<(f64, f64)> {
    let mut now = tau;
    while now < until {
        let value = at(motion, now, 0.0);
        let mut to = (now + scale(motion) / LOOKS).min(change(motion, now)).min(until);
        if value.abs() > 1.0 {
            return Some((now, -value.signum()));
        }
        // By the formula that holds here.
        let above = |time: f64| at(motion, now, time - now).abs() > 1.0;
        if above(to) {
            let side = -at(motion, now, to - now).signum();
            let mut below = now;
            loop {
                let middle = below + 0.5 * (to - below);
                if middle <= below || middle >= to {
                    return (to < until).then_some((to, side));
                }
                if above(middle) { to = middle } else { below = middle }
            }
        }
        now = if to > now { to } else { now.next_up() };
    }
    None
}

pub fn pushes(motion: &Motion, tau: f64) -> f64 {
    let step = scale(motion) / LOOKS;
    let above = |time: f64| at(motion, time.max(0.0), 0.0).abs() > 1.0;
    let looks = |direction: f64| {
        let mut away = step;
        while away < LOOKS * step && above(tau + direction * away) && tau + direction * away > 0.0 {
            away += step;
        }
        away
    };
    looks(1.0) + looks(-1.0)
}

/// By what multiple of `delta` the end of a motion moves: its times move together.
pub fn stretched(motion: &Motion) -> f64 {
    if matches!(motion, Motion::Record(_)) { 0.7 } else { 0.4 }
}

/// Stronger, slower and later by a mix of directions for each sign.
pub fn moved(motion: &Motion, delta: f64) -> Motion {
    let by = |share: f64| 1.0 + share * delta;
    let other = f64::from(u8::from(delta < 0.0)) * 2.0 - 1.0;
    match motion {
        Motion::Sinusoids(stretches) => {
            let term = |(k, term): (usize, &Sinusoid)| {
                let sign = if k % 2 == 0 { 1.0 } else { other };
                Sinusoid {
                    amplitude: term.amplitude * by(sign),
                    omega: term.omega * by(-0.7 * sign),
                    phase: term.phase + 0.8 * other * delta.abs(),
                }
            };
            let stretch = |stretch: &Stretch| Stretch {
                until: stretch.until * by(stretched(motion)),
                terms: stretch.terms.iter().enumerate().map(term).collect(),
            };
            Motion::Sinusoids(stretches.iter().map(stretch).collect())
        }
        Motion::Ricker(of) => Motion::Ricker(Ricker {
            amplitude: of.amplitude * by(1.0),
            omega: of.omega * by(-0.7),
            center: of.center * by(stretched(motion)),
            ..*of
        }),
        Motion::Record(of) => {
            Motion::Record(Record { scale: of.scale * by(1.0), dt: of.dt * by(stretched(motion)), ..of.clone() })
        }
    }
}
