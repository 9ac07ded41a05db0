//! The equation of motion by powers of the distance from the base: `u'' = Σ_p u^p (x_p + y_p G)`, with `u = iφ` and the pull `G = 1 + i f`.

/// No power of `u` above this is seen: `u` is of the second order in the speed.
pub const POWERS: usize = 10;

/// The coefficients of one equation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equation {
    /// `x_p`.
    pub free: [f64; POWERS],
    /// `y_p`.
    pub pulled: [f64; POWERS],
}

impl Equation {
    /// Eq. 4: `u'' = u - G`.
    pub fn linear() -> Self {
        let mut equation = Self { free: [0.0; POWERS], pulled: [0.0; POWERS] };
        let ([_, free, ..], [pulled, ..]) = (&mut equation.free, &mut equation.pulled);
        (*free, *pulled) = (1.0, -1.0);
        equation
    }

    /// Eq. 2: `u'' = [sin(αu) - G sin(α) cos(α(1 - u))]/(α cos α)`, by the powers of `αu`.
    pub fn nonlinear(alpha: f64) -> Self {
        let (sin, cos) = alpha.sin_cos();
        let mut equation = Self::linear();
        // α^(p-1)/p!
        let mut power = 1.0 / alpha;
        for (p, (free, pulled)) in (0_u32..).zip(equation.free.iter_mut().zip(&mut equation.pulled)) {
            let sign = if p % 4 < 2 { 1.0 } else { -1.0 };
            // cos(α - αu) = cos α cos(αu) + sin α sin(αu)
            (*free, *pulled) = if p % 2 == 1 {
                (sign * power / cos, -sign * power * sin * sin / cos)
            } else {
                (0.0, -sign * power * sin)
            };
            power *= alpha / f64::from(p + 1);
        }
        equation
    }

    /// The pull at the base in multiples of `G`.
    pub fn at_the_base(&self) -> f64 {
        let [first, ..] = self.pulled;
        -first
    }

    /// The highest power of `u`.
    pub fn degree(&self) -> usize {
        let is_there = |(free, pulled): (&f64, &f64)| *free != 0.0 || *pulled != 0.0;
        self.free.iter().zip(&self.pulled).map(is_there).rposition(|there| there).unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The powers of `u` sum up to Eq. 2 as it is printed.
    #[test]
    fn the_powers_are_those_of_equation_2() {
        let (alpha, u, pull) = (0.4_f64, 0.2_f64, 0.7);
        let Equation { free, pulled } = Equation::nonlinear(alpha);
        let sum = |of: [f64; POWERS]| of.iter().rev().fold(0.0, |sum, term| sum * u + term);
        // φ'' = -[sin(α(i - φ)) + tan(α) f cos(α(i - φ))]/α, with i = 1.
        let (sin, cos) = (alpha * (1.0 - u)).sin_cos();
        let printed = -(sin + alpha.tan() * (pull - 1.0) * cos) / alpha;
        assert!((sum(free) + pull * sum(pulled) - printed).abs() < 1e-14);
        assert_eq!((Equation::linear().degree(), Equation::nonlinear(alpha).degree()), (1, POWERS - 1));
        let slender = Equation::nonlinear(1e-9);
        assert!((slender.at_the_base() - 1.0).abs() < 1e-15 && slender.free[2].abs() + slender.pulled[2].abs() < 1e-8);
    }
}
