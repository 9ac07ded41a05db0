//! Looking methods up in the table: by name, by role, by what they use.

use contract::{Body, Case, Invalid, Model, Motion, Oracle};

use super::{Method, Panel, Refused, Role, Setting, Settings, TABLE};

/// The rows of the table.
pub fn methods() -> impl Iterator<Item = &'static Method> {
    TABLE.iter()
}

/// The method that the name of an oracle stands for, or begins with; the longest such name.
pub fn method(name: &str) -> Option<&'static Method> {
    let is_of = |method: &&Method| name == method.name || !method.in_name.is_empty() && rest(name, method).is_some();
    methods().filter(is_of).max_by_key(|method| method.name.len())
}

/// What the name of an oracle says after that of its method.
fn rest<'a>(name: &'a str, method: &Method) -> Option<&'a str> {
    name.strip_prefix(method.name)?.strip_prefix('/')
}

/// The largest share of the cases of a run that an oracle may decline; none that is not in the table.
pub fn may_decline(oracle: &str) -> f64 {
    method(oracle).map_or(0.0, |method| method.may_decline)
}

/// The oracles of the panel with one of these names.
fn panel(names: impl Iterator<Item = &'static str>) -> Panel {
    // What the table names can be made: a test holds it to that.
    names.filter_map(|name| one(name, &Settings::default(), "linear").ok()).collect()
}

/// Every oracle that `verify` asks by default.
pub fn default() -> Panel {
    panel(methods().flat_map(|method| method.by_default).copied())
}

/// Every oracle there is: the default panel, and those that are asked by name only.
pub fn all() -> Panel {
    panel(methods().flat_map(|method| method.by_default).chain(methods().flat_map(|method| method.by_name)).copied())
}

/// The oracles that have a role, in the order of the table.
pub fn with_role(role: Role) -> Panel {
    let with_role = methods().filter(move |method| method.roles.contains(&role));
    panel(with_role.flat_map(|method| method.by_default.iter().chain(method.by_name)).copied())
}

/// What is asked beside simulators of somebody else that solve these equations: they are what is in question, so one oracle for each equation, that which steps
/// fastest and to nearly all digits. The linear one is always there: the conditioning of the cases comes from it.
pub fn beside(models: &[Model]) -> Panel {
    let mut panel = with_role(Role::Stepper);
    panel.retain(|oracle| oracle.model() == Model::Linear || models.contains(&oracle.model()));
    panel
}

/// The oracle that steps fastest on this motion of the ground, on the nonlinear equation for a block with a slenderness and on the linear one for one without;
/// where none does the motion, the one that would be asked first.
pub fn stepper_on(body: &Body, motion: &Motion) -> Box<dyn Oracle> {
    let model = if body.alpha().is_some() { Model::Nonlinear } else { Model::Linear };
    // One for the nonlinear equation does the linear one too.
    let does = |oracle: &dyn Oracle| {
        (oracle.model() == model || model == Model::Linear) && oracle.flights_on(body, motion).is_ok()
    };
    let stepper = with_role(Role::Stepper).into_iter().find(|oracle| does(oracle.as_ref()));
    stepper.unwrap_or_else(|| super::stepper_of(model))
}

/// The oracles whose claims are proven, one for each model: they judge the others.
pub fn judges() -> Panel {
    with_role(Role::Judge)
}

/// The oracles whose names are in `list`, separated by commas. A name stands for every oracle of the default panel that it begins
/// (`ode` for all of them), or else for every other one that it is or begins (`enclosure` for both).
///
/// # Errors
/// When a name stands for none, or for one that is named already.
pub fn select(list: &str) -> Result<Panel, Invalid> {
    let (by_default, all) = (default(), all());
    let mut names: Vec<String> = Vec::new();
    for wanted in list.split(',').map(str::trim) {
        let begins = |name: &str| name == wanted || name.starts_with(&format!("{wanted}/"));
        let among = |panel: &Panel| -> Vec<String> {
            panel.iter().map(|oracle| oracle.name()).filter(|name| begins(name)).map(str::to_owned).collect()
        };
        let found = Some(among(&by_default)).filter(|found| !found.is_empty()).unwrap_or_else(|| among(&all));
        if found.is_empty() || found.iter().any(|name| names.contains(name)) {
            let allowed = "names from `chattercheck oracles`, each once, separated by commas";
            return Err(Invalid::new("oracles", wanted, allowed));
        }
        names.extend(found);
    }
    Ok(all.into_iter().filter(|oracle| names.iter().any(|name| name == oracle.name())).collect())
}

/// One oracle by the name of its method (`ode`) or its own (`ode/linear/bdf`). `equation` is the one that a method for both equations solves if neither
/// its name nor the settings say.
///
/// # Errors
/// When a name or the value of a setting is not known, or the method does not use a setting.
pub fn one(name: &str, settings: &Settings, equation: &str) -> Result<Box<dyn Oracle>, Refused> {
    let (method, settings, model) = resolve(name, settings, model_named(equation)?)?.ok_or_else(|| {
        let allowed =
            "auto, closed-form, closed-form/corrected, ode, taylor, asymptotic, accumulation, enclosure or printed";
        Invalid::new("oracle", name, allowed)
    })?;
    Ok((method.make)(&settings, model)?)
}

/// The method of that name, its settings with what the name says, and the equation that it is to solve; `None` for a name that is not known.
pub(super) fn resolve<'a>(
    name: &'a str,
    settings: &Settings<'a>,
    equation: Model,
) -> Result<Option<(&'static Method, Settings<'a>, Model)>, Refused> {
    let Some(method) = method(name) else { return Ok(None) };
    method.refuse_unused(settings)?;
    let mut settings = *settings;
    let parts = rest(name, method).into_iter().flat_map(|rest| rest.split('/'));
    let mut says = method.in_name.iter();
    for part in parts {
        let Some(&setting) = says.next() else { return Ok(None) };
        // `order-16` in a name is `16` as a setting.
        let part = part.strip_prefix("order-").unwrap_or(part);
        if let Some(value) = settings.get(setting).filter(|value| value != part) {
            let (option, oracle) = (setting.name(), name.to_owned());
            return Err(Refused::InName { option, value, oracle, method: method.name });
        }
        settings.set(setting, part);
    }
    let model = match settings.equation {
        Some(named) => model_named(named)?,
        None => *method.models.iter().find(|model| **model == equation).or(method.models.first()).unwrap_or(&equation),
    };
    if !method.models.contains(&model) {
        let value = settings.get(Setting::Model).unwrap_or_default();
        return Err(Refused::unused("model", value, name, |method| method.models.contains(&model)));
    }
    Ok(Some((method, settings, model)))
}

/// The equation of that name, `linear` or `nonlinear`.
///
/// # Errors
/// When it is neither.
pub fn model_named(name: &str) -> Result<Model, Invalid> {
    match name {
        "linear" => Ok(Model::Linear),
        "nonlinear" => Ok(Model::Nonlinear),
        _ => Err(Invalid::new("model", name, "linear or nonlinear")),
    }
}

/// The equation that a case is for: that of the block as it is where it has a slenderness.
pub fn model_of(case: &Case) -> Model {
    if case.slenderness().is_some() { Model::Nonlinear } else { Model::Linear }
}
