//! A history becomes numbers: asking an oracle, what is observed, the sum of infinitely many intervals, and how much each number may move.

pub mod asking;
pub mod clock;
pub mod closing;
pub mod conditioning;
pub mod critical;
pub mod excitation;
pub mod ground;
pub mod model_gap;
pub mod observables;
pub mod sharpest;
pub mod threshold;
pub mod zeno;
