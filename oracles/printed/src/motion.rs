use astro_float::BigFloat;
use contract::{Case, Sinusoid};

use crate::arithmetic::Arithmetic;

/// The excitation, `a sin(ωτ + ψ)`, and the particular solution that it forces, in absolute time.
pub(crate) struct Excitation {
    /// `a = 1 + ε`, of the exact double `ε` (Eq. 14).
    pub(crate) a: BigFloat,
    omega: BigFloat,
    psi: BigFloat,
    /// `a/(ω² + 1)` of Eq. 8.
    response: BigFloat,
}

impl Excitation {
    pub(crate) fn new(ar: &Arithmetic, case: &Case) -> Self {
        let one = ar.number(1.0);
        let a = ar.add(&one, &ar.number(case.epsilon()));
        let omega = ar.number(case.omega());
        // Eq. 12 with i_0 = -1.
        let psi = ar.asin(&ar.div(&one, &a));
        Self::of(ar, a, omega, psi)
    }

    /// A sinusoid as it is.
    pub(crate) fn of_term(ar: &Arithmetic, term: &Sinusoid) -> Self {
        let Sinusoid { amplitude, omega, phase } = *term;
        Self::of(ar, ar.number(amplitude), ar.number(omega), ar.number(phase))
    }

    fn of(ar: &Arithmetic, a: BigFloat, omega: BigFloat, psi: BigFloat) -> Self {
        let response = ar.div(&a, &ar.add(&ar.mul(&omega, &omega), &ar.number(1.0)));
        Self { a, omega, psi, response }
    }

    /// `T/2 = π/ω`.
    pub(crate) fn half_period(&self, ar: &Arithmetic) -> BigFloat {
        ar.div(&ar.pi(), &self.omega)
    }

    fn phase(&self, ar: &Arithmetic, tau: &BigFloat) -> BigFloat {
        ar.add(&ar.mul(&self.omega, tau), &self.psi)
    }

    /// `a sin(ωτ + ψ)`, the forcing of Eq. 4.
    pub(crate) fn forcing(&self, ar: &Arithmetic, tau: &BigFloat) -> BigFloat {
        ar.mul(&self.a, &ar.sin(&self.phase(ar, tau)))
    }

    /// `Ξ(τ)` of Eq. 8.
    pub(crate) fn xi(&self, ar: &Arithmetic, tau: &BigFloat) -> BigFloat {
        ar.mul(&self.response, &ar.sin(&self.phase(ar, tau)))
    }

    /// `Ξ'(τ)` of Eq. 8.
    pub(crate) fn xi_prime(&self, ar: &Arithmetic, tau: &BigFloat) -> BigFloat {
        ar.mul(&ar.mul(&self.response, &self.omega), &ar.cos(&self.phase(ar, tau)))
    }

    /// `a/(ω² + 1)`, the largest that `Ξ` can be.
    pub(crate) fn largest_xi(&self) -> &BigFloat {
        &self.response
    }
}

/// One flight as Eq. 6 has it.
pub(crate) struct Flight {
    /// `i_n`.
    pub(crate) sign: f64,
    /// `A_n`, of the falling mode.
    pub(crate) falling: BigFloat,
    /// `B_n`, of the growing mode.
    pub(crate) growing: BigFloat,
}

impl Flight {
    /// From `φ_n(τ_n) = 0` and the velocity `φ'_n(τ_n)`, by Eq. 36 for any `n`. At `τ_0 = 0` and `φ' = 0` it is Eq. 10.
    pub(crate) fn from_impact(
        ar: &Arithmetic,
        excitation: &Excitation,
        sign: f64,
        tau: &BigFloat,
        velocity: &BigFloat,
    ) -> Self {
        Self::from_state(ar, excitation, sign, tau, (&ar.number(0.0), velocity))
    }

    /// From a rotation and a velocity: `B e^τ + A e^-τ = φ - i - Ξ(τ)` and `B e^τ - A e^-τ = φ' - Ξ'(τ)`.
    pub(crate) fn from_state(
        ar: &Arithmetic,
        excitation: &Excitation,
        sign: f64,
        tau: &BigFloat,
        (rotation, velocity): (&BigFloat, &BigFloat),
    ) -> Self {
        let sum = ar.sub(&ar.sub(rotation, &ar.number(sign)), &excitation.xi(ar, tau));
        let difference = ar.sub(velocity, &excitation.xi_prime(ar, tau));
        let e = ar.exp(tau);
        let growing = ar.div(&ar.scale(&ar.add(&sum, &difference), 0.5), &e);
        let falling = ar.mul(&ar.scale(&ar.sub(&sum, &difference), 0.5), &e);
        Self { sign, falling, growing }
    }

    /// `B e^τ` and `A e^-τ`.
    pub(crate) fn modes(&self, ar: &Arithmetic, tau: &BigFloat) -> (BigFloat, BigFloat) {
        let e = ar.exp(tau);
        (ar.mul(&self.growing, &e), ar.div(&self.falling, &e))
    }

    /// `φ_n(τ)`, first line of Eq. 6.
    pub(crate) fn rotation(&self, ar: &Arithmetic, excitation: &Excitation, tau: &BigFloat) -> BigFloat {
        let (growing, falling) = self.modes(ar, tau);
        let transient = ar.add(&ar.add(&growing, &falling), &ar.number(self.sign));
        ar.add(&transient, &excitation.xi(ar, tau))
    }

    /// Whether a rotation has the sign of the flight. It is not rounded to a double for this: it may be too small for one.
    pub(crate) fn is_off_base(&self, rotation: &BigFloat) -> bool {
        !rotation.is_zero() && rotation.is_positive() == (self.sign > 0.0)
    }

    /// `φ'_n(τ)`, second line of Eq. 6.
    pub(crate) fn velocity(&self, ar: &Arithmetic, excitation: &Excitation, tau: &BigFloat) -> BigFloat {
        let (growing, falling) = self.modes(ar, tau);
        ar.add(&ar.sub(&growing, &falling), &excitation.xi_prime(ar, tau))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::double;

    fn excitation(ar: &Arithmetic) -> Excitation {
        Excitation::new(ar, &Case::from_amplitude(1.03, 2.0, 0.92).unwrap())
    }

    /// `φ'' - φ + i + a sin(ωτ + ψ) = 0` (Eq. 4), with `φ''` a central difference of the step `h`: its own error is of the order `h²`.
    #[test]
    fn a_flight_solves_eq_4() {
        let ar = Arithmetic::new(512).unwrap();
        let excitation = excitation(&ar);
        let h = ar.number(2_f64.powi(-120));
        for (sign, tau_n, velocity) in [(-1.0, 0.0, 0.0), (1.0, 0.5625, 0.01), (-1.0, 0.75, -0.25)] {
            let flight = Flight::from_impact(&ar, &excitation, sign, &ar.number(tau_n), &ar.number(velocity));
            assert!(double(&flight.rotation(&ar, &excitation, &ar.number(tau_n))).abs() < 1e-150);
            assert!((double(&flight.velocity(&ar, &excitation, &ar.number(tau_n))) - velocity).abs() < 1e-16);
            for s in [0.125, 0.5, 1.0] {
                let tau = ar.number(tau_n + s);
                let before = flight.rotation(&ar, &excitation, &ar.sub(&tau, &h));
                let at = flight.rotation(&ar, &excitation, &tau);
                let after = flight.rotation(&ar, &excitation, &ar.add(&tau, &h));
                let second = ar.div(&ar.sub(&ar.add(&before, &after), &ar.scale(&at, 2.0)), &ar.mul(&h, &h));
                let residual = ar.add(&ar.add(&ar.sub(&second, &at), &ar.number(sign)), &excitation.forcing(&ar, &tau));
                assert!(double(&residual).abs() < 1e-70, "residual {:e}", double(&residual));
                let slope = ar.div(&ar.sub(&after, &before), &ar.scale(&h, 2.0));
                assert!(double(&ar.sub(&slope, &flight.velocity(&ar, &excitation, &tau))).abs() < 1e-70);
            }
        }
    }

    #[test]
    fn the_first_flight_is_that_of_eq_10() {
        let ar = Arithmetic::new(256).unwrap();
        let excitation = excitation(&ar);
        let zero = ar.number(0.0);
        let flight = Flight::from_impact(&ar, &excitation, -1.0, &zero, &zero);
        let (xi, xi_prime, i_0) = (excitation.xi(&ar, &zero), excitation.xi_prime(&ar, &zero), ar.number(-1.0));
        let a_0 = ar.scale(&ar.add(&ar.sub(&xi, &xi_prime), &i_0), -0.5);
        let b_0 = ar.scale(&ar.add(&ar.add(&xi, &xi_prime), &i_0), -0.5);
        assert!(double(&ar.sub(&a_0, &flight.falling)).abs() < 1e-70);
        assert!(double(&ar.sub(&b_0, &flight.growing)).abs() < 1e-70);
        // Eq. 24: a sin ψ = -i_0, so that the acceleration starts at zero.
        assert!((double(&excitation.forcing(&ar, &zero)) - 1.0).abs() < 1e-16);
    }
}
