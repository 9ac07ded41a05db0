//! The flags that give one case, and the oracle to ask.

use std::{
    fs,
    io::Read as _,
    path::{Path, PathBuf},
};

use anyhow::{Context as _, bail};
use chattercheck::{
    cases::case_file::CaseFields,
    motion::{
        plan::Question,
        scene::{self, Scene},
    },
    panel::{self, Enclosure, Settings},
};
use clap::Args;
use contract::{Case, Horizon, Invalid, Model, Normalisation, Oracle, Slenderness};

/// A dimensionless case. Each value means the double nearest to it.
#[derive(Args)]
pub(crate) struct CaseFlags {
    /// Amplitude of the ground acceleration; rocking starts at 1
    #[arg(
        long,
        value_name = "A",
        required_unless_present_any = ["epsilon", "scene"],
        conflicts_with = "epsilon",
        allow_hyphen_values = true, value_parser = number
    )]
    a: Option<f64>,
    /// a - 1, without the rounding of a
    #[arg(long, value_name = "E", allow_hyphen_values = true, value_parser = number)]
    epsilon: Option<f64>,
    /// Frequency ratio omega_g/p
    #[arg(
        long,
        value_name = "W",
        required_unless_present = "scene",
        allow_hyphen_values = true,
        value_parser = number
    )]
    omega: Option<f64>,
    /// Coefficient of restitution
    #[arg(
        long,
        value_name = "E",
        required_unless_present = "scene",
        allow_hyphen_values = true,
        value_parser = number
    )]
    eta: Option<f64>,
    /// A scene file in place of these: a block and a ground motion in physical units; see `chattercheck scene`. Answered for a motion that
    /// passes the threshold and goes on; its phase and duration are for `chattercheck scene` and `chattercheck response`
    #[arg(long, value_name = "FILE", conflicts_with_all = ["a", "epsilon", "omega", "eta", "alpha"])]
    scene: Option<PathBuf>,
    /// Slenderness angle in radians, for the nonlinear model
    #[arg(long, value_name = "RAD", allow_hyphen_values = true, value_parser = number)]
    alpha: Option<f64>,
    /// What the amplitude is a multiple of: g tan(alpha), or g alpha [default: threshold]
    #[arg(long, value_name = "threshold|slender", requires = "alpha")]
    normalisation: Option<String>,
    /// Follow the block to this time tau, past half a period if it still rocks
    #[arg(long, value_name = "TAU", allow_hyphen_values = true, value_parser = number)]
    until: Option<f64>,
}

impl CaseFlags {
    /// The scene, if one is given.
    pub fn scene(&self) -> anyhow::Result<Option<Scene>> {
        self.scene.as_deref().map(read_scene).transpose()
    }

    /// The case, listing up to `impacts` impacts.
    pub fn case(&self, impacts: usize) -> anyhow::Result<Case> {
        if let Some(scene) = self.scene()? {
            let case = scene.case()?.with_max_impacts(impacts)?;
            return Ok(self.until.map_or(Ok(case), |until| case.with_horizon(Horizon::Until(until)))?);
        }
        let fields = CaseFields {
            a: self.a,
            epsilon: self.epsilon,
            omega: self.omega.unwrap_or(f64::NAN),
            eta: self.eta.unwrap_or(f64::NAN),
            alpha: self.alpha,
            normalisation: self.normalisation.clone(),
            impacts: Some(impacts),
            until: self.until,
        };
        Ok(fields.case()?)
    }
}

/// A scene file. No more of it is read than a scene may be long, and a byte to tell that it is longer.
pub(super) fn read_scene(path: &Path) -> anyhow::Result<Scene> {
    let mut text = String::new();
    let file = fs::File::open(path).with_context(|| format!("cannot read {}", path.display()))?;
    let read = file.take(scene::MOST_BYTES as u64 + 1).read_to_string(&mut text);
    read.with_context(|| format!("cannot read {}", path.display()))?;
    Scene::parse(&text).with_context(|| path.display().to_string())
}

/// Which oracle to ask, and its settings.
#[derive(Args)]
pub(crate) struct OracleFlags {
    /// The method; see `chattercheck oracles`. auto is the cheapest that meets --tolerance; see `chattercheck plan` (for impacts: the fastest on the equation that is asked for) [default: closed-form; auto for a scene]
    #[arg(long, value_name = "NAME")]
    oracle: Option<String>,
    /// For ode and enclosure: the equation of motion, linear or nonlinear [default: nonlinear if --alpha is given]
    #[arg(long, value_name = "MODEL")]
    model: Option<String>,
    /// For ode: the solver, tsit45, bdf, tr-bdf2 or esdirk34 [default: tsit45]
    #[arg(long, value_name = "METHOD")]
    method: Option<String>,
    /// For ode: the relative tolerance [default: the method's own]
    #[arg(long, value_name = "R", allow_hyphen_values = true, value_parser = number)]
    rtol: Option<f64>,
    /// For ode: each flight in its own units, or all on one clock: rescaled or naive [default: rescaled]
    #[arg(long, value_name = "FLIGHTS")]
    flights: Option<String>,
    /// For asymptotic: paper (Eq. 65), how many terms of the series (1 to 92), or resummed [default: paper]
    #[arg(long, value_name = "paper|K|resummed", allow_hyphen_values = true)]
    order: Option<String>,
    /// The largest relative error of tau_ch that is accepted: for asymptotic by its own claim [default: 0.5]; for auto [default: 1e-6, or the scene's]
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = number)]
    tolerance: Option<f64>,
}

impl OracleFlags {
    /// The oracle with proven bounds, if it is the one that is named.
    pub fn enclosure(&self, flags: &CaseFlags, case: &Case) -> Result<Option<Enclosure>, Invalid> {
        panel::enclosure(self.name(flags), &self.settings(), equation(case))
    }

    /// Says so where a scene has a phase or a duration that a named oracle, which answers for a case, leaves out.
    pub fn remark(&self, flags: &CaseFlags) -> anyhow::Result<()> {
        if let Some(scene) = flags.scene()?
            && self.name(flags) != "auto"
            && scene.question()?.request.is_some()
        {
            eprintln!(
                "{}: for a motion that passes the threshold and goes on; the phase and the duration of the scene are left out, see `chattercheck scene`",
                self.name(flags)
            );
        }
        Ok(())
    }

    /// The oracle, for a case with or without slenderness.
    pub fn oracle(&self, flags: &CaseFlags, case: &Case) -> anyhow::Result<Box<dyn Oracle>> {
        // For impacts, other than for a chattering time, it takes flights of the very equation that is asked for.
        if self.question(flags, case)?.is_some() {
            let model = if case.slenderness().is_some() { Model::Nonlinear } else { Model::Linear };
            return Ok(panel::stepper_of(model));
        }
        Ok(panel::one(self.name(flags), &self.settings(), equation(case))?)
    }

    /// What `auto` is asked; `None` for an oracle that is named.
    pub fn question(&self, flags: &CaseFlags, case: &Case) -> anyhow::Result<Option<Question>> {
        if self.name(flags) != "auto" {
            return Ok(None);
        }
        let Settings { equation, method, flights, rtol, order, .. } = self.settings();
        if equation.or(method).or(flights).or(order).is_some() || rtol.is_some() {
            bail!(
                "--model, --method, --flights, --rtol and --order are for an oracle that is named with --oracle, not for auto"
            );
        }
        let question = match flags.scene()? {
            Some(scene) => scene.question()?,
            None => Question::new(threshold(case)?, Question::DEFAULT_TOLERANCE),
        };
        let tolerance = self.tolerance.unwrap_or(question.tolerance);
        if !(1e-15..=0.5).contains(&tolerance) {
            return Err(Invalid::new("tolerance", format!("{tolerance:?}"), "1e-15 to 0.5 (relative)").into());
        }
        Ok(Some(Question { tolerance, ..question }))
    }

    /// A scene asks for an accuracy; the flags of a case do not.
    fn name(&self, flags: &CaseFlags) -> &str {
        self.oracle.as_deref().unwrap_or(if flags.scene.is_some() { "auto" } else { "closed-form" })
    }

    fn settings(&self) -> Settings<'_> {
        Settings {
            equation: self.model.as_deref(),
            method: self.method.as_deref(),
            flights: self.flights.as_deref(),
            rtol: self.rtol,
            order: self.order.as_deref(),
            tolerance: self.tolerance,
        }
    }
}

/// The case with its amplitude over the threshold `g tan α`, as the plan has it.
fn threshold(case: &Case) -> Result<Case, Invalid> {
    match case.slenderness() {
        Some(of) if of.normalisation() == Normalisation::Slender => {
            let a = case.amplitude() * of.alpha() / of.alpha().tan();
            let slenderness = Slenderness::new(of.alpha(), Normalisation::Threshold)?;
            Ok(Case::from_amplitude(a, case.omega(), case.eta())?.with_slenderness(slenderness))
        }
        _ => Ok(*case),
    }
}

/// The equation that is meant if none is named.
fn equation(case: &Case) -> &'static str {
    if case.slenderness().is_some() { "nonlinear" } else { "linear" }
}

/// A number of the command line. Whether its value is allowed is for the contract to say.
pub(super) fn number(text: &str) -> Result<f64, &'static str> {
    text.parse().map_err(|_| "not a number; allowed is one as in 1.03 or 1e-3")
}
