//! Files that commands write: that they can be is found out before the work; they are written beside where they go and put there when they are whole, so
//! that a full disk leaves what was there.

use std::{
    collections::BTreeMap,
    fs::{self, OpenOptions},
    io,
    path::{Path, PathBuf},
};

use anyhow::{Context as _, anyhow, bail};
use chattercheck::studies::chart;

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
            tempfile::tempdir_in(folder_of(&path)).with_context(refused)?;
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
        let name = self
            .path
            .file_name()
            .and_then(|name| name.to_str())
            .ok_or_else(|| anyhow!("not a name"))
            .with_context(failed)?;
        chart::place(folder_of(&self.path), &BTreeMap::from([(name.to_owned(), text.to_owned())]))
            .with_context(failed)?;
        Ok(())
    }
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
    tempfile::tempdir_in(folder).with_context(|| format!("{option} = {} cannot be written to", folder.display()))?;
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
    tempfile::tempdir_in(there).with_context(refused)?;
    Ok(())
}
