//! Where a case comes in: from a file, or generated.

pub mod case_file;
pub mod case_list;
pub mod generate;
pub mod hex_float;
pub mod shaking;
pub mod toml_error;
