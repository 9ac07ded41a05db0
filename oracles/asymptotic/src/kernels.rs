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
