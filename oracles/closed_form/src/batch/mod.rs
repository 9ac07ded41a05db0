//! Many cases at once.
//!
//! Each case is in a lane of its own, and goes through the same formulas as in `sequence`, in the same order of operations on every instruction set. The
//! bits of a case depend neither on the number of threads, nor on the other cases, nor on how many lanes there are: only on whether the instruction set has a
//! fused multiply-add ([`InstructionSet`]). What the lanes are not made
//! for (a flight that grazes, that ends at `T/2`, whose impact is not quickly proven to be the first) is done by the
//! scalar code, and the case goes on in its lane. There are no claims: they are what [`ClosedForm`](crate::ClosedForm) takes its time for.
//!
//! ```
//! use closed_form::batch::{Batch, Rows, Sequence};
//!
//! let (cases, impacts) = (3, 60);
//! let mut time = vec![0.0; cases * impacts];
//! let (mut interval, mut velocity) = (time.clone(), time.clone());
//! let mut sequences = vec![Sequence::default(); cases];
//! let batch = Batch::new(&[0.03, 0.02, 0.01], &[2.0, 2.0, 5.0], &[0.92, 0.92, 0.9], impacts)?;
//! batch.run(Rows {
//!     time: &mut time,
//!     interval: &mut interval,
//!     velocity: &mut velocity,
//!     sequences: &mut sequences,
//! })?;
//! // Impact 10 of the first case.
//! assert!((time[9] - 0.839_009_100_136_198_2).abs() < 1e-15);
//! # Ok::<(), closed_form::batch::Refusal>(())
//! ```

mod blocks;
mod counted;
mod lanes;
mod motion;
mod order;
mod pool;
mod refusal;
mod registers;
mod set;
mod single;
mod state;

use contract::{Ending, Limit};
use rayon::prelude::*;

pub use counted::Operations;
pub use refusal::Refusal;
pub use set::InstructionSet;

/// How many cases a thread takes at a time: so many that some of them go well side by side, and so few that the rows of some dozens of impacts fit into a cache.
const CHUNK: usize = 512;

/// How many impacts may be asked for, for each case.
pub const MOST_IMPACTS: usize = 1_000_000;

/// Cases to be followed to `T/2`, each to the same number of impacts at the most.
#[derive(Debug, Clone, Copy)]
pub struct Batch<'a> {
    work: Work<'a>,
    set: InstructionSet,
}

/// Where the impacts go: of `C` cases and `N` impacts, `C · N` numbers for each quantity. Impact `n` of case `c` is at `c N + n - 1`; what a
/// case has no impact for is not a number.
#[derive(Debug)]
pub struct Rows<'a> {
    /// The times `τ_n` of the impacts.
    pub time: &'a mut [f64],
    /// The intervals `τ_n - τ_(n-1)`.
    pub interval: &'a mut [f64],
    /// The velocities `φ'_n` after the impacts.
    pub velocity: &'a mut [f64],
    /// How long each of the `C` sequences is, and why it ended.
    pub sequences: &'a mut [Sequence],
}

/// How long a sequence is, and why it ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sequence {
    /// How many impacts there are in its row.
    pub impacts: usize,
    /// Why there are no more.
    pub ending: Ending,
}

/// What was done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Tally {
    /// How many impacts were found.
    pub impacts: u64,
    /// How many flights were left to the scalar code.
    pub alone: u64,
}

/// Cases, by what they are given by.
#[derive(Debug, Clone, Copy)]
struct Work<'a> {
    epsilon: &'a [f64],
    omega: &'a [f64],
    eta: &'a [f64],
    impacts: usize,
}

impl<'a> Batch<'a> {
    /// The cases with these `ε = a - 1`, `ω` and `η`, to `impacts` impacts at the most, with the fastest instruction set that the machine has.
    ///
    /// # Errors
    /// A [`Refusal`] when the slices differ in length, `impacts` is 0 or above [`MOST_IMPACTS`], or a case is none or out of range; it says which.
    pub fn new(epsilon: &'a [f64], omega: &'a [f64], eta: &'a [f64], impacts: usize) -> Result<Self, Refusal> {
        refusal::check(epsilon, omega, eta, impacts)?;
        Ok(Self { work: Work { epsilon, omega, eta, impacts }, set: InstructionSet::fastest() })
    }

    /// The same with another instruction set; one that the machine lacks is replaced by the next slower one.
    #[must_use]
    pub fn with_instruction_set(self, set: InstructionSet) -> Self {
        Self { set, ..self }
    }

    /// Follows all cases, on the threads of the current pool of rayon.
    ///
    /// # Errors
    /// A [`Refusal`] when the rows have not the shape of this batch.
    pub fn run(&self, rows: Rows) -> Result<Tally, Refusal> {
        let Self { work, set } = *self;
        rows.check(work.epsilon.len(), work.impacts)?;
        let Rows { time, interval, velocity, sequences } = rows;
        let numbers = CHUNK * work.impacts;
        let cases = (work.epsilon.par_chunks(CHUNK), work.omega.par_chunks(CHUNK), work.eta.par_chunks(CHUNK));
        let rows = (
            time.par_chunks_mut(numbers),
            interval.par_chunks_mut(numbers),
            velocity.par_chunks_mut(numbers),
            sequences.par_chunks_mut(CHUNK),
        );
        let tallies = cases.into_par_iter().zip(rows.into_par_iter()).map(|(cases, rows)| {
            let (epsilon, omega, eta) = cases;
            let (time, interval, velocity, sequences) = rows;
            let work = Work { epsilon, omega, eta, ..work };
            set.run(&work, &mut Rows { time, interval, velocity, sequences })
        });
        Ok(tallies.reduce(Tally::default, Tally::plus))
    }

    /// Follows the first cases (512 at the most), one at a time in a lane with a fused multiply-add that counts: the operations of the lane, those
    /// for flights that it leaves to the scalar code included, and how many impacts these are for.
    pub fn operations(&self) -> (Operations, Tally) {
        let first = |all: &'a [f64]| all.get(..CHUNK).unwrap_or(all);
        let Work { epsilon, omega, eta, impacts } = self.work;
        let work = Work { epsilon: first(epsilon), omega: first(omega), eta: first(eta), impacts };
        let mut time = vec![0.0; work.epsilon.len() * impacts];
        let (mut interval, mut velocity) = (time.clone(), time.clone());
        let mut sequences = vec![Sequence::default(); work.epsilon.len()];
        let rows =
            Rows { time: &mut time, interval: &mut interval, velocity: &mut velocity, sequences: &mut sequences };
        let tally = pool::run::<_, 1>(counted::Counted(0.0), &work, &mut { rows });
        (counted::take(), tally)
    }
}

impl Rows<'_> {
    fn check(&self, cases: usize, impacts: usize) -> Result<(), Refusal> {
        let numbers = cases.saturating_mul(impacts);
        for (what, length, expected) in [
            ("time", self.time.len(), numbers),
            ("interval", self.interval.len(), numbers),
            ("velocity", self.velocity.len(), numbers),
            ("sequences", self.sequences.len(), cases),
        ] {
            refusal::of_length(what, length, expected)?;
        }
        Ok(())
    }

    fn quantities(&mut self) -> [&mut [f64]; 3] {
        [self.time, self.interval, self.velocity]
    }

    /// No impacts yet. Written from start to end, the rows are in the cache when impacts are written to them in the order of the lanes.
    fn clear(&mut self) {
        for quantity in self.quantities() {
            quantity.fill(f64::NAN);
        }
    }

    /// Ends a case whose impacts are written.
    fn end(&mut self, case: usize, sequence: Sequence) {
        if let Some(place) = self.sequences.get_mut(case) {
            *place = sequence;
        }
    }
}

impl Default for Sequence {
    /// No impacts yet.
    fn default() -> Self {
        Self { impacts: 0, ending: Ending::LimitReached(Limit::Impacts) }
    }
}

impl Tally {
    fn plus(self, other: Self) -> Self {
        Self { impacts: self.impacts + other.impacts, alone: self.alone + other.alone }
    }
}
