//! The profiles of the engines of a run as files, and how fast their right answers came. The only place where times are kept: the report has none.

use std::{
    collections::BTreeMap,
    path::Path,
    sync::{Mutex, PoisonError},
};

use anyhow::anyhow;
use chattercheck::{
    engines::{Fleet, Took},
    gate::report::Report,
    studies::{
        chart,
        engine_profile::{self, Profiled, Speed},
        work_precision::{self, Stranger},
    },
};
use contract::Case;

use super::output::note;

/// Adds up how long right answers took.
pub(super) struct Clock<'a> {
    fleet: &'a Fleet,
    speeds: Mutex<BTreeMap<String, Speed>>,
}

impl<'a> Clock<'a> {
    /// For the engines of this fleet.
    pub fn new(fleet: &'a Fleet) -> Self {
        Self { fleet, speeds: Mutex::default() }
    }

    /// The answer of this engine to this case was right.
    pub fn note(&self, name: &str, case: &Case) {
        let Some(Took { impacts, seconds, own_seconds }) = self.fleet.engine(name).and_then(|engine| engine.took(case))
        else {
            return;
        };
        let mut speeds = self.speeds.lock().unwrap_or_else(PoisonError::into_inner);
        let speed = speeds.entry(name.to_owned()).or_default();
        speed.answers += 1;
        speed.impacts += impacts;
        speed.seconds += seconds;
        if let Some(own) = own_seconds {
            speed.own_impacts += impacts;
            speed.own_seconds += own;
        }
    }

    /// What was added up.
    pub fn speeds(self) -> BTreeMap<String, Speed> {
        self.speeds.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Tells people how fast each engine is.
pub(super) fn tell(speeds: &BTreeMap<String, Speed>) {
    for (name, speed) in speeds {
        let Some(outside) = speed.outside() else { continue };
        let own = speed.own().map_or_else(String::new, |own| format!(", {own:.1e} by its own clock"));
        let answers = speed.answers;
        note(format_args!(
            "{name}: {answers} right answers at {outside:.1e} impacts a second as seen from outside{own}"
        ));
    }
}

/// Writes the profiles of the engines of a report, and where they stand in the work-precision chart, into a folder that exists.
///
/// # Errors
/// When a file can't be written, or a chart can't be drawn.
pub(super) fn write(
    folder: &Path,
    report: &Report,
    fleet: &Fleet,
    speeds: &BTreeMap<String, Speed>,
) -> anyhow::Result<()> {
    let profiled = report.engines.iter().filter_map(|engine| {
        let name = engine.engine.name.as_str();
        Some(Profiled { name, profile: engine.profile.as_ref()?, speed: speeds.get(name).copied().unwrap_or_default() })
    });
    let mut files = engine_profile::files(&profiled.collect::<Vec<_>>())?;
    let asks: Vec<_> = fleet
        .engines
        .iter()
        .map(|engine| {
            let ask = move |case: &Case| {
                let answer = engine.oracle.engine().answer(case);
                let seconds = answer.ns.map_or(answer.elapsed.as_secs_f64(), |ns| 1e-9 * ns);
                (answer.told().ok(), seconds)
            };
            (engine.entry.launch.name.as_str(), engine.entry.launch.model, ask)
        })
        .collect();
    let strangers: Vec<Stranger> =
        asks.iter().map(|(name, model, ask)| Stranger { name, model: *model, ask }).collect();
    let rows = work_precision::measure_beside(&strangers).map_err(|decline| anyhow!("{decline}"))?;
    files.insert("profile_work.csv", chart::csv_text(&rows)?);
    let charts: Vec<chart::Chart> = engine_profile::CHARTS.into_iter().chain([work_precision::BESIDE]).collect();
    for path in chart::write(folder, &files, &charts)?.lines() {
        note(path);
    }
    Ok(())
}
