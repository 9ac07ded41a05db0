//! The panel: one table of the methods, a row a method. To add one, add its crate, and a row here.
//!
//! The harness meets a method through its row: its name, how it is made, what it solves, how much it may decline and what it is good for besides
//! being compared. Only this file and the studies name the crates of the oracles.

mod lookup;
mod proven_bouts;
mod settings;
#[cfg(test)]
mod tests;

use accumulation::Accumulation;
use asymptotic::{Asymptotic, Order};
use closed_form::ClosedForm;
use contract::{Case, Decline, History, Invalid, Model, Oracle};
use enclosure::Enclosure;
use ode::{Equation, Flights, Ode};
use printed::Printed;
use taylor::Taylor;

use crate::{
    gate::roles::Roles,
    measure::critical,
    motion::{closed::Closed, linearisation::Corrected},
};

pub use lookup::{
    all, beside, default, judges, may_decline, method, methods, model_named, model_of, one, select, stepper_on,
    with_role,
};
pub use proven_bouts::{ProvenBout, ProvenResponse, ProvenTime, proven_bouts};
pub use settings::{Refused, Setting, Settings};

/// Oracles that are asked the same cases.
pub type Panel = Vec<Box<dyn Oracle>>;

/// What an oracle is good for besides being compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// It steps fastest on its equation and to nearly all digits: truths of which many are needed.
    Stepper,
    /// Its claims are proven: it judges the others.
    Judge,
    /// It knows how its impacts answer to small changes of the parameters.
    Sensitivities,
    /// It knows how its impacts move when the block is less slender.
    SlendernessShifts,
    /// It sums to infinity itself: its chattering time does not depend on how many impacts are listed.
    OwnSum,
}

/// A method: a row of the table.
pub struct Method {
    /// Its name, or what the names of its oracles begin with.
    pub name: &'static str,
    /// The equations that it solves.
    pub models: &'static [Model],
    /// The settings that the rest of an oracle's name says, in order: `ode/linear/bdf`.
    pub in_name: &'static [Setting],
    /// The other settings that it uses.
    pub beside: &'static [Setting],
    /// The names of its oracles that `verify` asks by default.
    pub by_default: &'static [&'static str],
    /// The names of those that are asked by name only, because they judge, are slow, or are known to fail.
    pub by_name: &'static [&'static str],
    /// The largest share of the cases of a run that it may decline.
    pub may_decline: f64,
    /// What its oracles are good for besides being compared.
    pub roles: &'static [Role],
    /// Which of its oracles follow whole responses in the gate.
    pub responses: &'static [Follows],
    /// How an oracle is made from settings, of which the model is known.
    make: Make,
}

/// An oracle that follows whole responses in the gate.
pub struct Follows {
    /// The name of the oracle.
    pub oracle: &'static str,
    /// The equation that its responses are held against. A method for Eq. 2 alone is asked for a block as good as slender too, so that each equation
    /// has two methods beside the general solver or more.
    pub model: Model,
    /// What its flights are worth.
    pub accuracy: f64,
    /// Whether it is asked for wavelets, which have no closed form.
    pub wavelets: bool,
    /// Whether the table of its response is looked at as well; once for each equation is enough.
    pub table: bool,
}

/// How an oracle is made.
type Make = fn(&Settings, Model) -> Result<Box<dyn Oracle>, Invalid>;

/// The oracle whose error is to fall with `ε`: the series to the order of the paper.
pub const SERIES: &str = "asymptotic/paper";

/// What the gate is told of the panel.
pub fn roles() -> Roles<'static> {
    Roles {
        series: SERIES,
        may_decline: &may_decline,
        granted: &|_| false,
        never_rests: &|_| false,
        shown_by: &shown_by,
    }
}

/// The command that shows the history of an oracle for a case that is given by flags.
pub fn shown_by(oracle: &str, flags: &str) -> String {
    format!("chattercheck simulate {flags} --oracle {oracle}")
}

/// What is made for every case declines hardly any.
const HARDLY_ANY: f64 = 0.01;
/// What does not reach everywhere (the series and a correction near `a_cr`, where most of the cases of a run with few random ones are; many digits at depth).
const MOST: f64 = 2.0 / 3.0;

const LINEAR: &[Model] = &[Model::Linear];
const NONLINEAR: &[Model] = &[Model::Nonlinear];
const BOTH: &[Model] = &[Model::Linear, Model::Nonlinear];

/// The table. Where no method is named, the first one that uses everything that was given is asked.
const TABLE: [Method; 8] = [
    Method {
        name: "closed-form",
        models: LINEAR,
        in_name: &[],
        beside: &[],
        by_default: &["closed-form"],
        by_name: &[],
        may_decline: HARDLY_ANY,
        roles: &[Role::Stepper, Role::Sensitivities, Role::SlendernessShifts],
        responses: &[Follows {
            oracle: "closed-form",
            model: Model::Linear,
            accuracy: 1e-13,
            table: true,
            wavelets: false,
        }],
        make: |_, _| Ok(Box::new(ClosedForm)),
    },
    Method {
        name: "ode",
        models: BOTH,
        in_name: &[Setting::Model, Setting::Method, Setting::Flights],
        beside: &[Setting::Rtol],
        by_default: &[
            "ode/linear/tsit45",
            "ode/linear/bdf",
            "ode/linear/tr-bdf2",
            "ode/linear/esdirk34",
            "ode/nonlinear/tsit45",
        ],
        by_name: &[
            "ode/nonlinear/bdf",
            "ode/nonlinear/tr-bdf2",
            "ode/nonlinear/esdirk34",
            "ode/linear/tsit45/naive",
            "ode/nonlinear/tsit45/naive",
        ],
        may_decline: HARDLY_ANY,
        roles: &[],
        responses: &[
            Follows {
                oracle: "ode/linear/tsit45",
                model: Model::Linear,
                accuracy: 4e-11,
                table: false,
                wavelets: true,
            },
            Follows {
                oracle: "ode/nonlinear/tsit45",
                model: Model::Nonlinear,
                accuracy: 4e-11,
                table: false,
                wavelets: true,
            },
        ],
        make: |settings, model| Ok(Box::new(ode(settings, model)?)),
    },
    Method {
        name: "taylor",
        models: NONLINEAR,
        in_name: &[],
        beside: &[],
        by_default: &["taylor"],
        by_name: &[],
        may_decline: HARDLY_ANY,
        roles: &[Role::Stepper],
        responses: &[
            Follows { oracle: "taylor", model: Model::Linear, accuracy: 4e-12, table: false, wavelets: true },
            Follows { oracle: "taylor", model: Model::Nonlinear, accuracy: 1e-13, table: true, wavelets: true },
        ],
        make: |_, _| Ok(Box::new(Taylor)),
    },
    Method {
        name: "asymptotic",
        models: LINEAR,
        in_name: &[Setting::Order],
        beside: &[Setting::Tolerance],
        by_default: &[SERIES, "asymptotic/order-16"],
        by_name: &["asymptotic/resummed"],
        may_decline: MOST,
        roles: &[Role::OwnSum],
        responses: &[],
        make: |settings, _| Ok(Box::new(asymptotic(settings)?)),
    },
    Method {
        name: "enclosure",
        models: BOTH,
        in_name: &[Setting::Model],
        beside: &[Setting::Digits],
        by_default: &[],
        by_name: &["enclosure/linear", "enclosure/nonlinear"],
        may_decline: HARDLY_ANY,
        roles: &[Role::Judge, Role::OwnSum],
        responses: &[],
        make: |settings, model| Ok(Box::new(enclosure(settings, model)?)),
    },
    Method {
        name: "printed",
        models: LINEAR,
        in_name: &[],
        beside: &[],
        by_default: &[],
        by_name: &["printed"],
        may_decline: MOST,
        roles: &[],
        responses: &[],
        make: |_, _| Ok(Box::new(Printed::default())),
    },
    Method {
        name: "accumulation",
        models: BOTH,
        in_name: &[Setting::Model, Setting::Order],
        beside: &[],
        by_default: &[],
        by_name: &["accumulation/linear", "accumulation/nonlinear"],
        may_decline: MOST,
        roles: &[],
        responses: &[],
        make: |settings, model| Ok(Box::new(closed(settings, model)?)),
    },
    Method {
        name: "closed-form/corrected",
        models: NONLINEAR,
        in_name: &[],
        beside: &[],
        by_default: &[],
        by_name: &["closed-form/corrected"],
        may_decline: MOST,
        roles: &[],
        responses: &[],
        make: |_, _| Ok(Box::new(Corrected::new(stepper()))),
    },
];

/// What closes a sequence from any one of its impacts.
pub fn closing() -> Box<dyn Oracle> {
    Box::new(Accumulation::default())
}

/// What foretells when a block comes to rest that any motion of the ground sets rocking weakly, without following an impact.
pub fn foretelling() -> Option<Box<dyn Oracle>> {
    one(FORETELLS, &Settings { tolerance: Some(FORETOLD), ..Settings::default() }, "linear").ok()
}

/// The weak law, to a number of terms at which it claims much and takes a millisecond.
const FORETELLS: &str = "asymptotic/order-8";
/// What error it may claim, relative to how long the block rocks: the gate takes a wider claim on a rest for none.
const FORETOLD: f64 = 5e-4;

/// The oracle that steps fastest on the linear equation and to nearly all digits.
pub fn stepper() -> Box<dyn Oracle> {
    stepper_of(Model::Linear)
}

/// The oracle that steps fastest on an equation of motion: Eq. 4 or Eq. 2.
pub fn stepper_of(model: Model) -> Box<dyn Oracle> {
    let stepper = with_role(Role::Stepper).into_iter().find(|oracle| oracle.model() == model);
    // The table has one for each equation: a test holds it to that.
    stepper.unwrap_or_else(|| Box::new(ClosedForm))
}

/// The impacts of the stepper, closed by the local series.
fn closed(settings: &Settings, model: Model) -> Result<Closed, Invalid> {
    let name = if model == Model::Linear { "accumulation/linear" } else { "accumulation/nonlinear" };
    let order = settings.order.map_or(String::new(), |order| format!("/order-{order}"));
    Ok(Closed::new(name.to_owned() + &order, stepper_of(model), Box::new(accumulation(settings)?)))
}

fn accumulation(settings: &Settings) -> Result<Accumulation, Invalid> {
    let Some(order) = settings.order else { return Ok(Accumulation::default()) };
    let terms = order.parse().map_err(|_| Invalid::new("order", order, "1 to 16 for accumulation"))?;
    Accumulation::default().with_order(terms)
}

/// The judge of an equation of motion.
pub fn judge_of(model: Model) -> Option<Box<dyn Oracle>> {
    with_role(Role::Judge).into_iter().find(|oracle| oracle.model() == model)
}

fn asymptotic(settings: &Settings) -> Result<Asymptotic, Invalid> {
    let order = match settings.order.unwrap_or("paper") {
        "paper" => Order::Paper,
        "resummed" => Order::Resummed,
        terms => Order::Terms(
            terms
                .parse()
                .map_err(|_| Invalid::new("order", terms, "paper, resummed, or a number of terms, 1 to 92"))?,
        ),
    };
    let asymptotic = Asymptotic::new().with_order(order)?;
    settings.tolerance.map_or(Ok(asymptotic.clone()), |tolerance| asymptotic.with_tolerance(tolerance))
}

fn ode(settings: &Settings, model: Model) -> Result<Ode, Invalid> {
    let equation = match model {
        Model::Linear => Equation::Linear,
        Model::Nonlinear => Equation::Nonlinear,
    };
    let method = match settings.method.unwrap_or("tsit45") {
        "tsit45" => ode::Solver::Tsit45,
        "bdf" => ode::Solver::Bdf,
        "tr-bdf2" => ode::Solver::TrBdf2,
        "esdirk34" => ode::Solver::Esdirk34,
        other => return Err(Invalid::new("method", other, "tsit45, bdf, tr-bdf2 or esdirk34")),
    };
    let flights = match settings.flights.unwrap_or("rescaled") {
        "rescaled" => Flights::Rescaled,
        "naive" => Flights::Naive,
        other => return Err(Invalid::new("flights", other, "rescaled or naive")),
    };
    let ode = Ode::new(equation, method).with_flights(flights);
    settings.rtol.map_or(Ok(ode.clone()), |rtol| ode.with_rtol(rtol))
}

fn enclosure(settings: &Settings, model: Model) -> Result<Enclosure, Invalid> {
    let enclosure = Enclosure::new(model);
    settings.digits.map_or(Ok(enclosure), |digits| enclosure.with_digits(digits))
}

/// What is proven of a case.
pub struct Proven {
    /// The name of the oracle that proved it.
    pub oracle: String,
    /// The middles of the bounds.
    pub history: History,
    /// Bounds on the chattering time with the digits that were asked for, rounded outward; `None` where there is none.
    pub chattering_time: Option<[String; 2]>,
    /// Whether those bounds are wider than asked, because narrower ones take too long.
    pub wider_than_asked: bool,
}

/// Proven bounds on the chattering time of a case, if the judge is the method that `name` names.
///
/// # Errors
/// When the judge does not use one of the settings, or declines the case.
pub fn proven(name: &str, settings: &Settings, case: &Case) -> Result<Option<Result<Proven, Decline>>, Refused> {
    let Some((method, settings, model)) = lookup::resolve(name, settings, lookup::model_of(case))? else {
        return Ok(None);
    };
    if !method.roles.contains(&Role::Judge) {
        return Ok(None);
    }
    let enclosure = enclosure(&settings, model)?;
    Ok(Some(enclosure.enclose(case).map(|enclosed| {
        let digits = enclosure.digits();
        let wanted = |upper: f64| 10.0_f64.powi(1 - digits as i32) * upper;
        Proven {
            oracle: enclosure.name().to_owned(),
            history: enclosed.history(),
            wider_than_asked: enclosed.chattering_time.as_ref().is_some_and(|time| time.width() > wanted(time.upper())),
            chattering_time: enclosed.chattering_time.map(|time| time.decimals(time.places(digits))),
        }
    })))
}

/// The critical amplitude of the linear model, proven.
pub struct CriticalAmplitude {
    /// `a_cr`: the middle of the bounds.
    pub a_cr: f64,
    /// An amplitude whose chattering is proven to be complete, rounded down.
    pub complete_at: String,
    /// One whose chattering is proven to be incomplete, rounded up.
    pub incomplete_at: String,
    /// `β` of the approach `1 - τ_ch/(T/2) ~ K (a_cr - a)^β`.
    pub exponent: f64,
}

/// The critical amplitude of the linear model, with bounds of so many digits after the decimal point.
///
/// # Errors
/// When `omega` or `eta` is out of range, or no bracket was found.
pub fn critical_amplitude(omega: f64, eta: f64, digits: u32) -> Result<CriticalAmplitude, Decline> {
    let critical = match critical::interpolated(omega, eta) {
        Ok(epsilon) => enclosure::critical_amplitude_near(omega, eta, epsilon)?,
        Err(_) => enclosure::critical_amplitude(omega, eta)?,
    };
    let [complete_at, incomplete_at] = critical.amplitude.decimals(digits);
    let a_cr = critical.amplitude.middle().0;
    Ok(CriticalAmplitude { a_cr, complete_at, incomplete_at, exponent: critical.exponent })
}

/// `β` of the approach `1 - τ_ch/(T/2) ~ K (a_cr - a)^β` to the critical amplitude, for `eta` inside (0, 1).
pub fn approach_exponent(eta: f64) -> f64 {
    asymptotic::approach(eta).exponent
}
