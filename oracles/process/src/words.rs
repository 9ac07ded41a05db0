//! The words of the protocol for what the contract has types for.

use contract::{Ending, Limit, Loss, Model, Normalisation};

/// The name of a model.
pub fn model(model: Model) -> &'static str {
    match model {
        Model::Linear => "linear",
        Model::Nonlinear => "nonlinear",
    }
}

/// The name of what the amplitude is a multiple of.
pub fn normalisation(normalisation: Normalisation) -> &'static str {
    match normalisation {
        Normalisation::Threshold => "threshold",
        Normalisation::Slender => "slender",
    }
}

/// The ending of this name, of a history that lists all impacts asked for or fewer: that tells which limit was reached.
pub fn ending(name: &str, all_listed: bool) -> Option<Ending> {
    Some(match name {
        "never-rocks" => Ending::NeverRocks,
        "at-rest" => Ending::AtRest,
        "incomplete" => Ending::Incomplete,
        "overturned" => Ending::Overturned,
        "limit-reached" if all_listed => Ending::LimitReached(Limit::Impacts),
        "limit-reached" => Ending::LimitReached(Limit::Time),
        "lost" => Ending::Lost(Loss::SolverFailed),
        _ => return None,
    })
}
