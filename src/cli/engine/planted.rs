use std::io;

use anyhow::Context as _;
use chattercheck::{
    cases::toml_error::printable,
    engines::serve::serve,
    faults::{
        catalogue::of_engines,
        confusion,
        plant::{Plant, Planted},
        stepper::Wrong,
    },
    panel,
};
use clap::Args;
use contract::{Invalid, Oracle};

use crate::cli::{Status, numbers::number, output::say};

/// Be an engine that makes a mistake of the catalogue, to see what the gate makes of it; without a name, list the mistakes
///
/// It speaks the protocol on its standard input and output: run = ["chattercheck", "engine", "planted", "late clock"] in a manifest.
#[derive(Args)]
pub(super) struct Arguments {
    /// The name of the mistake, or `none`
    fault: Option<String>,
    /// How large it is [default: what it is where it is really made; of one at an impact, 7]
    #[arg(long, value_name = "S", requires = "fault", allow_hyphen_values = true, value_parser = number)]
    size: Option<f64>,
    /// Of mistakes that more than one oracle can make: the name of that which makes it
    #[arg(long, value_name = "NAME", requires = "fault")]
    oracle: Option<String>,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let faults = of_engines();
    let Some(name) = &arguments.fault else {
        let lines = faults.iter().map(|fault| format!("{:36} {:16} as if {}\n", fault.name, fault.oracle, fault.as_if));
        say(&lines.collect::<String>())?;
        return Ok(Status::Well);
    };
    if name == "none" && arguments.oracle.is_none() && arguments.size.is_none() {
        // A method of its own, as another simulator would be.
        let plant = Plant::Stepper(|_| Wrong::default());
        return talk("no mistake", &Planted { honest: panel::stepper().as_ref(), plant, size: 0.0 });
    }
    let wanted = |oracle: &str| arguments.oracle.as_ref().is_none_or(|wanted| wanted == oracle);
    let fault = faults.iter().find(|fault| fault.name == name && wanted(&fault.oracle)).ok_or_else(|| {
        let (field, value) = match &arguments.oracle {
            Some(oracle) if faults.iter().any(|fault| fault.name == name) => ("oracle", oracle),
            _ => ("fault", name),
        };
        Invalid::new(field, printable(value), "what `chattercheck engine planted` lists, or none")
    })?;
    let honest = confusion::honest(fault);
    let size = arguments.size.unwrap_or_else(|| confusion::size(fault));
    let planted = Planted { honest: honest.as_ref(), plant: fault.plant, size };
    talk(fault.name, &planted)
}

fn talk(name: &str, oracle: &dyn Oracle) -> anyhow::Result<Status> {
    match serve(name, oracle, io::stdin().lock(), io::BufWriter::new(io::stdout().lock())) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(error).context("what came on stdin is no question")
        }
        _ => Ok(Status::Well),
    }
}
