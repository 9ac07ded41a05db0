//! What a part of a run says of itself.

use crate::gate::{report::Report, responses, shortfall::Shortfall, verdict::Verdict};

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
        let undecided = |broke: bool| broke.then_some(Verdict::Undecided);
        for engine in &mut self.engines {
            engine.verdict = Verdict::of(engine.wrong, undecided(engine.broke > 0));
        }
        let broke = self.failures.iter().filter(|failure| failure.is_breakdown()).count();
        let wrong = self.failures.len() - broke;
        let of_responses = self.responses.iter().map(responses::Report::verdict);
        let other = self.shortfalls.iter().map(Shortfall::verdict).chain(undecided(broke > 0)).chain(of_responses);
        self.verdict = Verdict::of(wrong, other);
        self
    }
}
