//! Why a candidate can't answer.

use std::fmt;

use super::estimate::MEASURED;

/// Why a candidate can't answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Refusal {
    /// There is something to compute: the block rocks under this share of the threshold.
    Rocks(f64),
    /// There is nothing to compute: the block does not rock under this share of the threshold.
    NeverRocks(f64),
    /// It solves the nonlinear equation, and the linear model is asked for.
    LinearAsked,
    /// It knows the motion of a case alone.
    Motion,
    /// The amplitude is so much of the way to `a_cr`, not clearly beyond it.
    NotBeyond(f64),
    /// It is so much of the way, and the critical amplitude of the slender block may be on its other side.
    TooNear(f64),
    /// It is beyond `a_cr`, where the series does not converge.
    Diverges,
    /// Its error was measured in another range.
    NotMeasured,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rocks(share) => write!(
                f,
                "there is something to compute: the ground acceleration is {share:.4} times what begins to rock the block"
            ),
            Self::NeverRocks(share) => write!(
                f,
                "there is nothing to compute: the ground acceleration is {share:.4} times what begins to rock the block"
            ),
            Self::LinearAsked => f.write_str("the linear model is asked for"),
            Self::Motion => {
                f.write_str("not for a motion that starts above the threshold, or may end before the block rests")
            }
            Self::NotBeyond(way) => write!(f, "a is {:.4} % of the way to a_cr, not clearly beyond it", 100.0 * way),
            Self::TooNear(way) => write!(
                f,
                "a is {:.4} % of the way to a_cr of the slender block, too near to tell on which side of its own the block is",
                100.0 * way
            ),
            Self::Diverges => f.write_str("the series does not converge beyond a_cr"),
            Self::NotMeasured => {
                let [omegas, etas] = MEASURED;
                write!(
                    f,
                    "its error is known for omega from {} to {} and eta from {} to {} only",
                    omegas.start(),
                    omegas.end(),
                    etas.start(),
                    etas.end()
                )
            }
        }
    }
}
