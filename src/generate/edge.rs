//! Where methods break: towards the threshold, towards the critical amplitude from both sides, and at the corners of the parameters.

use contract::{Case, Oracle};

use super::case;
use crate::critical;

/// How far from the threshold and from `a_cr` (relative to `a_cr - 1`) the walks come.
const STEPS: [f64; 7] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-12];

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
        // Without a critical amplitude there is nothing to walk towards; `tests/reach.rs` makes sure that there is one.
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
    cases
}
