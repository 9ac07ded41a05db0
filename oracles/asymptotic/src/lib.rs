//! The asymptotic series for weak excitation, `a = 1 + ε` (Eq. 14): to the order of the paper, to any order, and resummed up to the critical
//! amplitude.
//!
//! # The order of the paper ([`Order::Paper`])
//! The iterative procedure of Eqs 31, 57, 60, 62 and 64, and the chattering time of Eq. 65. With `i_0 = -1`, `x = ω σ_{n;1}` and
//! `y = ω T_{n;1}` it is free of `ω` and `ε` (the `a` of Eq. 60 cancels against the `1/a` of Eq. 51): it is computed once for each `η`, and
//! the chattering time is two numbers, see [`Coefficients`].
//! Even flights (`i_n = i_0`) keep `T_{n;1} ε^(1/2)`, odd flights `T_{n;3} ε^(3/2)`, as Eq. 65 does. The `T_{n;3}` of the even flights, of the
//! same order as that of the odd ones, is dropped. So all relative errors are of the order of `ε`.
//!
//! # Any order ([`Order::Terms`], [`Expansion`])
//! The same iteration in power series of `ε`, truncated at the same order in every flight: `ω τ_ch = ε^(1/2) (c₀ + c₁ ε + c₂ ε² + ...)`. The
//! first two agree with Eq. 65 but for the dropped `T_{n;3}`. The series converges up to the critical amplitude.
//!
//! # Up to the critical amplitude ([`Order::Resummed`], [`Resummed`])
//! There the chattering time has a branch point whose exponent is known ([`approach`]). What is known of it is summed in closed form.
//!
//! # Other motions of the ground
//! Chattering after a weak push by any motion, about its peak: the chattering times of the bouts of a response, from `Oracle::bouts_on`.
//!
//! Every answer carries a claim of its own error, and the oracle declines where that is more than was asked for.
//!
//! # Misprints met
//! - Powers of `ε` under Eqs 43, 52-57: the half-integer steps are `ε^(1/2), ε^(2/2), ε^(3/2), ...`.
//! - `T_{0;3}` of Eqs 31 and 32: `32(ω²-1)/(5ω²)` has to be `32(ω²-1)/(15ω²)`. Eq. 30 stops at `m = 5` and lacks the term
//!   `Φ_{0;0}^{(6)} (T_{0;1})³`, which is of the same order. (Eq. 34 has 15. The procedure does not use `T_{0;3}`.)
//! - "Next steps" ends the procedure when the cubic of Eq. 62 returns a negative solution. It never does: it always has one positive root,
//!   and the sequence is infinite.
#![forbid(unsafe_code)]

mod compensated;
mod expansion;
mod flight;
mod kernels;
mod linear;
mod march;
mod number;
mod oracle;
mod paper;
mod resummed;
mod series;
mod singularity;
mod truncated;
mod weak;

pub use expansion::{Coefficient, Expansion};
pub use oracle::{Asymptotic, MOST_ORDER, Order};
pub use paper::{Coefficients, coefficients};
pub use resummed::{Alternative, RESUMMED_TERMS, Resummed, exponent_of_coefficients, scaled_tail};
pub use singularity::{Approach, Ratio, approach, ratios};
