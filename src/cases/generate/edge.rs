//! Where methods break: towards the threshold, towards the critical amplitude from both sides, and at the corners of the parameters.

use contract::{Case, Oracle};

use super::case;
use crate::measure::critical;

/// How far from the threshold and from `a_cr` (relative to `a_cr - 1`) the walks come.
const STEPS: [f64; 7] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-12];

/// How far from `a_cr` the ladder stands: the condition of the chattering time grows by a known factor from rung to rung.
const RUNGS: [f64; 10] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12];

/// Where ladders stand: `(ω, η, α)`.
const LADDERS: [(f64, f64, f64); 2] = [(2.0, 0.92, 0.1), (0.7, 0.85, 0.2)];

/// How many times more impacts the ladder needs: near `a_cr` the sequence becomes geometric late.
const DEEPER: usize = 4;

/// The name and case of each step.
pub(super) fn cases(stepper: &dyn Oracle) -> Vec<(String, Case)> {
    let mut cases = Vec::new();
    let mut add = |name: String, epsilon: f64, omega: f64, eta: f64| {
        cases.extend(case(epsilon, omega, eta, 0.1).map(|case| (name, case)));
    };
    for (omega, eta) in
        [(2.0, 0.92), (0.5, 0.92), (8.0, 0.92), (2.0, 0.5), (2.0, 0.75), (2.0, 0.97), (0.5, 0.8), (8.0, 0.6)]
    {
        let name = |what: &str| format!("{what},omega={omega},eta={eta}");
        for step in STEPS {
            add(name(&format!("a=1+{step:e}")), step, omega, eta);
        }
        // Without a critical amplitude there is nothing to walk towards; `tests/gate/reach.rs` makes sure that there is one.
        let Ok(Some((below, above))) = critical::bracket(stepper, omega, eta) else { continue };
        add(name("a=a_cr,below"), below, omega, eta);
        add(name("a=a_cr,above"), above, omega, eta);
        for ulps in [1, 2, 4] {
            let walk = |from: f64, next: fn(f64) -> f64| (0..ulps).fold(from, |value, _| next(value));
            add(name(&format!("a=a_cr-{ulps}ulp")), walk(below, f64::next_down), omega, eta);
            add(name(&format!("a=a_cr+{ulps}ulp")), walk(above, f64::next_up), omega, eta);
        }
        for step in STEPS {
            add(name(&format!("a=a_cr(1-{step:e})")), below * (1.0 - step), omega, eta);
            add(name(&format!("a=a_cr(1+{step:e})")), above * (1.0 + step), omega, eta);
        }
    }
    for eta in [0.5, 0.501, 0.98, 0.985, 0.99] {
        for omega in [0.1, 0.2, 2.0, 15.0, 20.0] {
            // At low frequencies a_cr falls well below the fits.
            let epsilon = 0.5 * (critical::eq77(eta) - 1.0) * f64::min(1.0, 2.0 * omega);
            add(format!("corner,eta={eta},omega={omega}"), epsilon, omega, eta);
        }
    }
    for (name, epsilon) in [("a=1", 0.0), ("a<1", -0.1), ("a=0", -1.0), ("a=1-ulp", -1.1e-16), ("a=1+1e-30", 1e-30)] {
        add(name.to_owned(), epsilon, 2.0, 0.92);
    }
    cases.extend(ladders(stepper));
    cases
}

/// The rungs below and above `a_cr`, absolute in `a`.
fn ladders(stepper: &dyn Oracle) -> Vec<(String, Case)> {
    let mut rungs = Vec::new();
    for (omega, eta, alpha) in LADDERS {
        let Ok(Some((below, above))) = critical::bracket(stepper, omega, eta) else { continue };
        for rung in RUNGS {
            for (side, epsilon) in [('-', below - rung), ('+', above + rung)] {
                let name = format!("a=a_cr{side}{rung:e},omega={omega},eta={eta},alpha={alpha}");
                let deep = |case: Case| case.with_max_impacts(DEEPER * case.max_impacts()).ok();
                rungs.extend(case(epsilon, omega, eta, alpha).and_then(deep).map(|case| (name, case)));
            }
        }
    }
    rungs
}
