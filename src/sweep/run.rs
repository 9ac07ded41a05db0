//! Running a sweep: groups of points, each by all threads; what is whole is handed on in order.

use std::{
    ops::Range,
    time::{Duration, Instant},
};

use rayon::{ThreadPool, prelude::*};

use super::Sweep;

/// Groups grow until they take about this long: so much is done again after an interruption.
const LONG: Duration = Duration::from_millis(250);
/// The most points of a group.
const MOST: usize = 1 << 18;
/// The most points that a thread takes at a time.
const BLOCK: usize = 2048;

/// Runs these points on the threads of a pool. `take` is given their rows, in order, and how many there are; it says whether to go on.
///
/// # Errors
/// What `take` says.
pub fn run<Error>(
    pool: &ThreadPool,
    sweep: &Sweep,
    points: Range<usize>,
    mut take: impl FnMut(&str, usize) -> Result<bool, Error>,
) -> Result<(), Error> {
    let threads = pool.current_num_threads();
    let (mut from, mut group) = (points.start, 4 * threads);
    while from < points.end {
        let began = Instant::now();
        let to = points.end.min(from.saturating_add(group));
        let block = ((to - from) / (16 * threads)).clamp(1, BLOCK);
        let blocks = (to - from).div_ceil(block);
        let rows_of = |number| sweep.rows(from + number * block..to.min(from + (number + 1) * block));
        let rows: Vec<String> = pool.install(|| (0..blocks).into_par_iter().map(rows_of).collect());
        if !take(&rows.concat(), to - from)? {
            return Ok(());
        }
        if began.elapsed() < LONG {
            group = MOST.min(2 * group);
        }
        from = to;
    }
    Ok(())
}
