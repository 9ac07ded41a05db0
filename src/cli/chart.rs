use std::{collections::BTreeMap, fs, path::PathBuf};

use anyhow::{Context as _, anyhow, ensure};
use chattercheck::studies::{
    atlas,
    chart::{self, Chart},
    plan_map, remaining_time, work_precision,
};
use clap::{Args, ValueEnum};
use contract::Invalid;

use super::{Status, files::make_folder, output::say};

/// Speed against accuracy, and where methods fail: tables (CSV), and charts (SVG) drawn from them
///
/// The work-precision charts show the error of the chattering time and of impact 40 against what they cost, in seconds and in work. The atlas
/// shows what each known way of handling the accumulation point does, near and far from the critical amplitude. The plan shows how much model a scene
/// needs, remaining-time what the local series says is left after each impact. Some minutes.
#[derive(Args)]
pub(super) struct Arguments {
    /// Where the files go
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Only one of the four parts
    #[arg(long, value_enum, value_name = "PART")]
    only: Option<Part>,
    /// Rows of the peers, from benches/peers, to be drawn beside the others
    #[arg(long, value_name = "FILE")]
    peers: Option<PathBuf>,
    /// Draw the charts again from the tables that are in DIR already, and measure nothing. A cell of theirs that is empty, inf or NaN is drawn as a failure
    #[arg(long, conflicts_with = "peers")]
    redraw: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Part {
    WorkPrecision,
    Atlas,
    Plan,
    RemainingTime,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let Arguments { out, only, peers, redraw } = arguments;
    ensure!(
        peers.is_none() || only.is_none_or(|only| only == Part::WorkPrecision),
        "peers are drawn in the work-precision charts; allowed: without --only, or with --only work-precision"
    );
    let wanted = |part| only.is_none_or(|only| only == part);
    if *redraw {
        let parts: [(Part, &[Chart]); 4] = [
            (Part::WorkPrecision, &work_precision::CHARTS),
            (Part::Atlas, &atlas::CHARTS),
            (Part::Plan, &plan_map::CHARTS),
            (Part::RemainingTime, &remaining_time::CHARTS),
        ];
        let charts = parts.into_iter().filter(|(part, _)| wanted(*part)).flat_map(|(_, charts)| charts);
        say(&chart::redraw(out, charts)?)?;
        return Ok(Status::Well);
    }
    let resolved = |path: &PathBuf| path.canonicalize().ok();
    if let Some(path) = peers
        && let Some(file) = resolved(path)
        && file.parent() == resolved(out).as_deref()
    {
        return Err(
            Invalid::new("peers", path.display(), "a file outside of --out, whose tables are written over").into()
        );
    }
    let peers = peers.as_ref().map(peers_in).transpose()?.unwrap_or_default();
    // First, because what follows takes a while.
    make_folder("out", out)?;
    let bar = indicatif::ProgressBar::new_spinner();
    if wanted(Part::WorkPrecision) {
        let mut rows = work_precision::measure(&work_precision::Scope::default(), || bar.inc(1))
            .map_err(|decline| anyhow!("{decline}"))?;
        rows.extend(peers);
        say(&chart::write(out, &work_precision::files(&rows)?, &work_precision::CHARTS)?)?;
    }
    if wanted(Part::Atlas) {
        let tables =
            atlas::Tables::measure(&atlas::Scope::default(), || bar.inc(1)).map_err(|decline| anyhow!("{decline}"))?;
        say(&chart::write(out, &tables.files()?, &atlas::CHARTS)?)?;
    }
    if wanted(Part::Plan) {
        let files = BTreeMap::from([("plan_map.csv", chart::csv_text(&plan_map::rows()?)?)]);
        say(&chart::write(out, &files, &plan_map::CHARTS)?)?;
    }
    if wanted(Part::RemainingTime) {
        let files = BTreeMap::from([("remaining_time.csv", chart::csv_text(&remaining_time::rows()?)?)]);
        say(&chart::write(out, &files, &remaining_time::CHARTS)?)?;
    }
    bar.finish_and_clear();
    Ok(Status::Well)
}

fn peers_in(path: &PathBuf) -> anyhow::Result<Vec<work_precision::WorkRow>> {
    let text = fs::read_to_string(path).with_context(|| format!("cannot read peers = {}", path.display()))?;
    work_precision::read(&text).with_context(|| format!("peers = {}", path.display()))
}
