//! The flags by which the table of a sweep is drawn.

use std::path::{Path, PathBuf};

use chattercheck::{
    gate::partition::Partition,
    studies::chart::Table,
    sweep::{Asked, Drawing, Sweep},
};
use clap::Args;
use contract::Invalid;

use super::files::{FileOption, Target, targets};

#[derive(Args)]
pub(super) struct MapFlags {
    /// Draw the table as a heat map, SVG; - is stdout
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// The axis to the right [default: the last that has several values]
    #[arg(long, value_name = "AXIS", requires = "svg")]
    x: Option<String>,
    /// The axis upwards [default: the last but one]
    #[arg(long, value_name = "AXIS", requires = "svg")]
    y: Option<String>,
    /// The column that is the colour [default: the first that is a number]
    #[arg(long, value_name = "COLUMN", requires = "svg")]
    column: Option<String>,
    /// Spread the colours by the logarithm
    #[arg(long, requires = "svg")]
    log_colour: bool,
    /// Draw the table that is there already, as of parts that were put together, and run nothing
    #[arg(long, requires = "svg", conflicts_with_all = ["threads", "partition"])]
    redraw: bool,
}

/// A drawing that can be made.
pub(super) struct Map {
    drawing: Drawing,
    target: Target,
    /// Whether it is of a table that is there.
    pub is_redrawn: bool,
}

impl MapFlags {
    /// What is to be drawn of the table `out`, if anything. That it can be is found out before the work.
    ///
    /// # Errors
    /// When it can't be.
    pub fn map(&self, sweep: &Sweep, out: &Path, partition: Partition) -> anyhow::Result<Option<Map>> {
        let Self { svg: Some(svg), x, y, column, log_colour, redraw } = self else { return Ok(None) };
        let refused = |allowed| Invalid::new("svg", svg.display(), allowed);
        if out == Path::new("-") {
            return Err(refused("only where --out is a file, which is drawn").into());
        }
        if partition.parts > 1 {
            return Err(refused("only of the whole: put the parts together and draw them with --redraw").into());
        }
        let mut taken = vec![("it has to be another file than that of --out", out)];
        taken.extend(sweep.files.iter().map(|file| ("it has to be another file than those of the sweep", &**file)));
        let option = FileOption { name: "svg", beside: "", path: Some(svg) };
        let target = targets([((), option)], &taken)?.into_iter().next().map(|(_, target)| target);
        let asked = Asked { x: x.as_deref(), y: y.as_deref(), column: column.as_deref(), is_log: *log_colour };
        let drawing = Drawing::choose(sweep, asked)?;
        Ok(target.map(|target| Map { drawing, target, is_redrawn: *redraw }))
    }
}

impl Map {
    /// Draws the table `out`.
    ///
    /// # Errors
    /// When it is not there or none of this sweep, or the drawing can't be written.
    pub fn write(&self, sweep: &Sweep, out: &Path) -> anyhow::Result<()> {
        let table = Table::read(out)?;
        if table.len() != sweep.points.count() {
            let allowed = "a table with a row for each point of the sweep";
            return Err(Invalid::new("out", format!("{} with {} rows", out.display(), table.len()), allowed).into());
        }
        self.target.write(&self.drawing.svg(sweep, &table)?)
    }
}
