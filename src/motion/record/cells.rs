//! The columns of a line.

use super::text::words;

/// What separates the columns of a line: semicolons or commas, between which an empty one counts; `None` for blanks.
pub fn separator(line: &[u8]) -> Option<u8> {
    [b';', b','].into_iter().find(|separator| line.contains(separator))
}

/// How many columns a line has.
pub fn columns(line: &[u8]) -> usize {
    match separator(line) {
        None => words(line).count(),
        // One at the end ends the last column.
        Some(separator) => {
            let line = line.strip_suffix(&[separator]).unwrap_or(line);
            1 + line.iter().filter(|byte| **byte == separator).count()
        }
    }
}

/// A field without blanks and quotes around it.
fn unquoted(field: &[u8]) -> &[u8] {
    let field = field.trim_ascii();
    field.strip_prefix(b"\"").and_then(|field| field.strip_suffix(b"\"")).unwrap_or(field).trim_ascii()
}

/// A column of a line, the first being 1.
pub fn column(line: &[u8], number: usize) -> Option<&[u8]> {
    let place = number.checked_sub(1)?;
    match separator(line) {
        None => words(line).nth(place),
        Some(separator) => line.split(|byte| *byte == separator).nth(place).map(unquoted),
    }
}
