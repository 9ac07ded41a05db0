//! Files that are whole or not there, and that show what became of them since.

use std::{
    fmt::Write as _,
    fs::{self, File},
    io::{self, Write as _},
    path::Path,
};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use tempfile::NamedTempFile;

/// The form of these files. A change that older programs can't read is another number.
const FORM: u32 = 1;

/// The first line.
#[derive(Serialize, Deserialize)]
struct Head {
    chattercheck: String,
    form: u32,
}

/// The last line.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Foot {
    end: End,
}

#[derive(Serialize, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
struct End {
    /// How many lines of content there are.
    lines: usize,
    /// The checksum of all lines above, the first one too.
    sha256: String,
}

/// What became of a file that was to be put somewhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Put {
    /// It is there.
    New,
    /// There is one already, which stays.
    TakenAlready,
}

/// Why a file is not what it should be.
#[derive(Debug, thiserror::Error)]
pub enum NotWhole {
    /// It can't be read.
    #[error("it cannot be read: {0}")]
    Unreadable(#[from] io::Error),
    /// It is something else.
    #[error("it is something else: a {wanted} begins with {{\"chattercheck\":\"{wanted}\"")]
    Other {
        /// What it should be.
        wanted: String,
    },
    /// It is of a form that this program does not know.
    #[error("it has form {0}, this program reads form {FORM}")]
    OtherForm(u32),
    /// It has no end.
    #[error("it ends before its end: half of it was written or copied")]
    CutOff,
    /// Its content is not what was written.
    #[error("it is damaged: its content does not have the checksum that it had when it was written")]
    Damaged,
}

/// Writes a file of this kind with these lines beside `path`, and puts it there when it is whole. What is there already stays.
///
/// # Errors
/// When it can't be written; nothing is left of it then.
pub fn put(path: &Path, kind: &str, lines: &[String]) -> io::Result<Put> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let head = serde_json::to_string(&Head { chattercheck: kind.to_owned(), form: FORM })?;
    let mut text = format!("{head}\n");
    for line in lines {
        text.push_str(line);
        text.push('\n');
    }
    let end = End { lines: lines.len(), sha256: sha256(text.as_bytes()) };
    text += &serde_json::to_string(&Foot { end })?;
    text.push('\n');
    let mut beside = NamedTempFile::new_in(folder)?;
    beside.write_all(text.as_bytes())?;
    // The name must not be on the disk before what it is the name of.
    beside.as_file().sync_all()?;
    match beside.persist_noclobber(path) {
        Ok(file) => {
            readable(&file)?;
            // So that the name is on the disk, too; not every system can.
            let _ = File::open(folder).and_then(|folder| folder.sync_all());
            Ok(Put::New)
        }
        Err(error) if error.error.kind() == io::ErrorKind::AlreadyExists => Ok(Put::TakenAlready),
        Err(error) => Err(error.error),
    }
}

/// Temporary files are their owner's alone; this one has become a file like any other.
#[cfg(unix)]
fn readable(file: &File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt as _;
    file.set_permissions(fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn readable(_: &File) -> io::Result<()> {
    Ok(())
}

/// The lines of a file of this kind, if it is whole.
///
/// # Errors
/// What became of it.
pub fn read(path: &Path, kind: &str) -> Result<Vec<String>, NotWhole> {
    let bytes = fs::read(path)?;
    let begins = format!("{{\"chattercheck\":\"{kind}\"");
    if !bytes.starts_with(begins.as_bytes().get(..bytes.len().min(begins.len())).unwrap_or_default()) {
        return Err(NotWhole::Other { wanted: kind.to_owned() });
    }
    let body = bytes.strip_suffix(b"\n").ok_or(NotWhole::CutOff)?;
    let last = body.iter().rposition(|byte| *byte == b'\n').ok_or(NotWhole::CutOff)? + 1;
    let (above, foot) = body.split_at_checked(last).ok_or(NotWhole::CutOff)?;
    let foot: Foot = match serde_json::from_slice(foot) {
        Ok(foot) => foot,
        // A footer that can't be read is one that was damaged; a line of content is none at all.
        Err(_) if foot.starts_with(b"{\"end\"") => return Err(NotWhole::Damaged),
        Err(_) => return Err(NotWhole::CutOff),
    };
    let text = std::str::from_utf8(above).map_err(|_| NotWhole::Damaged)?;
    let mut lines = text.lines();
    let head = lines.next().unwrap_or_default();
    let lines: Vec<String> = lines.map(str::to_owned).collect();
    if foot.end != (End { lines: lines.len(), sha256: sha256(above) }) {
        return Err(NotWhole::Damaged);
    }
    match serde_json::from_str(head) {
        Ok(Head { form: FORM, .. }) => Ok(lines),
        Ok(Head { form, .. }) => Err(NotWhole::OtherForm(form)),
        Err(_) => Err(NotWhole::Damaged),
    }
}

/// The checksum SHA-256, in hexadecimal.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

#[cfg(test)]
mod tests {
    use std::thread;

    use super::*;

    fn lines() -> Vec<String> {
        ["{\"one\":1.0}", "[2, \"zwei, дві\"]", ""].map(str::to_owned).to_vec()
    }

    #[test]
    fn the_checksum_is_the_one_that_others_compute() {
        assert_eq!(sha256(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }

    #[test]
    fn what_was_put_is_read_and_nothing_is_put_over_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.jsonl");
        assert_eq!(put(&path, "part", &lines()).unwrap(), Put::New);
        assert_eq!(read(&path, "part").unwrap(), lines());
        assert_eq!(put(&path, "part", &[]).unwrap(), Put::TakenAlready);
        assert_eq!(read(&path, "part").unwrap(), lines());
        assert!(matches!(read(&path, "sweep"), Err(NotWhole::Other { .. })));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is left beside it");
    }

    /// Cut off anywhere, and with any byte changed in one bit: what is read is what was written, or nothing.
    #[test]
    fn every_damage_is_seen() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.jsonl");
        put(&path, "part", &lines()).unwrap();
        let whole = fs::read(&path).unwrap();
        for length in 0..whole.len() {
            fs::write(&path, &whole[..length]).unwrap();
            let told = read(&path, "part");
            assert!(matches!(told, Err(NotWhole::CutOff)), "{length}: {told:?}");
        }
        for place in 0..whole.len() {
            for bit in 0..8 {
                let mut damaged = whole.clone();
                damaged[place] ^= 1 << bit;
                fs::write(&path, &damaged).unwrap();
                assert!(read(&path, "part").is_err(), "{place} {bit}");
            }
        }
        for more in ["x", "\n", "{\"end\":{}}\n"] {
            fs::write(&path, [&whole[..], more.as_bytes()].concat()).unwrap();
            assert!(read(&path, "part").is_err(), "{more:?}");
        }
    }

    #[test]
    fn of_many_that_put_the_same_at_once_one_does() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.jsonl");
        let all = thread::scope(|scope| {
            let threads: Vec<_> = (0..8).map(|_| scope.spawn(|| put(&path, "part", &lines()).unwrap())).collect();
            threads.into_iter().map(|thread| thread.join().unwrap()).collect::<Vec<_>>()
        });
        assert_eq!(all.iter().filter(|put| **put == Put::New).count(), 1);
        assert_eq!(read(&path, "part").unwrap(), lines());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
