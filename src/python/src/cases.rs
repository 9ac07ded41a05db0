//! Cases in arrays: chattering times, and impacts.

use std::time::{Duration, Instant};

use chattercheck::{
    cases::case_file::CaseFields,
    measure::{observables::Observed, sharpest},
    panel::{self, Refused, Role, Settings},
};
use contract::{Case, Decline, Ending, Invalid, Model, Oracle};
use numpy::{PyArray1, PyReadonlyArrayDyn, ndarray::ArrayViewD};
use pyo3::{prelude::*, types::PyDict};
use rayon::prelude::*;

use crate::error::value_error;

/// How a history may end; an answer has the place of the word in this list.
pub const ENDINGS: [&str; 8] =
    ["at-rest", "incomplete", "overturned", "never-rocks", "limit-reached", "lost", "unsure", "declined"];
const UNSURE: u8 = 6;
const DECLINED: u8 = 7;

/// The place of an ending in [`ENDINGS`].
fn place(ending: Ending) -> u8 {
    match ending {
        Ending::AtRest => 0,
        Ending::Incomplete => 1,
        Ending::Overturned => 2,
        Ending::NeverRocks => 3,
        Ending::LimitReached(_) => 4,
        Ending::Lost(_) => 5,
    }
}

/// What is asked of all cases alike.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Asked {
    /// Whether the amplitudes are `ε = a - 1`.
    is_epsilon: bool,
    normalisation: Option<String>,
    oracle: Option<String>,
    impacts: Option<usize>,
    until: Option<f64>,
}

impl Asked {
    /// The case of these parameters: `a` or `ε`, `ω`, `η` and, of the block as it is, `α`.
    fn case(&self, [amplitude, omega, eta, alpha]: [f64; 4], has_alpha: bool) -> Result<Case, Invalid> {
        let fields = CaseFields {
            a: (!self.is_epsilon).then_some(amplitude),
            epsilon: self.is_epsilon.then_some(amplitude),
            omega,
            eta,
            alpha: has_alpha.then_some(alpha),
            normalisation: self.normalisation.clone(),
            impacts: self.impacts,
            until: self.until,
        };
        fields.case()
    }

    /// Who is asked: the oracle that is named, or the one that steps fastest.
    fn oracle(&self, has_alpha: bool) -> Result<Box<dyn Oracle>, Refused> {
        let model = if has_alpha { Model::Nonlinear } else { Model::Linear };
        let Some(name) = &self.oracle else { return Ok(panel::stepper_of(model)) };
        let oracle = panel::one(name, &Settings::default(), if has_alpha { "nonlinear" } else { "linear" });
        let oracle = oracle.map_err(without_auto)?;
        if has_alpha && oracle.model() == Model::Linear {
            let solves = |method: &panel::Method| method.models.contains(&Model::Nonlinear);
            return Err(Refused::unused("alpha", "(given)", name, solves));
        }
        if !has_alpha && oracle.model() == Model::Nonlinear {
            return Err(Invalid::new("alpha", "(missing)", "the model needs a slenderness (alpha)").into());
        }
        Ok(oracle)
    }
}

/// What the program may choose is chosen here by leaving the name away.
fn without_auto(refused: Refused) -> Refused {
    match refused {
        Refused::Invalid(Invalid { field: "oracle", value, allowed }) => {
            Invalid { field: "oracle", value, allowed: allowed.trim_start_matches("auto, ") }.into()
        }
        other => other,
    }
}

/// Arrays of parameters, of one shape, as NumPy has them: of any strides, with nothing copied.
struct Columns<'a>(Vec<ArrayViewD<'a, f64>>);

impl Columns<'_> {
    fn len(&self) -> usize {
        self.0.first().map_or(0, ArrayViewD::len)
    }

    /// Every case in the order of C, read while the interpreter's lock is held.
    fn rows(&self) -> impl Iterator<Item = [f64; 4]> {
        let mut columns: Vec<_> = self.0.iter().map(|column| column.iter()).collect();
        std::iter::from_fn(move || {
            let mut row = [f64::NAN; 4];
            for (of_row, column) in row.iter_mut().zip(&mut columns) {
                *of_row = *column.next()?;
            }
            Some(row)
        })
    }

    /// Where the case is that has this place in the order of C, if there is more than one.
    fn said_of(&self, mut place: usize) -> String {
        let shape = self.0.first().map_or(&[][..], |column| column.shape());
        if self.len() < 2 {
            return String::new();
        }
        let mut index = Vec::new();
        for length in shape.iter().rev() {
            index.push((place % length).to_string());
            place /= length;
        }
        index.reverse();
        format!(" (at index [{}])", index.join(", "))
    }
}

/// What is asked of every case, in groups on all threads without the interpreter's lock; between two groups signals are looked for. Groups grow until they take
/// about [`LONG`].
fn each<T: Send>(
    py: Python<'_>,
    (columns, has_alpha): (&Columns<'_>, bool),
    asked: &Asked,
    answer: impl Fn(&Case) -> T + Sync,
    mut take: impl FnMut(T),
) -> PyResult<()> {
    let mut rows = columns.rows();
    let (mut done, mut group) = (0, 4 * rayon::current_num_threads());
    loop {
        let next: Vec<[f64; 4]> = rows.by_ref().take(group).collect();
        if next.is_empty() {
            return Ok(());
        }
        let cases = next.iter().enumerate().map(|(place, row)| {
            let refused = |invalid| value_error(format!("{invalid}{}", columns.said_of(done + place)));
            asked.case(*row, has_alpha).map_err(refused)
        });
        let cases = cases.collect::<PyResult<Vec<Case>>>()?;
        let began = Instant::now();
        let answers: Vec<T> = py.detach(|| cases.par_iter().map(&answer).collect());
        if began.elapsed() < LONG {
            group = (2 * group).min(MOST);
        }
        answers.into_iter().for_each(&mut take);
        done += cases.len();
        py.check_signals()?;
    }
}

/// A group of cases takes about this long.
const LONG: Duration = Duration::from_millis(50);
/// The most cases of a group.
const MOST: usize = 1 << 16;

/// The chattering time, its error, the place of the ending and how many impacts it took.
type Chattered = (f64, f64, u8, i64);

fn chattered(oracle: &dyn Oracle, case: &Case, impacts: Option<usize>) -> Chattered {
    let observed = match impacts {
        Some(_) => oracle.history(case).map(|history| Observed::new(case, history)),
        None => case
            .with_max_impacts(sharpest::FIRST_IMPACTS)
            .map_err(|_| Decline::Unsupported { what: "so many impacts" })
            .and_then(|case| sharpest::observe(oracle, &case).map(|(_, observed)| observed)),
    };
    let Ok(Observed { history, chattering_time }) = observed else { return (f64::NAN, f64::NAN, DECLINED, 0) };
    let impacts = history.impacts.len() as i64;
    match chattering_time {
        Some(time) if !time.uncertainty.is_finite() => (f64::NAN, f64::NAN, UNSURE, impacts),
        Some(time) => (time.value, time.uncertainty, place(history.ending), impacts),
        None => (f64::NAN, f64::NAN, place(history.ending), impacts),
    }
}

/// An oracle with a sum of its own has one chattering time, however many impacts are listed.
fn refuse_impacts(oracle: &dyn Oracle, impacts: Option<usize>) -> Result<(), Refused> {
    let sums = |method: &panel::Method| method.roles.contains(&Role::OwnSum);
    match impacts {
        Some(impacts) if panel::method(oracle.name()).is_some_and(sums) => {
            Err(Refused::unused("impacts", impacts, oracle.name(), |method| !sums(method)))
        }
        _ => Ok(()),
    }
}

/// The parameters of the cases.
type Parameters<'py> = Vec<PyReadonlyArrayDyn<'py, f64>>;

/// The chattering time of each case, in the order of C: times, errors, places of the endings in `ENDINGS`, and numbers of impacts.
#[pyfunction]
#[expect(clippy::type_complexity)] // a tuple for Python
pub fn chatter<'py>(
    py: Python<'py>,
    parameters: Parameters<'py>,
    asked: Asked,
) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u8>>, Bound<'py, PyArray1<i64>>)>
{
    let has_alpha = parameters.len() > 3;
    let oracle = asked.oracle(has_alpha).map_err(value_error)?;
    refuse_impacts(oracle.as_ref(), asked.impacts).map_err(value_error)?;
    let columns = Columns(parameters.iter().map(|column| column.as_array()).collect());
    let many = columns.len();
    let mut times = Vec::with_capacity(many);
    let mut errors = Vec::with_capacity(many);
    let mut endings = Vec::with_capacity(many);
    let mut impacts = Vec::with_capacity(many);
    each(
        py,
        (&columns, has_alpha),
        &asked,
        |case| chattered(oracle.as_ref(), case, asked.impacts),
        |answer| {
            times.push(answer.0);
            errors.push(answer.1);
            endings.push(answer.2);
            impacts.push(answer.3);
        },
    )?;
    Ok((
        PyArray1::from_vec(py, times),
        PyArray1::from_vec(py, errors),
        PyArray1::from_vec(py, endings),
        PyArray1::from_vec(py, impacts),
    ))
}

/// The chattering time of one case, without arrays.
#[pyfunction]
pub fn chatter_one(py: Python<'_>, parameters: [f64; 4], has_alpha: bool, asked: Asked) -> PyResult<Chattered> {
    let oracle = asked.oracle(has_alpha).map_err(value_error)?;
    refuse_impacts(oracle.as_ref(), asked.impacts).map_err(value_error)?;
    let case = asked.case(parameters, has_alpha).map_err(value_error)?;
    Ok(py.detach(|| chattered(oracle.as_ref(), &case, asked.impacts)))
}

/// The impacts of a case, and how its history ends.
#[derive(Default)]
struct Listed {
    /// Time, interval, velocity, and what is claimed for each.
    impacts: Vec<[f64; 6]>,
    ending: u8,
}

impl Listed {
    fn new(oracle: &dyn Oracle, case: &Case) -> Self {
        let Ok(history) = oracle.history(case) else { return Self { ending: DECLINED, ..Self::default() } };
        // Nothing is claimed.
        let known = |claim: f64| if claim.is_finite() { claim } else { f64::NAN };
        let impacts = history.impacts.iter().map(|impact| {
            let of = impact.uncertainty;
            [impact.time, impact.interval, impact.velocity, known(of.time), known(of.interval), known(of.velocity)]
        });
        Self { impacts: impacts.collect(), ending: place(history.ending) }
    }
}

/// The impacts of all cases, one case after another, where each case begins, and how each ends.
#[pyfunction]
pub fn impacts<'py>(py: Python<'py>, parameters: Parameters<'py>, asked: Asked) -> PyResult<Bound<'py, PyDict>> {
    let has_alpha = parameters.len() > 3;
    let oracle = asked.oracle(has_alpha).map_err(value_error)?;
    let columns = Columns(parameters.iter().map(|column| column.as_array()).collect());
    let (mut offsets, mut endings) = (vec![0_i64], Vec::with_capacity(columns.len()));
    let mut all: [Vec<f64>; 6] = Default::default();
    each(
        py,
        (&columns, has_alpha),
        &asked,
        |case| Listed::new(oracle.as_ref(), case),
        |listed| {
            for impact in &listed.impacts {
                all.iter_mut().zip(impact).for_each(|(column, value)| column.push(*value));
            }
            offsets.push(all.first().map_or(0, Vec::len) as i64);
            endings.push(listed.ending);
        },
    )?;
    let found = PyDict::new(py);
    let names = ["time", "interval", "velocity", "time_uncertainty", "interval_uncertainty", "velocity_uncertainty"];
    for (name, column) in names.into_iter().zip(all) {
        found.set_item(name, PyArray1::from_vec(py, column))?;
    }
    found.set_item("offsets", PyArray1::from_vec(py, offsets))?;
    found.set_item("endings", PyArray1::from_vec(py, endings))?;
    Ok(found)
}
