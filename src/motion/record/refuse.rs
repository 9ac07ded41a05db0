//! What is no record at all: said before a reader stumbles over it.

use super::{
    MOST_BYTES, RecordError,
    error::shown,
    text::{self, Numbered},
};

/// Refuses what is no text with numbers in it.
pub fn other_than_text(bytes: &[u8]) -> Result<(), RecordError> {
    const EXPECTED: &str = "expected is the text file of a recorded acceleration";
    let whole = |what: &str| Err(RecordError::whole(format!("{what}; {EXPECTED}")));
    if bytes.len() > MOST_BYTES {
        return whole(&format!("a file of more than {MOST_BYTES} bytes"));
    }
    let text = bytes.trim_ascii();
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    if text.iter().all(u8::is_ascii_whitespace) {
        return whole("an empty file");
    }
    if text.starts_with(b"\xff\xfe") || text.starts_with(b"\xfe\xff") {
        return whole("a text in UTF-16; save it as UTF-8");
    }
    let is_odd = |byte: &u8| matches!(byte, 0..=8 | 14..=31 | 127);
    let inside = text.strip_suffix(b"\x1a").unwrap_or(text);
    // A block at a time, which the compiler makes quick.
    let has_odd = inside.chunks(256).any(|block| block.iter().fold(false, |odd, byte| odd | is_odd(byte)));
    let odd = if has_odd { inside.iter().position(is_odd) } else { None };
    if let Some(at) = odd {
        let line = 1 + bytes.iter().take(at).filter(|byte| **byte == b'\n').count();
        return Err(RecordError::at(line, format!("a binary file (byte {} is no text); {EXPECTED}", at + 1)));
    }
    let first = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let what = match text.first() {
        Some(b'<') => "a page in HTML or XML, perhaps of a failed download",
        Some(b'{') => "a file in JSON or RTF",
        _ if text.starts_with(b"%PDF") => "a PDF",
        _ => return Ok(()),
    };
    Err(RecordError::at(1, format!("`{}` begins {what}; {EXPECTED}", shown(first))))
}

/// Refuses a header that speaks of a velocity, a displacement or a spectrum, and not of an acceleration in time.
pub fn other_than_acceleration(header: &[Numbered<'_>]) -> Result<(), RecordError> {
    let says =
        |words: &[&str]| header.iter().copied().find(|(_, line)| words.iter().any(|word| text::contains(line, word)));
    let refused = |(number, line): Numbered<'_>, what: &str| {
        let message = format!("`{}` is of a {what}; expected is an acceleration in time", shown(line));
        Err(RecordError::at(number, message))
    };
    // An accelerogram may be matched to a spectrum.
    let in_time = || says(&["TIME SERIES", "TIME HISTOR", "TIME-HISTOR", "ACCELEROGRAM", "MATCH"]).is_some();
    if let Some(line) = says(&["SPECTRA", "SPECTRUM"]).filter(|_| !in_time()) {
        return refused(line, "spectrum");
    }
    if says(&["ACCEL"]).is_some() {
        return Ok(());
    }
    match (says(&["VELOCITY"]), says(&["DISPLACEMENT"])) {
        (Some(line), _) => refused(line, "velocity"),
        (_, Some(line)) => refused(line, "displacement"),
        _ => Ok(()),
    }
}

/// Refuses the volumes of the strong-motion programs that are laid out otherwise: they have headers in numbers, which would be read as samples.
pub fn unknown_volume(header: &[Numbered<'_>]) -> Result<(), RecordError> {
    let is_volume =
        |(_, line): &&Numbered<'_>| text::contains(line, "CORRECTED ACCELEROGRAM") || text::contains(line, "(Format v");
    match header.iter().take(3).find(is_volume) {
        Some((number, line)) => {
            let expected = "expected is a V2 file of COSMOS or CSMIP, or SMC";
            Err(RecordError::at(
                *number,
                format!("`{}` begins a file that is laid out otherwise; {expected}", shown(line)),
            ))
        }
        None => Ok(()),
    }
}
