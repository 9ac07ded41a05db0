//! The units of a flight, how far its series is trusted, and its first root.

use super::*;

fn near(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{found:e} is not {expected:e}");
}

/// `sqrt(cos α)` and `1/ω`, whichever is shorter against the block's own time.
#[test]
fn no_step_is_longer_than_what_can_be_expanded() {
    near(cap(&Block::new(0.5, 4.0, 0.9, 1.2)), 1.2f64.cos().sqrt() / 4.0, 1e-15);
    near(cap(&Block::new(0.5, 0.25, 0.9, 1.2)), 1.2f64.cos().sqrt(), 1e-15);
}

/// The shortest of `4q/ω`, the cap, and where `α P = 1`; and `P/T = K qω T²`.
#[test]
fn the_units_of_the_first_flight() {
    for (epsilon, omega, alpha, which) in [(1e-4, 2.0, 0.2, 0), (0.5, 2.0, 0.2, 1), (9.0, 0.9, 1.2, 2)] {
        let block = Block::new(epsilon, omega, 0.9, alpha);
        let (q, k) = (f64::sqrt(epsilon * (2.0 + epsilon)), f64::sin(alpha) / alpha);
        let candidates = [
            4.0 * q / omega,
            f64::cos(alpha).sqrt() / f64::max(omega, 1.0),
            (1.0 / (alpha * k * q * omega)).powf(1.0 / 3.0),
        ];
        let shortest = candidates.iter().copied().fold(f64::INFINITY, f64::min);
        assert_eq!(shortest, candidates[which], "{candidates:?}");
        let (Scale { time, velocity }, rate) = first_scale(&block);
        near(time, shortest, 1e-14);
        near(velocity, k * q * omega * shortest * shortest, 1e-14);
        assert_eq!(rate, 1.0);
    }
}

/// `K = 1/2`, `α = 1/4`, `ω = 2` and `cos α = 1/4` are of no block together, but they are exact.
fn exact() -> Block {
    let block = Block::new(0.5, 2.0, 0.9, 0.25);
    Block { slope: 0.5, cos_alpha: 0.25, ..block }
}

/// By hand, with the cap `sqrt(1/4)/2 = 1/4`.
#[test]
fn the_units_of_a_later_flight() {
    let of = |gravity: f64, slope: f64, speed: f64| {
        let (Scale { time, velocity }, rate) = scale(&exact(), &Forcing { gravity, value: 0.0, slope }, speed);
        assert_eq!(velocity, speed);
        (time, rate)
    };
    // 2v/(K G) = 1/8; time/cap = 1/2 against αvT
    assert_eq!(of(2.0, 0.0, 0.0625), (0.125, 0.5));
    assert_eq!(of(2.0, -0.001, 0.0625), (0.125, 0.5));
    // the cubic, sqrt(6v/(Kω|f'|)) = 1/8
    assert_eq!(of(1e-9, 24.0, 0.0625), (0.125, 0.5));
    assert_eq!(of(1e-9, -24.0, 0.0625), (0.125, 0.5));
    // with no pull at all the same
    assert_eq!(of(0.0, 24.0, 0.0625), (0.125, 0.5));
    // the cap
    assert_eq!(of(2.0, 0.0, 1.0), (0.25, 1.0));
    // 1/(αv) = 1/8, and α v T = 1 is the faster
    assert_eq!(of(1e6, 1e-9, 32.0), (0.000128, 0.001024));
    assert_eq!(of(2.0, 0.0, 32.0), (0.125, 1.0));
    // pushed away: no sooner than 3|G|/(ω f') = 3/16, at the rate of what does not converge by itself
    assert_eq!(of(-0.125, 1.0, 0.0009765625), (0.1875, 1.0));
    // nor than where α K G s² = 1: sqrt(1/(α K |G|)) inverted, with K |G| = 64: 1/4 · 1/... = 1/4
    let (time, rate) = of(-4096.0, 1e-9, 1e-9);
    near(time, (0.25f64 * 2048.0).sqrt().recip(), 1e-15);
    assert_eq!(rate, 1.0);
    // a fast one lands later than it is pushed
    assert_eq!(of(-0.125, 24.0, 0.0625).0, 0.125);
}

/// `5 + ln(1e-18)/ln(2 rate)` and the like: 42 is a little more than `-ln 1e-18`.
#[test]
fn the_order_is_what_the_rate_of_convergence_asks_for() {
    assert_eq!([1.0, 0.5, 0.1].map(order), [ORDER; 3]);
    for (rate, digits) in
        [(0.04_f64, 2.525_729_f64), (0.01, 3.912_023), (1e-3, 6.214_608), (1e-6, 13.122_363), (1e-30, 68.384_4)]
    {
        assert_eq!(order(rate), (5.0 + 42.0 / digits).ceil() as usize, "{rate}");
    }
}

#[test]
fn which_terms_tell_the_size_of_a_series() {
    let of = |multiplicity: usize| {
        [-1.0, 0.0, 1.0].map(|gravity| leading(multiplicity, &Forcing { gravity, value: 0.0, slope: 0.0 }))
    };
    assert_eq!((of(0), of(1), of(3)), ([3; 3], [2, 1, 1], [1; 3]));
}

/// To where the last two terms are 1e-18 of the largest of the first ones, and no further than 2.
#[test]
fn a_series_is_trusted_as_far_as_its_last_terms_are_negligible() {
    near(reliable(&[1.0, 9.0, 0.0, 1.0], 1), 1e-6, 1e-12);
    near(reliable(&[1.0, 9.0, 0.0, -8.0], 1), 0.5e-6, 1e-12);
    near(reliable(&[1.0, 0.0, 1.0, 0.0], 1), 1e-9, 1e-12);
    near(reliable(&[1.0, -1e6, 0.0, 1.0], 2), 1e-4, 1e-12);
    near(reliable(&[1.0, 0.0, -1e6, 0.0, 1.0], 3), 1e-3, 1e-12);
    // 2³ c is negligible, and 2³ c is not
    assert_eq!(reliable(&[1.0, 9.0, 0.0, 1.2e-19], 1), 2.0);
    near(reliable(&[1.0, 9.0, 0.0, 1.3e-19], 1), f64::powf(1.0 / 0.13, 1.0 / 3.0), 1e-12);
}

fn root(polynomial: &[f64], step: f64) -> Option<f64> {
    match first_root(polynomial, step) {
        Root::At(x) => Some(x),
        Root::None => None,
        Root::Below => Some(-1.0),
    }
}

#[test]
fn the_first_root_is_found() {
    // (1 - x)(2 - x)(3 - x)
    let three = [6.0, -11.0, 6.0, -1.0];
    for (step, expected) in [(0.99, None), (1.0, Some(1.0)), (1.5, Some(1.0)), (2.5, Some(1.0)), (3.5, Some(1.0))] {
        match (root(&three, step), expected) {
            (Some(found), Some(expected)) => near(found, expected, 1e-14),
            (found, expected) => assert_eq!(found, expected, "{step}"),
        }
    }
    // It falls all the way, to above zero, to it, and below.
    assert_eq!(
        (root(&[1.0, -0.5], 1.9), root(&[1.0, -0.5], 2.0), root(&[1.0, -0.5], 4.0)),
        (None, Some(2.0), Some(2.0))
    );
    // It rises first: 1 + x - x²
    near(root(&[1.0, 1.0, -1.0], 2.0).unwrap(), 0.5 + 1.25f64.sqrt(), 1e-15);
    assert_eq!(root(&[1.0, 1.0, -1.0], 1.6), None);
    // It is not above zero at the start.
    assert_eq!((root(&[0.0, 1.0], 1.0), root(&[-1e-30, 1.0], 1.0)), (Some(-1.0), Some(-1.0)));
    assert_eq!(root(&[1e-30, 1.0], 1.0), None);
}

/// A dip below zero between two of the points that are looked at, and one that stays above. (x - 0.83)² - d
#[test]
fn a_dip_between_two_points_is_not_passed_over() {
    let dip = |d: f64| [0.83 * 0.83 - d, -1.66, 1.0];
    near(root(&dip(1e-6), 2.0).unwrap(), 0.829, 1e-9);
    assert_eq!(root(&dip(-1e-6), 2.0), None);
    // The fall and rise are both within the first part, and within the last.
    near(root(&[1e-4 - 1e-8, -0.02, 1.0], 2.0).unwrap(), 0.0099, 1e-9);
    near(root(&[1.99 * 1.99 - 1e-8, -3.98, 1.0], 2.0).unwrap(), 1.9899, 1e-9);
}

/// Where the higher terms could turn the linear one round, and do: 1 - x + c x², with roots for c <= 1/4.
#[test]
fn a_fall_that_turns_is_told_from_one_that_does_not() {
    near(root(&[1.0, -1.0, 0.24], 4.0).unwrap(), (1.0 - 0.04f64.sqrt()) / 0.48, 1e-14);
    assert_eq!(root(&[1.0, -1.0, 0.26], 4.0), None);
    near(root(&[1.0, -1.0, 0.0, 0.1], 2.0).unwrap(), 1.153_467_305_145_763, 1e-14);
    assert_eq!(root(&[1.0, -1.0, 0.0, 0.2], 4.0), None);
    // Down through zero and up again within the step: the cube turns it with three times its coefficient.
    near(root(&[1.0, -1.0, 0.0, 0.145], 1.8).unwrap(), 1.38638118253687, 1e-12);
    // The same in other units, where the coefficients are small, or large.
    near(root(&[1.0, -0.1, 0.0, 1.45e-4], 18.0).unwrap(), 13.863_811_825_368_7, 1e-12);
    near(root(&[1.0, -10.0, 0.0, 145.0], 0.18).unwrap(), 0.138_638_118_253_687, 1e-12);
    near(root(&[1.0, -10.0, 24.0], 0.4).unwrap(), 1.0 / 6.0, 1e-12);
    assert_eq!(root(&[1.0, -1.0, 0.0, 0.0, 0.2], 4.0), None);
}

/// Newton's method finds the root of what falls all the way to it, and leaves alone what may have turned before, or has none in the step.
#[test]
fn the_root_of_a_fall_is_found_by_newton_alone() {
    near(fallen(&[1.0, -1.0, 0.01, -0.02], 2.0).unwrap(), root(&[1.0, -1.0, 0.01, -0.02], 2.0).unwrap(), 3e-16);
    near(fallen(&[2.0, -1.5, 0.125], 2.0).unwrap(), 6.0 - 20.0f64.sqrt(), 3e-16);
    near(fallen(&[1e-40, -1.0, -1.0], 1.0).unwrap(), 1e-40, 1e-15);
    // (1 - x)(2 - x)(3 - x) falls to its first root, but its cube could have turned it.
    assert_eq!(fallen(&[6.0, -11.0, 6.0, -1.0], 3.5), None);
    assert_eq!((fallen(&[1.0, -1.0], 0.99), fallen(&[1.0, -1.0], 1.0)), (None, Some(1.0)));
    assert_eq!((fallen(&[1.0, -1.0, 0.26], 4.0), fallen(&[1.0], 4.0)), (None, None));
}

#[test]
fn the_lowest_point_and_the_root_are_found_to_the_last_digits() {
    near(minimum(&[0.0, -3.0, 1.0], 0.0, 2.0), 1.5, 1e-15);
    near(minimum(&[0.0, -3.0, 1.0], 1.25, 7.0), 1.5, 1e-15);
    near(polish(&[2.0, 0.0, -1.0], 0.0, 2.0), 2.0f64.sqrt(), 3e-16);
    near(polish(&[2.0, 0.0, -1.0], 1.25, 7.0), 2.0f64.sqrt(), 3e-16);
    // So near to the start that halving would take more steps than there are.
    near(polish(&[1e-40, -1.0, -1.0], 0.0, 1.0), 1e-40, 1e-15);
    // From 1.45, next to a minimum, a step of Newton's leads past the two other roots of (1 - x)(2 - x)(3 - x).
    near(polish(&[6.0, -11.0, 6.0, -1.0], 0.9, 2.0), 1.0, 3e-15);
    // Newton's steps leave the bracket here: 1 - x^9, from the middle of (0, 4) and of (0, 1.2)
    for right in [4.0, 1.2] {
        near(polish(&[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0], 0.0, right), 1.0, 3e-16);
    }
}

/// At the horizon the block is in the air; an impact before it is one.
#[test]
fn a_flight_is_followed_to_its_horizon() {
    let block = Block::new(0.03, 2.0, 0.9, 0.2);
    for (side, tau, speed) in [(-1.0, 0.0, 0.0), (1.0, 0.4, 0.1), (-1.0, 0.7, 0.3), (1.0, 1.3, 1e-9)] {
        let Landing::Impact { interval, steps, .. } = fly(&block, side, tau, speed, 10.0) else { panic!("no impact") };
        assert_eq!(fly(&block, side, tau, speed, 0.999 * interval), Landing::Flying);
        assert_eq!(fly(&block, side, tau, speed, 0.3 * interval), Landing::Flying);
        let Landing::Impact { interval: again, .. } = fly(&block, side, tau, speed, 1.001 * interval) else {
            panic!("no impact")
        };
        near(again, interval, 1e-14);
        assert!(steps <= 12, "{steps}");
    }
}

/// Where what the series begins with leads through the base, nothing lands: at the start of the shaking the ground pushes to one side only.
#[test]
fn a_flight_that_begins_below_the_base_has_fallen_through() {
    for (epsilon, omega, alpha) in [(0.03, 2.0, 0.2), (1.0, 0.5, 0.9), (1e-6, 20.0, 0.01)] {
        let block = Block::new(epsilon, omega, 0.9, alpha);
        assert_eq!(fly(&block, 1.0, 0.0, 0.0, 10.0), Landing::Lost(Loss::FellThrough));
        assert!(matches!(fly(&block, -1.0, 0.0, 0.0, 1e9), Landing::Impact { .. } | Landing::Overturned));
    }
    for polynomial in [&[0.0, 1.0][..], &[-1e-300, 1.0], &[]] {
        assert!(matches!(first_root(polynomial, 1.0), Root::Below));
    }
}
