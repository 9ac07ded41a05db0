//! How an engine is started, and what is granted to it.

use std::{collections::BTreeMap, path::PathBuf, time::Duration};

use contract::{Invalid, Model, Normalisation};

/// How an engine is started, and what is granted to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Launch {
    /// The name that reports use.
    pub name: String,
    /// The program and its arguments. No shell reads them.
    pub run: Vec<String>,
    /// Where it is run.
    pub directory: PathBuf,
    /// What is added to the environment.
    pub environment: BTreeMap<String, String>,
    /// How long it may take to answer the start.
    pub start_timeout: Duration,
    /// How long it may take for one case. A batch may take as many times as long as it has cases.
    pub case_timeout: Duration,
    /// How long it may take to end when it is told to.
    pub grace: Duration,
    /// The equation of motion that it is asked to solve.
    pub model: Model,
    /// What the amplitude is a multiple of in cases without a slenderness.
    pub normalisation: Normalisation,
    /// The errors granted where the engine claims none.
    pub tolerance: Tolerance,
    /// How many processes of it run side by side.
    pub processes: usize,
    /// How often processes of it may break before the rest is not asked any more.
    pub restarts: usize,
}

/// The errors granted to an engine where it claims none: the user's, not the engine's. Zero unless given.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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
            directory: PathBuf::from("."),
            environment: BTreeMap::new(),
            start_timeout: Duration::from_secs(10),
            case_timeout: Duration::from_secs(10),
            grace: Duration::from_secs(2),
            model,
            normalisation: Normalisation::Threshold,
            tolerance: Tolerance::default(),
            processes: 1,
            restarts: 20,
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
            ("tolerance.tau-ch", tau_ch),
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

#[cfg(test)]
mod tests {
    use super::*;

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
