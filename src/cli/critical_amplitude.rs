use anyhow::anyhow;
use chattercheck::{measure::critical, panel};
use clap::Args;
use serde::Serialize;

use super::{Status, numbers::number, output::Format};

/// The critical amplitude of the linear model: below it the chattering is complete, above it incomplete; with a proof of both
///
/// Seconds for eta up to 0.97; the nearer eta is to 1, the longer it takes.
#[derive(Args)]
pub(super) struct Arguments {
    /// Frequency ratio omega_g/p, 0.1 to 100
    #[arg(long, value_name = "W", allow_hyphen_values = true, value_parser = number)]
    omega: f64,
    /// Coefficient of restitution, 0.1 to 0.98
    #[arg(long, value_name = "E", allow_hyphen_values = true, value_parser = number)]
    eta: f64,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Serialize)]
struct Answer {
    omega: f64,
    eta: f64,
    a_cr: f64,
    /// An amplitude whose chattering is proven to be complete, rounded down.
    lower: String,
    /// One whose chattering is proven to be incomplete, rounded up.
    upper: String,
    certified: bool,
    /// `β` of `1 - τ_ch/(T/2) ~ K (a_cr - a)^β`.
    exponent: f64,
    eq76: f64,
    eq77: f64,
}

/// Digits enough to tell the two amplitudes apart.
const DIGITS: u32 = 18;

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let &Arguments { omega, eta, format } = arguments;
    let critical = panel::critical_amplitude(omega, eta, DIGITS).map_err(|decline| anyhow!("{decline}"))?;
    let answer = Answer {
        omega,
        eta,
        a_cr: critical.a_cr,
        lower: critical.complete_at,
        upper: critical.incomplete_at,
        certified: true,
        exponent: critical.exponent,
        eq76: critical::eq76(omega, eta),
        eq77: critical::eq77(eta),
    };
    format.print(&answer, text)?;
    Ok(Status::Well)
}

fn text(answer: &Answer) -> String {
    let Answer { a_cr, lower, upper, exponent, eq76, eq77, .. } = answer;
    let off = |fit: f64| format!("{fit:.5} (off by {:+.1e})", fit - a_cr);
    format!(
        "a_cr = {a_cr:.12}\n  proven: complete at {lower}\n          incomplete at {upper}\n  1 - tau_ch/(T/2) ~ (a_cr - a)^{exponent:.6}\n  \
         Eq. 76 gives {}, Eq. 77 gives {}",
        off(*eq76),
        off(*eq77)
    )
}
