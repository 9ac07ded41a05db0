//! Whole responses.

use chattercheck::motion::{
    response::{Bout, BoutEnd, Response, Sample, State, Termination, Window},
    scene::{self, Account},
};
use contract::Invalid;
use numpy::PyArray1;
use pyo3::{prelude::*, types::PyDict};

use crate::{
    error::value_error,
    scene::{Scene, oracle_of},
    wait::{Stop, interruptible},
};

/// A response, with what is shown of it.
struct Rocked {
    response: Response,
    samples: Vec<Sample>,
    account: Account,
    oracle: String,
    eta: f64,
}

fn rocked(
    scene: &scene::Scene,
    (until, steps): (Option<f64>, usize),
    oracle: Option<&str>,
    stop: &Stop,
) -> Result<Rocked, String> {
    let said = |error: &dyn std::fmt::Display| error.to_string();
    let asked = scene.asked(until, Termination::Exact).map_err(|invalid| said(&invalid))?;
    let oracle = oracle_of(&asked, scene.ask.model, oracle, stop).map_err(|refused| said(&refused))?;
    let declined = |decline| format!("{} declines: {decline}", oracle.oracle.name());
    let response = asked.response(&oracle).map_err(declined)?;
    let window = Window { from: 0.0, to: response.end, steps };
    let samples = asked.samples(&response, &oracle, &window).map_err(declined)?;
    let peak = asked.peak(&response, &oracle).map_err(declined)?;
    let account = scene.account(&response, peak).map_err(|invalid| said(&invalid))?;
    let oracle = oracle.oracle.name().to_owned();
    Ok(Rocked { response, samples, account, oracle, eta: scene.block.restitution })
}

/// The response of a scene. Times are `τ`, rotations shares of `α`.
#[pyfunction]
#[pyo3(signature = (scene, until=None, steps=1000, oracle=None))]
pub fn rock<'py>(
    py: Python<'py>,
    scene: &Scene,
    until: Option<f64>,
    steps: usize,
    oracle: Option<String>,
) -> PyResult<Bound<'py, PyDict>> {
    if !(1..=1_000_000).contains(&steps) {
        return Err(value_error(Invalid::new("steps", steps, "1 to 1000000")));
    }
    let (stop, scene) = (Stop::default(), scene.0.clone());
    let work = {
        let stop = stop.clone();
        move || rocked(&scene, (until, steps), oracle.as_deref(), &stop)
    };
    let rocked = interruptible(py, &stop, work)?.map_err(value_error)?;
    let Rocked { response, samples, account, oracle, eta } = &rocked;
    let found = PyDict::new(py);
    let column = |of: fn(&Sample) -> f64| PyArray1::from_iter(py, samples.iter().map(of));
    found.set_item("tau", column(|sample| sample.tau))?;
    found.set_item("phi", column(|sample| sample.phi))?;
    found.set_item("phi_velocity", column(|sample| sample.phi_velocity))?;
    found.set_item("ground", column(|sample| sample.ground_acceleration))?;
    found.set_item("state", PyArray1::from_iter(py, samples.iter().map(|sample| state(sample.state))))?;
    let impacts: Vec<(f64, f64, f64)> = response.bouts.iter().flat_map(|bout| bout.impact_list(*eta)).collect();
    found.set_item("impact_tau", PyArray1::from_iter(py, impacts.iter().map(|(time, ..)| *time)))?;
    found.set_item("impact_interval", PyArray1::from_iter(py, impacts.iter().map(|(_, interval, _)| *interval)))?;
    found.set_item("impact_velocity", PyArray1::from_iter(py, impacts.iter().map(|(.., velocity)| *velocity)))?;
    let bouts: Vec<_> = response.bouts.iter().map(told).collect();
    found.set_item("bouts", bouts)?;
    found.set_item("rests", response.rests())?;
    found.set_item("end", response.end)?;
    found.set_item("summary", serde_json::to_string(account).map_err(value_error)?)?;
    found.set_item("told", account.told())?;
    found.set_item("oracle", oracle)?;
    Ok(found)
}

/// A time of rocking: from, to, what `to` is expected to be off by, how many impacts are resolved, how it ends, and whether it then rests.
fn told(bout: &Bout) -> (f64, f64, f64, usize, &'static str, bool) {
    let uncertainty = Some(bout.uncertainty()).filter(|off| off.is_finite()).unwrap_or(f64::NAN);
    let is_rest = matches!(bout.outcome, BoutEnd::Complete { .. }) && !bout.is_unsure();
    (bout.begin(), bout.end(), uncertainty, bout.impacts(), bout.ending(), is_rest)
}

/// The place of a state in the list of the package.
fn state(state: State) -> u8 {
    match state {
        State::Rest => 0,
        State::Rocking => 1,
        State::Overturned => 2,
        State::Lying => 3,
    }
}
