//! What is counted over the whole responses of a run.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::{
    examine::{Compared, Examination},
    reach::Example,
    relations::Relation,
};
use crate::gate::counting::add_counts;

/// What was run, and what was compared of it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Tally {
    /// Which responses, in order.
    pub names: Vec<String>,
    /// Those that were not run because the run was interrupted.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<String>,
    /// How many were run.
    pub responses: usize,
    /// Of them, in how many it is too close to call what happens from some time on.
    pub too_close: usize,
    /// How many were examples of what; those of both models count once each.
    pub reach: BTreeMap<Example, usize>,
    /// How many pairs of answers were compared between which a change lies that must not matter.
    #[serde(default)]
    pub relations: BTreeMap<Relation, usize>,
    /// What was compared of each method.
    pub methods: BTreeMap<String, MethodCounts>,
}

/// What was compared of one method.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct MethodCounts {
    /// How many responses it gave.
    pub answered: usize,
    /// How many it declined.
    pub declined: usize,
    /// How many bouts it gave.
    pub bouts: usize,
    /// How many of its impacts were compared.
    pub impacts: usize,
    /// How many rows of its tables.
    pub rows: usize,
    /// How many of its responses were wrong.
    pub wrong: usize,
    /// How many of its answers were compared with one to the same question in another form.
    #[serde(default)]
    pub related: usize,
    /// How often it was compared when the block comes to rest, of a method that foretells that and lists no impacts.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub rests: usize,
    /// The largest share of what was allowed that an impact used, or of such a method a rest, where nothing was wrong.
    pub used: f64,
}

fn is_zero(count: &usize) -> bool {
    *count == 0
}

impl Tally {
    /// Adds what was counted over other responses of the same run.
    pub(super) fn add_all(&mut self, other: Self) {
        self.names.extend(other.names);
        self.left_out.extend(other.left_out);
        self.responses += other.responses;
        self.too_close += other.too_close;
        add_counts(&mut self.reach, other.reach);
        add_counts(&mut self.relations, other.relations);
        for (name, theirs) in other.methods {
            let mine = self.methods.entry(name).or_default();
            mine.answered += theirs.answered;
            mine.declined += theirs.declined;
            mine.bouts += theirs.bouts;
            mine.impacts += theirs.impacts;
            mine.rows += theirs.rows;
            mine.wrong += theirs.wrong;
            mine.related += theirs.related;
            mine.rests += theirs.rests;
            mine.used = mine.used.max(theirs.used);
        }
    }

    pub(super) fn add(&mut self, name: &str, examination: &Examination) {
        self.names.push(name.to_owned());
        self.responses += 1;
        self.too_close += usize::from(examination.too_close);
        for reach in &examination.reach {
            *self.reach.entry(*reach).or_default() += 1;
        }
        for (name, relation) in &examination.related {
            *self.relations.entry(*relation).or_default() += 1;
            self.methods.entry(name.clone()).or_default().related += 1;
        }
        for (name, asked) in &examination.asked {
            let method = self.methods.entry(name.clone()).or_default();
            let wrong = examination.findings.iter().filter(|finding| finding.method == *name).count();
            method.wrong += wrong;
            let used = match asked {
                Compared::Declined => {
                    method.declined += 1;
                    continue;
                }
                Compared::Answered { bouts, impacts, rows, used } => {
                    method.bouts += bouts;
                    method.impacts += impacts;
                    method.rows += rows;
                    used
                }
                Compared::Foretold { rests, used } => {
                    method.rests += rests;
                    used
                }
            };
            method.answered += 1;
            if wrong == 0 {
                method.used = method.used.max(*used);
            }
        }
    }
}
