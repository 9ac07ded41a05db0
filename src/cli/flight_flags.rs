//! The flags that say by whose flights a scene is followed.

use anyhow::bail;
use chattercheck::{
    motion::response::{OnMotion, Request},
    panel::{self, Method, ProvenResponse, Refused, Setting, Settings},
};
use clap::Args;
use contract::{Body, Decline, Followed, Model, Motion, Oracle};

use super::numbers::number;

/// Whose flights a response is made of.
#[derive(Args)]
pub(super) struct FlightFlags {
    /// By whose flights the block is followed: closed-form, ode or taylor; response is proven by enclosure too; auto is the fastest on the equation and the motion of the ground [default: auto]
    #[arg(long, value_name = "NAME")]
    oracle: Option<String>,
    /// For ode: the solver, tsit45, bdf, tr-bdf2 or esdirk34 [default: tsit45]
    #[arg(long, value_name = "METHOD")]
    method: Option<String>,
    /// For ode: the relative tolerance [default: the method's own]
    #[arg(long, value_name = "R", allow_hyphen_values = true, value_parser = number)]
    rtol: Option<f64>,
}

/// The name of the choice that is left to the program.
pub(super) const AUTO: &str = "auto";

/// What a proof is of: a block, a motion of the ground, and how far it is followed.
pub(super) type ToProve<'a> = (&'a Body, &'a Motion, &'a Followed);

impl FlightFlags {
    /// What the judge proves of a whole response, if it is the oracle that is named: its name, and the bouts.
    ///
    /// # Errors
    /// When a value is not known, or the judge does not use an option.
    pub fn proven(&self, model: Model, digits: Option<i64>, asked: ToProve) -> anyhow::Result<Option<ProvenResponse>> {
        let Some(name) = self.oracle.as_deref() else { return Ok(None) };
        Ok(panel::proven_bouts(name, &Settings { digits, ..self.settings() }, model, asked)?)
    }

    /// Whether an oracle is named.
    pub fn names_an_oracle(&self) -> bool {
        self.oracle.is_some()
    }

    fn settings(&self) -> Settings<'_> {
        Settings { method: self.method.as_deref(), rtol: self.rtol, ..Settings::default() }
    }

    /// Who follows a sinusoid that is that of a case.
    ///
    /// # Errors
    /// When a name or a value is not known, the method does not use an option, or it does not follow flights on the equation of the scene.
    pub fn on_sinusoid(&self, model: Model, request: &Request) -> anyhow::Result<Box<dyn Oracle>> {
        // Below the threshold nothing is followed.
        let rocks = request.case.epsilon() > 0.0;
        let named = self.named(model, |oracle| if rocks { oracle.flights(&request.case).map(drop) } else { Ok(()) })?;
        Ok(named.unwrap_or_else(|| panel::stepper_of(model)))
    }

    /// Who follows another motion.
    ///
    /// # Errors
    /// As [`FlightFlags::on_sinusoid`].
    pub fn on_motion(&self, model: Model, request: &OnMotion) -> anyhow::Result<Box<dyn Oracle>> {
        let named = self.named(model, |oracle| oracle.flights_on(&request.body, &request.motion).map(drop))?;
        Ok(named.unwrap_or_else(|| panel::stepper_on(&request.body, &request.motion)))
    }

    /// The oracle that is named, or the first that uses the options that are given; `None` if there are none.
    fn named(
        &self,
        model: Model,
        follows: impl Fn(&dyn Oracle) -> Result<(), Decline>,
    ) -> anyhow::Result<Option<Box<dyn Oracle>>> {
        let settings = self.settings();
        if self.oracle.as_deref() == Some(AUTO) {
            let unused = settings.given().next();
            let refused = unused.map(|(setting, value)| {
                Refused::unused(setting.name(), value, AUTO, |method| method.uses(setting)).into()
            });
            return refused.map_or(Ok(None), Err);
        }
        let uses_all = |method: &Method| settings.given().all(|(setting, _)| method.uses(setting));
        let name = match self.oracle.as_deref() {
            Some(name) => name,
            None if settings.given().next().is_none() => return Ok(None),
            // What no method uses is refused under the name of one.
            None => panel::methods().find(|method| uses_all(method)).map_or("ode", |method| method.name),
        };
        let equation = if model == Model::Linear { "linear" } else { "nonlinear" };
        let oracle = panel::one(name, &settings, equation)?;
        match follows(oracle.as_ref()) {
            // One for the nonlinear equation may do the linear one too, of a block without a slenderness.
            Ok(()) if oracle.model() == model || model == Model::Linear => Ok(Some(oracle)),
            Err(why @ Decline::Unsupported { .. })
                if oracle.model() == model && !follows_responses(oracle.as_ref()) =>
            {
                bail!(
                    "{} declines: {why}; it does not follow a block from impact to impact, of which a response is made: --oracle auto does, and so do {}",
                    oracle.name(),
                    followers(model)
                )
            }
            Err(why) if oracle.model() == model => bail!("{} declines: {why}", oracle.name()),
            _ => {
                let solves = |method: &Method| method.models.contains(&model);
                let value = format!("{equation} (of the scene)");
                Err(Refused::unused(Setting::Model.name(), value, oracle.name(), solves).into())
            }
        }
    }
}

/// Whether an oracle is one of those that follow whole responses.
fn follows_responses(oracle: &dyn Oracle) -> bool {
    panel::method(oracle.name()).is_some_and(|method| !method.responses.is_empty())
}

/// The methods that follow whole responses on an equation.
fn followers(model: Model) -> String {
    let follows = |method: &&Method| method.models.contains(&model) && !method.responses.is_empty();
    panel::methods().filter(follows).map(|method| method.name).collect::<Vec<_>>().join(", ")
}
