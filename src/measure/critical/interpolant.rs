//! The critical amplitude as a polynomial in `1/ω²` and `√(1-η)`, interpolated between values of direct stepping.
//!
//! In these variables it is smooth: `ω` enters the motion as `1/ω²` only, and as `η -> 1` the amplitude falls as a broken power of `1-η`
//! (see [`super::fit`]), which a polynomial in `η` could follow only slowly. With 14 and 24 nodes what is left is rounding.

use std::sync::LazyLock;

use contract::{Invalid, Oracle};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::bracket;

/// How far [`interpolated`] may be from the critical amplitude by direct stepping. Measured: 2e-15.
pub const INTERPOLATION_ERROR: f64 = 1e-14;

/// One term of the polynomial, as `data/reference/critical_interpolant.csv` has it: a coefficient times the Chebyshev polynomials of these
/// degrees, of `1/ω²` and of `√(1-η)`, each scaled to run from -1 to 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Term {
    /// The degree of the polynomial of `1/ω²`.
    pub omega_degree: u32,
    /// That of the polynomial of `√(1-η)`.
    pub eta_degree: u32,
    /// What they are multiplied by.
    pub coefficient: f64,
}

/// Made by the `reference` command. What can't be read makes every answer NaN; a test would tell.
static TERMS: LazyLock<Vec<Term>> = LazyLock::new(|| {
    let table = include_str!("../../../data/reference/critical_interpolant.csv");
    let unreadable = Term { omega_degree: 0, eta_degree: 0, coefficient: f64::NAN };
    csv::Reader::from_reader(table.as_bytes()).deserialize().map(|term| term.unwrap_or(unreadable)).collect()
});

/// A parameter, its range, and the variable that stands for it in the polynomial.
struct Axis {
    field: &'static str,
    least: f64,
    most: f64,
    allowed: &'static str,
    variable: fn(f64) -> f64,
    parameter: fn(f64) -> f64,
    nodes: u32,
}

const OMEGA: Axis = Axis {
    field: "omega",
    least: 0.5,
    most: 8.0,
    allowed: "0.5 <= omega <= 8",
    variable: |omega| 1.0 / (omega * omega),
    parameter: |s| 1.0 / s.sqrt(),
    nodes: 14,
};

const ETA: Axis = Axis {
    field: "eta",
    least: 0.5,
    most: 0.98,
    allowed: "0.5 <= eta <= 0.98",
    variable: |eta| (1.0 - eta).sqrt(),
    parameter: |y| 1.0 - y * y,
    nodes: 24,
};

impl Axis {
    /// The variable at both ends of the range.
    fn ends(&self) -> (f64, f64) {
        ((self.variable)(self.least), (self.variable)(self.most))
    }

    /// The angle `θ` by which the Chebyshev polynomials are `cos(kθ)`.
    fn angle(&self, value: f64) -> Result<f64, Invalid> {
        if !(self.least..=self.most).contains(&value) {
            return Err(Invalid::new(self.field, format!("{value:?}"), self.allowed));
        }
        let (start, end) = self.ends();
        let scaled = (2.0 * (self.variable)(value) - start - end) / (start - end);
        Ok(scaled.clamp(-1.0, 1.0).acos())
    }

    /// The values of the Chebyshev polynomials, by their degree.
    fn values(&self, value: f64) -> Result<Vec<f64>, Invalid> {
        let angle = self.angle(value)?;
        Ok((0..self.nodes).map(|degree| chebyshev(degree, angle)).collect())
    }

    /// The angle and the parameter at each node: the zeros of the polynomial of degree `nodes`.
    fn nodes(&self) -> Vec<(f64, f64)> {
        let (start, end) = self.ends();
        let node = |k: u32| {
            let angle = std::f64::consts::PI * (f64::from(k) + 0.5) / f64::from(self.nodes);
            (angle, (self.parameter)(0.5 * (start + end) + 0.5 * (start - end) * angle.cos()))
        };
        (0..self.nodes).map(node).collect()
    }

    /// What the sum over the nodes is divided by to become the coefficient of this degree.
    fn norm(&self, degree: u32) -> f64 {
        if degree == 0 { f64::from(self.nodes) } else { 0.5 * f64::from(self.nodes) }
    }
}

/// `a_cr - 1` of the linear model, where `a_cr` is the amplitude whose chattering time is half a period, for `ω` from 0.5 to 8 and `η` from
/// 0.5 to 0.98; good to [`INTERPOLATION_ERROR`].
///
/// # Errors
/// When `omega` or `eta` is outside that range.
pub fn interpolated(omega: f64, eta: f64) -> Result<f64, Invalid> {
    let (by_omega, by_eta) = (OMEGA.values(omega)?, ETA.values(eta)?);
    let of = |values: &[f64], degree: u32| values.get(degree as usize).copied().unwrap_or(f64::NAN);
    let value = |term: &Term| term.coefficient * of(&by_omega, term.omega_degree) * of(&by_eta, term.eta_degree);
    Ok(TERMS.iter().map(value).sum())
}

/// The Chebyshev polynomial of this degree at `cos(angle)`.
fn chebyshev(degree: u32, angle: f64) -> f64 {
    (f64::from(degree) * angle).cos()
}

/// The terms of the polynomial, from the critical amplitudes that `stepper` gives at its nodes; `None` where it gives none. `done` is called
/// after each node, from any thread.
///
/// # Errors
/// When a node is outside the allowed range of a case.
pub fn terms(stepper: &dyn Oracle, done: impl Fn() + Sync) -> Result<Option<Vec<Term>>, Invalid> {
    let etas = ETA.nodes();
    let nodes: Vec<_> = OMEGA.nodes().into_iter().flat_map(|omega| etas.iter().map(move |eta| (omega, *eta))).collect();
    let found = nodes.par_iter().map(|((_, omega), (_, eta))| {
        let found = bracket(stepper, *omega, *eta);
        done();
        found
    });
    let found: Vec<Option<(f64, f64)>> = found.collect::<Result<_, _>>()?;
    let Some(values) = found.into_iter().collect::<Option<Vec<_>>>() else { return Ok(None) };
    // A discrete cosine transform in both directions.
    let degrees =
        (0..OMEGA.nodes).flat_map(|omega_degree| (0..ETA.nodes).map(move |eta_degree| (omega_degree, eta_degree)));
    let term = |(omega_degree, eta_degree)| {
        let parts = nodes.iter().zip(&values).map(|(((by_omega, _), (by_eta, _)), (below, _))| {
            below * chebyshev(omega_degree, *by_omega) * chebyshev(eta_degree, *by_eta)
        });
        let coefficient = parts.sum::<f64>() / (OMEGA.norm(omega_degree) * ETA.norm(eta_degree));
        Term { omega_degree, eta_degree, coefficient }
    };
    Ok(Some(degrees.map(term).collect()))
}
