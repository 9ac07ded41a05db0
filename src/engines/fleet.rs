//! The engines of a run, started.

use contract::{Case, Oracle};
use process::{Breakdown, Engine, Outcome, Tolerance, Verdict, version};

use crate::gate::{known::Known, report};

use super::{granted::Granted, manifest::Entry, record::Keeper};

/// The engines of a run.
#[derive(Default)]
pub struct Fleet {
    /// In the order of the manifest.
    pub engines: Vec<Started>,
}

/// An engine that has shaken hands.
pub struct Started {
    /// What the manifest says of it.
    pub entry: Entry,
    /// What its version command printed: the line that matches the pattern, or the first; empty without a command.
    pub receipt: String,
    /// The engine as an oracle.
    pub oracle: Granted,
}

impl Fleet {
    /// Starts these engines, each with an oracle that has derivatives, made by `sensitive`. Every line of the talk goes to the keeper.
    ///
    /// # Errors
    /// All that do not start, by name, and how they broke.
    pub fn start(
        entries: &[Entry],
        sensitive: impl Fn() -> Box<dyn Oracle>,
        keeper: &Keeper,
    ) -> Result<Self, Vec<(String, Breakdown)>> {
        let mut fleet = Self::default();
        let mut broke = Vec::new();
        for entry in entries {
            match Started::new(entry, sensitive(), keeper) {
                Ok(started) => fleet.engines.push(started),
                Err(how) => broke.push((entry.launch.name.clone(), how)),
            }
        }
        if broke.is_empty() { Ok(fleet) } else { Err(broke) }
    }

    /// The engine of this name.
    pub fn engine(&self, name: &str) -> Option<&Started> {
        self.engines.iter().find(|started| started.entry.launch.name == name)
    }

    /// Every engine as an oracle.
    pub fn oracles(&self) -> impl Iterator<Item = &dyn Oracle> {
        self.engines.iter().map(|started| &started.oracle as &dyn Oracle)
    }

    /// The failures of all of them that are known.
    pub fn known(&self) -> Vec<Known> {
        self.engines.iter().flat_map(|started| &started.entry.known).cloned().collect()
    }

    /// Stops all of them; the names of those that did not want to, and how.
    pub fn stop(self) -> Vec<(String, Breakdown)> {
        let stop = |started: Started| {
            let broke = started.oracle.into_engine().stop();
            broke.into_iter().map(move |broke| (started.entry.launch.name.clone(), broke)).collect::<Vec<_>>()
        };
        self.engines.into_iter().flat_map(stop).collect()
    }
}

/// How long an answer took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Took {
    /// How many impacts it has.
    pub impacts: usize,
    /// As it is seen from outside.
    pub seconds: f64,
    /// As the engine says itself.
    pub own_seconds: Option<f64>,
}

impl Started {
    /// How long the history took that it gave last to this case, as far as it is remembered.
    pub fn took(&self, case: &Case) -> Option<Took> {
        let answer = self.oracle.engine().remembered(case)?;
        let Outcome::History(history) = &answer.outcome else { return None };
        let own = answer.ns.filter(|ns| *ns > 0.0 && ns.is_finite());
        let (impacts, seconds) = (history.impacts.len(), answer.elapsed.as_secs_f64());
        Some(Took { impacts, seconds, own_seconds: own.map(|ns| 1e-9 * ns) })
    }

    /// Whether its errors are what the manifest grants, and not what it claims.
    pub fn is_granted(&self) -> bool {
        !self.oracle.engine().welcome().claims
    }

    /// What a report says of it.
    pub fn described(&self) -> report::Engine {
        let welcome = self.oracle.engine().welcome();
        let language = if welcome.language.is_empty() { String::new() } else { format!(", {}", welcome.language) };
        let Tolerance { time, interval, velocity, tau_ch } = self.entry.launch.tolerance;
        report::Engine {
            name: self.entry.launch.name.clone(),
            says: format!("{} {}{language}", welcome.name, welcome.version),
            receipt: self.receipt.clone(),
            claims: welcome.claims,
            granted: report::Granted { time, interval, velocity, tau_ch, reason: self.entry.reason.clone() },
        }
    }

    /// Starts an engine.
    ///
    /// # Errors
    /// How its version command or the start failed.
    pub fn new(entry: &Entry, sensitive: Box<dyn Oracle>, keeper: &Keeper) -> Result<Self, Breakdown> {
        let receipt = entry.receipt()?;
        let engine = Engine::start(entry.launch.clone(), keeper.0.clone())?;
        Ok(Self { entry: entry.clone(), receipt, oracle: Granted::new(engine, sensitive) })
    }
}

impl Entry {
    /// What the version command prints: the line that matches the pattern, or the first; empty without a command.
    ///
    /// # Errors
    /// When the command fails, or no line matches.
    pub fn receipt(&self) -> Result<String, Breakdown> {
        let Some(command) = &self.version else { return Ok(String::new()) };
        let lines = version(&self.launch, command)?;
        let wanted = self.pattern.as_deref().unwrap_or("*");
        match lines.iter().find(|line| matches(wanted, line)) {
            Some(line) => Ok(line.clone()),
            None => Err(Breakdown {
                verdict: Verdict::AnotherVersion,
                happened: format!("{wanted:?} is wanted, {} prints {:?}", command.join(" "), lines.join(" | ")),
                stderr: String::new(),
            }),
        }
    }
}

/// Whether a text is as the pattern says, in which `*` stands for anything.
fn matches(pattern: &str, text: &str) -> bool {
    let mut pieces = pattern.split('*');
    let first = pieces.next().unwrap_or_default();
    let Some(mut rest) = text.strip_prefix(first) else { return false };
    let Some(last) = pieces.next_back() else { return rest.is_empty() };
    for piece in pieces {
        let Some(at) = rest.find(piece) else { return false };
        rest = rest.get(at + piece.len()..).unwrap_or_default();
    }
    rest.ends_with(last)
}

#[cfg(test)]
mod tests {
    use super::matches;

    #[test]
    fn a_star_stands_for_anything() {
        for (pattern, text, is_match) in [
            ("Python 3.11.2", "Python 3.11.2", true),
            ("Python 3.11.2", "Python 3.11.20", false),
            ("Python 3.*", "Python 3.11.2", true),
            ("Python 3.*", "Python 2.7", false),
            ("*", "", true),
            ("*3*2", "Python 3.11.2", true),
            ("*3*3", "Python 3.11.2", false),
            ("a*a", "a", false),
            ("", "x", false),
        ] {
            assert_eq!(matches(pattern, text), is_match, "{pattern} {text}");
        }
    }
}
