//! As many digits as it takes: the formats in order of their cost, and the climb from one to the next.

use crate::{digits::Digits, directed::Directed, twofold::Twofold};

/// Something that can be tried with any number of digits.
pub trait Attempt {
    /// What comes out of it.
    type Answer;

    /// The answer with the digits of `F`, and whether more digits could not better it.
    fn with<F: Directed>(&self) -> (Self::Answer, bool);
}

/// The first good answer with at least `bits` bits, or else the last one. Much beyond 768 bits the bounds on what a series leaves out would
/// themselves be too small for a double.
pub fn climb<A: Attempt>(attempt: &A, bits: u32) -> A::Answer {
    macro_rules! try_with {
        ($($format:ty),*) => {
            $(
                if bits <= <$format as Directed>::BITS {
                    let (answer, good) = attempt.with::<$format>();
                    if good {
                        return answer;
                    }
                }
            )*
        };
    }
    try_with!(f64, Twofold, Digits<128>, Digits<192>, Digits<256>, Digits<384>, Digits<512>);
    attempt.with::<Digits<768>>().0
}

/// Bits for this many decimal digits.
pub fn bits_for(digits: u32) -> u32 {
    // log2(10) < 10/3
    (10 * digits).div_ceil(3)
}
