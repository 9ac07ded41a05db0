//! Results that are kept in files, to be read by another process: a file says itself whether it is whole, and gives back every number to the last bit.
//!
//! Such a file is text, a JSON document a line: a first line that says what it is, the lines of content, and a footer with how many they are and a checksum of
//! all that is above. It is written beside its place and put there when it is whole, so that no half of one is ever found under its name.

mod exact;
mod whole_file;

pub use exact::{from_line, to_line};
pub use whole_file::{NotWhole, Put, put, read, sha256};
