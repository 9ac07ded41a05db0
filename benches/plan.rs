//! What `auto` costs against the generic solver at the tolerance that the strictest question needs, on the same 2,000 questions; and what each method costs, beside
//! what the plan predicts. Every answer is verified against the proven one before anything is timed.
//!
//! `cargo bench --bench plan`
#![allow(clippy::unwrap_used)] // A bench that is wrong stops.

use std::{hint::black_box, time::Instant};

use chattercheck::{
    answer::ask,
    panel::{self, Settings},
    plan::{Method, Outcome, Plan, evidence},
};
use contract::{Ending, Model};

const QUESTIONS: usize = 2000;
/// One in so many is answered by the slow ones.
const SAMPLE: usize = 20;
const IMPACTS: usize = 200;

fn main() {
    let questions = evidence::questions(1, QUESTIONS).unwrap();
    let plans: Vec<Plan> = questions.iter().map(|question| Plan::new(*question)).collect();
    let judge = panel::enclosure_of(Model::Nonlinear);
    let mut wrong = 0;
    for plan in plans.iter().step_by(SAMPLE) {
        let case = plan.question.case.with_max_impacts(20).unwrap();
        let truth = ask(&judge, &case).into_observed().unwrap();
        let right = match plan.answer().outcome() {
            Some(Outcome::Complete(time)) => truth
                .chattering_time
                .is_some_and(|truth| (time.value - truth.value).abs() <= plan.question.tolerance * truth.value),
            Some(Outcome::Incomplete) => matches!(truth.history.ending, Ending::Incomplete | Ending::Overturned),
            Some(Outcome::NeverRocks) => truth.history.ending == Ending::NeverRocks,
            None => false,
        };
        wrong += usize::from(!right);
    }
    assert_eq!(wrong, 0, "answers that miss their tolerance");

    let start = Instant::now();
    for question in &questions {
        black_box(Plan::new(*question).answer());
    }
    let auto = start.elapsed().as_secs_f64() / QUESTIONS as f64;

    let strictest = panel::one("ode", &Settings { rtol: Some(1e-12), ..Settings::default() }, "nonlinear").unwrap();
    let sample: Vec<_> = questions.iter().step_by(SAMPLE).collect();
    let start = Instant::now();
    for question in &sample {
        let _ = black_box(strictest.history(&question.case.with_max_impacts(IMPACTS).unwrap()));
    }
    let solver = start.elapsed().as_secs_f64() / sample.len() as f64;
    println!("auto: {:.1} us a question, on {QUESTIONS} questions", 1e6 * auto);
    println!("ode/nonlinear/tsit45, rtol 1e-12: {:.1} us a question, on {} of them", 1e6 * solver, sample.len());
    println!("ratio: {:.0}", solver / auto);

    println!("\nmethod, times chosen, measured us, predicted us");
    for method in [
        Method::Nothing,
        Method::CriticalAmplitude,
        Method::Linear,
        Method::Corrected,
        Method::Nonlinear,
        Method::Enclosure,
    ] {
        let (mut count, mut predicted, mut seconds) = (0, 0.0, 0.0);
        for plan in plans.iter().filter(|plan| plan.chosen().is_some_and(|chosen| chosen.method == method)) {
            predicted += plan.chosen().map_or(0.0, |chosen| chosen.cost);
            count += 1;
            let start = Instant::now();
            black_box(plan.answer());
            seconds += start.elapsed().as_secs_f64();
        }
        if count > 0 {
            let each = 1.0 / f64::from(count);
            println!("{method:24} {count:5} {:10.2} {:10.2}", 1e6 * seconds * each, predicted * each);
        }
    }
}
