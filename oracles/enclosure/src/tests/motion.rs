//! The equations of motion, against Eq. 2 and Eq. 4 as they are printed.

use proptest::prelude::*;

use crate::{
    digits::Digits,
    equation::{Equation, Start},
    excitation::{Excitation, HalfPhase, Side},
    interval::Interval,
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
            let equation = Equation::new(&excitation, alpha);
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
