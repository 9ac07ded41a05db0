use super::*;

/// A run of 200 responses by one method in which everything is as it has to be.
fn whole() -> Tally {
    let counts = MethodCounts { answered: 200, impacts: 5000, related: 50, used: 0.3, ..MethodCounts::default() };
    Tally {
        responses: 200,
        reach: Example::ALL.into_iter().map(|example| (example, 7)).collect(),
        relations: Relation::ALL.into_iter().map(|relation| (relation, 5)).collect(),
        methods: [("method".to_owned(), counts)].into(),
        ..Tally::default()
    }
}

fn changed(change: impl Fn(&mut Tally)) -> Vec<Shortfall> {
    let mut tally = whole();
    change(&mut tally);
    shortfalls(&tally).0
}

fn of_the_method(change: impl Fn(&mut MethodCounts)) -> Vec<Shortfall> {
    changed(|tally| tally.methods.values_mut().for_each(&change))
}

#[test]
fn each_thing_that_a_run_fails_to_prove_is_said_and_nothing_else() {
    let method = || "method".to_owned();
    assert_eq!(changed(|_| {}), []);
    assert_eq!(changed(|tally| tally.too_close = 50), []);
    assert_eq!(changed(|tally| tally.too_close = 51), [Shortfall::TooClose { too_close: 51, responses: 200 }]);
    assert_eq!(of_the_method(|counts| counts.declined = 10), []);
    assert_eq!(
        of_the_method(|counts| counts.declined = 11),
        [Shortfall::Declined { method: method(), declined: 11, asked: 211 }]
    );
    assert_eq!(of_the_method(|counts| counts.used = 9e-4), [Shortfall::Unused { method: method(), used: 9e-4 }]);
    assert_eq!(of_the_method(|counts| (counts.used, counts.wrong) = (0.0, 1)), []);
    assert_eq!(of_the_method(|counts| counts.impacts = 0), [Shortfall::NoImpact { method: method() }]);
    // What foretells rests lists no impacts, and may decline; of one that foretells nothing that is told.
    let foretells = |rests: usize, declined: usize| {
        of_the_method(move |counts| (counts.impacts, counts.rests, counts.declined) = (0, rests, declined))
    };
    assert_eq!(foretells(20, 500), []);
    let nothing =
        [Shortfall::Declined { method: method(), declined: 500, asked: 700 }, Shortfall::NoImpact { method: method() }];
    assert_eq!(foretells(0, 500), nothing);
    assert_eq!(of_the_method(|counts| counts.related = 0), [Shortfall::NeverAskedAgain { method: method() }]);
    let relation = Relation::Later;
    let never = changed(|tally| {
        tally.relations.remove(&relation);
    });
    assert_eq!(never, [Shortfall::NeverTried { relation }]);
    let example = Example::OverturnsAfterwards;
    let never = changed(|tally| {
        tally.reach.remove(&example);
    });
    assert_eq!(never, [Shortfall::NeverMet { example }]);
}

/// What a small run can't judge is listed and is not held against it; nothing is concluded from a part of a run.
#[test]
fn a_run_is_not_red_for_being_small_or_interrupted() {
    let small = Tally { responses: 199, ..Tally::default() };
    let (red, not_judged) = shortfalls(&small);
    assert!(red.is_empty() && matches!(&not_judged[..], [NotJudged { cases: 199, needed: 200, .. }]));
    let interrupted = Tally { left_out: vec!["response/200".into()], ..small };
    let red = shortfalls(&interrupted).0;
    assert_eq!(red, [Shortfall::Interrupted { examined: 199, handed: 200 }]);
    assert_eq!(red[0].verdict(), Verdict::Undecided);
}
