//! What the Python package `chattercheck` has in Rust: thin, as the commands are. Arrays come in as NumPy has them; the interpreter's lock is released while
//! something is computed.

mod cases;
mod certainty;
mod critical;
mod error;
mod gate;
mod plan;
mod record;
mod rock;
mod scene;
mod wait;

use pyo3::prelude::*;

#[pymodule]
mod _native {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::{
        cases::{chatter, chatter_one, impacts},
        certainty::{criterion, overturning},
        critical::critical_amplitude,
        gate::verify,
        plan::plan,
        record::read_record,
        rock::rock,
        scene::Scene,
    };

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("ENDINGS", super::cases::ENDINGS.to_vec())
    }
}
