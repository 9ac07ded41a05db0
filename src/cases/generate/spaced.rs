//! A grid over restitution, frequency, amplitude and slenderness.

use contract::Case;

use super::case;
use crate::measure::critical;

/// The name and case of each point.
pub(super) fn cases() -> Vec<(String, Case)> {
    let mut cases = Vec::new();
    for eta in [0.5, 0.65, 0.8, 0.92, 0.97] {
        for omega in [0.5, 1.0, 2.0, 4.0, 8.0] {
            for (share, alpha) in [(0.05, 0.3), (0.2, 0.2), (0.4, 0.15), (0.6, 0.1), (0.8, 0.06), (0.95, 0.03)] {
                let epsilon = share * (critical::eq77(eta) - 1.0);
                cases.extend(
                    case(epsilon, omega, eta, alpha)
                        .map(|case| (format!("eta={eta},omega={omega},share={share}"), case)),
                );
            }
        }
    }
    cases
}
