//! The critical amplitude, between one that is proven to be complete and one that is proven to be incomplete.

use contract::{Case, Decline, Invalid};

use crate::{
    bounds::Bounds,
    digits::Digits,
    directed::Directed,
    functions::pi,
    interval::Interval,
    ladder::{Attempt, climb},
    sequence::{self, End, Wanted},
};

/// A certified critical amplitude.
#[derive(Debug, Clone, PartialEq)]
pub struct Critical {
    /// `a_cr` lies between these.
    pub amplitude: Bounds,
    /// `a - 1` of an amplitude whose chattering is proven to be complete.
    pub epsilon_complete: f64,
    /// `a - 1` of one whose chattering is proven to be incomplete.
    pub epsilon_incomplete: f64,
    /// The exponent `β` of `1 - τ_ch/(T/2) ~ K (a_cr - a)^β`.
    pub exponent: f64,
    /// How many amplitudes were tried.
    pub tried: usize,
}

/// How far apart the two amplitudes may be.
const WIDTH: f64 = 2e-13;

/// How many amplitudes are tried.
const MOST_TRIED: usize = 200;

/// After so many the known approach is not trusted any more.
const TRUSTED: usize = 40;

/// What is proven of one amplitude.
enum Side {
    /// Complete; what is left of the half period, `1 - τ_ch/(T/2)`.
    Complete(f64),
    Incomplete,
}

/// The critical amplitude of the linear equation: complete below, incomplete above.
///
/// The search extrapolates the known approach `1 - τ_ch/(T/2) ~ K (a_cr - a)^β` from the amplitudes that were complete; the proof is that of
/// the two amplitudes returned.
///
/// # Errors
/// A [`Decline`] when a quantity is out of range or no bracket was found.
pub fn critical_amplitude(omega: f64, eta: f64) -> Result<Critical, Decline> {
    search(omega, eta, &[start(eta)])
}

/// The same, for who knows nearly where it is: proven at once if `epsilon`, its `a - 1`, is right to 8e-14, else found as by [`critical_amplitude`].
///
/// # Errors
/// As [`critical_amplitude`].
pub fn critical_amplitude_near(omega: f64, eta: f64, epsilon: f64) -> Result<Critical, Decline> {
    if !(epsilon > WIDTH && epsilon < 10.0) {
        return Err(Decline::OutOfRange { field: "epsilon", value: epsilon, allowed: "0 < epsilon < 10" });
    }
    search(omega, eta, &[epsilon - 0.4 * WIDTH, epsilon + 0.4 * WIDTH])
}

/// Eq. 77; no frequency in range has its critical amplitude beyond 10.
fn start(eta: f64) -> f64 {
    -0.3941 * eta.powi(3) + 0.5763 * eta * eta - 0.45 * eta + 0.271
}

/// From these amplitudes on.
fn search(omega: f64, eta: f64, first: &[f64]) -> Result<Critical, Decline> {
    let range = |field, value: f64, allowed| Decline::OutOfRange { field, value, allowed };
    if !(0.1..=100.0).contains(&omega) {
        return Err(range("omega", omega, "0.1 <= omega <= 100"));
    }
    if !(0.1..=0.98).contains(&eta) {
        return Err(range("eta", eta, "0.1 <= eta <= 0.98"));
    }
    let exponent = exponent(eta);
    let mut search = Search { complete: 0.0, incomplete: f64::INFINITY, points: Vec::new(), predicted: None, exponent };
    let mut first = first.iter();
    for tried in 1..=MOST_TRIED {
        let next = first.next().map_or_else(|| search.next(tried), |&next| next);
        let verdict = judge(next, omega, eta).map_err(|invalid| Decline::NotConvergent { why: invalid.to_string() })?;
        match verdict {
            None => {
                return Err(Decline::NotConvergent {
                    why: format!("the chattering at epsilon = {next:?} is undecided"),
                });
            }
            Some(Side::Complete(left)) => search.is_complete(next, left),
            Some(Side::Incomplete) => search.incomplete = search.incomplete.min(next),
        }
        if search.incomplete - search.complete <= WIDTH {
            return certified(search.complete, search.incomplete, exponent, tried);
        }
    }
    Err(Decline::NotConvergent { why: format!("no bracket after {MOST_TRIED} amplitudes") })
}

fn certified(complete: f64, incomplete: f64, exponent: f64, tried: usize) -> Result<Critical, Decline> {
    let one = Interval::<Digits<192>>::exactly(1.0);
    let amplitude = Bounds::new(&(&one + &Interval::between(complete, incomplete)))
        .ok_or(Decline::NotConvergent { why: "the bracket is empty".to_owned() })?;
    Ok(Critical { amplitude, epsilon_complete: complete, epsilon_incomplete: incomplete, exponent, tried })
}

/// What is known so far.
struct Search {
    complete: f64,
    incomplete: f64,
    /// Complete amplitudes with `(1 - τ_ch/(T/2))^(1/β)`, which vanishes at the critical one almost linearly.
    points: Vec<(f64, f64)>,
    predicted: Option<f64>,
    exponent: f64,
}

impl Search {
    fn is_complete(&mut self, epsilon: f64, left: f64) {
        self.complete = self.complete.max(epsilon);
        self.points.push((epsilon, left.powf(1.0 / self.exponent)));
        self.points.sort_by(|one, two| one.0.total_cmp(&two.0));
    }

    /// The next amplitude to try.
    fn next(&mut self, tried: usize) -> f64 {
        if self.incomplete.is_infinite() && self.points.len() < 2 {
            return 1.02 * self.complete;
        }
        let highest = if self.incomplete.is_finite() { self.incomplete } else { 2.0 * self.complete };
        let middle = if self.incomplete.is_finite() { 0.5 * (self.complete + self.incomplete) } else { highest };
        let inside = |epsilon: f64| if epsilon > self.complete && epsilon < highest { epsilon } else { middle };
        let [.., (e1, z1), (e2, z2)] = self.points.as_slice() else {
            // Only incomplete amplitudes so far, or one complete: come nearer from above.
            return if self.complete > 0.0 { middle } else { 0.97 * self.incomplete };
        };
        let predicted = e2 + (e2 - e1) * z2 / (z1 - z2);
        let before = self.predicted.replace(predicted);
        if tried > TRUSTED || !(predicted > self.complete && predicted < highest) {
            return middle;
        }
        let ahead = predicted - self.complete;
        if ahead > 0.4 * WIDTH {
            // From below, as near as the prediction is good.
            let margin = before.map_or(0.1 * ahead, |before| 2.0 * (predicted - before).abs());
            inside(predicted - margin.max(0.2 * WIDTH).min(0.3 * ahead))
        } else {
            inside(predicted + 0.4 * WIDTH)
        }
    }
}

/// The exponent of the approach. With `x` the flight over the time left, two impacts near the end of the half period act as one bounce with
/// restitution `η²` under a gravity that falls to zero linearly: the self-similar bounce solves `(1-x)²(3-x) = η²(3-2x)`, and `β = -ln(1-x)/ln μ`,
/// `μ = du'/du` for `u = x/2 - x²/6`, `u' = η²(x/2 - x²/3)/(1-x)²`.
pub fn exponent(eta: f64) -> f64 {
    let square = eta * eta;
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for _ in 0..200 {
        let x = 0.5 * (low + high);
        if (1.0 - x).powi(2) * (3.0 - x) > square * (3.0 - 2.0 * x) { low = x } else { high = x }
    }
    let x = 0.5 * (low + high);
    let du = 0.5 - x / 3.0;
    let du_next =
        square * ((0.5 - 2.0 * x / 3.0) / (1.0 - x).powi(2) + 2.0 * (0.5 * x - x * x / 3.0) / (1.0 - x).powi(3));
    -(1.0 - x).ln() / (du_next / du).ln()
}

/// An amplitude tried with some number of digits.
struct Judging {
    case: Case,
}

impl Attempt for Judging {
    type Answer = Option<Side>;

    fn with<F: Directed>(&self) -> (Option<Side>, bool) {
        let wanted = Wanted { impacts: 1, followed: 100_000, width: 1e-13 };
        let verdict = match sequence::follow::<F>(&self.case, None, wanted).end {
            End::Complete(time) => {
                let share = &(&time * &Interval::exactly(self.case.omega())) / &pi();
                Some(Side::Complete((&Interval::exactly(1.0) - &share).middle()))
            }
            End::HalfPeriod | End::Overturned => Some(Side::Incomplete),
            _ => None,
        };
        let decided = verdict.is_some();
        (verdict, decided)
    }
}

fn judge(epsilon: f64, omega: f64, eta: f64) -> Result<Option<Side>, Invalid> {
    let case = Case::from_epsilon(epsilon, omega, eta)?;
    Ok(climb(&Judging { case }, <f64 as Directed>::BITS))
}
