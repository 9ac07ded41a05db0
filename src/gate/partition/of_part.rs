//! What a part of a run says of itself.

use crate::gate::{report::Report, responses, shortfall::Shortfall};

impl Report {
    /// The same of a part of a run: without what only the whole of it can prove. What is wrong with its cases stands.
    #[must_use]
    pub fn of_part(mut self) -> Self {
        self.shortfalls.retain(|short| matches!(short, Shortfall::Interrupted { .. } | Shortfall::Unaccounted { .. }));
        self.not_judged.clear();
        if let Some(of) = &mut self.responses {
            of.shortfalls.retain(|short| matches!(short, responses::Shortfall::Interrupted { .. }));
            of.not_judged.clear();
        }
        self.concluded()
    }
}
