//! Sweeps: a map of what happens over any parameters of a case or a scene, as one table.
//!
//! A sweep is TOML: [axes](Axis) over fields, and the [columns](Column) that are wanted. Its [points](Points) are numbered; a row of the table is a function of
//! the sweep and of that number and of nothing else, so that neither threads, nor [parts](Stretch), nor [interruptions](Kept) change a byte.

mod axes;
mod axis;
mod case;
mod column;
mod file;
mod kept;
mod map;
mod parts;
mod points;
mod run;
mod scene;
mod value;

use std::{
    collections::BTreeSet,
    fmt, ops,
    path::{Path, PathBuf},
};

pub use axis::{Axis, Range, Spread};
pub use column::{Column, Findings};
pub use kept::{Kept, Mark, NotKept};
pub use map::{Asked, Drawing, MapError};
pub use parts::Stretch;
pub use points::Points;
pub use run::run;
pub use value::Value;

use crate::{
    cases::toml_error::{is_control, printable, read},
    stored::sha256,
};
use case::Cases;
use scene::{Scenes, read_text};

/// The most points of a sweep.
pub const MOST_POINTS: usize = 1_000_000_000_000;

/// A sweep whose values are all allowed, as far as that can be known before.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// What it is, for people; may be empty.
    pub title: String,
    /// Its points.
    pub points: Points,
    /// The columns of its table, beside those of the axes.
    pub columns: Vec<Column>,
    /// The files that it is made of: itself, a scene, records.
    pub files: Vec<PathBuf>,
    /// The checksum of the text of the sweep, and that of the other files.
    pub sums: [String; 2],
    subject: Subject,
}

/// What the points are.
#[derive(Debug, Clone, PartialEq)]
enum Subject {
    Cases(Cases),
    Scenes(Scenes),
}

/// What is wrong with a sweep, in one line: the line of the file where it can be named, the field, the value and what is allowed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{0}")]
pub struct SweepError(String);

/// The text of a sweep, to say where something is.
struct Text<'a>(&'a str);

impl Text<'_> {
    /// The error for what is written at a place.
    fn wrong(&self, field: &str, span: &ops::Range<usize>, allowed: impl fmt::Display) -> SweepError {
        let typed = self.0.get(span.clone()).unwrap_or_default();
        let shown: String = printable(typed).chars().take(60).collect();
        let dots = if shown.len() < typed.len() { "..." } else { "" };
        self.at(span, format_args!("{field} = {shown}{dots} is outside the allowed range: {allowed}"))
    }

    /// The error for a place, in other words.
    fn at(&self, span: &ops::Range<usize>, said: impl fmt::Display) -> SweepError {
        let line = self.0.get(..span.start).map_or(1, |before| before.matches('\n').count() + 1);
        SweepError(format!("line {line}: {said}"))
    }
}

impl Sweep {
    /// Reads a sweep.
    ///
    /// # Errors
    /// What is wrong with the first thing that is.
    pub fn read(path: &Path) -> Result<Self, SweepError> {
        let text = read_text(path)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut sweep =
            Self::parse_in(&text, folder).map_err(|error| SweepError(format!("{}: {error}", path.display())))?;
        sweep.files.insert(0, path.to_owned());
        Ok(sweep)
    }

    /// Reads a sweep whose scene is named from where `folder` is.
    ///
    /// # Errors
    /// As [`Sweep::read`].
    pub fn parse_in(source: &str, folder: &Path) -> Result<Self, SweepError> {
        let file: file::SweepFile = read(source, &file::ALLOWED).map_err(SweepError)?;
        let text = Text(source);
        let written = axes::read(&text)?;
        let axes: Vec<Axis> = written.iter().map(|written| written.axis.clone()).collect();
        let columns = columns(&file, &text)?;
        let seed = seed(&file, &axes, &text)?;
        same_counts(&written, &text)?;
        let points = Points::new(axes.clone(), seed).filter(|points| points.count() <= MOST_POINTS);
        let points = points.ok_or_else(|| SweepError("axes: too many points; allowed are up to 1e12".to_owned()))?;
        let mut files = Vec::new();
        let subject = match &file.scene {
            None => {
                let normalisation = file.normalisation.as_ref().map(|of| of.get_ref().clone());
                Subject::Cases(Cases::new(&axes, normalisation, &columns)?)
            }
            Some(scene) => {
                if let Some(of) = &file.normalisation {
                    return Err(text.wrong("normalisation", &of.span(), "only without scene: a scene says it itself"));
                }
                let path = folder.join(scene);
                let text = read_text(&path)?;
                files.push(path.clone());
                let folder = path.parent().unwrap_or(Path::new("")).to_owned();
                Subject::Scenes(Scenes::new(folder, path.display().to_string(), &text, &axes)?)
            }
        };
        let records = subject.check(&written, &points, &text)?;
        files.extend(records);
        let sums = [sha256(source.as_bytes()), sum_of(&files)?];
        let title = file.title.unwrap_or_default().chars().filter(|c| !is_control(*c)).take(200).collect();
        Ok(Self { title, points, columns, files, sums, subject })
    }

    /// The first line of the table, with its end.
    pub fn header(&self) -> String {
        let axes = self.points.axes().map(|axis| axis.name.as_str());
        let columns = self.columns.iter().map(|column| column.name());
        axes.chain(columns).collect::<Vec<_>>().join(",") + "\n"
    }

    /// What is found of a point.
    pub fn findings(&self, point: usize) -> Findings {
        let values = self.points.values(point);
        match &self.subject {
            Subject::Cases(cases) => cases.findings(values),
            Subject::Scenes(scenes) => scenes.findings(values),
        }
    }

    /// The rows of these points, each with its end.
    pub fn rows(&self, points: ops::Range<usize>) -> String {
        let mut rows = String::new();
        for point in points {
            self.points.write(point, &mut rows);
            let findings = self.findings(point);
            for (place, column) in self.columns.iter().enumerate() {
                if place > 0 {
                    rows.push(',');
                }
                findings.write(*column, &mut rows);
            }
            rows.push('\n');
        }
        rows
    }
}

impl Subject {
    /// Whether the ends of every axis are allowed, with the first values of the others. The records that the points are made of.
    fn check(&self, written: &[axes::Written], points: &Points, text: &Text) -> Result<BTreeSet<PathBuf>, SweepError> {
        let first: Vec<Value> = points.values(0).collect();
        let mut records = BTreeSet::new();
        for (place, axes::Written { axis, span }) in written.iter().enumerate() {
            for value in axis.spread.extremes() {
                let mut values = first.clone();
                if let Some(of_axis) = values.get_mut(place) {
                    *of_axis = value.clone();
                }
                let checked = match self {
                    Self::Cases(_) if value.number().is_none() || matches!(value, Value::Text(_)) => {
                        Err("a number, or a list or range of numbers".to_owned())
                    }
                    Self::Cases(cases) => cases.case(values.into_iter()).map(drop).map_err(|error| error.to_string()),
                    Self::Scenes(scenes) => scenes
                        .scene(values.into_iter())
                        .map(|scene| records.extend(Scenes::files(&scene).cloned()))
                        .map_err(|error| error.to_string()),
                };
                checked.map_err(|said| {
                    let mut shown = String::new();
                    value.write(&mut shown);
                    text.at(span, format_args!("axes.{} at {shown}: {said}", axis.name))
                })?;
            }
        }
        Ok(records)
    }
}

fn columns(file: &file::SweepFile, text: &Text) -> Result<Vec<Column>, SweepError> {
    let of_scene = file.scene.is_some();
    let known = || Column::ALL.into_iter().filter(|column| of_scene || !column.is_of_scenes());
    let names: Vec<&str> = known().map(Column::name).collect();
    let allowed = format!("{}, each once, at least one", names.join(", "));
    let listed = &file.want.columns;
    let mut wanted = Vec::new();
    for name in listed.get_ref() {
        match known().find(|column| column.name() == name.get_ref()) {
            Some(column) if !wanted.contains(&column) => wanted.push(column),
            _ => return Err(text.wrong("columns", &name.span(), allowed)),
        }
    }
    if wanted.is_empty() {
        return Err(text.wrong("columns", &listed.span(), allowed));
    }
    Ok(Column::with_companions(&wanted, of_scene))
}

fn seed(file: &file::SweepFile, axes: &[Axis], text: &Text) -> Result<u64, SweepError> {
    let Some(seed) = &file.seed else { return Ok(1) };
    if !axes.iter().any(|axis| axis.spread.is_random()) {
        return Err(text.wrong("seed", &seed.span(), "only with an axis that is random"));
    }
    u64::try_from(*seed.get_ref()).map_err(|_| text.wrong("seed", &seed.span(), file::SEEDS))
}

/// Random axes vary together.
fn same_counts(written: &[axes::Written], text: &Text) -> Result<(), SweepError> {
    let mut random = written.iter().filter(|written| written.axis.spread.is_random());
    let Some(first) = random.next() else { return Ok(()) };
    match random.find(|other| other.axis.spread.count() != first.axis.spread.count()) {
        None => Ok(()),
        Some(other) => {
            let (name, count) = (&first.axis.name, first.axis.spread.count());
            let allowed = format!("as many values as axes.{name}, {count}: random axes vary together");
            Err(text.at(
                &other.span,
                format_args!(
                    "axes.{} with {} values is outside the allowed range: {allowed}",
                    other.axis.name,
                    other.axis.spread.count()
                ),
            ))
        }
    }
}

/// The checksum of all these files.
fn sum_of(files: &[PathBuf]) -> Result<String, SweepError> {
    let mut sums = String::new();
    for path in files {
        let bytes =
            std::fs::read(path).map_err(|error| SweepError(format!("cannot read {}: {error}", path.display())))?;
        sums += &sha256(&bytes);
    }
    Ok(sha256(sums.as_bytes()))
}
