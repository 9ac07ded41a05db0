//! What `auto` costs against the generic solver at the tolerance that the strictest question needs, on the same 2,000 questions; and what each method costs, beside
//! what the plan predicts. One answer in 20 is verified against the proven one before anything is timed; `tests/motion/plan.rs` does so with all of them.
//!
//! `auto` is timed from the numbers of a case to its answer. The solver runs every 20th question, once for 200 impacts, as one does who does not know how many
//! will be enough, and once for as many as `auto` took (200 where that took none). For each question the least of five rounds is taken, as what
//! else the machine does only ever adds.
//!
//! `cargo bench --bench plan`
#![allow(clippy::unwrap_used)] // A bench that is wrong stops.

use std::{hint::black_box, time::Instant};

use chattercheck::{
    measure::asking::ask,
    panel::{self, Settings},
    plan::{Conclusion, Plan, Question, Way, evidence},
};
use contract::{Case, Ending, Model};

const QUESTIONS: usize = 2000;
/// One in so many is answered by the slow ones.
const SAMPLE: usize = 20;
const IMPACTS: usize = 200;
const ROUNDS: usize = 5;

/// How long one of these takes in the mean, in microseconds.
fn timed<T>(of: &[T], run: impl Fn(&T)) -> f64 {
    let mut least = vec![f64::INFINITY; of.len()];
    for _ in 0..ROUNDS {
        for (one, least) in of.iter().zip(&mut least) {
            let start = Instant::now();
            run(one);
            *least = least.min(start.elapsed().as_secs_f64());
        }
    }
    1e6 * least.iter().sum::<f64>() / of.len() as f64
}

fn main() {
    let questions = evidence::questions(1, QUESTIONS).unwrap();
    let plans: Vec<Plan> = questions.iter().map(|question| Plan::new(*question)).collect();
    let judge = enclosure::Enclosure::new(Model::Nonlinear);
    let mut wrong = 0;
    for plan in plans.iter().step_by(SAMPLE) {
        let case = plan.question.case.with_max_impacts(20).unwrap();
        let truth = ask(&judge, &case).into_observed().unwrap();
        let right = match plan.answer().conclusion() {
            Some(Conclusion::Complete(time)) => truth
                .chattering_time
                .is_some_and(|truth| (time.value - truth.value).abs() <= plan.question.tolerance * truth.value),
            Some(Conclusion::Incomplete | Conclusion::Overturned) => {
                matches!(truth.history.ending, Ending::Incomplete | Ending::Overturned)
            }
            // Only scenes are followed past half a period.
            Some(Conclusion::Rocking) => false,
            Some(Conclusion::NeverRocks) => truth.history.ending == Ending::NeverRocks,
            None => false,
        };
        wrong += usize::from(!right);
    }
    assert_eq!(wrong, 0, "answers that miss their tolerance");

    let strictest = panel::one("ode", &Settings { rtol: Some(1e-12), ..Settings::default() }, "nonlinear").unwrap();
    let with = |plan: &Plan, impacts: usize| plan.question.case.with_max_impacts(impacts).unwrap();
    let sample = || plans.iter().step_by(SAMPLE);
    let long: Vec<Case> = sample().map(|plan| with(plan, IMPACTS)).collect();
    let taken = |plan: &Plan| plan.answer().attempts.last().map_or(0, |last| last.impacts);
    let short: Vec<Case> =
        sample().map(|plan| with(plan, Some(taken(plan)).filter(|impacts| *impacts > 0).unwrap_or(IMPACTS))).collect();
    let solve = |case: &Case| drop(black_box(strictest.history(case)));
    let ask =
        |question: &Question| drop(black_box(Plan::new(Question::new(question.case, question.tolerance)).answer()));
    let auto = timed(&questions, ask);
    let [of_long, of_short] = [&long, &short].map(|cases| timed(cases, solve));
    println!("auto: {auto:.1} us a question, on {QUESTIONS} questions");
    for (what, solver) in [(IMPACTS.to_string(), of_long), ("as many".to_owned(), of_short)] {
        let name = strictest.name();
        println!(
            "{name}, rtol 1e-12, {what} impacts: {solver:.1} us a question, on {} of them: {:.0} times auto",
            long.len(),
            solver / auto
        );
    }

    println!("\nmethod, times chosen, measured us, predicted us");
    for method in [Way::Nothing, Way::CriticalAmplitude, Way::Linear, Way::Corrected, Way::Nonlinear, Way::Enclosure] {
        let of: Vec<_> =
            plans.iter().filter(|plan| plan.chosen().is_some_and(|chosen| chosen.method == method)).collect();
        if !of.is_empty() {
            let predicted: f64 = of.iter().filter_map(|plan| plan.chosen()).map(|chosen| chosen.cost).sum();
            let (count, measured) = (of.len(), timed(&of, |plan| drop(black_box(plan.answer()))));
            println!("{method:24} {count:5} {measured:10.2} {:10.2}", predicted / count as f64);
        }
    }
}
