//! The methods and their settings.

use asymptotic::{Expansion, Resummed};
use contract::{Case, Ending, History, Model, Uncertainty};
use ode::{Equation, Ode, Restart};

use crate::{
    measure::zeno,
    panel,
    studies::{
        atlas::LIFT,
        specimens::{Conclusion, MoreauJean, Rule, Specimen, Threshold, solver_on_one_clock},
    },
};

/// What a method found.
#[derive(Default)]
pub(super) struct Found {
    pub chattering_time: Option<f64>,
    pub impact_40: Option<f64>,
    pub impacts: Option<usize>,
    pub evaluations: Option<u64>,
    /// The proven relative width of the two, from the method whose word is taken for the truth.
    pub width: Option<(f64, f64)>,
    /// How it failed.
    pub outcome: String,
}

/// One setting.
pub(super) struct Contender {
    pub family: String,
    pub setting: String,
    pub run: Box<dyn Fn(&Case) -> Found>,
}

impl Contender {
    fn new(family: impl Into<String>, setting: impl Into<String>, run: impl Fn(&Case) -> Found + 'static) -> Self {
        Self { family: family.into(), setting: setting.into(), run: Box::new(run) }
    }
}

/// How many impacts the closed form lists.
const IMPACTS: [usize; 10] = [10, 20, 30, 40, 60, 80, 120, 160, 240, 400];
/// How many terms the series has.
const TERMS: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];

/// All of them, for a case.
pub(super) fn methods(case: &Case) -> Vec<Contender> {
    let mut methods = Vec::new();
    for impacts in IMPACTS {
        let setting = format!("{impacts} impacts");
        methods.push(Contender::new("closed form, Eq. 75", &setting, move |case| stepped(case, impacts, zeno::eq75)));
        let close = |history: &History, eta| zeno::close(history, eta).map(|time| time.value);
        methods.push(Contender::new("closed form, higher orders", &setting, move |case| stepped(case, impacts, close)));
    }
    methods.extend(thresholds(case));
    methods.extend(series());
    methods.extend(solvers());
    for exponent in 2..=6 {
        let scheme = MoreauJean { step: 10.0_f64.powi(-exponent) };
        methods.push(Contender::new(scheme.family(), scheme.setting(), move |case| time_stepping(&scheme, case)));
    }
    for digits in [2, 4, 6, 8, 10, 12, 14, 16] {
        methods
            .push(Contender::new("enclosure, proven", format!("{digits} digits"), move |case| enclosed(case, digits)));
    }
    methods
}

/// The closed form with so many impacts, its sum closed by `close`.
fn stepped(case: &Case, impacts: usize, close: impl Fn(&History, f64) -> Option<f64>) -> Found {
    let history = case.with_max_impacts(impacts).ok().and_then(|case| panel::stepper().history(&case).ok());
    let Some(history) = history else { return Found::failed("declines") };
    Found {
        chattering_time: close(&history, case.eta()),
        impact_40: history.impacts.get(39).map(|impact| impact.time),
        impacts: Some(history.impacts.len()),
        ..Found::default()
    }
}

/// The thresholds of the atlas: as many impacts as each takes, and the time of the last one.
fn thresholds(case: &Case) -> Vec<Contender> {
    let rules = [Rule::Velocity, Rule::TwoIntervals];
    let all = rules.into_iter().flat_map(|rule| (1..=12).map(move |exponent| (rule, 10.0_f64.powi(-exponent))));
    let method = |(rule, value)| {
        let threshold = Threshold { rule, value };
        let impacts = threshold.run(case)?.impacts.len();
        let last = |history: &History, _| history.impacts.last().map(|last| last.time);
        Some(Contender::new(threshold.family(), threshold.setting(), move |case| stepped(case, impacts, last)))
    };
    all.filter_map(method).collect()
}

/// The series: to the order of the paper, by order and resummed, the coefficients included.
fn series() -> Vec<Contender> {
    let value = |time: Option<f64>| {
        time.map_or_else(|| Found::failed("declines"), |time| Found { chattering_time: Some(time), ..Found::default() })
    };
    let paper = move |case: &Case| {
        value(asymptotic::coefficients(case.eta()).map(|known| known.chattering_time(case.epsilon(), case.omega())))
    };
    let mut methods = vec![Contender::new("series, Eq. 65", "", paper)];
    for terms in TERMS {
        methods.push(Contender::new("series by order", format!("{terms} terms"), move |case| {
            let expansion = Expansion::new(case.omega(), case.eta(), terms, 0).ok();
            value(expansion.map(|expansion| expansion.partial_sum(terms, case.epsilon())))
        }));
    }
    for terms in [32, 64, 96] {
        methods.push(Contender::new("series, resummed", format!("{terms} terms"), move |case| {
            let expansion = Expansion::new(case.omega(), case.eta(), terms, 0).ok();
            let resummed = expansion.and_then(|expansion| Resummed::new(&expansion).ok());
            value(resummed.and_then(|resummed| resummed.chattering_time(case.epsilon())).map(|time| time.value))
        }));
    }
    methods
}

/// diffsol: each method with rescaled flights, and Tsit45 on one clock.
fn solvers() -> Vec<Contender> {
    let mut methods = Vec::new();
    let tolerances = || (3..=12).map(|exponent| 10.0_f64.powi(-exponent));
    for method in ode::Solver::ALL {
        methods.extend(tolerances().filter_map(|rtol| {
            let solver = Ode::new(Equation::Linear, method).with_rtol(rtol).ok()?;
            Some(Contender::new(format!("{method}, rescaled"), format!("rtol {rtol:e}"), move |case| {
                solved(&solver, case)
            }))
        }));
    }
    let restarts = [("zero", Restart::Zero), ("lifted", Restart::Lifted(LIFT)), ("old step", Restart::OldStep)];
    for (name, restart) in restarts {
        methods.extend(tolerances().filter_map(|rtol| {
            let solver = solver_on_one_clock(restart, rtol).ok()?;
            let family = format!("tsit45, one clock, {name}");
            Some(Contender::new(family, format!("rtol {rtol:e}"), move |case| solved(&solver, case)))
        }));
    }
    methods
}

fn solved(solver: &Ode, case: &Case) -> Found {
    let Ok(counted) = solver.counted(case) else { return Found::failed("declines") };
    let mut history = counted.history;
    let wanted = case.max_impacts();
    for impact in &mut history.impacts {
        // The columns are chosen by what they do, as nothing is claimed.
        impact.uncertainty = Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 };
    }
    let is_whole = history.impacts.len() == wanted;
    Found {
        chattering_time: zeno::close(&history, case.eta()).filter(|_| is_whole).map(|time| time.value),
        impact_40: history.impacts.get(39).map(|impact| impact.time),
        impacts: Some(history.impacts.len()),
        evaluations: Some(counted.evaluations),
        outcome: if is_whole { String::new() } else { ended(history.ending, history.impacts.len()) },
        width: None,
    }
}

fn ended(ending: Ending, impacts: usize) -> String {
    format!("{ending}, after {impacts} impacts")
}

fn time_stepping(scheme: &MoreauJean, case: &Case) -> Found {
    let Some(run) = scheme.run(case) else { return Found::failed("declines") };
    let (chattering_time, outcome) = match run.conclusion {
        Conclusion::Rests(time) => (Some(time), String::new()),
        _ => (None, "rocks where the block rests".to_owned()),
    };
    Found {
        chattering_time,
        impact_40: run.impacts.get(39).map(|impact| impact.time),
        evaluations: run.evaluations,
        outcome,
        ..Found::default()
    }
}

fn enclosed(case: &Case, digits: i64) -> Found {
    let judge = enclosure::Enclosure::new(Model::Linear).with_digits(digits).ok();
    let listed = case.with_max_impacts(40).ok();
    let enclosed = judge.zip(listed).and_then(|(judge, case)| judge.enclose(&case).ok());
    let Some(enclosed) = enclosed else { return Found::failed("undecided") };
    let half_width = |bounds: &enclosure::Bounds| 0.5 * bounds.width() / bounds.middle().0;
    let (time, impact) = (enclosed.chattering_time.as_ref(), enclosed.impacts.get(39));
    Found {
        width: time.zip(impact).map(|(time, impact)| (half_width(time), half_width(&impact.time))),
        ..Found::default()
    }
}

impl Found {
    fn failed(why: &str) -> Self {
        Self { outcome: why.to_owned(), ..Self::default() }
    }
}
