//! The gate on whole responses: what it reaches, and that it notices what is wrong with them.

use chattercheck::{
    gate::{
        partition::{Partition, cost_of_response},
        responses::{self, Example, Report, Responder, Selection, Shortfall, Whole},
        verdict::Verdict,
    },
    panel, responders,
};
use contract::{Case, Model, Normalisation, Slenderness};

use crate::effort::pick;

fn run(responders: &[&dyn Responder], request: &Selection) -> (Report, Vec<responses::Failure>) {
    responses::run(responders, &responses::questions(request), &())
}

fn request(responses: usize) -> Selection {
    Selection { responses, seed: 1 }
}

/// A method that declines everything: what is left is the plain follower.
struct Nobody(Model);

impl Responder for Nobody {
    fn name(&self) -> &str {
        "nobody"
    }

    fn model(&self) -> Model {
        self.0
    }

    fn accuracy(&self) -> f64 {
        1e-13
    }

    fn respond(&self, _: &chattercheck::cases::shaking::Question, _: usize) -> Option<Whole> {
        None
    }
}

/// Every kind of response comes often enough, under both equations, and few are too close to call.
#[test]
fn random_responses_reach_every_regime() {
    for model in [Model::Linear, Model::Nonlinear] {
        let (report, _) = run(&[&Nobody(model)], &request(Selection::DEFAULT));
        assert_eq!((report.tally.responses, report.tally.methods["nobody"].answered), (Selection::DEFAULT, 0));
        for reach in Example::ALL {
            let found = report.tally.reach.get(&reach).copied().unwrap_or_default();
            assert!(found >= 3, "{model:?}: {found} responses: {}", reach.name());
        }
        assert!(
            report.tally.too_close <= Selection::DEFAULT / 20,
            "{model:?}: {} too close to call",
            report.tally.too_close
        );
        let all = Shortfall::Declined { method: "nobody".into(), declined: 200, asked: 200 };
        let nothing = Shortfall::NoImpact { method: "nobody".into() };
        // A block without a slenderness is not asked of the nonlinear model.
        let is_declined = |one: &Shortfall| {
            *one == all || matches!(one, Shortfall::Declined { declined, asked, .. } if declined == asked)
        };
        assert!(report.shortfalls.iter().any(is_declined) && report.shortfalls.contains(&nothing), "{report:?}");
    }
}

/// The same seed gives the same responses, and the shares of a run are the run.
#[test]
fn the_shares_of_a_run_are_the_run() {
    let all = responses::questions(&request(50));
    let costs: Vec<f64> = all.iter().map(|(_, question)| cost_of_response(question)).collect();
    let share = |part| Partition { part, parts: 3 }.of(all.clone(), &costs);
    let mut shares: Vec<_> = (1..=3).flat_map(share).collect();
    shares.sort_by_key(|(name, _)| all.iter().position(|(other, _)| other == name));
    assert_eq!(all, shares);
    assert_ne!(all[0].1, responses::questions(&Selection { seed: 2, ..request(1) })[0].1);
}

/// A method that has flights and is not verified would be trusted for nothing.
#[test]
fn every_method_with_flights_is_asked_for_whole_responses() {
    let slenderness = Slenderness::new(0.2, Normalisation::Threshold).unwrap();
    let case = Case::from_amplitude(1.03, 2.0, 0.9).unwrap().with_slenderness(slenderness);
    let asked = responders::all();
    for oracle in panel::default().iter().filter(|oracle| oracle.flights(&case).is_ok()) {
        let method = panel::method(oracle.name()).unwrap();
        let same = |one: &&responders::Stepped| {
            panel::method(one.oracle.name()).unwrap().name == method.name && one.oracle.model() == oracle.model()
        };
        assert!(asked.iter().any(|one| same(&one)), "{} is not asked", oracle.name());
    }
}

/// The methods agree with the plain follower on all of them, and come near what they are allowed.
#[test]
fn whole_responses_agree_with_a_plain_follower() {
    let all = responders::all();
    let all: Vec<&dyn Responder> = all.iter().map(|one| one as &dyn Responder).collect();
    let (report, failures) = run(&all, &request(pick("responses", Selection::DEFAULT, 5000)));
    assert!(report.verdict() == Verdict::Pass && failures.is_empty(), "{}", responses::failures_text(&report));
}
