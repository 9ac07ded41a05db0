use contract::{Decline, Estimate, Impact, Uncertainty};
use twofloat::TwoFloat;

use crate::compensated::Compensated;
use crate::flight::Block;
use crate::march::{self, Limit, Search, march};
use crate::number::Number;
use crate::series::Series;
use crate::truncated;

/// The asymptotic series of Section 3 to any order, for one frequency ratio and one restitution:
/// `ω τ_ch = ε^(1/2) (c₀ + c₁ ε + c₂ ε² + ...)`, and the same for each impact.
///
/// The paper keeps `c₀` and a part of `c₁` (Eq. 65). Here the iteration of Section 3 runs in power series of `ε` that are truncated at the same
/// order in every flight. Computing it takes milliseconds; then a value at one `ε` costs as many multiplications as there are terms.
#[derive(Debug, Clone)]
pub struct Expansion {
    omega: f64,
    eta: f64,
    precise: Series<TwoFloat>,
    coefficients: Vec<Coefficient>,
    impacts: Vec<ImpactSeries>,
}

/// A coefficient `c_k` of `ω τ_ch/ε^(1/2)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficient {
    /// The double nearest to what was computed.
    pub value: f64,
    /// What it may be off by: by that rounding, by the rounding before it, and because not all flights were followed.
    pub error: f64,
}

/// The series of one impact, in the units in which they have integer powers of `ε` and a constant term.
#[derive(Debug, Clone)]
struct ImpactSeries {
    /// `ω τ_n/ε^(1/2)`.
    time: Vec<f64>,
    /// `ω Δτ_{n-1}/ε^(1/2)`. That of an odd flight has no constant term.
    interval: Vec<f64>,
    /// `ω φ'_n/ε^(3/2)`.
    velocity: Vec<f64>,
}

impl Expansion {
    /// The largest number of terms.
    pub const MOST_TERMS: usize = 96;

    /// The series with `terms` terms, and those of the first `impacts` impacts.
    ///
    /// # Errors
    /// When `omega` is outside [0.05, 1000], `eta` outside [0.01, 0.99], or `terms` outside [1, [`Self::MOST_TERMS`]].
    pub fn new(omega: f64, eta: f64, terms: usize, impacts: usize) -> Result<Self, Decline> {
        for (field, value, range, allowed) in [
            ("omega", omega, 0.05..=1e3, "0.05 to 1000 for the series to any order"),
            ("eta", eta, 0.01..=0.99, "0.01 to 0.99 for the series to any order"),
            ("order", terms as f64, 1.0..=Self::MOST_TERMS as f64, "1 to 96"),
        ] {
            if !range.contains(&value) {
                return Err(Decline::OutOfRange { field, value, allowed });
            }
        }
        let (listed, limit) = march(&Block::<TwoFloat>::new(omega, eta), terms, impacts, Search::Until(PRECISION));
        let limit = limit.ok_or_else(|| Decline::NotConvergent {
            why: format!("the coefficients of the series at eta = {eta} have not settled"),
        })?;
        let (pairs, column) = limit.found_at;
        let (_, plain) = march(&Block::<f64>::new(omega, eta), terms, 0, Search::At(pairs, column));
        Ok(Self {
            omega,
            eta,
            coefficients: coefficients(&limit, plain.as_ref()),
            precise: limit.value,
            impacts: listed.iter().map(ImpactSeries::new).collect(),
        })
    }

    /// The same with the first `terms` terms at the most, and without the impacts.
    pub fn shortened(&self, terms: usize) -> Self {
        let coefficients: Vec<Coefficient> = self.coefficients.iter().copied().take(terms).collect();
        let precise = self.precise.with_terms(coefficients.len());
        Self { omega: self.omega, eta: self.eta, precise, coefficients, impacts: Vec::new() }
    }

    /// The frequency ratio `ω`.
    pub fn omega(&self) -> f64 {
        self.omega
    }

    /// The restitution `η`.
    pub fn eta(&self) -> f64 {
        self.eta
    }

    /// `c₀, c₁, ...`
    pub fn coefficients(&self) -> &[Coefficient] {
        &self.coefficients
    }

    /// The same in the precision that they were computed in.
    pub(crate) fn precise(&self) -> &Series<TwoFloat> {
        &self.precise
    }

    /// The chattering time from the first `order` terms at `epsilon`, whatever it is worth there.
    pub fn partial_sum(&self, order: usize, epsilon: f64) -> f64 {
        let terms = self.coefficients.iter().take(order);
        terms.rev().fold(0.0, |sum, coefficient| sum * epsilon + coefficient.value) * epsilon.sqrt() / self.omega
    }

    /// The chattering time from the first `order` terms at `epsilon`; `None` outside of the circle of convergence, as far as the coefficients
    /// tell, and with fewer than four of them.
    ///
    /// The claim comes from the coefficients beyond, so `order` should be less than their number.
    pub fn chattering_time(&self, order: usize, epsilon: f64) -> Option<Estimate> {
        let coefficients = self.coefficients.iter().map(|coefficient| coefficient.value);
        let sum = truncated::sum(coefficients, order, epsilon, 0.0)?;
        Some(scaled(sum.estimate, epsilon.sqrt() / self.omega))
    }

    /// The impacts whose series are known, from the first `order` terms at `epsilon`; `None` for one whose series does not converge there.
    pub fn impacts(&self, order: usize, epsilon: f64) -> impl Iterator<Item = Option<Impact>> {
        let step = epsilon.sqrt() / self.omega;
        let at = move |series: &[f64], order, ratio| truncated::sum(series.iter().copied(), order, epsilon, ratio);
        // The times are the sums of the intervals, and not their own series, which would be rounded another way.
        let (mut time, mut claims) = (Compensated::default(), 0.0);
        self.impacts.iter().map(move |series| {
            // Odd flights take no time to the lowest order: of theirs the first term that there is is kept.
            let of_interval = order.max(1 + usize::from(series.interval.first() == Some(&0.0)));
            let of_time = at(&series.time, order, 0.0)?;
            let interval = scaled(at(&series.interval, of_interval, of_time.ratio)?.estimate, step);
            let velocity = scaled(at(&series.velocity, order, of_time.ratio)?.estimate, step * epsilon);
            claims += interval.uncertainty;
            // To the lowest order the times are not those of their own series, because of what is kept of the odd flights.
            let uncertainty = if order == 1 { claims } else { of_time.estimate.uncertainty * step };
            time.add(interval.value);
            let relative = |of: Estimate| of.uncertainty / of.value.abs();
            let uncertainty =
                Uncertainty { time: uncertainty, interval: relative(interval), velocity: relative(velocity) };
            Some(Impact { time: time.value(), interval: interval.value, velocity: velocity.value, uncertainty })
        })
    }
}

/// To which the coefficients are extrapolated: well below the rounding to a double, because resummation magnifies what is left.
pub(crate) const PRECISION: f64 = 1e-18;
/// What rounding does in doubles it does so much less in double-doubles; two bits are left for chance.
const ROUNDING: f64 = f64::EPSILON * 4.0;

fn coefficients(limit: &Limit<TwoFloat>, plain: Option<&Limit<f64>>) -> Vec<Coefficient> {
    let in_doubles = plain.map(|plain| plain.value.0.iter().copied()).into_iter().flatten();
    let in_doubles = in_doubles.map(Some).chain(std::iter::repeat(None));
    let known = limit.value.0.iter().zip(&limit.change).zip(in_doubles);
    known
        .map(|((precise, change), in_doubles)| {
            let value = precise.rounded();
            let rounding = in_doubles.map_or(f64::INFINITY, |plain| ROUNDING * (plain - value).abs());
            Coefficient { value, error: 0.5 * f64::EPSILON * value.abs() + change + rounding }
        })
        .collect()
}

fn scaled(sum: Estimate, unit: f64) -> Estimate {
    Estimate { value: sum.value * unit, uncertainty: sum.uncertainty * unit }
}

impl ImpactSeries {
    fn new(impact: &march::Impact<TwoFloat>) -> Self {
        let rounded = |series: &Series<TwoFloat>| series.0.iter().map(|term| term.rounded()).collect();
        Self { time: rounded(&impact.time), interval: rounded(&impact.interval), velocity: rounded(&impact.velocity) }
    }
}
