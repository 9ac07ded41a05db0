use std::path::PathBuf;

use anyhow::anyhow;
use chattercheck::studies::{
    chart,
    diagnose::{CHARTS, Scope, Tables},
};
use clap::Args;
use contract::Invalid;

use super::{
    Status,
    files::make_folder,
    numbers::{number, whole},
    output::say,
};

/// Where and why the asymptotic series breaks near the critical amplitude: tables (CSV), and charts (SVG) drawn from them
///
/// Error against the amplitude for each order and resummed, coefficients and their ratios, where each order first errs by 1 %, the exponent
/// of the approach measured in three ways, and the fits of the critical amplitude. About a minute.
#[derive(Args)]
pub(super) struct Arguments {
    /// Where the files go
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Frequency ratio of the charts at one frequency, 0.5 to 8
    #[arg(long, value_name = "W", default_value = "2", allow_hyphen_values = true, value_parser = number)]
    omega: f64,
    /// Restitutions of the charts with a panel for each, 0.5 to 0.98, separated by commas
    #[arg(long, value_name = "E,E,...", default_value = "0.5,0.8,0.92,0.97", value_delimiter = ',', allow_hyphen_values = true, value_parser = among_others)]
    eta: Vec<f64>,
    /// How many steps each axis of the maps over omega and eta has, 1 to 200
    #[arg(long, value_name = "N", default_value_t = 16, allow_negative_numbers = true, value_parser = whole::<1, 200>)]
    grid: i64,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let Arguments { out, omega, eta, grid } = arguments;
    let request = request(*omega, eta, *grid)?;
    // First, because what follows takes a while.
    make_folder("out", out)?;
    let bar = indicatif::ProgressBar::new_spinner();
    let tables = Tables::measure(&request, || bar.inc(1)).map_err(|decline| anyhow!("{decline}"))?;
    bar.finish_and_clear();
    say(&chart::write(out, &tables.files()?, &CHARTS)?)?;
    Ok(Status::Well)
}

/// A number of a list, with or without a space before it.
fn among_others(text: &str) -> Result<f64, &'static str> {
    number(text.trim())
}

fn request(omega: f64, etas: &[f64], grid: i64) -> Result<Scope, Invalid> {
    if !(0.5..=8.0).contains(&omega) {
        return Err(Invalid::new("omega", omega, "0.5 to 8"));
    }
    if let Some(eta) = etas.iter().find(|eta| !(0.5..=0.98).contains(*eta)) {
        return Err(Invalid::new("eta", eta, "0.5 to 0.98, separated by commas"));
    }
    if let Some(eta) = etas.iter().enumerate().find(|(k, eta)| etas.iter().take(*k).any(|other| other == *eta)) {
        return Err(Invalid::new("eta", eta.1, "each restitution once"));
    }
    let steps = usize::try_from(grid).ok().filter(|grid| (1..=200).contains(grid));
    let grid = steps.ok_or_else(|| Invalid::new("grid", grid, "1 to 200"))?;
    Ok(Scope { omega, etas: etas.to_vec(), grid, ..Scope::default() })
}
