//! Each rule that every oracle has to keep: an oracle that keeps all of them, and for each rule one that breaks it and no other.

use std::sync::atomic::{AtomicUsize, Ordering};

use contract::{
    Case, Decline, Ending, History, Horizon, Impact, Limit, Model, Oracle, Sensitivity, Uncertainty,
    conformance::{Rule, check},
};

/// What is wrong with the oracle.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Flaw {
    None,
    Name,
    TooMany,
    RestWithoutImpacts,
    NoLimit,
    Claim,
    Interval,
    Sign,
    Sum,
    Changes,
    DependsOnLimit,
    Late,
    Slenderness,
    BelowThreshold,
    Sensitivities,
}

/// Not a block, but a ball of which each flight is half as long as the one before: the contract knows no physics.
struct Ball {
    flaw: Flaw,
    model: Model,
    asked: AtomicUsize,
}

impl Ball {
    fn new(flaw: Flaw, model: Model) -> Self {
        Self { flaw, model, asked: AtomicUsize::new(0) }
    }
}

impl Oracle for Ball {
    fn name(&self) -> &str {
        if self.flaw == Flaw::Name { "a, b" } else { "ball" }
    }

    fn model(&self) -> Model {
        self.model
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let is = |flaw| self.flaw == flaw;
        if self.model == Model::Nonlinear && case.slenderness().is_none() && !is(Flaw::Slenderness) {
            return Err(Decline::NeedsSlenderness);
        }
        if case.epsilon() <= 0.0 && !is(Flaw::BelowThreshold) {
            return Ok(History { impacts: Vec::new(), ending: Ending::NeverRocks, chattering_time: None });
        }
        let until = match case.horizon() {
            Horizon::Until(until) if !is(Flaw::Late) => until,
            Horizon::Until(_) | Horizon::HalfPeriod => f64::INFINITY,
        };
        let asked = self.asked.fetch_add(1, Ordering::Relaxed);
        let uncertainty = Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
        let (mut impacts, mut time, mut interval, mut velocity) = (Vec::new(), 0.0, 1.0, 1.0);
        if is(Flaw::Changes) {
            interval += asked as f64 * f64::EPSILON;
        }
        if is(Flaw::DependsOnLimit) {
            interval += case.max_impacts() as f64 / 1024.0;
        }
        if is(Flaw::Slenderness) && case.slenderness().is_some() {
            velocity = 0.5;
        }
        let mut ending = Ending::LimitReached(Limit::Impacts);
        while impacts.len() < case.max_impacts() + usize::from(is(Flaw::TooMany)) {
            if time + interval > until {
                ending = Ending::LimitReached(Limit::Time);
                break;
            }
            time += interval;
            impacts.push(Impact { time, interval, velocity, uncertainty });
            (interval, velocity) = (interval / 2.0, -velocity / 2.0);
        }
        if let Some(third) = impacts.get_mut(2) {
            match self.flaw {
                Flaw::Claim => third.uncertainty.velocity = f64::NAN,
                Flaw::Interval => third.interval = 0.0,
                Flaw::Sign => third.velocity = -third.velocity,
                Flaw::Sum => third.time += 1e-14,
                _ => {}
            }
        }
        if is(Flaw::NoLimit) {
            impacts.pop();
        }
        if is(Flaw::RestWithoutImpacts) {
            (ending, impacts) = (Ending::AtRest, Vec::new());
        }
        Ok(History { impacts, ending, chattering_time: None })
    }

    fn sensitivities(&self, case: &Case) -> Option<Vec<Sensitivity>> {
        let listed = self.history(case).ok()?.impacts.len() + usize::from(self.flaw == Flaw::Sensitivities);
        Some(vec![Sensitivity { time: [0.0; 3], interval: [0.0; 3], velocity: [0.0; 3] }; listed])
    }
}

fn broken(flaw: Flaw, model: Model) -> Vec<Rule> {
    let case = Case::from_epsilon(0.25, 2.0, 0.5).unwrap().with_max_impacts(8).unwrap();
    let mut rules: Vec<Rule> =
        check(&Ball::new(flaw, model), &[case]).err().into_iter().flatten().map(|(_, breach)| breach.rule).collect();
    rules.dedup();
    rules
}

#[test]
fn an_oracle_that_keeps_every_rule_is_found_to() {
    for model in [Model::Linear, Model::Nonlinear] {
        assert_eq!(broken(Flaw::None, model), []);
    }
}

#[test]
fn each_rule_is_broken_by_what_breaks_it_and_nothing_else() {
    for (flaw, rule) in [
        (Flaw::Name, Rule::Name),
        (Flaw::TooMany, Rule::Form),
        (Flaw::RestWithoutImpacts, Rule::Form),
        (Flaw::NoLimit, Rule::Form),
        (Flaw::Claim, Rule::Form),
        (Flaw::Interval, Rule::Form),
        (Flaw::Sign, Rule::SignAlternates),
        (Flaw::Sum, Rule::TimeIsSum),
        (Flaw::Changes, Rule::SameAgain),
        (Flaw::DependsOnLimit, Rule::FewerAreFirst),
        (Flaw::Late, Rule::Horizon),
        (Flaw::Slenderness, Rule::Slenderness),
        (Flaw::BelowThreshold, Rule::Threshold),
        (Flaw::Sensitivities, Rule::Derivatives),
    ] {
        let found = broken(flaw, Model::Linear);
        assert!(found.contains(&rule), "{flaw:?} breaks {rule:?}, found {found:?}");
        assert!(
            found.iter().all(|other| *other == rule || flaw == Flaw::Changes),
            "{flaw:?} breaks only {rule:?}: {found:?}"
        );
    }
    assert_eq!(broken(Flaw::Slenderness, Model::Nonlinear), [Rule::Slenderness]);
}

/// What is found says what and where, with the numbers.
#[test]
fn a_breach_is_told_in_words() {
    let case = Case::from_epsilon(0.25, 2.0, 0.5).unwrap().with_max_impacts(8).unwrap();
    let found = check(&Ball::new(Flaw::Sign, Model::Linear), &[case]).unwrap_err();
    assert_eq!(found[0].0, case);
    assert_eq!(found[0].1.to_string(), "SignAlternates at impact 3: velocity -0.25, expected sign +1");
}
