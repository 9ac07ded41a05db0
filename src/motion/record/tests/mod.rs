//! Small files with the quirks that real ones have, and what has to be read from them or said about them.

mod channels;
mod fuzz;
mod peer;
mod plain;
mod refused;
mod round_trip;
mod times;

use super::{Asked, RecordError, Recorded, Step, Units, read};

/// The file gives everything.
const FILE: Asked = Asked { units: None, step: Step::OfFile, column: None };
/// Who asks gives units and step.
const GIVEN: Asked = Asked { units: Some(Units::G), step: Step::Seconds(0.02), column: None };

fn text(text: &str, asked: Asked) -> Result<Recorded, RecordError> {
    read(text.as_bytes(), &asked)
}

/// What is wrong, as it is said.
fn wrong(file: &str, asked: Asked) -> String {
    match text(file, asked) {
        Ok(read) => panic!("{file:?} was read as {read:?}"),
        Err(error) => {
            let error = error.to_string();
            assert_eq!(error.lines().count(), 1, "{error}");
            assert!(!error.contains(char::is_control), "{error:?}");
            error
        }
    }
}
