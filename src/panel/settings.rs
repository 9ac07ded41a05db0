//! The settings of a method, in the words of the command line, and the refusal of one that it does not use.

use contract::Invalid;

use super::Method;

/// A setting that not every method uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Setting {
    /// The equation of motion.
    Model,
    /// The solver of differential equations.
    Method,
    /// Each flight in its own units, or all on one clock.
    Flights,
    /// The relative tolerance of a solver.
    Rtol,
    /// How many terms of a series.
    Order,
    /// The largest relative error of the chattering time that is accepted.
    Tolerance,
    /// How many digits are to be proven.
    Digits,
}

impl Setting {
    /// All of them.
    pub const ALL: [Self; 7] =
        [Self::Model, Self::Method, Self::Flights, Self::Rtol, Self::Order, Self::Tolerance, Self::Digits];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Model => "model",
            Self::Method => "method",
            Self::Flights => "flights",
            Self::Rtol => "rtol",
            Self::Order => "order",
            Self::Tolerance => "tolerance",
            Self::Digits => "digits",
        }
    }
}

/// Settings of an oracle in the words of the command line; `None` means its default.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Settings<'a> {
    /// The equation of motion: `linear` or `nonlinear`. Every method takes that which it solves.
    pub equation: Option<&'a str>,
    /// For ode: `tsit45`, `bdf`, `tr-bdf2` or `esdirk34`.
    pub method: Option<&'a str>,
    /// For ode: `rescaled` or `naive`.
    pub flights: Option<&'a str>,
    /// For ode: the relative tolerance.
    pub rtol: Option<f64>,
    /// For asymptotic: `paper`, how many terms, or `resummed`.
    pub order: Option<&'a str>,
    /// For asymptotic: the largest relative error of the chattering time that is accepted.
    pub tolerance: Option<f64>,
    /// For enclosure: how many digits are to be proven.
    pub digits: Option<i64>,
}

impl<'a> Settings<'a> {
    /// The value of a setting, as it is written.
    pub fn get(&self, setting: Setting) -> Option<String> {
        match setting {
            Setting::Model => self.equation.map(str::to_owned),
            Setting::Method => self.method.map(str::to_owned),
            Setting::Flights => self.flights.map(str::to_owned),
            Setting::Order => self.order.map(str::to_owned),
            Setting::Rtol => self.rtol.map(|rtol| rtol.to_string()),
            Setting::Tolerance => self.tolerance.map(|tolerance| tolerance.to_string()),
            Setting::Digits => self.digits.map(|digits| digits.to_string()),
        }
    }

    /// Those that are given, with their values.
    pub fn given(&self) -> impl Iterator<Item = (Setting, String)> {
        Setting::ALL.into_iter().filter_map(|setting| Some((setting, self.get(setting)?)))
    }

    /// Sets one of those that the name of an oracle says.
    pub(super) fn set(&mut self, setting: Setting, value: &'a str) {
        match setting {
            Setting::Model => self.equation = Some(value),
            Setting::Method => self.method = Some(value),
            Setting::Flights => self.flights = Some(value),
            Setting::Order => self.order = Some(value),
            Setting::Rtol | Setting::Tolerance | Setting::Digits => {}
        }
    }
}

impl Method {
    /// Whether it uses a setting.
    pub fn uses(&self, setting: Setting) -> bool {
        setting == Setting::Model || self.in_name.contains(&setting) || self.beside.contains(&setting)
    }

    /// An error that names the first of the settings that it does not use.
    pub(super) fn refuse_unused(&self, settings: &Settings) -> Result<(), Refused> {
        match settings.given().find(|(setting, _)| !self.uses(*setting)) {
            Some((setting, value)) => {
                Err(Refused::unused(setting.name(), value, self.name, |method| method.uses(setting)))
            }
            None => Ok(()),
        }
    }
}

/// Why there is no oracle for what was asked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Refused {
    /// A value is not allowed, or a name not known.
    #[error(transparent)]
    Invalid(#[from] Invalid),
    /// The method does not use an option.
    #[error("{option} = {value} is not used by {method}; only with --oracle {users}")]
    Unused {
        /// The option.
        option: &'static str,
        /// Its value.
        value: String,
        /// The method that was asked for.
        method: String,
        /// The methods that do use it.
        users: String,
    },
    /// The name of the oracle says something else already.
    #[error("{option} = {value} is not used by {oracle}, whose name says its {option}; only with --oracle {method}")]
    InName {
        /// The option.
        option: &'static str,
        /// Its value.
        value: String,
        /// The name that was asked for.
        oracle: String,
        /// The method.
        method: &'static str,
    },
    /// No method uses everything that was given.
    #[error("no method uses all of {options}; `--help` says which method uses what")]
    NoMethod {
        /// What was given.
        options: String,
    },
}

impl Refused {
    /// An option that `method` does not use; the methods of the table for which `uses` holds do.
    pub fn unused(option: &'static str, value: impl ToString, method: &str, uses: impl Fn(&Method) -> bool) -> Self {
        let users: Vec<&str> = super::methods().filter(|method| uses(method)).map(|method| method.name).collect();
        let users = match users.split_last() {
            Some((last, [])) => (*last).to_owned(),
            Some((last, first)) => format!("{} or {last}", first.join(", ")),
            None => "of another program".to_owned(),
        };
        Self::Unused { option, value: value.to_string(), method: method.to_owned(), users }
    }
}
