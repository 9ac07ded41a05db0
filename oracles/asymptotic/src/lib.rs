//! The asymptotic series for weak excitation, `a = 1 + ε` (Eq. 14), as the paper gives it: the iterative procedure of Eqs 31, 57, 60, 62
//! and 64, and the chattering time of Eq. 65.
//!
//! With `i_0 = -1`, `x = ω σ_{n;1}` and `y = ω T_{n;1}` the whole procedure is free of `ω` and `ε` (the `a` of Eq. 60 cancels against the
//! `1/a` of Eq. 51): it is computed once for each `η`, and the chattering time is two numbers, see [`Coefficients`].
//!
//! # What is kept, and what is not
//! - Even flights (`i_n = i_0`) keep `T_{n;1} ε^(1/2)`, odd flights `T_{n;3} ε^(3/2)`: as Eq. 65 does. The `T_{n;3}` of the even flights,
//!   of the same order as that of the odd ones, is dropped. So all relative errors are of the order of `ε`.
//! - The time of impact `n` is the sum of the intervals kept; the velocity is `Φ_{n;3}^{(1)} ε^(3/2)` of Eq. 57.
//! - The oracle claims a bound on its truncation error and declines where it has none to stand by.
//!
//! # Misprints met
//! - Powers of `ε` under Eqs 43, 52-57: the half-integer steps are `ε^(1/2), ε^(2/2), ε^(3/2), ...`.
//! - `T_{0;3}` of Eqs 31 and 32: `32(ω²-1)/(5ω²)` has to be `32(ω²-1)/(15ω²)`. Eq. 30 stops at `m = 5` and lacks the term
//!   `Φ_{0;0}^{(6)} (T_{0;1})³`, which is of the same order. (Eq. 34 has 15. The procedure does not use `T_{0;3}`.)
//! - "Next steps" ends the procedure when the cubic of Eq. 62 returns a negative solution. It never does: it always has one positive root,
//!   and the sequence is infinite.
#![forbid(unsafe_code)]

mod claim;
mod coefficients;
mod compensated;
mod even_flight;
mod flights;
mod oracle;

pub use coefficients::{Coefficients, coefficients};
pub use oracle::Asymptotic;
