//! How a scene is written in TOML. What the values mean and may be is for [`super`] to say.

use schemars::JsonSchema;
use serde::{
    Deserialize, Deserializer,
    de::{DeserializeOwned, Error},
};
use toml::Spanned;

use crate::cases::toml_error::Allowed;

/// What is allowed for each field, in words.
pub const ALLOWED: [Allowed; 43] = [
    ("title", "a text in quotes"),
    ("block", "a table [block]"),
    ("ground", "a table [ground]"),
    ("ask", "a table [ask]"),
    ("start", "a table [start]"),
    ("width", "a number, 1e-6 to 1e6 (metres)"),
    ("height", "a number, 1e-6 to 1e6 (metres)"),
    ("half_width", "a number, 1e-6 to 1e6 (metres)"),
    ("half_height", "a number, 1e-6 to 1e6 (metres)"),
    ("radius", "a number, 1e-6 to 1e6 (metres)"),
    ("slenderness", "a number, 1e-100 <= slenderness < pi/2 (radians)"),
    ("restitution", RESTITUTIONS),
    ("gravity", "a number, 1e-6 to 1e6 (m/s^2)"),
    ("amplitude", AMPLITUDES),
    ("frequency", FREQUENCIES),
    ("phase", "a number, -1000 to 1000 (radians)"),
    ("duration", DURATIONS),
    ("model", "\"linear\" or \"nonlinear\""),
    ("what", QUESTIONS),
    ("impacts", "a whole number, 1 to 1000000"),
    ("tolerance", "a number, 1e-15 to 0.5 (relative)"),
    ("hz", "a number, 1e-9 to 1e9 (cycles a second)"),
    ("g", "a number, 0 to 1e6"),
    ("m-per-s2", "a number, 0 to 1e6"),
    ("over-threshold", "a number, 0 to 1e6"),
    ("over-slender-threshold", "a number, 0 to 1e6"),
    ("omega", "a number, 1e-9 to 1e9 (over p)"),
    ("pulse", PULSES),
    ("center", TIMES),
    ("gamma", "a number, 1e-3 to 1e3"),
    ("sinusoids", "a list of { amplitude = .., frequency = .., phase = .. }, one at least"),
    ("record", RECORDS),
    ("file", "a text in quotes: the path of the record, from where the scene is"),
    ("units", UNITS),
    ("scale", "a number, -1e6 to 1e6"),
    ("direction", "1, or -1 for the other way round"),
    ("time_scale", "a number, 1e-6 to 1e6"),
    ("dt", TIMES),
    ("column", "a whole number, 1 to 1000"),
    ("rotation", "a number, of alpha, with its sign"),
    ("velocity", "a number (phi')"),
    ("tau", "a number above 0, up to 1e9"),
    ("seconds", "a number above 0, up to 1e9"),
];
const RESTITUTIONS: &str = "a number above 0 and below 1, or \"housner\"";
const AMPLITUDES: &str =
    "one of { g = number }, { m-per-s2 = number }, { over-threshold = number } or { over-slender-threshold = number }";
const FREQUENCIES: &str = "one of { hz = number } or { omega = number }";
const DURATIONS: &str = "one of { seconds = number }, { tau = number } or { cycles = number }";
const TIMES: &str = "one of { seconds = number } or { tau = number }";
const PULSES: &str =
    "one of \"one-sine\", \"one-cosine\", \"ricker\", \"ricker-antisymmetric\" or \"mavroeidis-papageorgiou\"";
const RECORDS: &str =
    "a table { file = \"..\", units = \"..\" }, with scale, direction, time_scale, dt and column where they are needed";
const UNITS: &str = "one of \"g\", \"m/s2\", \"cm/s2\" or \"threshold\"";
const QUESTIONS: &str =
    "a list of at least one of \"impact-times\", \"chattering-time\", \"response\" and \"rest-periods\", each once";

/// A rigid block on shaking ground, in physical units, and what is asked of it.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "chattercheck scene")]
pub struct SceneFile {
    /// What the scene is, for people.
    pub title: Option<String>,
    /// The block.
    pub block: BlockFields,
    /// The motion of the ground.
    pub ground: GroundFields,
    /// How the block is at the start; at rest unless given.
    pub start: Option<StartFields>,
    /// What is asked.
    #[serde(default)]
    pub ask: AskFields,
}

/// The block: its size by `width` and `height`, by half of them, `half_width` and `half_height`, or by `radius` and `slenderness`.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BlockFields {
    /// The width of the base, `2b`, in metres; above 0.
    #[schemars(with = "Option<f64>")]
    pub width: Option<Spanned<f64>>,
    /// The height, `2h`, in metres; above 0.
    #[schemars(with = "Option<f64>")]
    pub height: Option<Spanned<f64>>,
    /// Half of the width of the base, `b`, in metres; above 0.
    #[schemars(with = "Option<f64>")]
    pub half_width: Option<Spanned<f64>>,
    /// Half of the height, `h`, in metres; above 0.
    #[schemars(with = "Option<f64>")]
    pub half_height: Option<Spanned<f64>>,
    /// Half of the diagonal, `R`, in metres; above 0.
    #[schemars(with = "Option<f64>")]
    pub radius: Option<Spanned<f64>>,
    /// The slenderness angle `α = atan(b/h)` in radians; inside (0, π/2).
    #[schemars(with = "Option<f64>")]
    pub slenderness: Option<Spanned<f64>>,
    /// The coefficient of restitution `η` of the velocity, inside (0, 1); or `"housner"`, which is `1 - 3/2 sin²α`, from the conservation of
    /// angular momentum.
    #[schemars(with = "Restitution")]
    pub restitution: Spanned<Restitution>,
    /// The acceleration of gravity in m/s²; 9.81 unless given.
    #[schemars(with = "Option<f64>")]
    pub gravity: Option<Spanned<f64>>,
}

/// A number, or a rule.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "restitution: allowed is a number above 0 and below 1, or \"housner\"")]
pub enum Restitution {
    /// The value.
    Value(f64),
    /// A rule that gives it.
    Rule(RestitutionRule),
}

/// A rule that gives the restitution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RestitutionRule {
    /// Conservation of angular momentum about the new corner: `1 - 3/2 sin²α`.
    Housner,
}

/// The acceleration of the ground from `t = 0` on: a sinusoid, `A sin(2π f t + phase)`, by its amplitude and frequency; or a named pulse, a sum of sinusoids, or a
/// record.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GroundFields {
    /// The amplitude; of a pulse its peak, but for that of Mavroeidis and Papageorgiou: there it is `ω` times the amplitude of the velocity.
    #[schemars(with = "Option<Amplitude>")]
    #[serde(default, deserialize_with = "amplitude_if_any")]
    pub amplitude: Option<Spanned<Amplitude>>,
    /// The frequency.
    #[schemars(with = "Option<Frequency>")]
    #[serde(default, deserialize_with = "frequency_if_any")]
    pub frequency: Option<Spanned<Frequency>>,
    /// The phase at `t = 0` in radians. Unless given the motion starts at the threshold, so that the block begins to rock at once; one that stays below it starts at
    /// its peak.
    #[schemars(with = "Option<f64>")]
    pub phase: Option<Spanned<f64>>,
    /// How long the ground moves; without end unless given.
    #[schemars(with = "Option<Duration>")]
    #[serde(default, deserialize_with = "duration")]
    pub duration: Option<Spanned<Duration>>,
    /// The name of a pulse.
    #[schemars(with = "Option<PulseName>")]
    pub pulse: Option<Spanned<PulseName>>,
    /// When the middle of a Ricker wavelet is; it lasts twice as long.
    #[schemars(with = "Option<Time>")]
    #[serde(default, deserialize_with = "time")]
    pub center: Option<Spanned<Time>>,
    /// How many cycles the envelope of a pulse of Mavroeidis and Papageorgiou lasts, `γ`; its `ν` is `phase`.
    #[schemars(with = "Option<f64>")]
    pub gamma: Option<Spanned<f64>>,
    /// Sinusoids that are added up, over `duration`.
    #[schemars(with = "Option<Vec<SineFields>>")]
    pub sinusoids: Option<Spanned<Vec<SineFields>>>,
    /// A recorded motion.
    pub record: Option<RecordFields>,
}

/// A pulse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PulseName {
    /// One period of a sine.
    OneSine,
    /// One period of a cosine.
    OneCosine,
    /// The wavelet of Ricker, symmetric.
    Ricker,
    /// The wavelet of Ricker, antisymmetric.
    RickerAntisymmetric,
    /// That of Mavroeidis and Papageorgiou (2003).
    MavroeidisPapageorgiou,
}

/// One of several sinusoids.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SineFields {
    /// The amplitude.
    #[schemars(with = "Amplitude")]
    #[serde(deserialize_with = "amplitude")]
    pub amplitude: Spanned<Amplitude>,
    /// The frequency.
    #[schemars(with = "Frequency")]
    #[serde(deserialize_with = "frequency")]
    pub frequency: Spanned<Frequency>,
    /// The phase at `t = 0` in radians; 0 unless given.
    #[schemars(with = "Option<f64>")]
    pub phase: Option<Spanned<f64>>,
}

/// A recorded motion of the ground: samples at `k dt`, linear in between, nothing before the first and after the last. Nothing is corrected or filtered.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordFields {
    /// The path of the file, from where the scene is.
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// What the numbers in the file are in: `g`, `m/s2`, `cm/s2` or `threshold`, the acceleration at which the block begins to rock.
    #[schemars(with = "Option<String>")]
    pub units: Option<Spanned<String>>,
    /// What the samples are multiplied with, of either sign; 1 unless given.
    #[schemars(with = "Option<f64>")]
    pub scale: Option<Spanned<f64>>,
    /// 1, or -1 for the other way round; 1 unless given.
    #[schemars(with = "Option<i8>")]
    pub direction: Option<Spanned<i64>>,
    /// What the times are multiplied with; 1 unless given.
    #[schemars(with = "Option<f64>")]
    pub time_scale: Option<Spanned<f64>>,
    /// The time between samples, where the file does not say.
    #[schemars(with = "Option<Time>")]
    #[serde(default, deserialize_with = "time")]
    pub dt: Option<Spanned<Time>>,
    /// Which column of a table, the first being 1.
    #[schemars(with = "Option<u32>")]
    pub column: Option<Spanned<i64>>,
}

/// How the block is at the start.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartFields {
    /// The rotation as a share of `α`, with its sign; 0 unless given.
    #[schemars(with = "Option<f64>")]
    pub rotation: Option<Spanned<f64>>,
    /// The velocity `φ'`, with its sign; 0 unless given.
    #[schemars(with = "Option<f64>")]
    pub velocity: Option<Spanned<f64>>,
}

/// A time, above 0, in one of two ways.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Time {
    /// In seconds.
    Seconds(f64),
    /// In `1/p` of the block.
    Tau(f64),
}

/// The amplitude of the ground acceleration, from 0 on, in one of four ways.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Amplitude {
    /// In units of the scene's gravity.
    G(f64),
    /// In m/s².
    MPerS2(f64),
    /// Over the threshold of rocking, `g tan α` (Eq. 1): the `a` of the threshold normalisation.
    OverThreshold(f64),
    /// Over `g α`: the `a` of Eq. 5, of the slender normalisation.
    OverSlenderThreshold(f64),
}

/// The frequency of the ground motion, above 0, in one of two ways.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Frequency {
    /// In cycles a second.
    Hz(f64),
    /// The ratio `ω = ω_g/p` to the frequency parameter of the block.
    Omega(f64),
}

/// How long the ground moves, in one of three ways.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Duration {
    /// In seconds.
    Seconds(f64),
    /// In `1/p` of the block.
    Tau(f64),
    /// In cycles of the ground motion.
    Cycles(f64),
}

/// The value of a field in one of several ways; the error names all of them.
fn in_one_way<'de, D: Deserializer<'de>, T: DeserializeOwned>(
    deserializer: D,
    field: &str,
    allowed: &str,
) -> Result<Spanned<T>, D::Error> {
    let value = Spanned::<toml::Value>::deserialize(deserializer)?;
    let way = value.get_ref().clone().try_into();
    let way = way.map_err(|_: toml::de::Error| D::Error::custom(format!("{field}: allowed is {allowed}")))?;
    Ok(Spanned::new(value.span(), way))
}

fn amplitude<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Spanned<Amplitude>, D::Error> {
    in_one_way(deserializer, "amplitude", AMPLITUDES)
}

fn frequency<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Spanned<Frequency>, D::Error> {
    in_one_way(deserializer, "frequency", FREQUENCIES)
}

fn amplitude_if_any<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Spanned<Amplitude>>, D::Error> {
    amplitude(deserializer).map(Some)
}

fn frequency_if_any<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Spanned<Frequency>>, D::Error> {
    frequency(deserializer).map(Some)
}

fn time<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Spanned<Time>>, D::Error> {
    in_one_way(deserializer, "time", TIMES).map(Some)
}

fn duration<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Spanned<Duration>>, D::Error> {
    in_one_way(deserializer, "duration", DURATIONS).map(Some)
}

/// An empty list asks nothing, and the same twice is a mistake.
fn questions<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Vec<Question>>, D::Error> {
    let what = Vec::<Question>::deserialize(deserializer)?;
    let twice = what.iter().enumerate().any(|(place, one)| what.iter().take(place).any(|other| other == one));
    if what.is_empty() || twice {
        return Err(D::Error::custom(format!("what: allowed is {QUESTIONS}")));
    }
    Ok(Some(what))
}

/// What is asked of the scene: `chattercheck scene` answers it. Other commands do as their flags say, but for the model and the number of impacts.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AskFields {
    /// The equation of motion; `nonlinear` unless given.
    pub model: Option<ModelName>,
    /// What is wanted, each once; the chattering time unless given.
    #[serde(default, deserialize_with = "questions")]
    pub what: Option<Vec<Question>>,
    /// How many impacts are listed at the most, 1 to 1000000; 60 unless given.
    #[schemars(with = "Option<u32>", range(min = 1, max = 1_000_000))]
    pub impacts: Option<Spanned<i64>>,
    /// How accurately, relative, 1e-15 to 0.5; 1e-6 unless given.
    #[schemars(with = "Option<f64>", range(min = 1e-15, max = 0.5))]
    pub tolerance: Option<Spanned<f64>>,
}

/// An equation of motion.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ModelName {
    /// The slender block, Eq. 4.
    Linear,
    /// The block as it is, Eq. 2.
    #[default]
    Nonlinear,
}

/// Something that can be asked of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Question {
    /// The times of the impacts.
    ImpactTimes,
    /// When the chattering comes to rest.
    ChatteringTime,
    /// The whole response.
    Response,
    /// When the block rests.
    RestPeriods,
}
