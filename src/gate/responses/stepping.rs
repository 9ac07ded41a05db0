//! One step of `u'' = F(s, u)`: Störmer's rule with ever finer parts, extrapolated to none (Gragg, Bulirsch, Stoer). It shares nothing with the
//! methods that it is held against.

/// How many rules are extrapolated: the error falls as the 13th power of the step.
const RULES: usize = 6;

/// The state `(u, u')` a time `h` later.
pub(super) fn step(acceleration: impl Fn(f64, f64) -> f64, (u, w): (f64, f64), h: f64) -> (f64, f64) {
    let first = acceleration(0.0, u);
    let mut last = [(0.0, 0.0); RULES];
    let mut best = (0.0, 0.0);
    for rule in 0..RULES {
        let n = (rule + 1) as f64;
        let part = h / n;
        let mut rise_of_part = part * (w + 0.5 * part * first);
        let mut rise = rise_of_part;
        for k in 1..=rule {
            rise_of_part += part * part * acceleration(k as f64 * part, u + rise);
            rise += rise_of_part;
        }
        let speed = rise_of_part / part + 0.5 * part * acceleration(h, u + rise);
        // Neville's scheme in the square of the part.
        best = (rise, speed);
        for (k, old) in last.iter_mut().enumerate().take(rule) {
            let ratio = n / (n - (k + 1) as f64);
            let before = std::mem::replace(old, best);
            let weight = 1.0 / (ratio * ratio - 1.0);
            best = (best.0 + weight * (best.0 - before.0), best.1 + weight * (best.1 - before.1));
        }
        if let Some(slot) = last.get_mut(rule) {
            *slot = best;
        }
    }
    (u + best.0, best.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `u'' = u - 1 - a sin(ωs)` has a closed form.
    #[test]
    fn a_step_is_exact_but_for_rounding() {
        let (a, omega) = (2.0, 1.7);
        let forced = a / (1.0 + omega * omega);
        let exact = |s: f64, u: f64, w: f64| {
            let (one, two) = (u - 1.0, w - forced * omega);
            (
                1.0 + one * s.cosh() + two * s.sinh() + forced * (omega * s).sin(),
                one * s.sinh() + two * s.cosh() + forced * omega * (omega * s).cos(),
            )
        };
        for h in [0.3, 0.1, 1e-3, 1e-7] {
            let found = step(|s, u| u - 1.0 - a * (omega * s).sin(), (0.2, 0.4), h);
            let expected = exact(h, 0.2, 0.4);
            assert!(
                (found.0 - expected.0).abs() < 1e-14 && (found.1 - expected.1).abs() < 1e-13,
                "{h}: {found:?} {expected:?}"
            );
        }
    }

    /// A flight is as accurate, relative to itself, however short it is.
    #[test]
    fn a_short_flight_keeps_its_digits() {
        for v in [1e-3, 1e-9, 1e-15] {
            let interval = 2.0 * f64::atanh(v);
            let (u, w) = step(|_, u| u - 1.0, (0.0, v), interval);
            assert!(u.abs() < 1e-14 * v * v && (w + v).abs() < 1e-13 * v, "{v}: {u} {w}");
        }
    }
}
