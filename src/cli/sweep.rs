use std::{
    path::{Path, PathBuf},
    sync::atomic::Ordering,
};

use chattercheck::{
    gate::partition::Partition,
    sweep::{self, Kept, Mark, NotKept, Stretch, Sweep},
};
use clap::Args;
use contract::Invalid;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::{
    Status,
    map_flags::MapFlags,
    numbers::count,
    output::{self, Unwritten, note},
    watch::interruption,
};

/// A map: what happens at every point of axes over any parameters of a case or a scene, as one table
///
/// The sweep says in TOML what the axes are and what is wanted. The table is CSV, a row a point, the last axis fastest; its bytes depend neither on the
/// threads, nor on interruptions, nor on parts: those of all parts one after another are those of the whole. While it is not whole it is kept in
/// FILE.rows, beside a mark in FILE.sweep; the same command goes on from there.
#[derive(Args)]
pub(super) struct Arguments {
    /// The sweep, TOML: [axes] over fields, and [want] with the columns
    #[arg(value_name = "SWEEP")]
    sweep: PathBuf,
    /// The table, CSV; one that is there is not written over. - is stdout, where nothing is kept
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// How many threads [default: as many as there are processors]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = count::<1, MOST_THREADS>)]
    threads: Option<usize>,
    /// Only the K-th of N parts; the first has the head of the table
    #[arg(long, value_name = "K/N", allow_hyphen_values = true)]
    partition: Option<String>,
    #[command(flatten)]
    map: MapFlags,
}

const MOST_THREADS: usize = 1024;

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let Arguments { sweep: path, out, threads, partition, map } = arguments;
    if let Some(threads) = threads.filter(|threads| !(1..=MOST_THREADS).contains(threads)) {
        return Err(Invalid::new("threads", threads, "1 to 1024").into());
    }
    let partition = partition.as_deref().map_or(Ok(Partition::WHOLE), Partition::parse)?;
    let sweep = Sweep::read(path)?;
    let map = map.map(&sweep, out, partition)?;
    if let Some(map) = map.as_ref().filter(|map| map.is_redrawn) {
        map.write(&sweep, out)?;
        return Ok(Status::Well);
    }
    let stretch = Stretch::new(sweep.points.count(), partition.part, partition.parts);
    let pool = ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0)).build()?;
    if out == Path::new("-") {
        print(&sweep, &stretch, &pool)?;
        return Ok(Status::Well);
    }
    let [of_sweep, of_files] = sweep.sums.clone();
    let version = env!("CARGO_PKG_VERSION").to_owned();
    let mark = Mark { version, sweep: of_sweep, files: of_files, partition: partition.to_string() };
    let mut kept = Kept::open(out, &sweep, &stretch, &mark)?;
    if kept.whole > 0 {
        note(format_args!("chattercheck: {} of {} rows are whole already", kept.whole, stretch.points.len()));
    }
    let interrupted = interruption("would end the run at once");
    let bar = bar(stretch.points.len(), kept.whole);
    let left = stretch.points.start + kept.whole..stretch.points.end;
    sweep::run(&pool, &sweep, left, |rows, count| {
        kept.add(rows, count)?;
        bar.inc(count as u64);
        Ok::<bool, NotKept>(!interrupted.load(Ordering::Relaxed))
    })?;
    bar.finish_and_clear();
    if kept.whole < stretch.points.len() {
        note(format_args!(
            "chattercheck: interrupted; {} of {} rows are kept, and the same command goes on from there",
            kept.whole,
            stretch.points.len()
        ));
        return Ok(Status::Failed);
    }
    kept.finish()?;
    map.map_or(Ok(()), |map| map.write(&sweep, out))?;
    Ok(Status::Well)
}

/// The rows to stdout, as they come.
fn print(sweep: &Sweep, stretch: &Stretch, pool: &ThreadPool) -> Result<(), Unwritten> {
    output::write(|stdout| {
        if stretch.has_head {
            stdout.write_all(sweep.header().as_bytes())?;
        }
        sweep::run(pool, sweep, stretch.points.clone(), |rows, _| stdout.write_all(rows.as_bytes()).map(|()| true))
    })
}

/// How far it is, on stderr.
fn bar(points: usize, whole: usize) -> ProgressBar {
    let bar = ProgressBar::new(points as u64).with_position(whole as u64);
    match ProgressStyle::with_template("{bar:40} {pos}/{len} points, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
