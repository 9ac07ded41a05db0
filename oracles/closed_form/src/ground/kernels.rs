//! What one unit of the pull, of its slope and of a wave in it do to the rotation, each without the small difference of large numbers.
//!
//! They are the integrals `∫ sinh(s - r) c(r) dr` from 0 to `s` of `c = 1`, `r`, `sin(ωr)/ω` and `cos(ωr) - 1`, each with its derivative by `s`.

/// Up to which `s` and `ωs` the power series are used.
const SMALL: f64 = 1.0;

/// Of `c = 1`: `cosh s - 1` and `sinh s`.
pub fn of_level(s: f64) -> (f64, f64) {
    (cosh_less_one(s), s.sinh())
}

/// Of `c = r`: `sinh s - s` and `cosh s - 1`.
pub fn of_slope(s: f64) -> (f64, f64) {
    (sinh_less(s, || s.sinh()), cosh_less_one(s))
}

/// Of `c = level + slope r`, with no more exponentials than that takes.
pub fn of_line(s: f64, level: f64, slope: f64) -> (f64, f64) {
    // Most changes of a record are of the slope alone.
    if level == 0.0 {
        let (value, rate) = of_slope(s);
        return (slope * value, slope * rate);
    }
    let (cosh_less_one, sinh) = of_level(s);
    (level * cosh_less_one + slope * sinh_less(s, || sinh), level * sinh + slope * cosh_less_one)
}

fn cosh_less_one(s: f64) -> f64 {
    let half = (0.5 * s).sinh();
    2.0 * half * half
}

/// `sinh s - s`; the sine is asked for where it is needed.
fn sinh_less(s: f64, sinh: impl FnOnce() -> f64) -> f64 {
    if s < SMALL { series(s, 3, |_| 1.0) } else { sinh() - s }
}

/// Of `c = sin(ωr)/ω`: `(sinh s - sin(ωs)/ω)/(1 + ω²)` and `(cosh s - cos ωs)/(1 + ω²)`.
pub fn of_sine(s: f64, omega: f64) -> (f64, f64) {
    if is_small(s, omega) {
        return (series(s, 3, powers(omega)), series(s, 2, powers(omega)));
    }
    let (w2, (sin, cos)) = (1.0 + omega * omega, (omega * s).sin_cos());
    // Of ω = 0 it is that of the slope.
    let sine = if omega > 0.0 { sin / omega } else { s };
    ((s.sinh() - sine) / w2, (s.cosh() - cos) / w2)
}

/// Of `c = cos(ωr) - 1`: `-[ω²(cosh s - 1) - (1 - cos ωs)]/(1 + ω²)` and `-ω(ω sinh s - sin ωs)/(1 + ω²)`.
pub fn of_cosine(s: f64, omega: f64) -> (f64, f64) {
    let square = omega * omega;
    if is_small(s, omega) {
        return (-square * series(s, 4, powers(omega)), -square * series(s, 3, powers(omega)));
    }
    let half = (0.5 * omega * s).sin();
    let value = square * cosh_less_one(s) - 2.0 * half * half;
    let slope = omega * (omega * s.sinh() - (omega * s).sin());
    (-value / (1.0 + square), -slope / (1.0 + square))
}

fn is_small(s: f64, omega: f64) -> bool {
    s < SMALL && omega * s < SMALL
}

/// `q_0 = 1`, `q_(m+1) = 1 - ω² q_m`: the coefficients that the powers of `1` and of `-ω²` leave of each other.
fn powers(omega: f64) -> impl FnMut(f64) -> f64 {
    let square = omega * omega;
    move |before| 1.0 - square * before
}

/// `Σ q_m s^(n+2m)/(n+2m)!`, with `q_0 = 1` and each `q` made from the one before.
fn series(s: f64, n: u32, mut next: impl FnMut(f64) -> f64) -> f64 {
    let mut power = (1..=n).fold(1.0, |product, k| product * s / f64::from(k));
    let (mut q, mut sum, mut k) = (1.0, power, f64::from(n));
    for _ in 0..16 {
        power *= s * s / ((k + 1.0) * (k + 2.0));
        q = next(q);
        sum += q * power;
        k += 2.0;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    type Kernel<'a> = (&'static str, &'a dyn Fn(f64) -> (f64, f64), &'a dyn Fn(f64) -> f64);

    /// `k'' = k + c`: each is the rotation that its part of the pull drives, from rest on the base.
    #[test]
    fn each_kernel_solves_its_equation() {
        for omega in [0.0, 0.3, 1.0, 2.5, 40.0] {
            let kernels: [Kernel<'_>; 4] = [
                ("level", &of_level, &|_| 1.0),
                ("slope", &of_slope, &|s| s),
                ("sine", &|s| of_sine(s, omega), &|s| if omega > 0.0 { (omega * s).sin() / omega } else { s }),
                ("cosine", &|s| of_cosine(s, omega), &|s| (omega * s).cos() - 1.0),
            ];
            for (name, kernel, pull) in kernels {
                for s in [0.01, 0.02, 0.3, 0.99, 1.01, 2.0, 5.0] {
                    let d = 1e-5;
                    let ((low, low_rate), (value, rate), (high, high_rate)) = (kernel(s - d), kernel(s), kernel(s + d));
                    let size = value.abs() + pull(s).abs() + 1e-3;
                    assert!(
                        ((high - low) / (2.0 * d) - rate).abs() < 2e-7 * (size + rate.abs()) * (1.0 + omega * omega),
                        "{name} {omega} {s}"
                    );
                    let second = (high_rate - low_rate) / (2.0 * d);
                    assert!(
                        (second - value - pull(s)).abs() < 3e-7 * size * (1.0 + omega * omega),
                        "{name} {omega} {s}: {second} {value}"
                    );
                }
            }
        }
    }

    /// Where the series end and the formulas begin, and at depths where the formulas would be nothing but rounding.
    #[test]
    fn the_series_are_the_formulas_and_keep_their_digits() {
        for omega in [0.2, 0.999, 3.0] {
            let edge = SMALL / f64::max(omega, 1.0);
            for kernel in [of_sine, of_cosine] {
                let (below, above) = (kernel(edge * (1.0 - 1e-12), omega), kernel(edge * (1.0 + 1e-12), omega));
                assert!((below.0 / above.0 - 1.0).abs() < 1e-11 && (below.1 / above.1 - 1.0).abs() < 1e-11, "{omega}");
            }
        }
        let s = 1e-30;
        let near = |value: f64, expected: f64| assert!((value / expected - 1.0).abs() < 1e-15, "{value} {expected}");
        near(of_sine(s, 2.0).0, s * s * s / 6.0);
        near(of_cosine(s, 2.0).0, -4.0 * s * s * s * s / 24.0);
        near(of_slope(s).0, s * s * s / 6.0);
        near(of_level(s).0, s * s / 2.0);
    }
}
