use crate::number::{Number, real};
use crate::series::Series;

/// The functions that Eq. 4 is solved with, of a duration `D` of `ω s/ε^(1/2)`, as power series in `ε`. Each is entire in `w = ε D²`:
///
/// - `of_state[j] = Σ_m q^m w^m/(2m+j)!`, `q = 1/ω²`: for `j = 0` the `cosh s`, for `j = 1` the `sinh s/s` of Eq. 6;
/// - `of_forcing[j] = Σ_m p_m w^m/(2m+2+j)!`, `p_m = Σ_{k<=m} q^k (-1)^(m-k)`: what `1 - cos` of the forcing does to rotation and velocity;
/// - `of_phase[j] = Σ_m (-1)^m w^m/(2m+j)!`: the forcing itself at the end of the flight.
///
/// In this form nothing cancels, however short the flight.
pub(crate) struct Kernels<T> {
    pub(crate) of_state: [Series<T>; 3],
    pub(crate) of_forcing: [Series<T>; 3],
    pub(crate) of_phase: [Series<T>; 3],
}

impl<T: Number> Kernels<T> {
    /// At the duration `d`, for `q = 1/ω²`, with `ε` counted in `unit`.
    pub(crate) fn new(d: &Series<T>, q: T, unit: T) -> Self {
        let terms = d.terms();
        let zeros = || std::array::from_fn(|_| Series::constant(T::zero(), terms));
        let mut kernels = Self { of_state: zeros(), of_forcing: zeros(), of_phase: zeros() };
        let w = d.times(d).shifted().scaled(unit);
        let mut power = Series::constant(T::one(), terms);
        let (mut q_power, mut forcing, mut sign) = (T::one(), T::one(), T::one());
        // 1/(2m)!
        let mut factor = T::one();
        for m in 0..terms {
            let mut over = factor;
            for j in 0..5 {
                if j > 0 {
                    over = over.over(real((2 * m + j) as f64));
                }
                if let Some(sum) = kernels.of_state.get_mut(j) {
                    sum.add(q_power * over, &power);
                }
                if let Some(sum) = kernels.of_phase.get_mut(j) {
                    sum.add(sign * over, &power);
                }
                if let Some(sum) = j.checked_sub(2).and_then(|j| kernels.of_forcing.get_mut(j)) {
                    sum.add(forcing * over, &power);
                }
            }
            let largest = q_power.rounded().max(forcing.rounded().abs()).max(1.0) * factor.rounded();
            if m > 0 && is_negligible(largest, &power, &kernels.of_state) {
                break;
            }
            factor = factor.over(real(((2 * m + 1) * (2 * m + 2)) as f64));
            q_power = q_power * q;
            forcing = q_power - forcing;
            sign = -sign;
            power = power.times(&w);
        }
        kernels
    }
}

/// Whether a term is too small to be seen in any coefficient of the sum.
fn is_negligible<T: Number>(factor: f64, power: &Series<T>, [sum, ..]: &[Series<T>; 3]) -> bool {
    let factor = factor / T::NEGLIGIBLE;
    power.0.iter().zip(&sum.0).all(|(term, sum)| (factor * term.rounded()).abs() <= sum.rounded().abs())
}

#[cfg(test)]
mod tests {
    use twofloat::TwoFloat;

    use super::*;

    /// Of a constant duration the coefficients of each kernel are those of its definition, one by one; the powers are kept exact.
    #[test]
    fn every_coefficient_is_right_to_the_digits_of_two_doubles() {
        const TERMS: usize = 14;
        let (duration, q) = (1.5, 0.25);
        let kernels = Kernels::new(&Series::constant(real::<TwoFloat>(duration), TERMS), real(q), real(1.0));
        let factorial = |n: usize| (1..=n).fold(real::<TwoFloat>(1.0), |product, k| product * k as f64);
        for m in 0..TERMS as i32 {
            let w = real::<TwoFloat>((duration * duration).powi(m));
            let sign = |k: i32| if k % 2 == 0 { 1.0 } else { -1.0 };
            let forced: f64 = (0..=m).map(|k| q.powi(k) * sign(m - k)).sum();
            for j in 0..3 {
                let n = 2 * m as usize + j;
                for (found, factor, n) in [
                    (&kernels.of_state[j], q.powi(m), n),
                    (&kernels.of_phase[j], sign(m), n),
                    (&kernels.of_forcing[j], forced, n + 2),
                ] {
                    let expected = (w * factor).over(factorial(n));
                    let error = (found.0[m as usize] - expected).hi().abs();
                    assert!(error < 1e-28 * expected.hi().abs(), "{m} {j}: {} {expected}", found.0[m as usize]);
                }
            }
        }
    }
}
