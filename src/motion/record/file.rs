//! The file itself.

use std::{fs::File, io::Read, path::Path};

use super::{Asked, MOST_BYTES, RecordError, Recorded, line_with, read, text::Text};

/// Reads the file of a recorded ground motion, no more of it than is allowed.
///
/// # Errors
/// As [`read`], with the file in front; and when the file can't be read.
pub fn read_file(path: &Path, asked: &Asked) -> Result<Recorded, RecordError> {
    let of_file = |error: RecordError| error.of_file(&path.display().to_string());
    let bytes =
        bytes_of(path).map_err(|why| of_file(RecordError::whole(format!("the record can't be read: {why}"))))?;
    read(&bytes, asked).map_err(of_file)
}

/// In which line of the file of a record, from where its samples begin, a sample stands, and how it is typed there; `None` where it can't be found again.
#[must_use]
pub fn line_of_sample(path: &Path, read: &Recorded, sample: f64) -> Option<(usize, String)> {
    line_with(&Text::new(&bytes_of(path).ok()?), read.start, sample)
}

fn bytes_of(path: &Path) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
