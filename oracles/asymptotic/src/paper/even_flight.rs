use std::f64::consts::SQRT_2;

/// Duration `y = ω T_{n;1}` of an even flight (`i_n = i_0`): the one real positive root of the cubic of Eq. 62.
///
/// With Eqs 51 and 60 at `i_0 = -1`, multiplied by `ω`, the cubic has no `ω` left in it:
/// `y³/24 + c₂ y² + c₁ y + v = 0` with `c₂ = (x - √2)/6`, `c₁ = x (x - 2√2)/4`,
/// where `x = ω σ_{n;1} >= 0` is when the flight starts and `v = ω Φ_{n;3}^{(1)} <= 0` is the velocity that it starts with.
///
/// The coefficients change their sign once for every `x` (Descartes), so there is one positive root. Where the cubic is concave,
/// from 0 to `y = -8 c₂` for `c₂ < 0`, it is negative; so Newton's method from above the root falls to it without ever passing it.
pub(crate) fn duration(x: f64, v: f64) -> f64 {
    let (c1, c2) = coefficients(x);
    let mut y = above_the_root(c1, c2, v);
    for _ in 0..MOST_NEWTON_STEPS {
        let slope = c1 + y * (2.0 * c2 + y / 8.0);
        let next = y - (v + y * (c1 + y * (c2 + y / 24.0))) / slope;
        // Monotone until rounding alone decides: that is the root. (A comparison with NaN ends the loop too.)
        if !(next < y && next > 0.0) {
            break;
        }
        y = next;
    }
    y
}

/// A bound above the positive root of `y³/24 + c₂ y² + c₁ y + v`, near enough to it for Newton's method at every scale of `v`.
fn above_the_root(c1: f64, c2: f64, v: f64) -> f64 {
    let (against, speed) = ((-c1).max(0.0), -v);
    // Bound of Fujiwara, `2 max |c_k/c_3|^(1/(3-k))` over the terms that are negative.
    let cubic = 2.0 * (24.0 * (-c2).max(0.0)).max((24.0 * against).sqrt()).max((12.0 * speed).cbrt());
    // The same without the cubic term, and then without the square one, while what is left is positive in the end:
    // positive terms that are left out can only lower the root.
    let square = if c2 > 0.0 { 2.0 * (against / c2).max((speed / (2.0 * c2)).sqrt()) } else { f64::INFINITY };
    let linear = if c1 > 0.0 && c2 >= 0.0 { speed / c1 } else { f64::INFINITY };
    cubic.min(square).min(linear)
}

/// Velocity `ω Φ_{n;3}^{(1)}|_{τ_{n+1}}` at the end of the even flight of duration `y`, before the impact: the third line of Eq. 58,
/// from which the cubic of Eq. 62, which is zero, has been subtracted. What is left has no `v` in it, and cannot cancel late.
pub(crate) fn velocity_at_end(x: f64, y: f64) -> f64 {
    let (c1, c2) = coefficients(x);
    y * (c1 + y * (2.0 * c2 + y / 8.0))
}

/// `c₁ = ω Φ_{n;2}^{(2)} / ω` and `c₂ = Φ_{n;1}^{(3)} / ω` of Eqs 60 and 51.
fn coefficients(x: f64) -> (f64, f64) {
    (x * (x - 2.0 * SQRT_2) / 4.0, (x - SQRT_2) / 6.0)
}

/// Far more than the quadratic convergence from the bounds above ever takes.
const MOST_NEWTON_STEPS: usize = 100;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_flight_is_that_of_eqs_31_and_35() {
        let y = duration(0.0, 0.0);
        assert!((y - 4.0 * SQRT_2).abs() < 4e-15, "{y}");
        assert!((velocity_at_end(0.0, y) - 16.0 * SQRT_2 / 3.0).abs() < 2e-14);
    }

    /// Above it, as Newton's method needs it, and near enough that few steps of that are left.
    #[test]
    fn the_bound_is_above_the_root_and_near_it() {
        for x in [0.0, 1e-9, 0.5, 1.4, SQRT_2, 1.5, 2.0, 2.5, 2.8, 2.0 * SQRT_2, 2.9, 4.0, 10.8, 100.0] {
            for v in [-1e6, -1e3, -10.0, -1.0, -1e-3, -1e-10, -1e-200] {
                let ((c1, c2), root) = (coefficients(x), duration(x, v));
                let share = above_the_root(c1, c2, v) / root;
                assert!((1.0 - 1e-14..3.0).contains(&share), "x = {x}, v = {v}: {share} of the root");
            }
        }
    }

    #[test]
    fn the_root_is_accurate_down_to_the_smallest_velocities() {
        for x in [0.0, 1e-9, 0.5, 1.4, SQRT_2, 2.0, 2.8, 2.0 * SQRT_2, 2.9, 5.0, 10.8, 100.0] {
            for v in [-1e3, -10.0, -1.0, -1e-3, -1e-10, -1e-30, -1e-200] {
                let (y, (c1, c2)) = (duration(x, v), coefficients(x));
                let terms = [v, c1 * y, c2 * y * y, y * y * y / 24.0];
                let largest = terms.iter().fold(0.0_f64, |most, term| most.max(term.abs()));
                assert!(y > 0.0 && terms.iter().sum::<f64>().abs() <= 4e-16 * largest, "x = {x}, v = {v}: y = {y}");
            }
        }
    }
}
