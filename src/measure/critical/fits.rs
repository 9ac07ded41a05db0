//! Formulas for the critical amplitude that are short enough to print. They return `a_cr` itself, dimensionless as in Eq. 5: 1 is
//! the amplitude at which rocking starts.
//!
//! The largest errors are those on the grid of `tests/studies/critical.rs`, against the interpolant; `ω` is from 0.5 to 8 everywhere.

/// The fit of Eq. 76, good to a few parts in a thousand for `η > 0.75` and `ω` from 0.5 to 8.
pub fn eq76(omega: f64, eta: f64) -> f64 {
    let (w, n) = (omega, eta);
    1.079 - 0.1885 * n + 0.1405 * w + 0.6442 * n * n - 0.1903 * n * w - 0.02818 * w * w - 0.7372 * n.powi(3)
        + 0.06413 * n * n * w
        + 0.03236 * n * w * w
        + 0.00176 * w.powi(3)
        + 0.2146 * n.powi(4)
        - 0.0187 * n.powi(3) * w
        - 0.003045 * n * n * w * w
        - 0.00185 * n * w.powi(3)
}

/// The fit of Eq. 77, by the restitution alone.
pub fn eq77(eta: f64) -> f64 {
    -0.3941 * eta.powi(3) + 0.5763 * eta * eta - 0.45 * eta + 1.271
}

/// A better fit with as many coefficients as Eq. 76, 14: with `z = (1-η)^(3/7)` and `s = 1/ω²`, `a_cr - 1 = z²/P(s, z)`.
///
/// | Largest error for `η` | from 0.75 to 0.98 | from 0.5 to 0.98 |
/// |---|---|---|
/// | Eq. 76 | 5.52e-3 | 1.14e-2 |
/// | this | 2.51e-6 | 2.52e-6 |
///
/// The powers are those of the motion. As `η -> 1` the flights after the first hardly change from one to the next, so their velocity keeps
/// `v³/(effective gravity)`: it starts at `v ~ ε^(3/2)` where that gravity is of the order `ε`, and is `ε^(7/6)` where it is of the order 1.
/// There the impacts take away `1-η` of it in a time `v`; to use it up before `T/2` they need `v ~ 1-η`, so `ε ~ (1-η)^(6/7)`. And `ω` enters by
/// the rotation, `φ/ω²`, which is of the order `ε²` where the gravity is of the order `ε`: hence in powers of about `s z²`.
///
/// Of the terms that this allows, those were taken that leave the smallest error; their coefficients are those of the smallest largest error for
/// `η` from 0.5 to 0.98, by linear programming. In the form of Eq. 76 itself the best coefficients leave 4.6e-3 and 9.6e-3.
pub fn fit(omega: f64, eta: f64) -> f64 {
    let z = (1.0 - eta).powf(3.0 / 7.0);
    let s = 1.0 / (omega * omega);
    let z2 = z * z;
    let p0 = 2.766524 + z2 * (2.461652 + z * (-2.117818 + z * (1.741084 + z.powi(3) * (1.736633 - 2.849465 * z))));
    let p1 = z2 * (0.990817 + z * (-0.358266 + z * (1.432017 - 0.817768 * z)));
    let p2 = z2 * z2 * (0.157535 - 0.094359 * z);
    let p3 = z2 * z2 * (0.001036 - 0.004591 * z);
    1.0 + z2 / (p0 + s * (p1 + s * (p2 + s * p3)))
}

/// A better fit with as many coefficients as Eq. 77, 4. It knows `ω` as well: whatever does not is off by half of what `ω` changes, 1.4e-2 at
/// `η = 0.75`.
///
/// | Largest error for `η` | from 0.75 to 0.98 | from 0.5 to 0.98 |
/// |---|---|---|
/// | Eq. 77 | 2.80e-2 | 5.90e-2 |
/// | this | 3.74e-4 | 3.74e-4 |
///
/// In the powers of [`fit`]; of all choices of four up to `z⁵` and `s²`, the one with the smallest largest error for `η` from 0.5 to 0.98.
pub fn short_fit(omega: f64, eta: f64) -> f64 {
    let z = (1.0 - eta).powf(3.0 / 7.0);
    let s = 1.0 / (omega * omega);
    let z2 = z * z;
    1.0 + z2 / (2.771353 + z2 * (1.772206 + s * (1.139997 + 0.134825 * s * z * z2)))
}
