//! The engines of a run: the flags that name them, and what is made of these.

use std::{
    fs,
    io::BufWriter,
    path::{Path, PathBuf},
    sync::Arc,
};

use anyhow::{Context as _, bail};
use chattercheck::{
    engines::{
        Entry, Fleet, Manifest, Started,
        record::{Keeper, Recording},
    },
    faults::explain,
    gate::{explanation::Explained, guests::Guests, known::Known, partition::EngineAsked, roles::Roles, tally::Tally},
    panel::{self, Panel},
    stored::sha256,
};
use clap::Args;
use contract::{Case, Invalid, Model, Oracle};
use tempfile::NamedTempFile;

use super::{engine::sensitive, engine_profile::Clock, files::Target, output::note};

#[derive(Args)]
pub(super) struct EngineFlags {
    /// A manifest of engines, simulators of your own, to be put beside the panel and under the judge
    #[arg(long, value_name = "FILE")]
    engines: Option<PathBuf>,
    /// Of these engines only the one of this name
    #[arg(long, value_name = "NAME", requires = "engines")]
    only: Option<String>,
    /// Keep every line of the talk with the engines, a JSON object a line
    #[arg(long, value_name = "FILE", requires = "engines")]
    record: Option<PathBuf>,
}

/// The engines that are asked for, not started yet.
pub(super) struct Asked<'a> {
    manifest: &'a Path,
    checksum: String,
    entries: Vec<Entry>,
    record: Option<&'a Path>,
    /// What the run reads.
    files: Vec<PathBuf>,
}

/// The engines of a run, started.
pub(super) struct Engines {
    pub fleet: Fleet,
    manifest: PathBuf,
    /// Of the manifest.
    checksum: String,
    record: Option<Record>,
}

/// A record that is being written beside where it goes.
struct Record {
    path: PathBuf,
    file: NamedTempFile,
    recording: Arc<Recording<BufWriter<std::fs::File>>>,
}

/// What is allowed for a file that is written where a run reads it, or an engine is made of it.
const READ: &str = "it has to be another file than one that is read";

impl EngineFlags {
    /// Whether the talk is to be kept.
    pub fn is_recorded(&self) -> bool {
        self.record.is_some()
    }

    /// The engines that are asked for, in a run that reads these files too.
    ///
    /// # Errors
    /// When the manifest has something wrong in it, an engine has the name of an oracle, or the record would be written over a file that is read.
    pub fn read(&self, read: &[&Path]) -> anyhow::Result<Asked<'_>> {
        let mut files: Vec<PathBuf> = read.iter().map(|path| path.to_path_buf()).collect();
        let asked = self.asked(&mut files)?;
        if let Some(record) = &self.record {
            let target = Target::new(record)?;
            if files.iter().filter_map(|path| Target::resolved(path)).any(|path| target.is_at(&path)) {
                return Err(Invalid::new("record", record.display(), READ).into());
            }
        }
        Ok(Asked { files, ..asked })
    }

    /// The engines; their manifest and what they are made of are added to the files that are read.
    fn asked(&self, files: &mut Vec<PathBuf>) -> anyhow::Result<Asked<'_>> {
        let Some(path) = &self.engines else {
            let (manifest, checksum) = (Path::new(""), String::new());
            return Ok(Asked { manifest, checksum, entries: Vec::new(), record: None, files: Vec::new() });
        };
        files.push(path.clone());
        let manifest = Manifest::read(path)?;
        let text = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
        files.extend(manifest.engines.iter().flat_map(Entry::files));
        let entries: Vec<Entry> = match &self.only {
            Some(name) => vec![manifest.engine(name)?.clone()],
            None => manifest.engines,
        };
        for entry in &entries {
            let name = &entry.launch.name;
            if panel::method(name).is_some() || panel::all().iter().any(|oracle| oracle.name() == name) {
                bail!("{}: name: {name:?} is the name of an oracle (see `chattercheck oracles`)", path.display());
            }
        }
        let (checksum, record) = (sha256(&text), self.record.as_deref());
        Ok(Asked { manifest: path, checksum, entries, record, files: Vec::new() })
    }
}

impl Asked<'_> {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The files that no report may be written over, each with what is allowed for it instead.
    pub fn taken(&self) -> Vec<(&'static str, &Path)> {
        let read = self.files.iter().map(|path| (READ, path.as_path()));
        read.chain(self.record.map(|record| ("it has to be another file than that of --record", record))).collect()
    }

    /// The oracles that are asked beside them unless others are named.
    pub fn panel(&self) -> Panel {
        let models: Vec<Model> = self.entries.iter().map(|entry| entry.launch.model).collect();
        panel::beside(&models)
    }

    /// Starts the engines; none if they broke, which is told.
    ///
    /// # Errors
    /// When the record can't be written.
    pub fn start(self) -> anyhow::Result<Option<Engines>> {
        let record = self.record.map(Record::new).transpose()?;
        let keeper = record.as_ref().map_or_else(Keeper::default, |record| Keeper::of(&record.recording));
        match Fleet::start(&self.entries, sensitive, &keeper) {
            Ok(fleet) => {
                let (manifest, checksum) = (self.manifest.to_owned(), self.checksum);
                Ok(Some(Engines { fleet, manifest, checksum, record }))
            }
            Err(broke) => {
                for (name, broke) in broke {
                    note(format_args!("chattercheck: {name}: {broke}"));
                    broke.stderr.lines().for_each(|line| note(format_args!("  | {line}")));
                }
                Record::finish(record)?;
                Ok(None)
            }
        }
    }
}

/// Hands `then` what the gate has to be told of the panel and of these engines of a manifest: the same for a run and for its parts put together.
pub(super) fn with_roles<T>(engines: &[EngineAsked], manifest: &str, then: impl FnOnce(&Roles<'_>) -> T) -> T {
    let engine = |name: &str| engines.iter().find(|asked| asked.engine.name == name);
    let may_decline =
        |oracle: &str| engine(oracle).map_or_else(|| panel::may_decline(oracle), |asked| asked.may_decline);
    let granted = |oracle: &str| engine(oracle).is_some_and(|asked| !asked.engine.claims);
    let never_rests = |oracle: &str| engine(oracle).is_some_and(|asked| asked.never_at_rest);
    let shown_by = |oracle: &str, flags: &str| match engine(oracle) {
        Some(_) => format!("chattercheck engine ask {oracle} --engines {manifest} {flags}"),
        None => panel::shown_by(oracle, flags),
    };
    let roles = panel::roles();
    then(&Roles {
        may_decline: &may_decline,
        granted: &granted,
        never_rests: &never_rests,
        shown_by: &shown_by,
        ..roles
    })
}

impl Engines {
    /// The oracles of the panel, then the engines.
    pub fn beside<'a>(&'a self, panel: &[&'a dyn Oracle]) -> Vec<&'a dyn Oracle> {
        panel.iter().copied().chain(self.fleet.oracles()).collect()
    }

    /// Hands `then` what the gate has to be told of the panel and of the engines.
    pub fn with_roles<T>(&self, then: impl FnOnce(&Roles<'_>) -> T) -> T {
        with_roles(&self.asked(), &self.path(), then)
    }

    /// Hands `then` who the engines are, and what is known to fail with them. The clock is told of what is right.
    pub fn with_guests<T>(&self, known: &[Known], clock: &Clock, then: impl FnOnce(&Guests<'_>) -> T) -> T {
        let is_guest = |oracle: &str| self.fleet.engine(oracle).is_some();
        let was_right = |oracle: &str, case: &Case| clock.note(oracle, case);
        then(&Guests { is_guest: &is_guest, known, was_right: &was_right })
    }

    /// What mistakes would explain the wrong answers of the engine of this name, of those that were kept; `None` if there is none.
    pub fn explain(&self, name: &str, tally: &Tally) -> Option<Explained> {
        explain::for_guest(name, self.fleet.engine(name)?.entry.launch.model, tally)
    }

    /// The engines, as far as the verdict on them depends on more than their answers.
    pub fn asked(&self) -> Vec<EngineAsked> {
        let asked = |started: &Started| EngineAsked {
            engine: started.described(),
            model: match started.entry.launch.model {
                Model::Linear => "linear",
                Model::Nonlinear => "nonlinear",
            }
            .to_owned(),
            may_decline: started.entry.may_decline,
            never_at_rest: started.entry.never_at_rest,
            manifest: self.checksum.clone(),
        };
        self.fleet.engines.iter().map(asked).collect()
    }

    /// The manifest, as it was given; nothing without one.
    pub fn path(&self) -> String {
        self.manifest.display().to_string()
    }

    /// The flag that names the manifest, for commands that are shown.
    pub fn flag(&self) -> String {
        if self.fleet.engines.is_empty() { String::new() } else { format!(" --engines {}", self.manifest.display()) }
    }

    /// Ends the engines, tells which did not want to, and puts the record where it goes.
    ///
    /// # Errors
    /// When the record can't be written.
    pub fn stop(self) -> anyhow::Result<()> {
        for (name, broke) in self.fleet.stop() {
            note(format_args!("chattercheck: {name}: {broke}"));
        }
        Record::finish(self.record)
    }
}

impl Record {
    fn new(path: &Path) -> anyhow::Result<Self> {
        if path == Path::new("-") {
            return Err(Invalid::new("record", "-", "a file").into());
        }
        let failed = || format!("cannot write {}", path.display());
        if path.is_dir() {
            bail!("{}: it is a folder", failed());
        }
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let file = NamedTempFile::new_in(folder).with_context(failed)?;
        let recording = Arc::new(Recording::new(BufWriter::new(file.reopen().with_context(failed)?)));
        Ok(Self { path: path.to_owned(), file, recording })
    }

    fn finish(record: Option<Self>) -> anyhow::Result<()> {
        let Some(Self { path, file, recording }) = record else { return Ok(()) };
        let failed = || format!("cannot write {}", path.display());
        recording.finish().with_context(failed)?;
        file.persist(&path).with_context(failed)?;
        Ok(())
    }
}
