//! A response that failed.

use super::examine::Finding;
use crate::cases::shaking::Question;

/// A response in which something was wrong.
#[derive(Debug, Clone, PartialEq)]
pub struct Failure {
    /// Its name, as in `response/17`.
    pub name: String,
    /// What was asked.
    pub question: Question,
    /// What was wrong.
    pub findings: Vec<Finding>,
}
