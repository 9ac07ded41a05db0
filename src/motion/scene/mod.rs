//! Scenes: a block in metres and a ground motion in seconds, and what is asked of them; read from TOML and turned into cases.
//!
//! Unknown keys, missing ones and impossible values are errors that name the line.

mod account;
mod answer;
mod file;
mod response;
mod shaking;

use std::{f64::consts::TAU, fmt, ops::Range, path::Path};

use contract::{Case, Invalid, Model, Normalisation, Slenderness};
use toml::Spanned;

pub use account::{Account, End, Largest, Stretch};
pub use answer::{AnswerError, Answers, ChatteringTime, Summary};
pub use file::{
    Amplitude, AskFields, BlockFields, Duration, Frequency, GroundFields, ModelName, PulseName, Question, RecordFields,
    Restitution, RestitutionRule, SceneFile, SineFields, StartFields, Time,
};
pub use shaking::Shaking;

use shaking::Reader;

use crate::cases::toml_error::{is_control, read};

/// The largest file that is read.
pub const MOST_BYTES: usize = 1 << 20;
/// What the division by the threshold leaves of rounding.
const ROUNDING: f64 = 2.0 * f64::EPSILON;
/// Standard for this field; give `gravity` for another.
const GRAVITY: f64 = 9.81;

/// A scene whose values are all allowed.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// What it is, for people; may be empty.
    pub title: String,
    /// The block.
    pub block: Block,
    /// The ground motion.
    pub ground: Ground,
    /// The rotation and the velocity at the start, `φ` and `φ'`; both 0 at rest.
    pub start: (f64, f64),
    /// What is asked.
    pub ask: Ask,
}

/// A rectangular rigid block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// Half of the diagonal, `R`, in metres.
    pub radius: f64,
    /// The slenderness angle `α` in radians.
    pub slenderness: f64,
    /// The coefficient of restitution `η` (Eq. 13).
    pub restitution: f64,
    /// The acceleration of gravity in m/s².
    pub gravity: f64,
}

/// A ground acceleration.
#[derive(Debug, Clone, PartialEq)]
pub enum Ground {
    /// A sinusoid.
    Sinusoid(Sine),
    /// Another motion: a pulse, a sum of sinusoids, a record.
    Shaking(Shaking),
}

/// A sinusoidal ground acceleration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sine {
    /// As it is written.
    pub amplitude: Amplitude,
    /// As it is written.
    pub frequency: Frequency,
    /// The phase at `t = 0` in radians; `None` for the threshold.
    pub phase: Option<f64>,
    /// How long it lasts, in seconds; `None` for without end.
    pub duration: Option<f64>,
}

/// What is asked of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Ask {
    /// The equation of motion.
    pub model: Model,
    /// What is wanted, at least one thing.
    pub what: Vec<Question>,
    /// How many impacts are listed at the most.
    pub impacts: usize,
    /// How accurately, relative.
    pub tolerance: f64,
}

/// What is wrong with a scene, in one line: the line of the file where it can be named, the field, the value and the allowed range.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneError(String);

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for SceneError {}

/// The text of a scene, to say on which line something is.
struct Text<'a>(&'a str);

impl Text<'_> {
    fn error(&self, span: &Range<usize>, problem: impl fmt::Display) -> SceneError {
        let line = self.0.get(..span.start).map_or(1, |before| before.matches('\n').count() + 1);
        SceneError(format!("line {line}: {problem}"))
    }

    /// The value if it is finite and `holds`.
    fn number(
        &self,
        field: &'static str,
        value: &Spanned<f64>,
        holds: impl Fn(f64) -> bool,
        allowed: &'static str,
    ) -> Result<f64, SceneError> {
        self.check(field, *value.get_ref(), &value.span(), holds, allowed)
    }

    fn check(
        &self,
        field: &'static str,
        value: f64,
        span: &Range<usize>,
        holds: impl Fn(f64) -> bool,
        allowed: &'static str,
    ) -> Result<f64, SceneError> {
        if value.is_finite() && holds(value) {
            Ok(value)
        } else {
            // As it is typed, on one line; of a rule, what it gives.
            let typed = self
                .0
                .get(span.clone())
                .filter(|typed| typed.len() < 60 && !typed.contains(is_control) && !typed.starts_with('"'));
            Err(self.error(span, Invalid::new(field, typed.map_or(format!("{value:?}"), str::to_owned), allowed)))
        }
    }
}

impl Text<'_> {
    fn amplitude(&self, amplitude: &Spanned<Amplitude>) -> Result<Amplitude, SceneError> {
        let (Amplitude::G(value)
        | Amplitude::MPerS2(value)
        | Amplitude::OverThreshold(value)
        | Amplitude::OverSlenderThreshold(value)) = *amplitude.get_ref();
        self.check("amplitude", value, &amplitude.span(), |value| (0.0..=1e6).contains(&value), "0 to 1e6")?;
        Ok(*amplitude.get_ref())
    }

    fn frequency(&self, frequency: &Spanned<Frequency>) -> Result<Frequency, SceneError> {
        let (Frequency::Hz(value) | Frequency::Omega(value)) = *frequency.get_ref();
        let positive = |value: f64| (1e-9..=1e9).contains(&value);
        self.check("frequency", value, &frequency.span(), positive, "1e-9 to 1e9")?;
        Ok(*frequency.get_ref())
    }
}

impl Scene {
    /// Reads a scene.
    ///
    /// # Errors
    /// When the text is not TOML, a key is unknown or missing, or a value is not allowed. The message names the line.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        Self::parse_in(text, Path::new(""))
    }

    /// Reads a scene whose files are named from where `folder` is.
    ///
    /// # Errors
    /// As [`Scene::parse`], and when a record can't be read.
    pub fn parse_in(text: &str, folder: &Path) -> Result<Self, SceneError> {
        if text.len() > MOST_BYTES {
            return Err(SceneError(Invalid::new("size of the file", text.len(), "up to 1 MiB").to_string()));
        }
        let file: SceneFile = read(text, &file::ALLOWED).map_err(SceneError)?;
        let text = Text(text);
        let block = Block::read(&file.block, &text)?;
        let ask = Ask::read(&file.ask, &text)?;
        let start = file.start.as_ref().map_or(Ok((0.0, 0.0)), |start| start_of(start, &text))?;
        let reader = Reader { block: &block, model: ask.model, text: &text, folder };
        let ground = match reader.shaking(&file.ground)? {
            Some(shaking) => Ground::Shaking(shaking),
            None => Ground::Sinusoid(Sine::read(&file.ground, &block, &text)?),
        };
        Ok(Self {
            // It is printed: no control characters.
            title: file.title.unwrap_or_default().chars().filter(|c| !is_control(*c)).take(200).collect(),
            ground,
            start,
            ask,
            block,
        })
    }

    /// The sinusoid, of a scene that is one and starts from rest: of which a case can be made.
    ///
    /// # Errors
    /// When its ground moves in another way, or the block does.
    pub fn sine(&self) -> Result<&Sine, Invalid> {
        match &self.ground {
            Ground::Sinusoid(sine) if self.start == (0.0, 0.0) => Ok(sine),
            _ => Err(Invalid::new(
                "ground",
                self.ground_name(),
                "a sinusoid under a block at rest, for what is asked; `chattercheck response` does every motion",
            )),
        }
    }

    /// What the ground does, in a few words.
    pub fn ground_name(&self) -> &'static str {
        match &self.ground {
            Ground::Sinusoid(_) if self.start == (0.0, 0.0) => "a sinusoid",
            Ground::Sinusoid(_) => "a sinusoid under a block that is in motion",
            Ground::Shaking(shaking) => shaking.name,
        }
    }

    /// The dimensionless case: that of the first rocking from rest, with the slenderness if the model needs it.
    ///
    /// A case knows neither when the motion of the ground starts nor when it ends: it is that of a motion that passes the threshold and goes on.
    ///
    /// The amplitude is measured against the threshold `g tan α`, at which the block does begin to rock, for both models; only one that is
    /// written `over-slender-threshold` is measured against `g α`.
    ///
    /// # Errors
    /// When the numbers leave the range of a case.
    pub fn case(&self) -> Result<Case, Invalid> {
        let sine = self.sine()?;
        let omega = self.block.omega(sine.frequency);
        let (a, normalisation) = match sine.amplitude {
            Amplitude::OverSlenderThreshold(a) => (a, Normalisation::Slender),
            amplitude => (self.block.over_threshold(amplitude), Normalisation::Threshold),
        };
        let case = Case::from_amplitude(a, omega, self.block.restitution)?.with_max_impacts(self.ask.impacts)?;
        Ok(match self.ask.model {
            Model::Linear => case,
            Model::Nonlinear => case.with_slenderness(Slenderness::new(self.block.slenderness, normalisation)?),
        })
    }
}

impl Block {
    fn read(fields: &BlockFields, text: &Text) -> Result<Self, SceneError> {
        const LENGTH: &str = "1e-6 to 1e6 (metres)";
        let length =
            |field, value: &Spanned<f64>| text.number(field, value, |value| (1e-6..=1e6).contains(&value), LENGTH);
        let BlockFields { width, height, half_width, half_height, radius, slenderness, restitution, gravity } = fields;
        let (radius, slenderness) = match ((width, height), (half_width, half_height), (radius, slenderness)) {
            ((Some(width), Some(height)), (None, None), (None, None)) => {
                let (width, height) = (0.5 * length("width", width)?, 0.5 * length("height", height)?);
                (width.hypot(height), width.atan2(height))
            }
            ((None, None), (Some(width), Some(height)), (None, None)) => {
                let (width, height) = (length("half_width", width)?, length("half_height", height)?);
                (width.hypot(height), width.atan2(height))
            }
            ((None, None), (None, None), (Some(radius), Some(slenderness))) => {
                let allowed = |value: f64| (1e-100..std::f64::consts::FRAC_PI_2).contains(&value);
                let slenderness =
                    text.number("slenderness", slenderness, allowed, "1e-100 <= slenderness < pi/2 (radians)")?;
                (length("radius", radius)?, slenderness)
            }
            ((Some(_), None), (None, Some(half)), (None, None)) => {
                return Err(mixed(text, "width", ("half_height", half)));
            }
            ((None, Some(_)), (Some(half), None), (None, None)) => {
                return Err(mixed(text, "height", ("half_width", half)));
            }
            _ => {
                return Err(SceneError(
                    "[block] needs width and height (of the whole block), or half_width and half_height (half of them), or radius and slenderness; one pair, and nothing of another"
                        .to_owned(),
                ));
            }
        };
        let of_angular_momentum = 1.0 - 1.5 * slenderness.sin().powi(2);
        let (value, allowed) = match restitution.get_ref() {
            Restitution::Value(value) => (*value, "0 < restitution < 1"),
            Restitution::Rule(RestitutionRule::Housner) if of_angular_momentum >= 1.0 => (
                of_angular_momentum,
                "for \"housner\" 1 - 3/2 sin^2(slenderness) has to be below 1 as a double: slenderness > 6.1e-9",
            ),
            Restitution::Rule(RestitutionRule::Housner) => (
                of_angular_momentum,
                "for \"housner\" 1 - 3/2 sin^2(slenderness) has to be above 0: slenderness < 0.9553",
            ),
        };
        let inside = |value: f64| value > 0.0 && value < 1.0;
        let restitution = text.check("restitution", value, &restitution.span(), inside, allowed)?;
        let gravity = gravity.as_ref().map_or(Ok(GRAVITY), |gravity| {
            text.number("gravity", gravity, |gravity| (1e-6..=1e6).contains(&gravity), "1e-6 to 1e6 (m/s^2)")
        })?;
        Ok(Self { radius, slenderness, restitution, gravity })
    }

    /// An amplitude of the ground acceleration in m/s².
    pub fn acceleration(&self, amplitude: Amplitude) -> f64 {
        let Self { gravity, slenderness, .. } = *self;
        match amplitude {
            Amplitude::G(value) => value * gravity,
            Amplitude::MPerS2(value) => value,
            Amplitude::OverThreshold(a) => a * gravity * slenderness.tan(),
            Amplitude::OverSlenderThreshold(a) => a * gravity * slenderness,
        }
    }

    /// An amplitude over the threshold `g tan α` (Eq. 1); without rounding where it is written so.
    pub fn over_threshold(&self, amplitude: Amplitude) -> f64 {
        match amplitude {
            Amplitude::OverThreshold(a) => a,
            _ => self.acceleration(amplitude) / (self.gravity * self.slenderness.tan()),
        }
    }

    /// An amplitude over the threshold of a model, `g α` where a linear one is written over that and `g tan α` otherwise, and by how much rounding may have moved
    /// it, relative.
    fn over_own_threshold(&self, amplitude: Amplitude, model: Model) -> (f64, f64) {
        match amplitude {
            Amplitude::OverThreshold(a) => (a, 0.0),
            Amplitude::OverSlenderThreshold(a) if model == Model::Linear => (a, 0.0),
            amplitude => (self.over_threshold(amplitude), ROUNDING),
        }
    }

    /// The frequency ratio `ω = ω_g/p`.
    pub fn omega(&self, frequency: Frequency) -> f64 {
        match frequency {
            Frequency::Omega(omega) => omega,
            Frequency::Hz(frequency) => TAU * frequency / self.frequency_parameter(),
        }
    }

    /// The frequency parameter `p = (3g/4R)^(1/2)` in 1/s (after Eq. 2).
    pub fn frequency_parameter(&self) -> f64 {
        (0.75 * self.gravity / self.radius).sqrt()
    }
}

impl Sine {
    fn read(fields: &GroundFields, block: &Block, text: &Text) -> Result<Self, SceneError> {
        let needed = |field: &str| {
            SceneError(format!(
                "[ground] needs {field}: a sinusoid has an amplitude and a frequency; or it is a pulse, sinusoids or a record"
            ))
        };
        shaking::refuse_unused(
            text,
            "a sinusoid",
            [
                ("center", fields.center.as_ref().map(Spanned::span)),
                ("gamma", fields.gamma.as_ref().map(Spanned::span)),
            ],
        )?;
        let fields_amplitude = fields.amplitude.as_ref().ok_or_else(|| needed("amplitude"))?;
        let fields_frequency = fields.frequency.as_ref().ok_or_else(|| needed("frequency"))?;
        let (amplitude, frequency) = (text.amplitude(fields_amplitude)?, text.frequency(fields_frequency)?);
        let whole_turns =
            |phase: &Spanned<f64>| text.number("phase", phase, |phase| phase.abs() <= 1e3, "-1000 to 1000 (radians)");
        let phase = fields.phase.as_ref().map(whole_turns).transpose()?;
        let cycles_a_second = match frequency {
            Frequency::Hz(frequency) => frequency,
            Frequency::Omega(omega) => omega * block.frequency_parameter() / TAU,
        };
        let seconds = |duration: &Spanned<Duration>| {
            let (field, value, seconds) = match *duration.get_ref() {
                Duration::Seconds(seconds) => ("duration", seconds, seconds),
                Duration::Tau(tau) => ("duration", tau, tau / block.frequency_parameter()),
                Duration::Cycles(cycles) => ("duration", cycles, cycles / cycles_a_second),
            };
            let most = |_| seconds > 0.0 && seconds * cycles_a_second <= 1e4;
            text.check(field, value, &duration.span(), most, "above 0, up to 10000 cycles")?;
            Ok(seconds)
        };
        let duration = fields.duration.as_ref().map(seconds).transpose()?;
        Ok(Self { amplitude, frequency, phase, duration })
    }
}

/// Of a block that is given by one whole and one half of its lengths.
fn mixed(text: &Text, whole: &str, (half, length): (&str, &Spanned<f64>)) -> SceneError {
    let of = half.trim_start_matches("half_");
    let twice = 2.0 * length.get_ref();
    let said = format!(
        "{half} is half of the {of}, and {whole} the whole {whole} of the block; expected is {of} = {twice} beside {whole}, if that is meant, or half_width and half_height"
    );
    text.error(&length.span(), said)
}

/// The rotation and the velocity at the start.
fn start_of(fields: &StartFields, text: &Text) -> Result<(f64, f64), SceneError> {
    let number = |field, value: &Option<Spanned<f64>>, allowed, holds: fn(f64) -> bool| {
        value.as_ref().map_or(Ok(0.0), |value| text.number(field, value, holds, allowed))
    };
    let below_the_corner = "above -1 and below 1 (of alpha)";
    let rotation = number("rotation", &fields.rotation, below_the_corner, |value| value.abs() < 1.0)?;
    let velocity = number("velocity", &fields.velocity, "-1e6 to 1e6 (phi')", |value| value.abs() <= 1e6)?;
    Ok((rotation, velocity))
}

impl Ask {
    fn read(fields: &AskFields, text: &Text) -> Result<Self, SceneError> {
        let impacts = match &fields.impacts {
            None => Case::DEFAULT_IMPACTS,
            Some(impacts) => {
                let value = usize::try_from(*impacts.get_ref()).ok();
                value.filter(|value| (1..=Case::MOST_IMPACTS).contains(value)).ok_or_else(|| {
                    text.error(&impacts.span(), Invalid::new("impacts", impacts.get_ref(), "1 to 1000000"))
                })?
            }
        };
        let tolerance = fields.tolerance.as_ref().map_or(Ok(1e-6), |tolerance| {
            text.number("tolerance", tolerance, |value| (1e-15..=0.5).contains(&value), "1e-15 to 0.5 (relative)")
        })?;
        let model = match fields.model.unwrap_or_default() {
            ModelName::Linear => Model::Linear,
            ModelName::Nonlinear => Model::Nonlinear,
        };
        let what =
            fields.what.clone().filter(|what| !what.is_empty()).unwrap_or_else(|| vec![Question::ChatteringTime]);
        Ok(Self { model, what, impacts, tolerance })
    }
}

/// The JSON Schema of scene files.
///
/// # Errors
/// Never, as far as a schema can be written as JSON.
pub fn schema() -> Result<String, serde_json::Error> {
    Ok(serde_json::to_string_pretty(&schemars::schema_for!(SceneFile))? + "\n")
}
