//! The law of what is left: what the local series says after single impacts, against every history that ends with rest.

use accumulation::{Accumulation, Series};
use chattercheck::{
    cases::generate::Named,
    gate::{
        finding::Finding,
        judge::Judges,
        laws::Law,
        report::Report,
        run::{self, Run},
    },
    panel,
};
use contract::{
    Body, Case, Closure, Decline, Departure, Estimate, History, Model, Motion, Normalisation, Oracle, Slenderness,
};

/// The series with a mistake of this share in its second term.
struct Planted(f64);

struct Wrong {
    series: Series,
    share: f64,
}

impl Oracle for Planted {
    fn name(&self) -> &str {
        "planted"
    }

    fn model(&self) -> Model {
        Model::Linear
    }

    fn history(&self, _: &Case) -> Result<History, Decline> {
        Err(Decline::Unsupported { what: "impacts" })
    }

    fn closure_on(&self, body: &Body, motion: &Motion) -> Result<Box<dyn Closure>, Decline> {
        Ok(Box::new(Wrong { series: Accumulation::default().series(body, motion), share: self.0 }))
    }
}

impl Closure for Wrong {
    fn time_left(&self, departure: &Departure) -> Result<Estimate, Decline> {
        let left = self.series.time_left(departure)?;
        let second = self.series.terms(departure)?.as_slice()[1];
        Ok(Estimate { value: left.value + self.share * second, ..left })
    }
}

fn cases() -> Vec<Named> {
    let of = |epsilon: f64, omega, eta| Case::from_epsilon(epsilon, omega, eta).unwrap().with_max_impacts(200).unwrap();
    let stocky = |case: Case| case.with_slenderness(Slenderness::new(0.2, Normalisation::Threshold).unwrap());
    let cases = [
        of(0.03, 2.0, 0.92),
        of(0.01, 0.7, 0.6),
        of(1e-4, 4.0, 0.8),
        of(1e-10, 1.0, 0.5),
        of(0.3, 0.5, 0.3),
        stocky(of(0.02, 2.0, 0.9)),
        stocky(of(1e-3, 3.0, 0.7)),
    ];
    cases.iter().enumerate().map(|(place, case)| Named::parse(&format!("list/left-{place}"), *case)).collect()
}

fn run(closing: &dyn Oracle) -> Run {
    let panel = panel::select("closed-form,ode/linear/tsit45,taylor,asymptotic").unwrap();
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let judges = Judges { oracles: Vec::new(), every: 1, closing: Some(closing) };
    run::run(&panel, &judges, &cases(), 1, None, &())
}

/// Of each failed case, the methods of which it is said that what is left is wrong.
fn told(run: &Run) -> Vec<String> {
    let of_law = |finding: &Finding| match finding {
        Finding::Law { oracle, breach } if breach.law == Law::TimeLeft => Some(oracle.clone()),
        _ => None,
    };
    run.failures.iter().flat_map(|failure| failure.findings.iter().filter_map(of_law)).collect()
}

/// It holds for all methods, on both equations, and what is allowed is used: more than a hundredth, less than all.
#[test]
fn what_is_left_is_what_every_method_says() {
    let run = run(panel::closing().as_ref());
    assert_eq!(told(&run), Vec::<String>::new(), "{:?}", run.failures);
    let report = Report::new(&run, &panel::roles());
    let figures = &report.time_left;
    for method in ["closed-form", "ode/linear/tsit45", "taylor", "asymptotic/order-16"] {
        let share = figures[method].share;
        assert!(share > 1e-3 && share <= 1.0, "{method}: {share}");
    }
}

/// A mistake in the second coefficient is told of every method with claims that are narrow enough.
#[test]
fn a_mistake_of_a_millionth_in_the_second_coefficient_is_noticed() {
    let told = told(&run(&Planted(1e-6)));
    for method in ["closed-form", "ode/linear/tsit45", "taylor"] {
        assert!(told.iter().any(|name| name == method), "{method}: {told:?}");
    }
}
