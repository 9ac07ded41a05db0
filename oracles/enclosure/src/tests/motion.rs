//! The equations of motion, against Eq. 2 and Eq. 4 as they are printed.

use proptest::prelude::*;

use crate::{
    digits::Digits,
    equation::{Equation, Start},
    excitation::{Excitation, HalfPhase},
    ground::Ground,
    interval::Interval,
    pull::Side,
};

proptest! {
    /// `φ'' = -(1/α) [sin(α(i - φ)) + a tan α sin(ωτ + ψ) cos(α(i - φ))]` and `φ'' = φ - i - a sin(ωτ + ψ)`, with `x = i φ`.
    #[test]
    fn the_acceleration_is_that_of_the_printed_equations(
        alpha in 0.01..1.4_f64, epsilon in 1e-3..3.0_f64, omega in 0.1..9.0_f64, tau in 0.0..3.0_f64, x in 0.0..2.0_f64, plus in any::<bool>(),
    ) {
        let excitation = Excitation::<Digits<128>>::new(&Interval::exactly(epsilon), omega);
        let side = if plus { Side::Plus } else { Side::Minus };
        let phase = excitation.later(&HalfPhase::start(), &Interval::exactly(tau));
        let pull = excitation.pull(&phase, side);
        let (a, i) = (1.0 + epsilon, side.sign());
        let theta = omega * tau + (1.0 / a).asin();
        let f = a * theta.sin();
        let phi = i * x;
        prop_assert!((pull.value.middle() - (1.0 + i * f)).abs() < 1e-12);
        prop_assert!((pull.slope.middle() - i * a * omega * theta.cos()).abs() < 1e-11);
        let block = -((alpha * (i - phi)).sin() + alpha.tan() * f * (alpha * (i - phi)).cos()) / alpha;
        for (alpha, expected) in [(None, phi - i - f), (Some(alpha), block)] {
            let equation = Equation::new(alpha);
            let start = Start { distance: Interval::exactly(x), velocity: Interval::exactly(0.3), pull: pull.clone() };
            let found = 2.0 * i * equation.coefficients(&start).extend().middle();
            prop_assert!((found - expected).abs() < 1e-11 * (1.0 + expected.abs()), "{found} {expected}");
            let towards = equation.towards_base(&Interval::between(0.0, x), &pull.value);
            let acceleration = equation.towards_base(&Interval::exactly(x), &pull.value);
            if towards.is_positive() {
                prop_assert!(towards.lower <= Interval::<Digits<128>>::exactly(-i * expected + 1e-11).upper);
                prop_assert!(towards.upper >= Interval::<Digits<128>>::exactly(-i * expected - 1e-11).lower);
                prop_assert!(towards.lower <= acceleration.upper);
            }
            let drive = equation.drive(&excitation.amplitude);
            prop_assert!(expected.abs() <= x + drive + 1e-12);
        }
    }
}

/// Past the balance the least torque outward is `sin β - a tan α cos β`: from `tan β = a tan α` on the block can't come back, if it moves outwards;
/// of the slender block, from `x + x' = 1 + a` on.
#[test]
fn a_block_is_overturned_from_where_nothing_can_bring_it_back() {
    let point = |x: f64| Interval::<Digits<128>>::exactly(x);
    for alpha in [0.02, 0.2, 0.6_f64] {
        for a in [1.01, 1.3, 2.0_f64] {
            let excitation = Excitation::<Digits<128>>::new(&point(a - 1.0), 2.0);
            let amplitude = excitation.amplitude.clone();
            let block = Equation::new(Some(alpha));
            let border = 1.0 + (a * alpha.tan()).atan() / alpha;
            let overturned = |x: f64, v: f64| block.overturned(&point(x), &point(v), &amplitude);
            assert!(overturned(border + 1e-9, 1e-3) && !overturned(border - 1e-9, 1e-3), "{alpha} {a}");
            assert!(!overturned(border + 1e-9, -1e-3) && !overturned(0.5, 10.0), "{alpha} {a}");
            let slender = Equation::new(None);
            let overturned = |x: f64, v: f64| slender.overturned(&point(x), &point(v), &amplitude);
            assert!(overturned(0.5, 0.5 + a + 1e-9) && !overturned(0.5, 0.5 + a - 1e-9), "{a}");
            assert!(!overturned(-0.5, 2.0 + a), "{a}");
        }
    }
}
