//! The seed of the random cases, by a flag or by the environment.

use std::env;

use clap::Args;
use contract::Invalid;

/// The variable that sets the seed where no flag does.
const VARIABLE: &str = "CHATTERCHECK_SEED";

#[derive(Args)]
pub(super) struct Seed {
    /// Seed of the random cases, 0 to 18446744073709551615 [env: CHATTERCHECK_SEED, where that is not empty] [default: 1]
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = parse)]
    seed: Option<u64>,
}

impl Seed {
    /// The seed that the flag gives, or else the environment. A variable that is empty counts as one that is not set.
    ///
    /// # Errors
    /// When the variable is something else than a seed.
    pub fn value(&self) -> Result<u64, Invalid> {
        let variable = || env::var_os(VARIABLE).filter(|value| !value.is_empty());
        match (self.seed, variable()) {
            (Some(seed), _) => Ok(seed),
            (None, None) => Ok(1),
            (None, Some(text)) => {
                let text = text.to_string_lossy();
                parse(&text).map_err(|allowed| Invalid::new(VARIABLE, text, allowed))
            }
        }
    }
}

fn parse(text: &str) -> Result<u64, &'static str> {
    text.parse().map_err(|_| "a whole number, 0 to 18446744073709551615")
}
