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

/// The name of an ending.
pub fn ending_name(ending: Ending) -> &'static str {
    match ending {
        Ending::NeverRocks => "never-rocks",
        Ending::AtRest => "at-rest",
        Ending::Incomplete => "incomplete",
        Ending::Overturned => "overturned",
        Ending::LimitReached(_) => "limit-reached",
        Ending::Lost(_) => "lost",
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ending_is_known_by_its_name() {
        for end in [
            Ending::NeverRocks,
            Ending::AtRest,
            Ending::Incomplete,
            Ending::Overturned,
            Ending::LimitReached(Limit::Impacts),
            Ending::Lost(Loss::SolverFailed),
        ] {
            assert_eq!(ending(ending_name(end), true), Some(end));
        }
    }
}
