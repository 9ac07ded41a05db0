//! Where cases come from. Every generator is a function of the seed alone, so the same seed gives the same cases on any machine and any
//! number of threads.

mod edge;
mod list;
mod motions;
mod random;
mod responses;
mod spaced;

use std::fmt;

use contract::{Case, Invalid, Oracle};
use serde::{Deserialize, Serialize};

use super::case_file::CaseFields;

pub use list::shipped;
pub use motions::motions;
pub use responses::shakings;

/// The generators, in the order in which their cases run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Generator {
    /// The user's own cases.
    Own,
    /// The curated list in `data/cases`: those of the paper, and every bug that was found.
    List,
    /// Towards `a = 1` and `a = a_cr` by ever smaller steps, and the corners of the parameters.
    Edge,
    /// A grid.
    Spaced,
    /// At random, seeded.
    Random,
}

/// A case with its origin, as in `random/17`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(into = "Written", try_from = "Written")]
pub struct Named {
    /// Which generator made it.
    pub generator: Generator,
    /// What distinguishes it among the cases of its generator.
    pub name: String,
    /// The case itself.
    pub case: Case,
}

/// A named case as it is written.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    name: String,
    case: CaseFields,
}

impl From<Named> for Written {
    fn from(named: Named) -> Self {
        Self { name: named.to_string(), case: CaseFields::from(&named.case) }
    }
}

impl TryFrom<Written> for Named {
    type Error = Invalid;

    fn try_from(written: Written) -> Result<Self, Invalid> {
        Ok(Self::parse(&written.name, written.case.case()?))
    }
}

impl Named {
    /// A case under the name that it was shown by; one that no generator made counts as listed.
    pub fn parse(shown: &str, case: Case) -> Self {
        let of = |generator: &Generator| shown.strip_prefix(generator.name())?.strip_prefix('/').map(str::to_owned);
        let found =
            [Generator::Own].into_iter().chain(Generator::ALL).find_map(|generator| Some((generator, of(&generator)?)));
        let (generator, name) = found.unwrap_or((Generator::List, shown.to_owned()));
        Self { generator, name, case }
    }
}

impl fmt::Display for Named {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.generator.name(), self.name)
    }
}

impl Generator {
    /// Every generator that makes cases itself.
    pub const ALL: [Self; 4] = [Self::List, Self::Edge, Self::Spaced, Self::Random];

    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Own => "own",
            Self::List => "list",
            Self::Edge => "edge",
            Self::Spaced => "spaced",
            Self::Random => "random",
        }
    }

    /// The cases of this generator. `random` is how many the random one makes, `seed` what from; `stepper` finds the critical
    /// amplitudes that the edge generator walks towards.
    pub fn cases(self, seed: u64, random: usize, stepper: &dyn Oracle) -> Vec<Named> {
        let cases: Vec<(String, Case)> = match self {
            Self::Own => Vec::new(),
            Self::List => shipped().into_iter().map(|listed| (listed.name, listed.case)).collect(),
            Self::Edge => edge::cases(stepper),
            Self::Spaced => spaced::cases(),
            Self::Random => random::cases(seed, random),
        };
        cases.into_iter().map(|(name, case)| Named { generator: self, name, case }).collect()
    }
}

/// As many impacts as it takes for the sequence to become geometric and the closure of its sum to lose nothing: until the velocity has
/// fallen by some two hundred times, and 40 at least.
fn impacts_for(eta: f64) -> usize {
    ((-5.3 / eta.ln()).ceil() as usize).clamp(40, 600)
}

/// A case that the generators put together themselves, so it can only be wrong if they are.
fn case(epsilon: f64, omega: f64, eta: f64, alpha: f64) -> Option<Case> {
    use contract::{Normalisation, Slenderness};
    let slenderness = Slenderness::new(alpha, Normalisation::Threshold).ok()?;
    let case = Case::from_epsilon(epsilon, omega, eta).ok()?.with_slenderness(slenderness);
    case.with_max_impacts(impacts_for(eta)).ok()
}
