use contract::Case;

use super::{Conclusion, ENDLESS, Landing, Response, Run, Specimen, half_period};

/// Eqs 6-13 as they are printed: doubles, absolute time, `A_n e^-τ` and `B_n e^τ`, and a search for the next change of sign of the rotation. It
/// has no way of its own to end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PrintedInDoubles;

/// A flight is searched in steps of this share of the parabola's, from one such step after its start.
const SEARCH: f64 = 0.25;
/// And of no more than this share of half a period.
const LONGEST: f64 = 1.0 / 64.0;

/// The solution of Eq. 6 in one flight.
struct Flight {
    sign: f64,
    a: f64,
    b: f64,
    scale: f64,
    omega: f64,
    psi: f64,
}

impl Flight {
    /// Eqs 8 and 10, for the flight that leaves the base at `tau`.
    fn new(case: &Case, sign: f64, tau: f64, velocity: f64) -> Self {
        let (amplitude, omega) = (case.amplitude(), case.omega());
        let mut flight = Self {
            sign,
            a: 0.0,
            b: 0.0,
            scale: amplitude / (omega * omega + 1.0),
            omega,
            psi: (1.0 / amplitude).asin(),
        };
        let (rotation, slope) = flight.particular(tau);
        flight.a = -0.5 * (rotation - slope + sign + velocity) * tau.exp();
        flight.b = -0.5 * (rotation + slope + sign - velocity) * (-tau).exp();
        flight
    }

    /// `Ξ` and `Ξ'`.
    fn particular(&self, tau: f64) -> (f64, f64) {
        let (sin, cos) = (self.omega * tau + self.psi).sin_cos();
        (self.scale * sin, self.scale * self.omega * cos)
    }

    fn rotation(&self, tau: f64) -> f64 {
        self.b * tau.exp() + self.a * (-tau).exp() + self.sign + self.particular(tau).0
    }

    fn velocity(&self, tau: f64) -> f64 {
        self.b * tau.exp() - self.a * (-tau).exp() + self.particular(tau).1
    }

    /// The next change of sign after `tau`, to neighbouring doubles; nothing before `end`.
    fn landing(&self, tau: f64, step: f64, end: f64) -> Option<f64> {
        let mut low = tau;
        while low < end {
            let mut high = low + step;
            if high <= low {
                return Some(low); // time stands still
            }
            if self.sign * self.rotation(high) <= 0.0 {
                loop {
                    let middle = 0.5 * (low + high);
                    if middle <= low || middle >= high {
                        return Some(high);
                    }
                    let is_up = middle <= tau + 0.5 * step || self.sign * self.rotation(middle) > 0.0;
                    if is_up { low = middle } else { high = middle }
                }
            }
            low = high;
        }
        None
    }
}

impl Specimen for PrintedInDoubles {
    fn family(&self) -> &'static str {
        "Eq. 6 in absolute time"
    }

    fn setting(&self) -> String {
        String::new()
    }

    fn run(&self, case: &Case) -> Option<Run> {
        let (half_period, a, omega) = (half_period(case), case.amplitude(), case.omega());
        let end = 2.0 * half_period;
        let mut impacts: Vec<Landing> = Vec::new();
        let (mut tau, mut velocity, mut sign) = (0.0, 0.0, -1.0);
        let conclusion = loop {
            let flight = Flight::new(case, sign, tau, velocity);
            let acceleration = -sign - a * (omega * tau + flight.psi).sin();
            let parabola = (2.0 * velocity / acceleration).abs();
            // Of the first flight, which starts with a jerk (Eq. 31).
            let first = 4.0 * (case.epsilon() * (2.0 + case.epsilon())).sqrt() / omega;
            let expected = if impacts.is_empty() { first } else { parabola };
            let step = (SEARCH * expected).min(LONGEST * half_period);
            let Some(landing) = flight.landing(tau, step, end) else { break None };
            velocity = case.eta() * flight.velocity(landing);
            if sign * velocity >= 0.0 {
                break Some(Conclusion::Astray("the velocity at an impact has the wrong sign"));
            }
            impacts.push(Landing { time: landing, interval: landing - tau, velocity });
            if impacts.len() > ENDLESS || landing <= tau {
                break Some(Conclusion::Hangs("time stands still"));
            }
            (tau, sign) = (landing, -sign);
        };
        let response = conclusion.is_none().then(|| Response::of(case, &impacts, None));
        impacts.retain(|impact| impact.time < half_period);
        Some(Run { impacts, conclusion: conclusion.unwrap_or(Conclusion::Rocks), response, evaluations: None })
    }
}
