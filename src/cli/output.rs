//! Printing for people, where a reader that has gone away must not change the exit status.

use std::io::{self, Write as _};

/// Prints a text to stdout. A reader that has seen enough, as in `chattercheck verify | head`, is no error.
///
/// # Errors
/// When stdout can't be written to for any other reason.
pub(super) fn print(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}
