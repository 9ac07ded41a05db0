//! Parts become the run that they are the parts of.

use std::collections::HashMap;

use super::Part;
use crate::gate::{responses, run::Run};

/// A run whose parts were put together.
pub struct Whole {
    /// What was found in cases.
    pub run: Run,
    /// What was found in whole responses, where any were run.
    pub responses: Option<responses::Report>,
}

/// Adds parts up. Cases, of which `places` says where they are in the run, are in its order again; nothing of what was concluded in a part is kept.
/// `None` where there are no parts.
pub fn join(parts: Vec<Part>, places: &HashMap<String, usize>) -> Option<Whole> {
    let count = parts.len();
    let mut parts = parts.into_iter();
    let Part { partition, request, mut run, mut responses, .. } = parts.next()?;
    for part in parts {
        run.add(part.run);
        responses = match (responses, part.responses) {
            (Some(mine), Some(theirs)) => Some(mine.and(theirs)),
            (mine, theirs) => mine.or(theirs),
        };
    }
    // What was to be run by all parts is what was asked: a case that fell to none of them is missing.
    if count == partition.parts {
        run.handed = request.all;
    }
    let place = |name: &String| places.get(name).copied().unwrap_or(usize::MAX);
    run.failures.sort_by_cached_key(|failure| place(&failure.named.to_string()));
    run.left_out.sort_by_key(place);
    Some(Whole { run, responses: responses.map(responses::Report::in_order) })
}
