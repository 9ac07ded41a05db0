//! Above the critical amplitude flights are long and graze: the impact is the first root, by a dense scan of the solution in closed form.

use contract::{Case, Horizon, Model, Oracle};
use enclosure::Enclosure;

#[test]
fn no_flight_has_an_earlier_root() {
    let (mut flights, mut long, mut dipping) = (0, 0, 0);
    for epsilon in [0.04, 0.06, 0.1, 0.2, 0.4, 0.8, 1.5] {
        for omega in [1.5, 2.0, 3.0, 5.0, 9.0] {
            for eta in [0.5, 0.8, 0.92] {
                let horizon = Horizon::Until(3.0 * core::f64::consts::TAU / omega);
                let case = Case::from_epsilon(epsilon, omega, eta).unwrap().with_horizon(horizon).unwrap();
                let Ok(history) = Enclosure::new(Model::Linear).history(&case) else { continue };
                let (a, psi) = (1.0 + epsilon, (1.0 / (1.0 + epsilon)).asin());
                // x = 1 + i f/(1 + ω²) + C e^s + D e^-s, from the impact before (or from initiation).
                for pair in history.impacts.windows(2) {
                    let (start, interval) = (pair[0], pair[1].interval);
                    if interval < 1e-3 {
                        continue;
                    }
                    let i = start.velocity.signum();
                    let forced = |s: f64| {
                        let theta = omega * (start.time + s) + psi;
                        let scale = i * a / (1.0 + omega * omega);
                        (1.0 + scale * theta.sin(), scale * omega * theta.cos())
                    };
                    let (x, v) = forced(0.0);
                    let (c, d) = (0.5 * (-x + start.velocity.abs() - v), 0.5 * (-x - start.velocity.abs() + v));
                    let height = |s: f64| forced(s).0 + c * s.exp() + d * (-s).exp();
                    let heights: Vec<f64> = (1..4000).map(|k| height(interval * f64::from(k) / 4000.0)).collect();
                    assert!(heights.iter().all(|&x| x > 0.0), "{case:?} at {start:?}");
                    assert!(height(interval).abs() < 1e-12 && height(interval * 1.0001) < 0.0, "{case:?} at {start:?}");
                    flights += 1;
                    long += usize::from(interval > 0.3);
                    // A flight that comes near the base and rises again could be taken for one that lands.
                    let turns = heights.windows(3).filter(|h| h[1] < h[0] && h[1] < h[2]).count();
                    dipping += usize::from(turns > 0);
                }
            }
        }
    }
    assert!(flights > 300 && long > 50 && dipping > 0, "{flights} flights, {long} long ones, {dipping} that dip");
}
