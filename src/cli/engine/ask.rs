use std::sync::Arc;

use anyhow::bail;
use chattercheck::engines::{
    Manifest, Started,
    record::{Keeper, Transcript},
};
use clap::Args;
use contract::{Case, Model, Oracle};

use super::{ManifestFlag, sensitive};
use crate::cli::{Status, case_flags::CaseFlags, numbers::count, output::say};

/// Ask one engine one case, and print both sides of the talk: what goes to it after >, what comes from it after <
///
/// Exit status 3: it broke.
#[derive(Args)]
pub(super) struct Arguments {
    /// The name of the engine
    name: String,
    #[command(flatten)]
    manifest: ManifestFlag,
    #[command(flatten)]
    case: CaseFlags,
    /// List this many impacts at the most
    #[arg(long, value_name = "N", default_value_t = Case::DEFAULT_IMPACTS, allow_negative_numbers = true, value_parser = count::<1, { Case::MOST_IMPACTS }>)]
    impacts: usize,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let case = arguments.case.case(arguments.impacts)?;
    let manifest = Manifest::read(arguments.manifest.path())?;
    let entry = manifest.engine(&arguments.name)?;
    arguments.check_model(entry.launch.model, &case)?;
    let talk = Arc::new(Transcript::default());
    let (answer, status) = match Started::new(entry, sensitive(), &Keeper::of(&talk)) {
        Err(broke) => (broke.to_string(), Status::Failed),
        Ok(started) => {
            let (answer, status) = match started.oracle.history(&case) {
                Ok(history) => (format!("{} impacts, {}", history.impacts.len(), history.ending), Status::Well),
                Err(decline) if decline.is_breakdown() => (decline.to_string(), Status::Failed),
                Err(decline) => (format!("declined: {decline}"), Status::Well),
            };
            match started.oracle.into_engine().stop().first() {
                Some(broke) => (format!("{answer}\n{}: {broke}", arguments.name), Status::Failed),
                None => (answer, status),
            }
        }
    };
    let mut lines = talk.lines();
    lines.push(format!("{}: {answer}", arguments.name));
    say(&(lines.join("\n") + "\n"))?;
    Ok(status)
}

impl Arguments {
    /// No option is silently ignored.
    fn check_model(&self, model: Model, case: &Case) -> anyhow::Result<()> {
        let (name, word) = (
            &self.name,
            match model {
                Model::Linear => "linear",
                Model::Nonlinear => "nonlinear",
            },
        );
        match (self.case.model(), self.case.alpha(), model) {
            (Some(asked), ..) if asked != word => {
                bail!("--model {asked}: the model of {name} is {word} (its manifest)")
            }
            (_, Some(alpha), Model::Linear) => bail!("--alpha {alpha}: {name} does not use it, its model is linear"),
            (_, None, Model::Nonlinear) if case.slenderness().is_none() => {
                bail!("--alpha is missing: the model of {name} is nonlinear")
            }
            _ => Ok(()),
        }
    }
}
