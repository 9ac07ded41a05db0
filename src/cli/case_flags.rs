//! The flags that give one case.

use std::{
    fs,
    io::{self, Read as _},
    path::{Path, PathBuf},
};

use anyhow::{Context as _, anyhow};
use chattercheck::{
    cases::case_file::CaseFields,
    motion::scene::{self, Scene},
    panel,
};
use clap::Args;
use contract::{Case, Horizon};

use super::numbers::number;

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
    /// A scene file in place of these: a block and a ground motion in physical units; see `chattercheck scene`. Answered for its first rocking: from where the
    /// motion sets it off, past half a period and past the end of the motion
    #[arg(long, value_name = "FILE", conflicts_with_all = ["a", "epsilon", "omega", "eta", "alpha", "normalisation"])]
    pub(super) scene: Option<PathBuf>,
    /// Slenderness angle in radians, for the nonlinear model
    #[arg(long, value_name = "RAD", allow_hyphen_values = true, value_parser = number)]
    alpha: Option<f64>,
    /// What the amplitude is a multiple of: g tan(alpha), or g alpha [default: threshold]
    #[arg(long, value_name = "threshold|slender")]
    normalisation: Option<String>,
    /// The equation of motion, linear or nonlinear [default: the one that the method solves; nonlinear, if it solves both and --alpha is given; for a scene the one that it asks for]
    #[arg(long, value_name = "MODEL")]
    model: Option<String>,
    /// Follow the block to this time tau, past half a period if it still rocks; for a scene from the start of its motion
    #[arg(long, value_name = "TAU", allow_hyphen_values = true, value_parser = number)]
    until: Option<f64>,
}

impl CaseFlags {
    /// `--alpha` as it was given.
    pub fn alpha(&self) -> Option<f64> {
        self.alpha
    }

    /// `--until` as it was given.
    pub fn until(&self) -> Option<f64> {
        self.until
    }

    /// `--model` as it was given.
    pub fn model(&self) -> Option<&str> {
        self.model.as_deref()
    }

    /// The scene, if one is given, asked for `--model`.
    pub fn scene(&self) -> anyhow::Result<Option<Scene>> {
        self.scene.as_ref().map(|path| read_scene_as(path, self.model())).transpose()
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

/// A scene file, asked for another model than its own if one is named.
pub(super) fn read_scene_as(path: &Path, model: Option<&str>) -> anyhow::Result<Scene> {
    let mut scene = read_scene(path)?;
    if let Some(name) = model {
        scene.ask.model = panel::model_named(name)?;
    }
    Ok(scene)
}

/// A scene file.
pub(super) fn read_scene(path: &Path) -> anyhow::Result<Scene> {
    let folder = path.parent().unwrap_or(Path::new(""));
    Scene::parse_in(&read_text(path)?, folder).with_context(|| path.display().to_string())
}

/// A file that people write. No more of it is read than a scene may be long, and a byte to tell that it is longer.
pub(super) fn read_text(path: &Path) -> anyhow::Result<String> {
    let mut text = String::new();
    let file = fs::File::open(path).map_err(|error| anyhow!("cannot read {}: {error}", path.display()))?;
    let read = file.take(scene::MOST_BYTES as u64 + 1).read_to_string(&mut text);
    read.map_err(|error| match error.kind() {
        io::ErrorKind::InvalidData => anyhow!("{}: not a text (UTF-8)", path.display()),
        _ => anyhow!("cannot read {}: {error}", path.display()),
    })?;
    Ok(text)
}
