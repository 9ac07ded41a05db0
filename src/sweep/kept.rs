//! What a sweep keeps while it runs, so that it goes on after an interruption: its rows in `OUT.rows`, and beside them in `OUT.sweep` the mark of what they are
//! of. When all is whole the rows become `OUT`, and the mark goes.

use std::{
    ffi::OsString,
    fs::{self, File, OpenOptions, TryLockError},
    io::{self, BufRead as _, BufReader, Read as _, Seek as _, SeekFrom, Write as _},
    path::{Path, PathBuf},
};

use serde::{Deserialize, Serialize};

use super::{Stretch, Sweep};

/// What rows are of: a sweep, a part of it, and the program that made them.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mark {
    /// The version of the program.
    pub version: String,
    /// The checksum of the text of the sweep.
    pub sweep: String,
    /// That of the other files that it is made of.
    pub files: String,
    /// Which part, `K/N`.
    pub partition: String,
}

/// The rows so far, open to be added to. While they are, no other process has them.
#[derive(Debug)]
pub struct Kept {
    out: PathBuf,
    rows: File,
    /// Locked.
    mark: File,
    /// How many points are whole.
    pub whole: usize,
}

/// Why rows can't be kept.
#[derive(Debug, thiserror::Error)]
pub enum NotKept {
    /// The table is there.
    #[error("out = {0} is there already and is not written over; delete it, or choose another --out")]
    There(String),
    /// Another process is at it.
    #[error("out = {0}: another run is at work on it, and keeps {0}.sweep locked")]
    Busy(String),
    /// The rows that are there are of something else.
    #[error(
        "out = {out}: the rows in {out}.rows are of another {what}: {there} there, {here} asked; delete them and {out}.sweep, or choose another --out"
    )]
    Other {
        /// The table.
        out: String,
        /// In what they differ.
        what: &'static str,
        /// What it is there.
        there: String,
        /// What it is here.
        here: String,
    },
    /// What there is can't be read as what it should be.
    #[error("out = {out}: {out}.{which} is {what}; delete {out}.rows and {out}.sweep, or choose another --out")]
    Strange {
        /// The table.
        out: String,
        /// Which of the two files.
        which: &'static str,
        /// What it is.
        what: &'static str,
    },
    /// A file can't be read or written.
    #[error("cannot write {path}")]
    Failed {
        /// The file.
        path: String,
        /// What the system says.
        source: io::Error,
    },
}

impl Mark {
    /// In what another one differs, with what it is there and here.
    fn difference(&self, there: &Self) -> Option<(&'static str, String, String)> {
        let short = |sum: &String| sum.chars().take(12).collect();
        [
            ("version", there.version.clone(), self.version.clone()),
            ("sweep (its file has changed)", short(&there.sweep), short(&self.sweep)),
            ("scene or record (a file has changed)", short(&there.files), short(&self.files)),
            ("partition", there.partition.clone(), self.partition.clone()),
        ]
        .into_iter()
        .find(|(_, there, here)| there != here)
    }
}

impl Kept {
    /// Opens what is kept of a stretch of a sweep for the table `out`, or begins it. What is not whole of the rows is dropped.
    ///
    /// # Errors
    /// When the table is there, another process is at it, or what is kept is of something else.
    pub fn open(out: &Path, sweep: &Sweep, stretch: &Stretch, mark: &Mark) -> Result<Self, NotKept> {
        let shown = || out.display().to_string();
        let strange = |which, what| NotKept::Strange { out: shown(), which, what };
        let [rows_path, mark_path] = ["rows", "sweep"].map(|what| beside(out, what));
        let failed = |path: &Path| {
            let path = path.display().to_string();
            move |source| NotKept::Failed { path, source }
        };
        is_free(out)?;
        let mut open = OpenOptions::new();
        open.read(true).write(true).create(true).truncate(false);
        let mut mark_file = open.open(&mark_path).map_err(failed(&mark_path))?;
        match mark_file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(NotKept::Busy(shown())),
            Err(TryLockError::Error(error)) => return Err(failed(&mark_path)(error)),
        }
        // Another process may have finished in between.
        is_free(out)?;
        let mut there = String::new();
        mark_file.read_to_string(&mut there).map_err(|_| strange("sweep", "no mark of a sweep"))?;
        if there.is_empty() {
            if fs::metadata(&rows_path).is_ok_and(|rows| rows.len() > 0) {
                return Err(strange("rows", "there without its mark"));
            }
            let text = serde_json::to_string(mark).map_err(|error| failed(&mark_path)(error.into()))? + "\n";
            let written = mark_file.write_all(text.as_bytes()).and_then(|()| mark_file.sync_all());
            written.map_err(failed(&mark_path))?;
        } else {
            let there: Mark =
                serde_json::from_str(&there).map_err(|_| strange("sweep", "no mark of a sweep of this version"))?;
            if let Some((what, there, here)) = mark.difference(&there) {
                return Err(NotKept::Other { out: shown(), what, there, here });
            }
        }
        let mut rows = open.open(&rows_path).map_err(failed(&rows_path))?;
        let head = if stretch.has_head { sweep.header() } else { String::new() };
        let (bytes, whole) = whole(&rows, &head, sweep, stretch).map_err(failed(&rows_path))?;
        let cut = rows.set_len(bytes).and_then(|()| rows.seek(SeekFrom::End(0)));
        let begun = cut.and_then(|_| if bytes == 0 { rows.write_all(head.as_bytes()) } else { Ok(()) });
        begun.map_err(failed(&rows_path))?;
        Ok(Self { out: out.to_owned(), rows, mark: mark_file, whole })
    }

    /// Adds rows.
    ///
    /// # Errors
    /// When they can't be written.
    pub fn add(&mut self, rows: &str, points: usize) -> Result<(), NotKept> {
        self.rows.write_all(rows.as_bytes()).map_err(|error| self.failed(error))?;
        self.whole += points;
        Ok(())
    }

    /// The rows, which are all there now, become the table.
    ///
    /// # Errors
    /// When they can't be.
    pub fn finish(self) -> Result<(), NotKept> {
        self.rows.sync_all().map_err(|error| self.failed(error))?;
        is_free(&self.out)?;
        fs::rename(beside(&self.out, "rows"), &self.out).map_err(|error| self.failed(error))?;
        let gone = fs::remove_file(beside(&self.out, "sweep"));
        drop(self.mark);
        gone.map_err(|source| NotKept::Failed { path: beside(&self.out, "sweep").display().to_string(), source })
    }

    fn failed(&self, source: io::Error) -> NotKept {
        NotKept::Failed { path: beside(&self.out, "rows").display().to_string(), source }
    }
}

/// A table that is there is not written over.
fn is_free(out: &Path) -> Result<(), NotKept> {
    if out.symlink_metadata().is_ok() { Err(NotKept::There(out.display().to_string())) } else { Ok(()) }
}

/// The path with another ending after its own.
fn beside(out: &Path, ending: &str) -> PathBuf {
    let mut name = OsString::from(out);
    name.push(".");
    name.push(ending);
    name.into()
}

/// How many bytes and points are whole: up to the first line that is torn, or is not that of its point.
fn whole(rows: &File, head: &str, sweep: &Sweep, stretch: &Stretch) -> io::Result<(u64, usize)> {
    let mut reader = BufReader::with_capacity(1 << 20, rows);
    let mut line = Vec::new();
    let mut next = |line: &mut Vec<u8>| {
        line.clear();
        reader.read_until(b'\n', line)
    };
    let mut bytes = head.len() as u64;
    if !head.is_empty() {
        next(&mut line)?;
        if line != head.as_bytes() {
            return Ok((0, 0));
        }
    }
    let mut place = String::new();
    for (count, point) in stretch.points.clone().enumerate() {
        place.clear();
        sweep.points.write(point, &mut place);
        next(&mut line)?;
        let rest = line.strip_prefix(place.as_bytes()).and_then(|rest| rest.strip_suffix(b"\n"));
        let is_whole = |rest: &[u8]| rest.iter().filter(|byte| **byte == b',').count() + 1 == sweep.columns.len();
        if !rest.is_some_and(is_whole) {
            return Ok((bytes, count));
        }
        bytes += line.len() as u64;
    }
    Ok((bytes, stretch.points.len()))
}
