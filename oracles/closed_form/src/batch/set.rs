//! The instruction sets that the lanes can be computed with.

use super::{
    Rows, Tally, Work,
    lanes::Many,
    pool,
    registers::{Found, Two},
};

/// An instruction set. Those without a fused multiply-add give the same bits, and so do those with it; the two differ by rounding errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum InstructionSet {
    /// No registers of several lanes; some cases at once all the same, because they do not wait for each other.
    Scalar,
    /// What every machine of the target has: on x86-64, SSE2.
    Baseline,
    /// AVX2 with FMA.
    Avx2,
    /// AVX-512 (F, BW, CD, DQ and VL).
    Avx512,
}

impl InstructionSet {
    /// Those that this machine has, from the slowest to the fastest.
    pub fn available() -> Vec<Self> {
        let all = [Self::Scalar, Self::Baseline, Self::Avx2, Self::Avx512];
        all.into_iter().filter(|set| set.is_available()).collect()
    }

    /// The fastest that this machine has.
    pub fn fastest() -> Self {
        Self::available().pop().unwrap_or(Self::Baseline)
    }

    /// Whether this machine has it.
    pub fn is_available(self) -> bool {
        match self {
            Self::Scalar | Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => pulp::x86::V3::is_available(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => pulp::x86::V4::is_available(),
            #[cfg(not(target_arch = "x86_64"))]
            Self::Avx2 | Self::Avx512 => false,
        }
    }

    /// Does the work; with the next slower instruction set where the machine lacks this one.
    ///
    /// A flight is a chain of operations that wait for each other, so that several are worked on at once. Where registers are narrow two of them take turns with
    /// each operation (`Many`), which would be too much for the number of wide ones that there is; and two or three of what is then a group take turns with
    /// each stage of a flight (`GROUPS` of the pool). How many are fastest was measured.
    pub(super) fn run(self, work: &Work, rows: &mut Rows) -> Tally {
        match self {
            Self::Scalar => pool::run::<_, 3>(Many([0.0; 2]), work, rows),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => match pulp::x86::V3::try_new() {
                Some(simd) => pulp::Simd::vectorize(simd, OnLanes { work, rows }),
                None => Self::Baseline.run(work, rows),
            },
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => match pulp::x86::V4::try_new() {
                Some(simd) => pulp::Simd::vectorize(simd, OnLanes { work, rows }),
                None => Self::Avx2.run(work, rows),
            },
            _ => pool::run::<_, 2>(Many([Two::ZERO; 2]), work, rows),
        }
    }
}

/// Work that is done with an instruction set found at run time.
struct OnLanes<'a, 'w, 'r> {
    work: &'a Work<'w>,
    rows: &'a mut Rows<'r>,
}

impl pulp::WithSimd for OnLanes<'_, '_, '_> {
    type Output = Tally;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, simd: S) -> Tally {
        pool::run::<_, 3>(Found::zero(simd), self.work, self.rows)
    }
}
