//! How a sample is written: in columns. That every bit of its numbers comes back is for [`stored`](crate::stored) to see.

use contract::{Ending, Estimate, History, Impact, Limit, Loss, Uncertainty};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

use super::Sample;
use crate::cases::case_file::CaseFields;

#[derive(Serialize, Deserialize)]
struct Written {
    case: CaseFields,
    is_wrong: bool,
    is_ending_wrong: bool,
    answer: Option<Columns>,
}

#[derive(Serialize, Deserialize)]
struct Columns {
    time: Vec<f64>,
    interval: Vec<f64>,
    velocity: Vec<f64>,
    ending: String,
    chattering_time: Option<f64>,
}

const ENDINGS: [(&str, Ending); 10] = [
    ("never-rocks", Ending::NeverRocks),
    ("at-rest", Ending::AtRest),
    ("incomplete", Ending::Incomplete),
    ("overturned", Ending::Overturned),
    ("limit-of-impacts", Ending::LimitReached(Limit::Impacts)),
    ("limit-of-time", Ending::LimitReached(Limit::Time)),
    ("fell-through", Ending::Lost(Loss::FellThrough)),
    ("stalled", Ending::Lost(Loss::Stalled)),
    ("not-finite", Ending::Lost(Loss::NotFinite)),
    ("solver-failed", Ending::Lost(Loss::SolverFailed)),
];

impl From<&History> for Columns {
    fn from(history: &History) -> Self {
        let column = |of: fn(&Impact) -> f64| history.impacts.iter().map(of).collect();
        let ending = ENDINGS.iter().find(|(_, ending)| *ending == history.ending);
        Self {
            time: column(|impact| impact.time),
            interval: column(|impact| impact.interval),
            velocity: column(|impact| impact.velocity),
            ending: ending.map_or_else(String::new, |(name, _)| (*name).to_owned()),
            chattering_time: history.chattering_time.map(|time| time.value),
        }
    }
}

impl Columns {
    fn history(&self) -> Result<History, String> {
        let ending = ENDINGS.iter().find(|(name, _)| *name == self.ending);
        let (_, ending) = ending.ok_or_else(|| format!("ending = {} is none", self.ending))?;
        if self.time.len() != self.interval.len() || self.time.len() != self.velocity.len() {
            return Err("columns of unequal length".to_owned());
        }
        let rows = self.time.iter().zip(&self.interval).zip(&self.velocity);
        let impact = |((&time, &interval), &velocity): ((&f64, &f64), &f64)| Impact {
            time,
            interval,
            velocity,
            uncertainty: Uncertainty { time: 0.0, interval: 0.0, velocity: 0.0 },
        };
        let chattering_time = self.chattering_time.map(|value| Estimate { value, uncertainty: 0.0 });
        Ok(History { impacts: rows.map(impact).collect(), ending: *ending, chattering_time })
    }
}

impl Serialize for Sample {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let &Self { ref case, ref answer, is_wrong, is_ending_wrong } = self;
        let answer = answer.as_ref().map(Columns::from);
        Written { case: CaseFields::from(case), is_wrong, is_ending_wrong, answer }.serialize(to)
    }
}

impl<'de> Deserialize<'de> for Sample {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let Written { case, is_wrong, is_ending_wrong, answer } = Written::deserialize(from)?;
        let answer = answer.map(|columns| columns.history()).transpose().map_err(D::Error::custom)?;
        Ok(Self { case: case.case().map_err(D::Error::custom)?, answer, is_wrong, is_ending_wrong })
    }
}
