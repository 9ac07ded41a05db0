//! What a run was asked: two parts belong together where this is the same.

use serde::{Deserialize, Serialize};

use crate::{
    cases::{case_file, generate::Named},
    gate::{identity::Identity, report::Engine, run::Selection},
    stored::{sha256, to_line},
};

/// All that the outcome of a run depends on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// The version of this program, and of its oracles with it.
    pub version: String,
    /// What the random cases and responses are made from.
    pub seed: u64,
    /// How many random cases.
    pub cases: usize,
    /// The user's own cases.
    pub own: Vec<Named>,
    /// Whether the built-in cases are run too, and the run has to prove something by itself.
    pub whole: bool,
    /// The names of the oracles, those of engines too.
    pub oracles: Vec<String>,
    /// The names of the judges.
    pub judges: Vec<String>,
    /// Every so many cases one is judged.
    pub judge_every: usize,
    /// How many whole responses.
    pub responses: usize,
    /// The names of the methods that follow them.
    pub responders: Vec<String>,
    /// The engines.
    pub engines: Vec<EngineAsked>,
    /// All cases of the run, to the last bit: those near a critical amplitude are computed.
    pub all: Identity,
}

/// An engine, as far as the verdict on it depends on more than its answers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EngineAsked {
    /// Who it says it is, its receipt, and what is granted it.
    pub engine: Engine,
    /// The equation that it solves, `linear` or `nonlinear`.
    pub model: String,
    /// The largest share of the cases of a run that it may decline.
    pub may_decline: f64,
    /// Whether it never says that a block comes to rest, as its manifest has it.
    pub never_at_rest: bool,
    /// The checksum of the manifest that it is in.
    pub manifest: String,
}

impl Request {
    /// Which cases it is made of, besides the user's own.
    pub fn selection(&self) -> Selection {
        Selection { cases: self.cases, seed: self.seed }
    }

    /// What tells this request from every other.
    pub fn hash(&self) -> String {
        let fields: String = self.fields().into_iter().map(|(name, value)| format!("{name}={value}\n")).collect();
        sha256(fields.as_bytes())
    }

    /// The first thing in which another request differs: what it is, what it is there, and what it is here.
    pub fn difference(&self, other: &Self) -> Option<(String, [String; 2])> {
        let (mine, theirs) = (self.fields(), other.fields());
        let differs = mine.iter().zip(&theirs).find(|(mine, theirs)| mine != theirs);
        let (name, [there, here]) = match differs {
            Some(((name, here), (other, there))) if name == other => (name.clone(), [there.clone(), here.clone()]),
            Some(((name, here), (other, there))) => {
                ("what is asked".to_owned(), [format!("{other} {there}"), format!("{name} {here}")])
            }
            None if mine.len() == theirs.len() => return None,
            None => ("engines".to_owned(), [theirs.len().to_string(), mine.len().to_string()]),
        };
        Some((name, [there, here].map(|value| shortened(&value))))
    }

    /// Every field by name, as text: first what others follow from.
    fn fields(&self) -> Vec<(String, String)> {
        let Self { version, seed, cases, own, whole, oracles, judges, .. } = self;
        let Self { judge_every, responses, responders, engines, all, .. } = self;
        let own_case = |named: &Named| format!("{named} {}", case_file::flags(&named.case));
        let own: Vec<String> = own.iter().map(own_case).collect();
        let mut fields: Vec<(String, String)> = [
            ("version", version.clone()),
            ("seed", seed.to_string()),
            ("cases", cases.to_string()),
            ("case-file", own.join("; ")),
            ("built-in cases", whole.to_string()),
            ("oracles", oracles.join(",")),
            ("judges", judges.join(",")),
            ("judge", judge_every.to_string()),
            ("responses", responses.to_string()),
            ("responders", responders.join(",")),
        ]
        .map(|(name, value)| (name.to_owned(), value))
        .to_vec();
        for EngineAsked { engine, model, may_decline, never_at_rest, manifest } in engines {
            let Engine { name, says, receipt, .. } = engine;
            let receipt = if receipt.is_empty() { String::new() } else { format!("; {receipt}") };
            fields.push((format!("engine {name}"), format!("{says}{receipt}")));
            fields.push((format!("the manifest of {name}"), manifest.clone()));
            // What the manifest says, and what the engine said at its start.
            let granted = format!("{} {model} {may_decline:?} {never_at_rest}", exact(engine));
            fields.push((format!("what is granted {name}"), granted));
        }
        let Identity { cases, hash } = all;
        fields.push(("the cases, to the last bit".to_owned(), format!("{cases} with hash {hash:016x}")));
        fields
    }
}

fn exact(engine: &Engine) -> String {
    to_line(engine).unwrap_or_default()
}

/// What fits into a line that is read.
fn shortened(value: &str) -> String {
    const LONGEST: usize = 100;
    let kept: String = value.chars().take(LONGEST).collect();
    if kept.len() < value.len() { format!("{kept}...") } else { kept }
}
