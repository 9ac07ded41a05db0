//! Points that are scenes: a scene file with some of its fields set.

use std::{fs, path::PathBuf};

use contract::{Estimate, Oracle};
use toml::{Table, Value as Toml};

use super::{Axis, Findings, SweepError, Value};
use crate::{
    motion::{
        response::{Asked, Bout, BoutEnd, Peak, Response, Termination},
        scene::{End, Ground, Scene},
    },
    panel,
};

/// How scenes are made of the values of the axes, and what is found out of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Scenes {
    /// The scene as it is written.
    base: Table,
    /// The fields that the axes are, from table to table.
    paths: Vec<Vec<String>>,
    /// Where it is.
    folder: PathBuf,
    /// Its path, for people.
    shown: String,
}

impl Scenes {
    /// # Errors
    /// When the scene can't be read, or an axis goes through what is no table.
    pub(super) fn new(folder: PathBuf, shown: String, text: &str, axes: &[Axis]) -> Result<Self, SweepError> {
        // As it stands it has to be a scene, but for what the axes set.
        let base = text.parse().or_else(|_| Scene::parse_in(text, &folder).map(|_| Table::new()));
        let base: Table = base.map_err(|error| SweepError(format!("{shown}: {error}")))?;
        let paths = axes.iter().map(|axis| axis.name.split('.').map(str::to_owned).collect()).collect();
        let scenes = Self { base, paths, folder, shown };
        for axis in axes {
            if axis.name.split('.').count() < 2 || axis.name.split('.').any(str::is_empty) {
                let allowed =
                    "a field of the scene with that of its table, as block.restitution or ground.record.scale";
                return Err(SweepError(format!("axes.{} is outside the allowed: {allowed}", axis.name)));
            }
        }
        Ok(scenes)
    }

    /// The scene of these values, one for each axis.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn scene(&self, values: impl Iterator<Item = Value>) -> Result<Scene, SweepError> {
        let mut table = self.base.clone();
        for (path, value) in self.paths.iter().zip(values) {
            set(&mut table, path, value)
                .ok_or_else(|| SweepError(format!("axes.{}: not a field of {}", path.join("."), self.shown)))?;
        }
        let text = toml::to_string(&table).map_err(|error| SweepError(error.to_string()))?;
        Scene::parse_in(&text, &self.folder).map_err(|error| {
            // The line is that of a text that nobody has seen.
            let said = error.to_string();
            let said =
                said.strip_prefix("line ").and_then(|rest| rest.split_once(": ")).map_or(&*said, |(_, said)| said);
            let said = said.split(", in `").next().unwrap_or(said);
            SweepError(format!("{}: {said}", self.shown))
        })
    }

    /// The files that a scene is made of, beside itself.
    pub(super) fn files(scene: &Scene) -> Option<&PathBuf> {
        match &scene.ground {
            Ground::Shaking(shaking) => shaking.file.as_ref(),
            Ground::Sinusoid(_) => None,
        }
    }

    /// What is found of a point.
    pub(super) fn findings(&self, values: impl Iterator<Item = Value>) -> Findings {
        let Ok(scene) = self.scene(values) else { return Findings::nothing("refused") };
        let Some((response, rotation)) = response(&scene) else { return Findings::nothing("declined") };
        let Ok(account) = scene.account(&response, rotation.map(|(peak, _)| peak)) else {
            return Findings::nothing("refused");
        };
        let seconds = |tau: f64| tau / scene.block.frequency_parameter();
        let Some((first, last)) = response.bouts.first().zip(response.bouts.last()) else {
            return Findings { impacts: Some(0), bouts: Some(0), ..Findings::nothing("never-rocks") };
        };
        let ending = name(account.ending);
        let is_known = account.ending != End::NotKnown;
        let falls = matches!(account.ending, End::Overturned | End::Lying);
        let rests = |bout: &&Bout| matches!(bout.outcome, BoutEnd::Complete { .. }) && !bout.is_unsure();
        Findings {
            tau_ch: Some(first)
                .filter(rests)
                .map(|bout| Estimate { value: bout.duration - bout.start, uncertainty: bout.uncertainty() }),
            tau_ch_ending: if first.ending() == "complete" { "at-rest" } else { first.ending() },
            largest_rotation: rotation
                .filter(|(_, uncertainty)| is_known && !falls && uncertainty.is_finite())
                .map(|(peak, uncertainty)| Estimate { value: peak.rotation.abs(), uncertainty }),
            impacts: is_known.then_some(account.impacts),
            bouts: is_known.then_some(account.times_of_rocking),
            rest_time: Some(last)
                .filter(|_| account.ending == End::AtRest)
                .filter(rests)
                .map(|bout| Estimate { value: seconds(bout.end()), uncertainty: seconds(bout.uncertainty()) }),
            ending,
        }
    }
}

/// The response to a scene, with the largest rotation; `None` if it is declined.
fn response(scene: &Scene) -> Option<(Response, Option<(Peak, f64)>)> {
    let asked = scene.asked(None, Termination::Exact).ok()?;
    let oracle: Box<dyn Oracle> = match &asked {
        Asked::Sinusoid(_) => panel::stepper_of(scene.ask.model),
        Asked::Motion(request) => panel::stepper_on(&request.body, &request.motion),
    };
    asked.with_rotation(oracle.as_ref()).ok()
}

/// The fields that say a quantity in a unit, alone in their table.
const UNITS: [&str; 9] =
    ["g", "m-per-s2", "over-threshold", "over-slender-threshold", "hz", "omega", "seconds", "tau", "cycles"];

/// Sets a field of a table in a table; `None` if the way to it goes through something else.
fn set(table: &mut Table, path: &[String], value: Value) -> Option<()> {
    let (first, rest) = path.split_first()?;
    if rest.is_empty() {
        let value = match value {
            Value::Number(number) => Toml::Float(number),
            Value::Whole(whole) => Toml::Integer(whole),
            Value::Text(text) => Toml::String(text),
        };
        // A quantity is written in one unit only.
        if UNITS.contains(&first.as_str()) {
            table.clear();
        }
        table.insert(first.clone(), value);
        return Some(());
    }
    let inner = table.entry(first.clone()).or_insert_with(|| Toml::Table(Table::new()));
    set(inner.as_table_mut()?, rest, value)
}

fn name(end: End) -> &'static str {
    match end {
        End::AtRest => "at-rest",
        End::Rocking => "rocking",
        End::Overturned => "overturned",
        End::Lying => "lying",
        End::NotKnown => "not-known",
    }
}

/// The text of a file that people write.
pub(super) fn read_text(path: &std::path::Path) -> Result<String, SweepError> {
    let wrong = |error| SweepError(format!("cannot read {}: {error}", path.display()));
    let long = fs::metadata(path).map_err(wrong)?.len() > crate::motion::scene::MOST_BYTES as u64;
    if long {
        return Err(SweepError(format!("{}: the file is too large; allowed is up to 1 MiB", path.display())));
    }
    fs::read_to_string(path).map_err(wrong)
}
