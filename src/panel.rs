//! The panel of oracles: the only file that names them all. To add a method, add its crate and a line here.

use asymptotic::Asymptotic;
pub use asymptotic::{
    Alternative, Approach, Coefficients, Expansion, Order, RESUMMED_TERMS, Resummed, approach, coefficients,
    exponent_of_coefficients, ratios, scaled_tail,
};
use closed_form::ClosedForm;
use contract::{Decline, Invalid, Model, Oracle};
pub use enclosure::{Bounds, Critical, Enclosure};
use ode::{Equation, Flights};
pub use ode::{Method, Ode, Restart};
use printed::Printed;
use taylor::Taylor;

use crate::motion::linearisation::Corrected;

/// Oracles that are asked the same cases.
pub type Panel = Vec<Box<dyn Oracle>>;

/// The oracle whose error is to fall with `ε`: the series to the order of the paper.
pub const SERIES: &str = "asymptotic/paper";

/// The order of the series in the default panel: as high as random cases can have it in milliseconds each.
const HIGH_ORDER: Order = Order::Terms(16);

/// The largest share of the cases of a run that an oracle may decline: two thirds for those that do not reach everywhere (the series near `a_cr`,
/// where most of the cases of a run with few random ones are; a correction there; many digits at depth), hardly any for those that are made for every case.
pub fn may_decline(oracle: &str) -> f64 {
    let limited = oracle.starts_with("asymptotic/") || oracle.ends_with("/corrected") || oracle == "printed";
    if limited { 2.0 / 3.0 } else { 0.01 }
}

/// Every oracle that `verify` asks by default.
pub fn default() -> Panel {
    vec![
        Box::new(ClosedForm),
        Box::new(Ode::new(Equation::Linear, Method::Tsit45)),
        Box::new(Ode::new(Equation::Linear, Method::Bdf)),
        Box::new(Ode::new(Equation::Linear, Method::TrBdf2)),
        Box::new(Ode::new(Equation::Linear, Method::Esdirk34)),
        Box::new(Ode::new(Equation::Nonlinear, Method::Tsit45)),
        Box::new(Taylor),
        Box::new(Asymptotic::new()),
        Box::new(series(HIGH_ORDER)),
    ]
}

/// The series to an order that is known to be allowed; to that of the paper otherwise.
fn series(order: Order) -> Asymptotic {
    Asymptotic::new().with_order(order).unwrap_or_default()
}

/// The oracles whose claims are proven, one for each model: they judge the others.
pub fn judges() -> Panel {
    vec![Box::new(Enclosure::new(Model::Linear)), Box::new(Enclosure::new(Model::Nonlinear))]
}

/// Every oracle there is: the default panel, and those that are asked only by name because they judge, are slow, or are known to fail.
pub fn all() -> Panel {
    let mut panel = default();
    panel.extend(judges());
    panel.push(Box::new(series(Order::Resummed)));
    panel.push(Box::new(Printed::default()));
    panel.push(Box::new(corrected()));
    for method in [Method::Bdf, Method::TrBdf2, Method::Esdirk34] {
        panel.push(Box::new(Ode::new(Equation::Nonlinear, method)));
    }
    for equation in [Equation::Linear, Equation::Nonlinear] {
        panel.push(Box::new(Ode::new(equation, Method::Tsit45).with_flights(Flights::Naive)));
    }
    panel
}

/// The oracle that steps fastest and to nearly all digits, for truths of which many are needed.
pub fn stepper() -> Box<dyn Oracle> {
    Box::new(ClosedForm)
}

/// The oracle that steps fastest on an equation of motion: Eq. 4 or Eq. 2.
pub fn stepper_of(model: Model) -> Box<dyn Oracle> {
    match model {
        Model::Linear => stepper(),
        Model::Nonlinear => Box::new(Taylor),
    }
}

/// The linear oracle corrected to first order for the slenderness of the block.
pub fn corrected() -> Corrected {
    Corrected::new(stepper())
}

/// The methods of diffsol.
pub const SOLVERS: [Method; 4] = Method::ALL;

/// diffsol by itself, for what only it can do: the linear equation, by `method` and at the tolerance `rtol`.
///
/// # Errors
/// When the tolerance is not inside [1e-13, 1e-2].
pub fn solver(method: Method, rtol: f64) -> Result<Ode, Invalid> {
    Ode::new(Equation::Linear, method).with_rtol(rtol)
}

/// The same on one clock, by Tsit45, restarted after each impact as named: a specimen.
///
/// # Errors
/// As [`solver`].
pub fn one_clock(restart: Restart, rtol: f64) -> Result<Ode, Invalid> {
    Ok(solver(Method::Tsit45, rtol)?.with_flights(Flights::Naive).with_restart(restart))
}

/// The oracle with many digits by itself, for what only it can do.
pub fn printed() -> Printed {
    Printed::default()
}

/// The oracle with proven bounds by itself, for what only it can do.
pub fn enclosure_of(model: Model) -> Enclosure {
    Enclosure::new(model)
}

/// The same, if `name` is its name; the model is the one that the name or the settings say, or else `equation`.
///
/// # Errors
/// When the model is not known, or settings are given that are for another oracle only.
pub fn enclosure(name: &str, settings: &Settings, equation: &str) -> Result<Option<Enclosure>, Invalid> {
    let named = match name {
        "enclosure" => None,
        "enclosure/linear" => Some("linear"),
        "enclosure/nonlinear" => Some("nonlinear"),
        _ => return Ok(None),
    };
    settings.refuse_all_but(&["model"])?;
    match settings.equation.or(named).unwrap_or(equation) {
        "linear" => Ok(Some(Enclosure::new(Model::Linear))),
        "nonlinear" => Ok(Some(Enclosure::new(Model::Nonlinear))),
        other => Err(Invalid::new("model", other, "linear or nonlinear")),
    }
}

/// The certified critical amplitude of the linear model.
///
/// # Errors
/// When `omega` or `eta` is out of range, or no bracket was found.
pub fn critical_amplitude(omega: f64, eta: f64) -> Result<Critical, Decline> {
    enclosure::critical_amplitude(omega, eta)
}

/// The oracles whose names are in `list`, separated by commas. A name stands for every oracle of the default panel that it begins
/// (`ode` for all of them), or else for every other one that it is or begins (`enclosure` for both).
///
/// # Errors
/// When a name stands for none.
pub fn select(list: &str) -> Result<Panel, Invalid> {
    let mut names: Vec<String> = Vec::new();
    for wanted in list.split(',').map(str::trim) {
        let family = |name: &str| name == wanted || name.starts_with(&format!("{wanted}/"));
        let mut found: Vec<_> = default().iter().map(|o| o.name().to_owned()).filter(|n| family(n)).collect();
        if found.is_empty() {
            found = all().iter().map(|o| o.name().to_owned()).filter(|n| family(n)).collect();
        }
        if found.is_empty() || found.iter().any(|name| names.contains(name)) {
            return Err(Invalid::new(
                "oracles",
                wanted,
                "names from `chattercheck oracles`, each once, separated by commas",
            ));
        }
        names.extend(found);
    }
    Ok(all().into_iter().filter(|oracle| names.iter().any(|name| name == oracle.name())).collect())
}

/// Settings of an oracle in the words of the command line; `None` means its default.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Settings<'a> {
    /// For ode and enclosure: `linear` or `nonlinear`.
    pub equation: Option<&'a str>,
    /// For ode: `tsit45`, `bdf`, `tr-bdf2` or `esdirk34`.
    pub method: Option<&'a str>,
    /// For ode: `rescaled` or `naive`.
    pub flights: Option<&'a str>,
    /// For ode: the relative tolerance.
    pub rtol: Option<f64>,
    /// For asymptotic: `paper`, how many terms, or `resummed`.
    pub order: Option<&'a str>,
    /// For asymptotic: the largest relative error of the chattering time that is accepted.
    pub tolerance: Option<f64>,
}

impl Settings<'_> {
    /// An error if a setting is given that is not one of `used`.
    fn refuse_all_but(&self, used: &[&str]) -> Result<(), Invalid> {
        let Self { equation, method, flights, rtol, order, tolerance } = *self;
        let given = [
            ("model", equation.map(str::to_owned), "only with --oracle ode or enclosure"),
            ("method", method.map(str::to_owned), "only with --oracle ode"),
            ("flights", flights.map(str::to_owned), "only with --oracle ode"),
            ("rtol", rtol.map(|rtol| rtol.to_string()), "only with --oracle ode"),
            ("order", order.map(str::to_owned), "only with --oracle asymptotic"),
            ("tolerance", tolerance.map(|tolerance| tolerance.to_string()), "only with --oracle asymptotic"),
        ];
        let unused = given.into_iter().filter(|(field, ..)| !used.contains(field));
        match unused.filter_map(|(field, value, allowed)| Some((field, value?, allowed))).next() {
            Some((field, value, allowed)) => Err(Invalid::new(field, value, allowed)),
            None => Ok(()),
        }
    }
}

/// One oracle by its name: `closed-form`, `closed-form/corrected`, `ode`, `enclosure`, `asymptotic` (or the full name of one of these), `taylor` or `printed`.
/// `equation` is the one that an oracle for both equations solves if the settings don't say.
///
/// # Errors
/// When a name or a setting is not known, or settings are given to an oracle that has none.
pub fn one(name: &str, settings: &Settings, equation: &str) -> Result<Box<dyn Oracle>, Invalid> {
    // The full name of an ODE oracle says its settings.
    if let Some(of_ode) = name.strip_prefix("ode/") {
        let mut parts = of_ode.split('/');
        let (named_equation, named_method, named_flights) = (parts.next(), parts.next(), parts.next());
        let settings = Settings {
            equation: settings.equation.or(named_equation),
            method: settings.method.or(named_method),
            flights: settings.flights.or(named_flights),
            ..*settings
        };
        return Ok(Box::new(ode(&settings, equation)?));
    }
    if let Some(order) = name.strip_prefix("asymptotic/") {
        let order = order.strip_prefix("order-").unwrap_or(order);
        if let Some(other) = settings.order.filter(|other| *other != order) {
            return Err(Invalid::new(
                "order",
                other,
                "only the one that the name of the oracle says, or --oracle asymptotic",
            ));
        }
        return Ok(Box::new(asymptotic(&Settings { order: Some(order), ..*settings })?));
    }
    if let Some(enclosure) = enclosure(name, settings, equation)? {
        return Ok(Box::new(enclosure));
    }
    let simple: Box<dyn Oracle> = match name {
        "ode" => return Ok(Box::new(ode(settings, equation)?)),
        "asymptotic" => return Ok(Box::new(asymptotic(settings)?)),
        "closed-form" => Box::new(ClosedForm),
        "closed-form/corrected" => Box::new(corrected()),
        "taylor" => Box::new(Taylor),
        "printed" => Box::new(Printed::default()),
        _ => {
            return Err(Invalid::new(
                "oracle",
                name,
                "auto, closed-form, closed-form/corrected, ode, taylor, asymptotic, enclosure or printed",
            ));
        }
    };
    settings.refuse_all_but(&[])?;
    Ok(simple)
}

fn asymptotic(settings: &Settings) -> Result<Asymptotic, Invalid> {
    settings.refuse_all_but(&["order", "tolerance"])?;
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

fn ode(settings: &Settings, equation: &str) -> Result<Ode, Invalid> {
    settings.refuse_all_but(&["model", "method", "flights", "rtol"])?;
    let equation = match settings.equation.unwrap_or(equation) {
        "linear" => Equation::Linear,
        "nonlinear" => Equation::Nonlinear,
        other => return Err(Invalid::new("model", other, "linear or nonlinear")),
    };
    let method = match settings.method.unwrap_or("tsit45") {
        "tsit45" => Method::Tsit45,
        "bdf" => Method::Bdf,
        "tr-bdf2" => Method::TrBdf2,
        "esdirk34" => Method::Esdirk34,
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
