//! Files that commands write: that they can be is found out before the work; they are written beside where they go and put there when they are whole, so
//! that a full disk leaves what was there.

use std::{
    fs::{self, OpenOptions},
    io::{self, Write as _},
    path::{Path, PathBuf},
};

use anyhow::{Context as _, bail};
use chattercheck::studies::chart;
use contract::Invalid;

use super::output;

/// A file to be written.
pub(super) struct Target {
    /// As it was given.
    pub given: PathBuf,
    /// Without links.
    path: PathBuf,
    kind: Kind,
}

#[derive(PartialEq, Eq)]
enum Kind {
    /// `-`
    Stdout,
    /// A pipe or a device, which nothing can be put in the place of.
    Special,
    File,
}

impl Target {
    /// The file that `given` names, if it can be written. What is in it stays.
    ///
    /// # Errors
    /// When it can't be written.
    pub fn new(given: &Path) -> anyhow::Result<Self> {
        let refused = || format!("cannot write {}", given.display());
        if given == Path::new("-") {
            return Ok(Self { given: given.to_owned(), path: given.to_owned(), kind: Kind::Stdout });
        }
        let path = resolve(given).with_context(refused)?;
        let there = fs::metadata(given).ok();
        if there.as_ref().is_some_and(fs::Metadata::is_dir) {
            return Err(io::Error::from(io::ErrorKind::IsADirectory)).with_context(refused);
        }
        // A pipe would wait for its reader.
        if there.as_ref().is_some_and(fs::Metadata::is_file) {
            OpenOptions::new().append(true).open(&path).with_context(refused)?;
        }
        let kind = if there.is_none_or(|there| there.is_file()) { Kind::File } else { Kind::Special };
        if kind == Kind::File {
            chart::folder_in(folder_of(&path)).with_context(refused)?;
        }
        Ok(Self { given: given.to_owned(), path, kind })
    }

    /// Whether it is stdout.
    pub fn is_stdout(&self) -> bool {
        self.kind == Kind::Stdout
    }

    /// Whether both are one file, however it is named.
    pub fn is(&self, other: &Self) -> bool {
        self.path == other.path
    }

    /// The path without links, if there is such a file or a folder for it.
    pub fn resolved(path: &Path) -> Option<PathBuf> {
        resolve(path).ok()
    }

    /// Whether it is the file at this path, which is without links.
    pub fn is_at(&self, path: &Path) -> bool {
        self.kind != Kind::Stdout && self.path == path
    }

    /// Writes the whole file, or leaves what was there.
    ///
    /// # Errors
    /// When it can't be written.
    pub fn write(&self, text: &str) -> anyhow::Result<()> {
        let failed = || format!("cannot write {}", self.given.display());
        match self.kind {
            Kind::Stdout => return Ok(output::print(text)?),
            Kind::Special => return fs::write(&self.path, text).with_context(failed),
            Kind::File => {}
        }
        self.replace(text).with_context(failed)
    }

    /// Puts a file that is whole in the place of what was there.
    fn replace(&self, text: &str) -> io::Result<()> {
        let beside = chart::folder_in(folder_of(&self.path))?;
        let whole = beside.path().join("whole");
        fs::write(&whole, text)?;
        fs::rename(&whole, &self.path)
    }
}

/// An option that names a file to be written.
#[derive(Clone, Copy)]
pub(super) struct FileOption<'a> {
    /// Its name.
    pub name: &'static str,
    /// What is allowed for the others where this one is given.
    pub beside: &'static str,
    /// The file, if it is given.
    pub path: Option<&'a Path>,
}

/// The files that are given, each with what goes into it. That they can be written is found out before the work, not after it. What is in them stays.
///
/// # Errors
/// When one can't be written, or two are the same, or one is among the files that are `taken`: what is allowed then, and the path.
pub(super) fn targets<'a, Content>(
    options: impl IntoIterator<Item = (Content, FileOption<'a>)>,
    taken: &[(&'static str, &Path)],
) -> anyhow::Result<Vec<(Content, Target)>> {
    let mut files: Vec<(Content, Target)> = Vec::new();
    let mut besides: Vec<&'static str> = Vec::new();
    for (content, FileOption { name, beside, path }) in options {
        let Some(path) = path else { continue };
        let target = Target::new(path)?;
        let refused = |allowed| Invalid::new(name, path.display(), allowed);
        if let Some((_, beside)) = files.iter().zip(&besides).find(|((_, other), _)| other.is(&target)) {
            return Err(refused(beside).into());
        }
        // What is written over it would be the end of it.
        let is_taken = |taken: &Path| Target::resolved(taken).is_some_and(|taken| target.is_at(&taken));
        if let Some((allowed, _)) = taken.iter().find(|(_, taken)| is_taken(taken)) {
            return Err(refused(allowed).into());
        }
        files.push((content, target));
        besides.push(beside);
    }
    Ok(files)
}

/// Writes a new file, and nothing over one that is there.
///
/// # Errors
/// When it is there, or can't be written; nothing is left of it then.
pub(super) fn write_new(path: &Path, text: &str) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    let written = file.write_all(text.as_bytes());
    if written.is_err() {
        // What is half there is worth nothing.
        let _ = fs::remove_file(path);
    }
    written
}

/// Writes a file of `folder` under the first of the names `STEM-1.toml`, `STEM-2.toml`... that is free, or has the same text already: what another run has
/// left there stays, and the same run again leaves no more. `text` is told the path. The path.
///
/// # Errors
/// When it can't be written.
pub(super) fn write_numbered<Text>(folder: &Path, stem: &str, text: Text) -> anyhow::Result<PathBuf>
where
    Text: Fn(&Path) -> anyhow::Result<String>,
{
    for number in 1_u64.. {
        let path = folder.join(format!("{stem}-{number}.toml"));
        let text = text(&path)?;
        match write_new(&path, &text) {
            Ok(()) => return Ok(path),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                // A pipe would wait for its writer.
                if path.is_file() && fs::read(&path).is_ok_and(|there| there == text.as_bytes()) {
                    return Ok(path);
                }
            }
            Err(error) => return Err(error).with_context(|| format!("cannot write {}", path.display())),
        }
    }
    bail!("no name is free in {}", folder.display())
}

/// The path without links; that of a file which is not there yet through its folder.
fn resolve(path: &Path) -> io::Result<PathBuf> {
    match path.canonicalize() {
        Ok(path) if path.exists() => Ok(path),
        // A pipe of this process, such as /dev/stdout, has a name that leads nowhere.
        _ if path.exists() => Ok(path.to_owned()),
        Err(error) if path.is_symlink() => Err(error),
        _ => {
            let name = path.file_name().ok_or(io::ErrorKind::InvalidInput)?;
            Ok(folder_of(path).canonicalize()?.join(name))
        }
    }
}

/// The folder that a file is in.
fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Makes the folder that `option` names, and finds out that files can be put into it.
///
/// # Errors
/// When it is not a folder, can't be made one, or can't be written to.
pub(super) fn make_folder(option: &str, folder: &Path) -> anyhow::Result<()> {
    fs::create_dir_all(folder)
        .with_context(|| format!("{option} = {} is not a folder, and cannot be made one", folder.display()))?;
    chart::folder_in(folder).with_context(|| format!("{option} = {} cannot be written to", folder.display()))?;
    Ok(())
}

/// Finds out whether the folder that `option` names could be made and written to, without making it.
///
/// # Errors
/// When it could not.
pub(super) fn check_folder(option: &str, folder: &Path) -> anyhow::Result<()> {
    let refused = || format!("{option} = {} cannot be written to", folder.display());
    let there = folder.ancestors().map(|above| if above.as_os_str().is_empty() { Path::new(".") } else { above });
    let Some(there) = there.into_iter().find(|above| above.symlink_metadata().is_ok()) else { bail!(refused()) };
    chart::folder_in(there).with_context(refused)?;
    Ok(())
}
