//! Claims that are halved or doubled turn the gate red, although every case may still be right.

use std::collections::BTreeMap;

use chattercheck::{
    cases::generate::Named,
    faults::{
        plant::{Plant, Planted},
        remember::Remembering,
    },
    gate::{
        judge::Judges,
        report::Report,
        run::{self, Selection},
        shortfall::Shortfall,
    },
    panel,
};
use contract::{Case, History, Oracle, Uncertainty};

/// The cases of a default run that are judged.
fn sample(seed: u64) -> Vec<Named> {
    let selection = Selection { cases: Selection::DEFAULT_CASES, seed };
    let all = run::cases(&selection, panel::stepper().as_ref());
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: 10, closing: None };
    let sampled = all.into_iter().enumerate().filter(|(place, named)| judges.asks(*place, named));
    sampled.map(|(_, named)| named).collect()
}

fn scaled(history: &mut History, factor: f64) {
    for impact in &mut history.impacts {
        let Uncertainty { time, interval, velocity } = impact.uncertainty;
        impact.uncertainty =
            Uncertainty { time: factor * time, interval: factor * interval, velocity: factor * velocity };
    }
}

#[test]
fn claims_that_are_halved_or_doubled_are_noticed() {
    let oracles: Vec<Remembering> =
        panel::select("closed-form,ode/linear/tsit45").unwrap().into_iter().map(Remembering::new).collect();
    let judge = Remembering::new(panel::judges().swap_remove(0));
    let judges = Judges { oracles: vec![&judge], every: 1, closing: None };
    let cases = sample(1);
    for (change, red) in [
        ((|_, _, _| ()) as fn(&Case, f64, &mut History), false),
        (|_, _, history| scaled(history, 0.5), true),
        (|_, _, history| scaled(history, 2.0), true),
    ] {
        let planted = Planted { honest: &oracles[0], plant: Plant::Answer(change), size: 1.0 };
        let panel: [&dyn Oracle; 2] = [&planted, &oracles[1]];
        let run = run::run(&panel, &judges, &cases, 1, Some(Vec::new()), &());
        let report = Report::new(&run, &panel::roles());
        assert!(report.failures.is_empty(), "no case is wrong by itself");
        let moved = |shortfall: &Shortfall| matches!(shortfall, Shortfall::Recalibrated { oracle, .. } if oracle == "closed-form");
        let found = report.shortfalls.iter().filter(|shortfall| moved(shortfall)).count();
        assert_eq!(found == 3 || found == 4, red, "{:?}", report.shortfalls);
        assert_eq!(report.passes(), !red, "{:?}", report.shortfalls);
    }
}

/// Writes the record: `cargo test --release --test gate -- --ignored the_record_of_the_claims`. The geometric mean over four seeds.
#[test]
#[ignore = "writes data/record/calibration.csv, from four default runs"]
fn the_record_of_the_claims() {
    let oracles = panel::default();
    let oracles: Vec<&dyn Oracle> = oracles.iter().map(AsRef::as_ref).collect();
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: 1, closing: None };
    const SEEDS: [u64; 4] = [1, 2, 3, 4];
    let mut logarithms: BTreeMap<(String, String), f64> = BTreeMap::new();
    for seed in SEEDS {
        let run = run::run(&oracles, &judges, &sample(seed), seed, Some(Vec::new()), &());
        for (oracle, claims) in Report::new(&run, &panel::roles()).judged.claims {
            for (observable, figure) in claims {
                let observable = serde_json::to_value(observable).unwrap().as_str().unwrap().to_owned();
                *logarithms.entry((oracle.clone(), observable)).or_default() += figure.median.ln();
            }
        }
    }
    let mut text = "oracle,observable,recorded\n".to_owned();
    for ((oracle, observable), sum) in logarithms {
        text += &format!("{oracle},{observable},{:.2}\n", (sum / SEEDS.len() as f64).exp());
    }
    std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/data/record/calibration.csv"), text).unwrap();
}
