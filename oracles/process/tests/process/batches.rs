//! Many cases at once, over several processes: the answers are those of one case at a time.

use contract::{Case, Oracle};
use process::{Engine, Outcome, Verdict};

use crate::common::{case, cases, launch, verdict};

fn outcomes(how: &str, processes: usize, restarts: usize, cases: &[Case]) -> Vec<Outcome> {
    let mut launch = launch(how);
    launch.processes = processes;
    launch.restarts = restarts;
    let engine = Engine::start(launch, None).unwrap();
    engine.ask_all(cases);
    cases.iter().map(|case| engine.answer(case).outcome).collect()
}

/// In batches, in any order, by any number of processes: the answers are the same.
#[test]
fn the_answers_are_those_of_one_at_a_time() {
    let cases = cases(150);
    let alone = outcomes("well", 1, 0, &cases);
    for (how, processes) in [("well", 3), ("batch", 1), ("batch", 3), ("batch-any-order", 2)] {
        assert_eq!(outcomes(how, processes, 0, &cases), alone, "{how} {processes}");
    }
}

/// One case that crashes its batch costs the others nothing.
#[test]
fn a_crash_in_a_batch_is_of_one_case() {
    let mut cases = cases(70);
    cases.insert(17, case(0.25));
    for processes in [1, 3] {
        let outcomes = outcomes("batch-crashes-on-bad", processes, 20, &cases);
        for (at, outcome) in outcomes.iter().enumerate() {
            match outcome {
                Outcome::Broke(broke) => assert_eq!((at, broke.verdict), (17, Verdict::Crashed)),
                _ => assert_ne!(at, 17),
            }
        }
    }
}

/// Which cases are not asked any more does not depend on how many processes there are.
#[test]
fn exhausted_restarts_are_the_same_for_any_number_of_processes() {
    let mut cases = cases(40);
    for (n, at) in [5, 9, 20, 33].into_iter().enumerate() {
        let bad = case(0.25).with_max_impacts(n + 5).unwrap();
        cases.insert(at, bad);
    }
    for how in ["crashes-on-bad", "batch-crashes-on-bad"] {
        let one = outcomes(how, 1, 3, &cases);
        let named = |verdict| one.iter().filter(|o| matches!(o, Outcome::Broke(b) if b.verdict == verdict)).count();
        assert!(named(Verdict::Crashed) >= 2 && named(Verdict::RestartsExhausted) > 0, "{how}: {one:?}");
        for processes in [2, 3] {
            assert_eq!(outcomes(how, processes, 3, &cases), one, "{how} {processes}");
        }
    }
}

/// Whoever answers otherwise in company than alone is found out, in every case.
#[test]
fn an_engine_that_is_right_only_in_a_batch_is_noticed() {
    let cases = cases(100);
    for outcome in outcomes("batch-only", 2, 0, &cases) {
        let Outcome::Broke(broke) = outcome else { panic!("{outcome:?}") };
        assert_eq!(broke.verdict, Verdict::DiffersAlone);
        assert!(broke.happened.starts_with("impact 2 is at"), "{broke}");
    }
}

#[test]
fn a_second_answer_in_a_batch_is_noticed() {
    let cases = cases(3);
    let outcomes = outcomes("batch-twice", 1, 0, &cases);
    assert!(matches!(&outcomes[0], Outcome::Broke(broke) if broke.verdict == Verdict::TwoAnswers), "{outcomes:?}");
    assert!(matches!(outcomes[1], Outcome::History(_)));
}

/// A second answer that comes after the first was taken is laid to the right case, for any number of processes.
#[test]
fn a_late_second_answer_is_noticed() {
    let cases = cases(5);
    for processes in [1, 2] {
        for outcome in outcomes("two-answers", processes, 0, &cases) {
            assert!(matches!(&outcome, Outcome::Broke(broke) if broke.verdict == Verdict::TwoAnswers), "{outcome:?}");
        }
    }
    let last = outcomes("batch-last-twice", 1, 0, &cases);
    assert!(matches!(&last[4], Outcome::Broke(broke) if broke.verdict == Verdict::TwoAnswers), "{last:?}");
}

#[test]
fn answers_without_end_break_the_talk() {
    let engine = Engine::start(launch("answers-again-and-again"), None).unwrap();
    engine.history(&case(0.9)).unwrap();
    assert_eq!(verdict(&engine.answer(&case(0.8))), Verdict::TwoAnswers);
}

/// A batch that is not answered in full is asked alone, one case after the other.
#[test]
fn what_a_batch_leaves_out_is_asked_alone() {
    let cases = cases(4);
    let outcomes = outcomes("batch-one-missing", 1, 1, &cases);
    assert!(outcomes.iter().all(|outcome| matches!(outcome, Outcome::History(_))), "{outcomes:?}");
}

/// What is forgotten is asked anew.
#[test]
fn the_memory_can_be_cleared() {
    let engine = Engine::start(launch("batch-only"), None).unwrap();
    let cases = cases(2);
    engine.ask_all(&cases);
    assert!(engine.history(&cases[0]).is_err());
    engine.forget();
    engine.history(&cases[0]).unwrap();
}
