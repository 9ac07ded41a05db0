//! What is measured once, recorded and drawn: the paper, where methods fail, what precision costs.

pub mod atlas;
pub mod chart;
pub mod chattering_threshold;
pub mod diagnose;
pub mod engine_profile;
pub mod paper;
pub mod plan_map;
pub mod reference;
pub mod remaining_time;
pub mod specimens;
pub mod work_precision;
