//! Where the time of an impact goes, in batches on one thread, and how far that is from what its arithmetic alone would take.
//!
//! The operations are counted in a lane that does nothing else. What they would take alone is measured, not derived: as many multiply-adds as there are
//! sums, products and multiply-adds, in the widest registers of the machine, twelve chains of them so that none has to wait, with a quotient to every sixty.
//! All is measured in turns, and each time is the shortest of many.
//!
//! ```text
//! cargo bench -p closed_form --bench cost
//! ```
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used)]

mod workload;

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use closed_form::batch::{Batch, InstructionSet};
use contract::Case;

use workload::{Batched, IMPACTS, one_thread, workload};

/// The workload, and as much of it as has its answer in the cache.
const CASES: [usize; 2] = [100_000, 600];

/// How many multiply-adds there are for each quotient of the arithmetic alone.
const TO_A_QUOTIENT: usize = 60;

/// Multiply-adds in twelve chains, and a quotient that is ready long before the next one needs it.
struct Arithmetic {
    rounds: usize,
}

impl pulp::WithSimd for Arithmetic {
    /// How many lanes there are.
    type Output = usize;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, simd: S) -> usize {
        let [factor, term, one] = [0.999, 1e-3, 1.0].map(|value| simd.splat_f64s(black_box(value)));
        let mut sums = [one; 12];
        let mut quotient = one;
        for _ in 0..self.rounds {
            for _ in 0..TO_A_QUOTIENT / sums.len() {
                for sum in &mut sums {
                    *sum = simd.mul_add_f64s(*sum, factor, term);
                }
            }
            quotient = simd.div_f64s(one, simd.add_f64s(quotient, one));
        }
        black_box(sums);
        black_box(quotient);
        S::F64_LANES
    }
}

/// The shorter of a time so far and that of one run more.
fn shorter(so_far: &mut Duration, mut run: impl FnMut()) {
    let start = Instant::now();
    run();
    *so_far = start.elapsed().min(*so_far);
}

fn main() {
    let sets = InstructionSet::available();
    for set in &sets {
        Batched::verify(*set, 1e-12);
    }

    let cases = workload(512);
    let [epsilon, omega, eta] =
        [Case::epsilon, Case::omega, Case::eta].map(|of| cases.iter().map(of).collect::<Vec<_>>());
    let (operations, tally) = Batch::new(&epsilon, &omega, &eta, IMPACTS).expect("cases").operations();
    let each = |count: u64| count as f64 / tally.impacts as f64;
    let arithmetic = each(operations.sums + operations.products + operations.fused);
    println!(
        "operations of an impact: {:.1} sums, {:.1} products, {:.1} of both in one, {:.1} quotients; {:.1} comparisons and choices",
        each(operations.sums),
        each(operations.products),
        each(operations.fused),
        each(operations.quotients),
        each(operations.choices)
    );

    let thread = one_thread();
    let mut batches = CASES.map(|cases| Batched::new(&workload(cases), IMPACTS));
    let mut times = vec![[Duration::MAX; 2]; sets.len()];
    let mut impacts = [0; 2];
    let (mut alone, mut lanes) = (Duration::MAX, 0);
    const ROUNDS: usize = 100_000;
    for turn in 0..400 {
        shorter(&mut alone, || lanes = pulp::Arch::new().dispatch(Arithmetic { rounds: ROUNDS }));
        for (set, times) in sets.iter().zip(&mut times) {
            for (place, ((batch, time), impacts)) in batches.iter_mut().zip(times).zip(&mut impacts).enumerate() {
                // The whole workload takes so much longer that it has its shortest time after fewer turns.
                if place > 0 || turn % 40 == 0 {
                    shorter(time, || *impacts = thread.install(|| batch.run(*set)).impacts);
                }
            }
        }
    }

    println!("time for an impact, in ns:");
    println!("{:>16}  {:>14}  {:>20}  {:>10}", "instruction set", "100,000 cases", "answer in the cache", "impacts/s");
    for (set, times) in sets.iter().zip(times) {
        let [whole, small] = times.map(|time| time.as_secs_f64() * 1e9);
        let [of_whole, of_small] = impacts.map(|impacts| impacts as f64);
        let (all, cached) = (whole / of_whole, small / of_small);
        println!("{:>16}  {all:>14.2}  {cached:>20.2}  {:>10.2e}", format!("{set:?}"), 1e9 / all);
    }
    let alone = alone.as_secs_f64() * 1e9 / (ROUNDS * TO_A_QUOTIENT * lanes) as f64 * arithmetic;
    println!("the arithmetic alone, in registers of {lanes} lanes: {alone:.2}");
}
