//! Fig. 2: chattering into rest, with the first and the final cycles.

use super::{
    Error, Figure, half_period,
    history::{self, ETA, EXACT, OMEGA, PART, Row, WHOLE, lines, mark, response, rows, table},
    missing,
};
use crate::studies::chart::{self, Mark, Table};

pub(super) const FIGURE: Figure = Figure {
    name: "fig_2",
    measure,
    charts: &[("fig_2a.svg", whole), ("fig_2b.svg", first_cycles), ("fig_2c.svg", final_cycles)],
};

const A: f64 = 1.03;
/// The first cycles end with this impact, the final ones begin with that.
const FIRST: usize = 6;
const FINAL: usize = 40;

fn measure() -> Result<String, Error> {
    let (response, _) = response(A, EXACT)?;
    let bout = response.bouts.first().ok_or_else(|| missing("the chattering of Fig. 2"))?;
    let (impacts, rest): (Vec<f64>, f64) = (bout.impact_times().collect(), bout.end());
    let time = |n: usize| impacts.get(n - 1).copied().ok_or_else(|| missing(format!("impact {n}")));
    let marks = |part, from: usize, to: usize| {
        (from..=to).map(|n| Ok(mark(part, Some(n), time(n)?))).collect::<Result<Vec<Row>, Error>>()
    };
    let after = rest + 0.05 * (rest - time(FINAL)?);
    table(vec![
        rows("a", A, EXACT, (0.0, half_period(OMEGA)), WHOLE)?,
        vec![mark("rest", None, rest)],
        rows("b", A, EXACT, (0.0, time(FIRST)?), PART)?,
        marks("impacts b", 1, 4)?,
        rows("c", A, EXACT, (time(FINAL)?, after), PART)?,
        marks("impacts c", FINAL + 1, FINAL + 4)?,
    ])
}

/// The upright lines at the marked times of one part, each named by the number of its impact (NaN where the impacts accumulate).
fn marks(table: &Table, part: &str, name: impl Fn(f64) -> String) -> Result<Vec<Mark>, chart::Error> {
    let rows = table.filter("part", part)?;
    let places = rows.numbers("tau")?.into_iter().zip(rows.numbers("n")?);
    Ok(places.filter_map(|(tau, n)| Some(Mark::at(tau?, name(n.unwrap_or(f64::NAN))))).collect())
}

fn whole(table: &Table) -> Result<String, chart::Error> {
    let title = format!("Chattering into rest, a = {A}, ω = {OMEGA}, η = {ETA}");
    let caption = "The block comes to rest at τ_{ch}, well before T/2, while the ground still moves.";
    let mut marks = marks(table, "rest", |_| "τ_{ch}".into())?;
    marks.push(Mark::at(half_period(OMEGA), "T/2"));
    history::chart(&title, caption, lines(table, "a", "phi")?, marks)
}

fn first_cycles(table: &Table) -> Result<String, chart::Error> {
    let caption = "A flight of the sign of the first one, i_{0}, is long and high, one of the other sign short and low, because \
                   the excitation nearly lifts the block to the one side and presses it down on the other.";
    let marks = marks(table, "impacts b", |n| format!("τ_{{{n}}}"))?;
    history::chart("First cycles", caption, lines(table, "b", "phi")?, marks)
}

fn final_cycles(table: &Table) -> Result<String, chart::Error> {
    let caption = format!(
        "From n = {} on each flight is shorter than the last but one by nearly η² and lower by nearly η⁴, until they \
         accumulate; those of the sign −i_{{0}} are now the longer ones, as the excitation has turned.",
        FINAL + 1
    );
    let first = (FINAL + 1) as f64;
    let mut marks =
        marks(table, "impacts c", |n| if n == first { "τ_{n}".into() } else { format!("τ_{{n+{}}}", n - first) })?;
    marks.extend(self::marks(table, "rest", |_| "τ_{ch}".into())?);
    history::chart("Final cycles", &caption, lines(table, "c", "phi")?, marks)
}
