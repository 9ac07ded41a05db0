//! How an engine is started, and what is granted to it.

use std::{collections::BTreeMap, path::PathBuf, time::Duration};

use contract::{Invalid, Model, Normalisation};
use serde::{Deserialize, Deserializer};

/// How an engine is started, and what is granted to it. Read from a table, the names are those of the fields with dashes, times are in seconds, and a name
/// that is not known is an error.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Launch {
    /// The name that reports use.
    pub name: String,
    /// The program and its arguments. No shell reads them.
    pub run: Vec<String>,
    /// Where it is run.
    #[serde(default = "here")]
    pub directory: PathBuf,
    /// What is added to the environment.
    #[serde(default)]
    pub environment: BTreeMap<String, String>,
    /// How long it may take to answer the start.
    #[serde(default = "ten_seconds", deserialize_with = "seconds")]
    pub start_timeout: Duration,
    /// How long it may take for one case. A batch may take as many times as long as it has cases.
    #[serde(default = "ten_seconds", deserialize_with = "seconds")]
    pub case_timeout: Duration,
    /// How long it may take to end when it is told to.
    #[serde(default = "two_seconds", deserialize_with = "seconds")]
    pub grace: Duration,
    /// The equation of motion that it is asked to solve.
    #[serde(deserialize_with = "model")]
    pub model: Model,
    /// What the amplitude is a multiple of in cases without a slenderness.
    #[serde(default = "threshold", deserialize_with = "normalisation")]
    pub normalisation: Normalisation,
    /// The errors granted where the engine claims none.
    #[serde(default)]
    pub tolerance: Tolerance,
    /// How many processes of it run side by side.
    #[serde(default = "one")]
    pub processes: usize,
    /// How often processes of it may break before the rest is not asked any more.
    #[serde(default = "twenty")]
    pub restarts: usize,
}

/// The errors granted to an engine where it claims none: the user's, not the engine's. Zero unless given.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Tolerance {
    /// Of a time, absolute in `τ`.
    pub time: f64,
    /// Of an interval, relative.
    pub interval: f64,
    /// Of a velocity, relative.
    pub velocity: f64,
    /// Of the chattering time, absolute in `τ`.
    pub tau_ch: f64,
}

impl Launch {
    /// The engine of this name that is run so, with the defaults for the rest: here, ten seconds for the start and for a case, one process.
    pub fn new(name: impl Into<String>, run: impl IntoIterator<Item = impl Into<String>>, model: Model) -> Self {
        Self {
            name: name.into(),
            run: run.into_iter().map(Into::into).collect(),
            directory: here(),
            environment: BTreeMap::new(),
            start_timeout: ten_seconds(),
            case_timeout: ten_seconds(),
            grace: two_seconds(),
            model,
            normalisation: threshold(),
            tolerance: Tolerance::default(),
            processes: one(),
            restarts: twenty(),
        }
    }

    /// Whether every setting is one that can be used.
    ///
    /// # Errors
    /// The first that is not, with its value and what is allowed.
    pub fn check(&self) -> Result<(), Invalid> {
        let Tolerance { time, interval, velocity, tau_ch } = self.tolerance;
        for (field, value) in [
            ("tolerance.time", time),
            ("tolerance.interval", interval),
            ("tolerance.velocity", velocity),
            ("tolerance.tau_ch", tau_ch),
        ] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(Invalid::new(field, format!("{value:?}"), "0 or more, and finite"));
            }
        }
        for (field, value) in
            [("start-timeout", self.start_timeout), ("case-timeout", self.case_timeout), ("grace", self.grace)]
        {
            if value.is_zero() || value > LONGEST {
                return Err(Invalid::new(field, format!("{} s", value.as_secs_f64()), "above 0 s, at most a day"));
            }
        }
        if self.run.first().is_none_or(String::is_empty) {
            return Err(Invalid::new("run", format!("{:?}", self.run), "the program first, then its arguments"));
        }
        if !(1..=MOST_PROCESSES).contains(&self.processes) {
            return Err(Invalid::new("processes", self.processes, "1 to 256"));
        }
        Ok(())
    }
}

const LONGEST: Duration = Duration::from_secs(86_400);
const MOST_PROCESSES: usize = 256;

fn here() -> PathBuf {
    PathBuf::from(".")
}

fn ten_seconds() -> Duration {
    Duration::from_secs(10)
}

fn two_seconds() -> Duration {
    Duration::from_secs(2)
}

fn threshold() -> Normalisation {
    Normalisation::Threshold
}

fn one() -> usize {
    1
}

fn twenty() -> usize {
    20
}

fn seconds<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Duration, D::Error> {
    let seconds = f64::deserialize(deserializer)?;
    Duration::try_from_secs_f64(seconds)
        .map_err(|_| serde::de::Error::custom(format!("{seconds} is no time in seconds")))
}

fn model<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Model, D::Error> {
    #[derive(Deserialize)]
    #[serde(rename_all = "kebab-case")]
    enum Word {
        Linear,
        Nonlinear,
    }
    Ok(match Word::deserialize(deserializer)? {
        Word::Linear => Model::Linear,
        Word::Nonlinear => Model::Nonlinear,
    })
}

fn normalisation<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Normalisation, D::Error> {
    #[derive(Deserialize)]
    #[serde(rename_all = "kebab-case")]
    enum Word {
        Threshold,
        Slender,
    }
    Ok(match Word::deserialize(deserializer)? {
        Word::Threshold => Normalisation::Threshold,
        Word::Slender => Normalisation::Slender,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names that a manifest uses, and what it may leave out.
    #[test]
    fn a_table_becomes_a_launch() {
        let table = r#"{"name":"mine","run":["python3","mine.py"],"model":"nonlinear","normalisation":"slender",
            "case-timeout":0.5,"tolerance":{"time":1e-9},"processes":2}"#;
        let read: Launch = serde_json::from_str(table).unwrap();
        let mut written = Launch::new("mine", ["python3", "mine.py"], Model::Nonlinear);
        written.normalisation = Normalisation::Slender;
        written.case_timeout = Duration::from_millis(500);
        written.tolerance.time = 1e-9;
        written.processes = 2;
        assert_eq!(read, written);
        assert_eq!(read.check(), Ok(()));
        let slip = serde_json::from_str::<Launch>(r#"{"name":"mine","run":["x"],"model":"linear","case_timeout":1}"#);
        assert!(slip.unwrap_err().to_string().contains("unknown field `case_timeout`"));
    }

    /// A setting that can't be used is named, with its value.
    #[test]
    fn unusable_settings_are_named() {
        let told = |change: fn(&mut Launch)| {
            let mut launch = Launch::new("mine", ["x"], Model::Linear);
            change(&mut launch);
            launch.check().unwrap_err().to_string()
        };
        assert!(told(|launch| launch.tolerance.velocity = f64::NAN).starts_with("tolerance.velocity = NaN"));
        assert!(told(|launch| launch.case_timeout = Duration::ZERO).starts_with("case-timeout = 0 s"));
        assert!(told(|launch| launch.run.clear()).starts_with("run = []"));
        assert!(told(|launch| launch.processes = 0).starts_with("processes = 0"));
    }
}
