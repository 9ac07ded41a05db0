//! The schemas of the protocol hold of what is really said, in both directions, and of nothing else that is understood.

use std::sync::{Arc, Mutex};

use contract::{Case, Horizon, Model, Normalisation, Slenderness};
use process::{Direction, Engine, Line, Sink};

use crate::{
    common::{case, cases, launch},
    schema::Schema,
};

#[derive(Default)]
struct Kept(Mutex<Vec<(Direction, String)>>);

impl Sink for Kept {
    fn keep(&self, line: &Line<'_>) {
        self.0.lock().unwrap().push((line.direction, line.text.to_owned()));
    }
}

/// What is said in both directions, to the stop, by an engine that misbehaves so and is asked these cases.
fn talk(how: &str, model: Model, cases: &[Case]) -> Vec<(Direction, String)> {
    let kept = Arc::new(Kept::default());
    let mut launch = launch(how);
    launch.model = model;
    if let Ok(engine) = Engine::start(launch, Some(Arc::clone(&kept) as Arc<dyn Sink>)) {
        engine.ask_all(cases);
    }
    let lines = kept.0.lock().unwrap();
    lines.clone()
}

fn from(how: &str) -> Vec<String> {
    let lines = talk(how, Model::Linear, &[case(0.9)]).into_iter();
    lines.filter(|(direction, _)| *direction == Direction::From).map(|(_, text)| text).collect()
}

#[test]
fn what_is_said_to_an_engine_is_as_the_schemas_say() {
    let schemas = ["start", "case", "cases", "stop"].map(|name| (name, Schema::read(name)));
    let slender = |normalisation| case(0.7).with_slenderness(Slenderness::new(0.2, normalisation).unwrap());
    let all = [
        slender(Normalisation::Threshold),
        slender(Normalisation::Threshold).with_horizon(Horizon::Until(7.5)).unwrap(),
        Case::from_epsilon(5e-324, 1e-300, 0.5)
            .unwrap()
            .with_slenderness(Slenderness::new(1.5, Normalisation::Threshold).unwrap()),
    ];
    let mut seen = [0; 4];
    for (how, model) in
        [("well", Model::Linear), ("well", Model::Nonlinear), ("batch", Model::Linear), ("batch", Model::Nonlinear)]
    {
        for (_, text) in talk(how, model, &all).into_iter().filter(|(direction, _)| *direction == Direction::To) {
            let name = text.split('"').nth(3).unwrap();
            let at = schemas.iter().position(|(schema, _)| *schema == name).unwrap();
            assert!(schemas[at].1.allows(&text), "{text}");
            assert!(schemas.iter().filter(|(_, schema)| schema.allows(&text)).count() == 1, "{text}");
            seen[at] += 1;
        }
    }
    assert!(seen.iter().all(|seen| *seen > 0), "{seen:?}");
}

/// Whoever checks his answers by the schemas has them accepted.
#[test]
fn what_is_accepted_is_as_the_schemas_say() {
    let (welcome, reply) = (Schema::read("welcome"), Schema::read("reply"));
    for how in [
        "well",
        "own-field",
        "declines",
        "errors",
        "errors-without-seq",
        "claims",
        "no-interval",
        "hexadecimal",
        "quoted-nan",
        "start-own-field",
        "start-hexadecimal-echo",
        "whole-numbers",
        "nulls",
    ] {
        let lines = from(how);
        let [first, second, ..] = lines.as_slice() else { panic!("{how}: {lines:?}") };
        assert!(welcome.allows(first), "{how}: {first}");
        assert!(reply.allows(second), "{how}: {second}");
    }
    let batch = talk("batch", Model::Linear, &cases(3));
    let replies = batch.iter().filter(|(direction, _)| *direction == Direction::From).skip(1);
    assert!(replies.filter(|(_, text)| reply.allows(text)).count() > 3);
    assert!(welcome.allows(&from("start-error")[0]));
}

/// What the schemas refuse is refused: they are as strict as the gate where they can be.
#[test]
fn what_breaks_the_talk_is_refused_by_the_schemas() {
    let (welcome, reply) = (Schema::read("welcome"), Schema::read("reply"));
    for how in [
        "start-garbage",
        "start-version-2",
        "start-no-version",
        "start-no-echo",
        "start-short-echo",
        "start-no-models",
        "start-unknown-field",
        "start-batch-0",
    ] {
        let lines = from(how);
        assert!(!welcome.allows(&lines[0]), "{how}: {}", lines[0]);
    }
    for how in [
        "garbage",
        "empty-line",
        "two-objects",
        "cut-line",
        "bare-nan",
        "too-large",
        "no-seq",
        "two-in-one",
        "none-in-one",
        "unknown-field",
        "no-velocity",
        "wrong-kind",
        "text-for-number",
        "unknown-ending",
    ] {
        let lines = from(how);
        assert!(!reply.allows(&lines[1]), "{how}: {}", lines[1]);
    }
}
