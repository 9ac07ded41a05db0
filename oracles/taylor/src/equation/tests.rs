//! The forcing, the point of no return and the proof of rest against formulas written another way.

use super::*;

fn near(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{found:e} is not {expected:e}");
}

/// `G = 1 + i f`, `i f` and `i df/dx` of `f = a sin(x + ψ)`.
#[test]
fn the_forcing_is_that_of_the_excitation() {
    for (epsilon, omega) in [(0.03, 2.0), (1.5, 0.7), (0.4, 9.0)] {
        let block = Block::new(epsilon, omega, 0.9, 0.2);
        let psi = (1.0 / (1.0 + epsilon)).asin();
        for tau in [0.05, 0.3, 0.9, 2.0, 7.3] {
            let (sin, cos) = (omega * tau + psi).sin_cos();
            for side in [-1.0, 1.0] {
                let Forcing { gravity, value, slope } = block.forcing(side, tau);
                let expected = [side * (1.0 + epsilon) * sin, side * (1.0 + epsilon) * cos];
                assert!((gravity - 1.0 - expected[0]).abs() < 1e-14 * (2.0 + epsilon) * (1.0 + omega * tau));
                assert!((value - expected[0]).abs() < 1e-14 * (2.0 + epsilon) * (1.0 + omega * tau));
                assert!((slope - expected[1]).abs() < 1e-14 * (2.0 + epsilon) * (1.0 + omega * tau));
            }
        }
        // At initiation the forcing balances the block, to the last bit.
        assert_eq!((block.forcing(-1.0, 0.0).gravity, block.forcing(1.0, 0.0).gravity), (0.0, 2.0));
    }
}

/// `tan(α(u - 1)) >= a tan α`, on the way out.
#[test]
fn there_is_no_return_from_where_the_forcing_can_not_turn_the_block() {
    let block = Block::new(0.5, 2.0, 0.9, 0.4);
    let border = 1.0 + (1.5 * 0.4f64.tan()).atan() / 0.4;
    assert!(block.overturned(border + 1e-9, 0.0) && block.overturned(border + 1e-9, 1.0));
    assert!(!block.overturned(border - 1e-9, 1.0));
    assert!(!block.overturned(border + 1e-9, -1e-9));
}

/// How much of the window the flights may take, by the words of [`Block::certainly_rests`].
fn share_taken(block: &Block, f: f64, w: f64) -> f64 {
    let kappa = block.alpha / (block.alpha.sin() * block.alpha.cos());
    let (least, most) = ((1.0 + f).min(1.0 - f), (1.0 + f).max(1.0 - f));
    let window = 0.4 * least / (block.omega * block.amplitude + 4.0 * kappa * w);
    // A flight of speed v lasts 2v/(K G); speeds fall by η, the slower side first.
    let pull = block.alpha.sin() / block.alpha;
    let sum = (2.0 * w / (pull * least) + 2.0 * w * block.eta / (pull * most)) / (1.0 - block.eta * block.eta);
    1.4 / 0.6 * sum / window
}

#[test]
fn rest_is_proven_as_long_as_the_flights_fit_into_the_window() {
    for (epsilon, omega, eta, alpha, tau) in
        [(0.03, 2.0, 0.9, 0.2, 0.5), (0.2, 0.7, 0.6, 0.9, 2.5), (0.5, 5.0, 0.95, 1.3, 0.4), (0.01, 2.0, 0.5, 0.05, 0.9)]
    {
        let block = Block::new(epsilon, omega, eta, alpha);
        let f = (1.0 + epsilon) * (omega * tau + (1.0f64 / (1.0 + epsilon)).asin()).sin();
        assert!(f.abs() < 1.0, "{f}");
        let (mut slow, mut fast) = (0.0, 10.0);
        for _ in 0..80 {
            let middle = 0.5 * (slow + fast);
            if share_taken(&block, f, middle) <= 1.0 { slow = middle } else { fast = middle }
        }
        assert!(block.certainly_rests(tau, 0.999_999 * slow), "{slow}");
        assert!(!block.certainly_rests(tau, 1.000_001 * slow), "{slow}");
    }
    // Where the forcing holds one side up there is no rest, however slow the block is; nor at initiation, where it balances it.
    let block = Block::new(0.5, 2.0, 0.9, 0.2);
    assert!(
        !block.certainly_rests(0.1, 0.0) && !block.certainly_rests(0.0, 0.0) && !block.certainly_rests(f64::NAN, 0.0)
    );
    for w in [1e-6, 1e-3, 0.1, 1.0] {
        assert!(!block.certainly_rests(0.1, w) && !block.certainly_rests(0.01, w), "{w}");
    }
    assert!(block.certainly_rests(0.9, 0.0));
}

#[test]
fn sine_less_cosine_keeps_its_digits() {
    for x in [0.5f64, 0.8, 1.2, 1.5] {
        near(sin_less_x_cos(x), x.sin() - x * x.cos(), 2e-15 / (x * x * x / 3.0));
    }
    // x³/3 - x⁵/30 + x⁷/840
    for x in [1e-9f64, 1e-4, 0.01] {
        near(sin_less_x_cos(x), x.powi(3) / 3.0 * (1.0 - x * x / 10.0 + x.powi(4) / 280.0), 1e-15);
    }
}

/// Under the slender normalisation `a` is a multiple of `α`, and so of `α/tan α` thresholds; what cancels is in the rounding error.
#[test]
fn the_excess_over_the_threshold_and_its_rounding() {
    let of = |epsilon: f64, alpha: f64, normalisation| match Slenderness::new(alpha, normalisation) {
        Ok(slenderness) => excess(epsilon, slenderness),
        Err(invalid) => panic!("{invalid}"),
    };
    assert_eq!(of(0.3, 0.5, Normalisation::Threshold), (0.3, 0.0));
    for (epsilon, alpha) in [(0.3, 0.5f64), (0.02, 0.2), (-0.1, 0.7), (2.0, 1.3)] {
        let (found, rounding) = of(epsilon, alpha, Normalisation::Slender);
        let expected = (1.0 + epsilon) * alpha / alpha.tan() - 1.0;
        assert!((found - expected).abs() < 1e-15 * (1.0 + epsilon), "{found} {expected}");
        let lost = 1.0 - alpha / alpha.tan();
        near(rounding, f64::EPSILON * (1.0 + lost / expected.abs()), 1e-11);
    }
}
