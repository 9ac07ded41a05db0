//! Which engines there are, how each is started, and what is allowed it.

use std::{
    f64::consts::FRAC_PI_2,
    fs::File,
    io::Read,
    ops::Range,
    path::{Path, PathBuf},
    time::Duration,
};

use contract::{Model, Normalisation};
use process::{Launch, Tolerance, Verdict};
use toml::Spanned;

use super::{
    error::{ManifestError, Source},
    program,
    spans::Spans,
    table,
};
use crate::{
    cases::toml_error,
    gate::known::{Class, Known, Regime},
};

/// How long a manifest may be.
const MOST_BYTES: usize = 1 << 20;

/// The share of the cases that an engine may decline unless its manifest says otherwise.
const MAY_DECLINE: f64 = 0.5;

/// Over how many cases of its regime a known failure has to show unless the manifest says otherwise.
const WITHIN: usize = 20;

/// A manifest: a table `[[engine]]` for each engine.
#[derive(Debug, Clone, PartialEq)]
pub struct Manifest {
    /// The file.
    pub path: PathBuf,
    /// The engines, in its order.
    pub engines: Vec<Entry>,
}

/// An engine of a manifest.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// How it is started, and the errors that are granted to it where it claims none.
    pub launch: Launch,
    /// Why that much is granted; empty where nothing is.
    pub reason: String,
    /// The command that tells its version.
    pub version: Option<Vec<String>>,
    /// What a line of what that prints has to look like; `*` stands for anything.
    pub pattern: Option<String>,
    /// The largest share of the cases of a run that it may decline.
    pub may_decline: f64,
    /// Whether it never says that a block comes to rest, so that no chattering time of it can be compared.
    pub never_at_rest: bool,
    /// Its known failures.
    pub known: Vec<Known>,
}

impl Entry {
    /// An engine of which no more is known than how it is started and which equation it solves: it may decline nothing.
    pub fn bare<'a>(name: &str, run: impl IntoIterator<Item = &'a str>, model: Model) -> Self {
        let launch = Launch::new(name, run, model);
        Self {
            launch,
            reason: String::new(),
            version: None,
            pattern: None,
            may_decline: 0.0,
            never_at_rest: false,
            known: Vec::new(),
        }
    }

    /// The files that its commands name: the program where it is not one of PATH, and its arguments that are files.
    pub fn files(&self) -> Vec<PathBuf> {
        let words = self.launch.run.iter().chain(self.version.iter().flatten());
        words.map(|word| self.launch.directory.join(word)).filter(|path| path.is_file()).collect()
    }
}

impl Manifest {
    /// Reads a manifest.
    ///
    /// # Errors
    /// The first line that is wrong: what is no TOML, unknown, not allowed or given twice; a program or a folder that is not there.
    pub fn read(path: &Path) -> Result<Self, ManifestError> {
        let source = Source { path, text: "" };
        let mut bytes = Vec::new();
        let file = File::open(path).map_err(|error| source.error(format!("cannot be read: {error}")))?;
        let read = file.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes);
        read.map_err(|error| source.error(format!("cannot be read: {error}")))?;
        if bytes.len() > MOST_BYTES {
            return Err(source.error("longer than a manifest may be, a megabyte"));
        }
        let text = String::from_utf8(bytes).map_err(|_| source.error("not a text (UTF-8)"))?;
        Self::parse(path, &text)
    }

    /// Reads the text of the manifest at this path.
    ///
    /// # Errors
    /// As [`Manifest::read`].
    pub fn parse(path: &Path, text: &str) -> Result<Self, ManifestError> {
        let source = Source { path, text };
        let file: table::File = toml_error::read(text, &table::ALLOWED).map_err(|what| source.error(what))?;
        if file.engine.is_empty() {
            return Err(source.error("there is no engine in it: each is a table that starts with [[engine]]"));
        }
        let mut engines: Vec<Entry> = Vec::new();
        for spanned in file.engine {
            let whole = spanned.span();
            let table = spanned.into_inner();
            let name = table.name.span();
            let entry = entry(source, &whole, table)?;
            if engines.iter().any(|other| other.launch.name == entry.launch.name) {
                let what = format!("name: {:?} is the name of an engine above already", entry.launch.name);
                return Err(source.error_at(&name, what));
            }
            engines.push(entry);
        }
        Ok(Self { path: path.to_owned(), engines })
    }

    /// The engine of this name.
    ///
    /// # Errors
    /// When there is none; the names that there are.
    pub fn engine(&self, name: &str) -> Result<&Entry, ManifestError> {
        let found = self.engines.iter().find(|entry| entry.launch.name == name);
        found.ok_or_else(|| {
            let names: Vec<&str> = self.engines.iter().map(|entry| entry.launch.name.as_str()).collect();
            let what = format!("there is no engine {name:?} in it; there are {}", names.join(", "));
            Source { path: &self.path, text: "" }.error(what)
        })
    }
}

fn entry(source: Source<'_>, whole: &Range<usize>, table: table::Table) -> Result<Entry, ManifestError> {
    let spans = Spans::of(&table, whole);
    let name = table.name.get_ref();
    let is_allowed = |c: char| c.is_alphanumeric() || "-_.+".contains(c);
    if name.is_empty() || name.chars().count() > 60 || !name.chars().all(is_allowed) {
        let what = format!("name: allowed are up to 60 letters, digits and - _ . +, not {name:?}");
        return Err(source.error_at(&spans.name, what));
    }
    let mut launch = Launch::new(name.clone(), table.run.get_ref().clone(), model(table.model));
    let here = source.path.parent().unwrap_or(Path::new(""));
    let given = table.directory.as_ref().map_or(Path::new(""), |directory| directory.get_ref());
    let folder = here.join(given);
    launch.directory = if folder.as_os_str().is_empty() { PathBuf::from(".") } else { folder };
    launch.environment = table.environment;
    let times = [
        (&table.start_timeout, &mut launch.start_timeout),
        (&table.case_timeout, &mut launch.case_timeout),
        (&table.grace, &mut launch.grace),
    ];
    for (given, time) in times {
        let Some(given) = given else { continue };
        let seconds = *given.get_ref();
        *time = Duration::try_from_secs_f64(seconds)
            .map_err(|_| source.error_at(&given.span(), format!("{seconds} is no time in seconds")))?;
    }
    launch.normalisation = table.normalisation.map_or(launch.normalisation, normalisation);
    launch.processes = table.processes.as_ref().map_or(launch.processes, |processes| *processes.get_ref());
    launch.restarts = table.restarts.unwrap_or(launch.restarts);
    let tolerance = table.tolerance.map(Spanned::into_inner).unwrap_or_default();
    let table::Tolerance { time, interval, velocity, tau_ch, reason } = tolerance;
    launch.tolerance = Tolerance { time, interval, velocity, tau_ch };
    launch.check().map_err(|invalid| source.error_at(spans.field(&invalid), &invalid))?;
    if launch.tolerance != Tolerance::default() && reason.trim().is_empty() {
        let what = "tolerance: it needs a reason, as reason = \"what my root finder is asked for\"";
        return Err(source.error_at(&spans.tolerance, what));
    }
    if !launch.directory.is_dir() {
        let what = format!("directory: {} is no folder", launch.directory.display());
        return Err(source.error_at(&spans.directory, what));
    }
    let path = launch.environment.get("PATH").map(String::as_str);
    let missing = |command: &[String]| match command.first().filter(|program| !program.is_empty()) {
        Some(program) => program::missing(program, &launch.directory, path),
        None => Some("the program is missing".to_owned()),
    };
    if let Some(what) = missing(&launch.run) {
        return Err(source.error_at(&spans.run, format!("run: {what}")));
    }
    let (version, pattern) = match table.version.map(Spanned::into_inner) {
        None => (None, None),
        Some(table::Version { command, pattern }) => {
            if let Some(what) = missing(&command) {
                return Err(source.error_at(&spans.version, format!("version: {what}")));
            }
            (Some(command), pattern)
        }
    };
    let may_decline = table.may_decline.map_or(MAY_DECLINE, Spanned::into_inner);
    if !(0.0..=1.0).contains(&may_decline) {
        return Err(
            source.error_at(&spans.may_decline, format!("may-decline: allowed is a share, 0 to 1, not {may_decline}"))
        );
    }
    let mut known: Vec<Known> = Vec::new();
    for spanned in table.known {
        let span = spanned.span();
        let entry = self::known(source, name, spanned)?;
        if known.iter().any(|other| other.class == entry.class && other.regime == entry.regime) {
            return Err(source.error_at(&span, "known: the same class and the same where stand above already"));
        }
        known.push(entry);
    }
    let never_at_rest = table.never_at_rest;
    Ok(Entry { launch, reason, version, pattern, may_decline, never_at_rest, known })
}

fn known(source: Source<'_>, engine: &str, spanned: Spanned<table::Known>) -> Result<Known, ManifestError> {
    let span = spanned.span();
    let table::Known { class: name, regime, reason, link, within } = spanned.into_inner();
    let is_breakdown = |name: &str| Verdict::ALL.iter().any(|verdict| verdict.name() == name);
    let class = Class::named(&name, is_breakdown).ok_or_else(|| {
        let what = "class: allowed is interval, velocity, impact-time, interval-ratio, chattering-time, ending, a law as \
                    sign-alternates, or a breakdown as \"timed out\"";
        source.error_at(&span, format!("{what}, not {name:?}"))
    })?;
    let Regime { a, epsilon, omega, eta, alpha, impact } = regime;
    if let Some([from, to]) = [a, epsilon, omega, eta, alpha, impact]
        .into_iter()
        .flatten()
        .find(|[from, to]| from.is_nan() || to.is_nan() || from > to)
    {
        return Err(
            source.error_at(&span, format!("where: allowed is a range [from, to] with from <= to, not [{from}, {to}]"))
        );
    }
    if impact.into_iter().flatten().any(|bound| bound < 0.0 || bound.is_finite() && bound.fract() != 0.0) {
        return Err(source.error_at(&span, "where: impact is a range of whole numbers, 0 for the history as a whole"));
    }
    // Where no case can be, nothing would ever show that the entry is out of date.
    let possible = [("omega", omega, 0.0, f64::INFINITY), ("eta", eta, 0.0, 1.0), ("alpha", alpha, 0.0, FRAC_PI_2)];
    for (name, range, least, most) in possible {
        if let Some([from, to]) = range.filter(|[from, to]| *to < least || *from > most) {
            let what = format!("where: no case has {name} from {from} to {to}: it is from {least} to {most}");
            return Err(source.error_at(&span, what));
        }
    }
    if within == Some(0) {
        return Err(source.error_at(&span, "within: allowed is a number of cases from 1 on, not 0"));
    }
    if reason.as_ref().is_none_or(|reason| reason.trim().is_empty()) {
        return Err(source.error_at(&span, "known: it needs a reason"));
    }
    let reason = reason.unwrap_or_default();
    let (oracle, entry) = (engine.to_owned(), source.place(&span));
    Ok(Known { oracle, class, regime, reason, link, within: within.unwrap_or(WITHIN), entry })
}

fn model(word: table::Model) -> Model {
    match word {
        table::Model::Linear => Model::Linear,
        table::Model::Nonlinear => Model::Nonlinear,
    }
}

fn normalisation(word: table::Normalisation) -> Normalisation {
    match word {
        table::Normalisation::Threshold => Normalisation::Threshold,
        table::Normalisation::Slender => Normalisation::Slender,
    }
}

#[cfg(test)]
mod tests;
