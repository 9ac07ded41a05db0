//! A run with an engine that is right, wrong, breaks, declines, and fails as is known: what the reports that list cases are tested with.

use chattercheck::{
    cases::generate::{Generator, Named},
    gate::{
        judge::Judges,
        known::{Class, Known, Regime},
        outcome::Outcomes,
        report::{Engine, FailedCase, Granted, Report},
        roles::Roles,
        run::{self, Selection},
    },
    measure::observables::Observable,
    panel,
};
use contract::{Case, Decline, History, Model, Oracle};

/// A name that tries to be more than a name, in HTML, XML, Markdown, JavaScript and workflow commands.
pub const HOSTILE: &str = "</script><script>alert(1)</script>\"'&`|]]>::error::%\u{2028}\u{202e}\u{7}";

/// What the engine does with a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Does {
    Right,
    Wrong,
    Breaks,
    Declines,
    FailsAsKnown,
}

/// What it does with the case at this place.
pub fn does(place: usize) -> Does {
    [Does::Right, Does::Wrong, Does::Breaks, Does::Declines, Does::FailsAsKnown][place % 5]
}

struct Mine {
    honest: Box<dyn Oracle>,
    name: String,
    cases: Vec<Case>,
}

impl Oracle for Mine {
    fn name(&self) -> &str {
        &self.name
    }

    fn model(&self) -> Model {
        Model::Linear
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let place = self.cases.iter().position(|known| known == case).unwrap();
        let mut history = self.honest.history(case)?;
        match does(place) {
            Does::Right => {}
            Does::Wrong => history.impacts.iter_mut().for_each(|impact| impact.velocity *= 1.001),
            Does::FailsAsKnown => history.impacts.iter_mut().for_each(|impact| impact.interval *= 1.001),
            Does::Declines => return Err(Decline::ByEngine { reason: "on holiday".to_owned(), why: String::new() }),
            Does::Breaks => {
                let happened = format!("it said {HOSTILE}");
                return Err(Decline::NoAnswer { breakdown: "crashed", happened, advice: "mend it".to_owned() });
            }
        }
        Ok(history)
    }
}

/// What came out of the run.
pub struct Mixed {
    pub report: Report,
    pub cases: Vec<Named>,
    pub outcomes: Outcomes,
}

/// Ten cases of the closed form and an engine of this name.
pub fn mixed(name: &str) -> Mixed {
    let stepper = panel::stepper();
    let all = run::cases(&Selection { cases: 0, seed: 1 }, stepper.as_ref());
    let rocks = |named: &&Named| stepper.history(&named.case).is_ok_and(|history| history.impacts.len() > 5);
    let mut cases: Vec<Named> = all.iter().filter(rocks).take(10).cloned().collect();
    cases.dedup_by_key(|named| named.case);
    assert_eq!(cases.len(), 10);
    let mine =
        Mine { honest: panel::stepper(), name: name.to_owned(), cases: cases.iter().map(|named| named.case).collect() };
    let judges = panel::judges();
    let judges = Judges { oracles: judges.iter().map(AsRef::as_ref).collect(), every: 1, closing: None };
    let known = Known {
        oracle: name.to_owned(),
        class: Class::Observable(Observable::Interval),
        regime: Regime::default(),
        reason: "the step is too long".to_owned(),
        link: None,
        within: 20,
        entry: "engines.toml, line 8".to_owned(),
    };
    let laws = Known { class: Class::named("time-is-sum", |_| false).unwrap(), ..known.clone() };
    let run = run::run(&[stepper.as_ref(), &mine], &judges, &cases, 1, None, &()).excused(&[known, laws], &cases);
    let granted = Granted { time: 1e-9, interval: 1e-9, velocity: 1e-9, tau_ch: 1e-9, reason: HOSTILE.to_owned() };
    let engine = Engine {
        name: name.to_owned(),
        says: format!("{HOSTILE} 1.0"),
        receipt: "1.0".to_owned(),
        claims: false,
        granted,
    };
    let roles = Roles { may_decline: &|_| 1.0, ..panel::roles() };
    let report = Report::new(&run, &roles).with_engines(vec![engine], &run);
    Mixed { report, cases, outcomes: run.outcomes }
}

impl Mixed {
    /// The same report on so many random cases of which so many failed: what one of these ten did, changed by `as_failed` for each.
    pub fn many(mut self, cases: usize, failed: usize, as_failed: impl Fn(usize, FailedCase) -> FailedCase) -> Self {
        let wrong = self.report.failures.iter().find(|failure| !failure.is_breakdown()).unwrap().clone();
        let case = self.cases[0].case;
        let random = |n: usize| Named { generator: Generator::Random, name: n.to_string(), case };
        self.cases = (0..cases).map(random).collect();
        self.report.failures = (0..failed).map(|n| as_failed(n, wrong.clone())).collect();
        self
    }
}
