//! The flags that say which oracle is asked, and how. Where none is named, the first that uses everything that was given.

use anyhow::bail;
use chattercheck::{
    measure::threshold::excess,
    motion::response::OnMotion,
    panel::{self, Method, ProvenResponse, Refused, Role, Setting, Settings},
    plan::Question,
};
use clap::Args;
use contract::{Case, Invalid, Model, Normalisation, Oracle, Slenderness};

use super::{
    case_flags::CaseFlags,
    flight_flags::{AUTO, ToProve},
    numbers::number,
};

/// Which oracle to ask, and its settings.
#[derive(Args)]
pub(crate) struct OracleFlags {
    /// The method; see `chattercheck oracles`. auto is the cheapest that meets --tolerance; see `chattercheck plan` (for impacts: the fastest on the equation that is asked for) [default: the first of closed-form, taylor, auto, ode, asymptotic, enclosure and accumulation that uses everything that is given; auto for a scene]
    #[arg(long, value_name = "NAME")]
    oracle: Option<String>,
    /// For ode: the solver, tsit45, bdf, tr-bdf2 or esdirk34 [default: tsit45]
    #[arg(long, value_name = "METHOD")]
    method: Option<String>,
    /// For ode: the relative tolerance [default: the method's own]
    #[arg(long, value_name = "R", allow_hyphen_values = true, value_parser = number)]
    rtol: Option<f64>,
    /// For ode: each flight in its own units, or all on one clock: rescaled or naive [default: rescaled]
    #[arg(long, value_name = "FLIGHTS")]
    flights: Option<String>,
    /// For asymptotic: paper (Eq. 65), how many terms of the series (1 to 92), or resummed [default: paper]; for accumulation: how many terms of the local series (1 to 16) [default: 8]
    #[arg(long, value_name = "paper|K|resummed", allow_hyphen_values = true)]
    order: Option<String>,
    /// The largest relative error of tau_ch that is accepted: for asymptotic by its own claim [default: 0.5]; for auto, of a chattering time only [default: 1e-6, or the scene's]
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = number)]
    tolerance: Option<f64>,
}

/// What is asked.
pub(crate) enum Asked {
    /// The cheapest method that meets a tolerance.
    Auto(Box<Question>),
    /// One oracle.
    Oracle(Box<dyn Oracle>),
}

impl OracleFlags {
    /// What is asked about the case that the flags give; `digits` are those that are to be proven.
    ///
    /// # Errors
    /// When a name or value is not known, or something was given that the method does not use.
    pub fn asked(&self, flags: &CaseFlags, case: &Case, digits: Option<i64>) -> anyhow::Result<Asked> {
        let settings = self.settings(flags, digits);
        let name = self.name(flags, &settings)?;
        if name == AUTO {
            return Ok(Asked::Auto(Box::new(self.question(flags, case, &settings)?)));
        }
        let model = if panel::model_of(case) == Model::Nonlinear { "nonlinear" } else { "linear" };
        let oracle = panel::one(name, &settings, model)?;
        self.check(flags, case, oracle.as_ref())?;
        Ok(Asked::Oracle(oracle))
    }

    /// Who follows a scene whose ground is no sinusoid, or whose block is in motion: the method that is named, or the one that does it best.
    ///
    /// # Errors
    /// As [`OracleFlags::asked`].
    pub fn on_motion(
        &self,
        flags: &CaseFlags,
        request: &OnMotion,
        digits: Option<i64>,
    ) -> anyhow::Result<Box<dyn Oracle>> {
        let settings = self.settings(flags, digits);
        if let Some(name) = self.oracle.as_deref().filter(|name| *name != AUTO) {
            let model = if request.body.alpha().is_some() { "nonlinear" } else { "linear" };
            return Ok(panel::one(name, &settings, model)?);
        }
        if let Some((setting, value)) = settings.given().find(|(setting, _)| *setting != Setting::Model) {
            let by = "auto on this motion of the ground";
            return Err(Refused::unused(setting.name(), value, by, |method| method.uses(setting)).into());
        }
        Ok(panel::stepper_on(&request.body, &request.motion))
    }

    /// What the judge proves of the case, if that is who is asked.
    ///
    /// # Errors
    /// As [`OracleFlags::asked`], and when the judge declines.
    pub fn proven(&self, flags: &CaseFlags, case: &Case, digits: Option<i64>) -> anyhow::Result<Option<panel::Proven>> {
        let settings = self.settings(flags, digits);
        let name = self.name(flags, &settings)?;
        match panel::proven(name, &settings, case)? {
            Some(Ok(proven)) => Ok(Some(proven)),
            Some(Err(decline)) => bail!("{name} declines: {decline}"),
            None => Ok(None),
        }
    }

    /// What the judge proves of a whole response, if that is who is asked: its name, and the bouts.
    ///
    /// # Errors
    /// As [`OracleFlags::asked`].
    pub fn proven_bouts(
        &self,
        flags: &CaseFlags,
        digits: Option<i64>,
        model: Model,
        asked: ToProve,
    ) -> anyhow::Result<Option<ProvenResponse>> {
        let Some(name) = self.oracle.as_deref() else { return Ok(None) };
        Ok(panel::proven_bouts(name, &self.settings(flags, digits), model, asked)?)
    }

    /// The accuracy that is asked of the whole.
    pub fn tolerance(&self) -> Option<f64> {
        self.tolerance
    }

    /// The method that is named, or else the first that uses everything that was given.
    fn name<'a>(&'a self, flags: &CaseFlags, settings: &Settings) -> Result<&'a str, Refused> {
        if let Some(name) = &self.oracle {
            return Ok(name);
        }
        let given: Vec<Setting> = settings.given().map(|(setting, _)| setting).collect();
        let only_tolerance = given.iter().all(|setting| auto_uses(*setting, flags));
        // A scene asks for an accuracy; the flags of a case do not.
        if only_tolerance && (flags.scene.is_some() || !given.is_empty()) {
            return Ok(AUTO);
        }
        let nonlinear = flags.alpha().is_some();
        let fits = |method: &&Method| {
            given.iter().all(|setting| method.uses(*setting))
                && method.models.iter().any(|model| match settings.equation {
                    Some("linear") => *model == Model::Linear && !nonlinear,
                    Some("nonlinear") => *model == Model::Nonlinear,
                    _ => *model == if nonlinear { Model::Nonlinear } else { Model::Linear },
                })
        };
        let steppers = panel::methods().filter(|method| method.roles.contains(&Role::Stepper));
        let method = steppers.chain(panel::methods()).find(fits);
        method.map(|method| method.name).ok_or_else(|| {
            let alpha = nonlinear.then(|| "--alpha".to_owned());
            let settings = settings.given().map(|(setting, value)| format!("--{} {value}", setting.name()));
            Refused::NoMethod { options: alpha.into_iter().chain(settings).collect::<Vec<_>>().join(", ") }
        })
    }

    /// Refuses what an oracle that is named leaves out of the case or of the scene.
    fn check(&self, flags: &CaseFlags, case: &Case, oracle: &dyn Oracle) -> anyhow::Result<()> {
        let is_linear = oracle.model() == Model::Linear;
        let solves_it = |method: &Method| method.models.contains(&Model::Nonlinear);
        match flags.scene()? {
            None => {
                if let Some(alpha) = flags.alpha().filter(|_| is_linear) {
                    return Err(Refused::unused("alpha", alpha, oracle.name(), solves_it).into());
                }
            }
            Some(scene) => {
                if is_linear && case.slenderness().is_some() {
                    return Err(Refused::unused("model", "nonlinear (of the scene)", oracle.name(), solves_it).into());
                }
                if !is_linear && case.slenderness().is_none() {
                    bail!(
                        "model = linear (of the scene) is not solved by {}; --model nonlinear asks it of the scene",
                        oracle.name()
                    );
                }
                if scene.question()?.request.is_some() && oracle.flights(case).is_err() {
                    bail!(
                        "phase or duration (of the scene) is not used by {}, which is for a motion that passes the threshold and goes on; only with --oracle auto, closed-form, taylor or ode",
                        oracle.name()
                    );
                }
            }
        }
        Ok(())
    }

    /// What `auto` is asked.
    fn question(&self, flags: &CaseFlags, case: &Case, settings: &Settings) -> anyhow::Result<Question> {
        if let Some((setting, value)) = settings.given().find(|(setting, _)| !auto_uses(*setting, flags)) {
            return Err(Refused::unused(setting.name(), value, AUTO, |method| method.uses(setting)).into());
        }
        let question = match flags.scene()? {
            Some(scene) => scene.question()?,
            None => {
                let (case, rounding) = threshold(case)?;
                Question { rounding, ..Question::new(case, Question::DEFAULT_TOLERANCE) }
            }
        };
        let tolerance = self.tolerance.unwrap_or(question.tolerance);
        if !(1e-15..=0.5).contains(&tolerance) {
            return Err(Invalid::new("tolerance", format!("{tolerance:?}"), "1e-15 to 0.5 (relative)").into());
        }
        Ok(Question { tolerance, ..question })
    }

    fn settings<'a>(&'a self, flags: &'a CaseFlags, digits: Option<i64>) -> Settings<'a> {
        Settings {
            equation: flags.model(),
            method: self.method.as_deref(),
            flights: self.flights.as_deref(),
            rtol: self.rtol,
            order: self.order.as_deref(),
            tolerance: self.tolerance,
            digits,
        }
    }
}

/// Whether `auto` uses a setting: the accuracy, and the equation that is asked of a scene.
fn auto_uses(setting: Setting, flags: &CaseFlags) -> bool {
    setting == Setting::Tolerance || setting == Setting::Model && flags.scene.is_some()
}

/// The case with its amplitude over the threshold `g tan α`, as the plan has it, and what the rounding of that leaves of `ε`, relative.
fn threshold(case: &Case) -> Result<(Case, f64), Invalid> {
    match case.slenderness() {
        Some(of) if of.normalisation() == Normalisation::Slender => {
            let (epsilon, rounding) = excess(case);
            let slenderness = Slenderness::new(of.alpha(), Normalisation::Threshold)?;
            Ok((Case::from_epsilon(epsilon, case.omega(), case.eta())?.with_slenderness(slenderness), rounding))
        }
        _ => Ok((*case, 0.0)),
    }
}
