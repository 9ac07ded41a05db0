//! The first difference of a response from what it has to be.

use std::{cell::Cell, fmt};

use serde::{Deserialize, Serialize};

use super::{
    follower::Followed,
    reference::Reference,
    whole::{Bout, BoutEnding, Row, State, Whole},
};

/// What rounding leaves in any number, beside what grows out of it.
const ROUNDING: f64 = 1e-13;
/// The same in a row, where a state is interpolated.
const ROUNDING_OF_ROWS: f64 = 1e-10;
/// A claim on when a block comes to rest that is wider than this share of the bout, where that is known, claims nothing.
const WIDE: f64 = 1e-3;
/// Beyond this rotation a fall is not followed.
const OUT_OF_SIGHT: f64 = 5.0;

/// Where and how a response differs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Difference {
    /// When, `τ`.
    pub time: f64,
    /// In what.
    pub what: What,
    /// What the method has.
    pub found: f64,
    /// What it has to be.
    pub expected: f64,
    /// How far apart they may be.
    pub allowed: f64,
}

/// What a response differs in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum What {
    /// It has one bout fewer.
    NoBout,
    /// It has one bout more.
    ExtraBout,
    /// When a bout begins.
    Begin,
    /// To which side.
    Side,
    /// It has one impact fewer.
    NoImpact,
    /// It has one impact more.
    ExtraImpact,
    /// When the block hits its base.
    ImpactTime,
    /// How fast.
    ImpactSpeed,
    /// How a bout ends: that of the method, and that which it has to be.
    Ending(BoutEnding, BoutEnding),
    /// When the block comes to rest.
    RestTime,
    /// It claims so little of when the block comes to rest that it does not know.
    Unsure,
    /// The largest rotation.
    Peak,
    /// The rotation in a row of the table.
    Rotation,
    /// The velocity in a row of the table.
    Velocity,
    /// A row that says that the block has overturned while it has not.
    State,
}

impl What {
    /// The same kind of difference, whatever the numbers.
    pub fn resembles(self, other: Self) -> bool {
        std::mem::discriminant(&self) == std::mem::discriminant(&other)
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { time, what, found, expected, allowed } = self;
        let numbers = |f: &mut fmt::Formatter<'_>, name: &str| {
            let off = (found - expected).abs();
            write!(
                f,
                "{name} at τ = {time:.9}: {found:?}, expected {expected:?} (off by {off:.1e}, allowed {allowed:.1e})"
            )
        };
        match what {
            What::NoBout => write!(f, "rests on where it has to rock from τ = {time:.9}"),
            What::ExtraBout => write!(f, "rocks from τ = {time:.9} where it has to rest"),
            What::NoImpact => write!(f, "has no impact where there has to be one at τ = {time:.9}"),
            What::ExtraImpact => write!(f, "has an impact at τ = {time:.9} where there is none"),
            What::Ending(own, right) => {
                write!(f, "{} at τ = {found:.9}, where it {} at τ = {time:.9}", own.name(), right.name())
            }
            What::State => write!(f, "says overturned at τ = {time:.9}, φ = {expected:.6}, and the block comes back"),
            What::Begin => numbers(f, "begin of rocking"),
            What::Side => numbers(f, "side of the first rotation"),
            What::ImpactTime => numbers(f, "time of an impact"),
            What::ImpactSpeed => numbers(f, "speed of an impact"),
            What::RestTime => numbers(f, "coming to rest"),
            What::Unsure => numbers(f, "claim on coming to rest"),
            What::Peak => numbers(f, "peak"),
            What::Rotation => numbers(f, "rotation"),
            What::Velocity => numbers(f, "velocity"),
        }
    }
}

/// The first difference of a response of a method of this accuracy, as far as it is known what has to happen; and the largest share of what is allowed
/// that any impact used.
pub(super) fn first_difference(whole: &Whole, reference: &Reference, accuracy: f64) -> (Option<Difference>, f64) {
    let comparison = Comparison { reference, scale: Reference::scale(accuracy), used: Cell::new(0.0) };
    let difference = comparison.bouts(whole).or_else(|| whole.rows.iter().find_map(|row| comparison.row(row)));
    (difference, comparison.used.get())
}

struct Comparison<'a> {
    reference: &'a Reference,
    scale: f64,
    used: Cell<f64>,
}

/// The difference, if it is more than is allowed; what is not a number is always more.
fn unless_near(what: What, time: f64, found: f64, expected: f64, allowed: f64) -> Option<Difference> {
    let near = (found - expected).abs() <= allowed;
    (!near).then_some(Difference { time, what, found, expected, allowed })
}

impl Comparison<'_> {
    fn bouts(&self, whole: &Whole) -> Option<Difference> {
        let expected = &self.reference.nominal.bouts;
        for (k, (bout, known)) in expected.iter().zip(&self.reference.known).enumerate() {
            let Some(own) = whole.bouts.get(k) else {
                return Some(plain(What::NoBout, bout.begin));
            };
            let late = ROUNDING * (1.0 + bout.begin);
            let begins = unless_near(What::Begin, bout.begin, own.begin, bout.begin, self.scale * known.begin + late);
            let difference = begins
                .or_else(|| unless_near(What::Side, bout.begin, own.side, bout.side, 0.0))
                .or_else(|| self.impacts(own, bout, &known.impacts))
                .or_else(|| known.ending.and_then(|moves| self.ending(own, bout, moves)));
            if difference.is_some() {
                return difference;
            }
        }
        let more = whole.bouts.get(expected.len()).filter(|bout| bout.begin < self.reference.until);
        more.map(|bout| plain(What::ExtraBout, bout.begin))
    }

    fn impacts(&self, own: &Bout, bout: &Bout, known: &[(f64, f64)]) -> Option<Difference> {
        for (n, (impact, (time, speed))) in bout.impacts.iter().zip(known).enumerate() {
            let Some(found) = own.impacts.get(n) else {
                // A method may close the sum of infinitely many earlier.
                let closed = own.outcome == BoutEnding::Rest && bout.outcome == BoutEnding::Rest;
                return (!closed).then(|| plain(What::NoImpact, impact.time));
            };
            let late = ROUNDING * (1.0 + impact.time);
            let late = self.scale * time + late;
            let faster = (self.scale * speed + 1e-11) * impact.before + 1e-16;
            let shares = [(found.time - impact.time).abs() / late, (found.before - impact.before).abs() / faster];
            self.used.set(shares.into_iter().fold(self.used.get(), f64::max));
            let difference = unless_near(What::ImpactTime, impact.time, found.time, impact.time, late)
                .or_else(|| unless_near(What::ImpactSpeed, impact.time, found.before, impact.before, faster));
            if difference.is_some() {
                return difference;
            }
        }
        None
    }

    fn ending(&self, own: &Bout, bout: &Bout, (end, peak): (f64, f64)) -> Option<Difference> {
        let rests = bout.outcome == BoutEnding::Rest;
        if let Some(extra) = own.impacts.get(bout.impacts.len()).filter(|_| !rests) {
            return Some(plain(What::ExtraImpact, extra.time));
        }
        if !self.may_end(own.outcome, bout.outcome) {
            let what = What::Ending(own.outcome, bout.outcome);
            return Some(Difference { found: own.end, ..plain(what, bout.end) });
        }
        if rests {
            let allowed = self.scale * end + bout.uncertainty + ROUNDING * (1.0 + bout.end);
            let most = WIDE * (bout.end - bout.begin) + allowed;
            let unsure = unless_near(What::Unsure, bout.end, own.uncertainty, 0.0, most);
            let at = unless_near(What::RestTime, bout.end, own.end, bout.end, allowed + own.uncertainty);
            if let Some(difference) = unsure.or(at) {
                return Some(difference);
            }
        }
        let (found, expected) = own.peak.zip(bout.peak)?;
        let allowed = self.scale * peak + ROUNDING_OF_ROWS * (1.0 + expected);
        unless_near(What::Peak, bout.end, found, expected, allowed)
    }

    /// One method is certain earlier than another that a block overturns: then the one has it, and the other still follows it where the response ends.
    fn may_end(&self, own: BoutEnding, right: BoutEnding) -> bool {
        match (own, right) {
            (BoutEnding::Overturned, BoutEnding::Cut) => self.reference.nominal.falls,
            (BoutEnding::Cut, BoutEnding::Overturned) => true,
            _ => own == right,
        }
    }

    /// Whether the bout at this time ends with the block on its side, if it is followed long enough.
    fn overturns(&self, time: f64) -> bool {
        let Followed { bouts, falls, .. } = &self.reference.nominal;
        let bout = bouts.iter().take_while(|bout| bout.begin <= time).last();
        bout.is_some_and(|bout| match bout.outcome {
            BoutEnding::Overturned => true,
            BoutEnding::Cut => *falls,
            BoutEnding::Rest | BoutEnding::GivenUp => false,
        })
    }

    fn row(&self, row: &Row) -> Option<Difference> {
        if row.time >= self.reference.until {
            return None;
        }
        let ((rotation, velocity), spread) = self.reference.at(row.time);
        if rotation.abs() > OUT_OF_SIGHT.min(self.reference.nominal.problem.lies_at) {
            return None;
        }
        if matches!(row.state, State::Overturned | State::Lying) && !self.overturns(row.time) {
            return Some(Difference { expected: rotation, ..plain(What::State, row.time) });
        }
        let floor = ROUNDING_OF_ROWS * (1.0 + rotation.abs());
        let allowed = self.scale * spread.0 + floor;
        let differs = unless_near(What::Rotation, row.time, row.rotation, rotation, allowed);
        if differs.is_some() || row.state == State::Lying || self.is_at_an_impact(row.time) {
            return differs;
        }
        let allowed = self.scale * spread.1 + ROUNDING_OF_ROWS * (1.0 + velocity.abs());
        unless_near(What::Velocity, row.time, row.velocity, velocity, allowed)
    }

    /// Whether the velocity jumps at this time, as far as that is known, or so often that it is not resolved.
    fn is_at_an_impact(&self, time: f64) -> bool {
        let bouts = self.reference.nominal.bouts.iter().zip(&self.reference.known);
        let Some((bout, known)) = bouts.take_while(|(bout, _)| bout.begin <= time + ROUNDING).last() else {
            return false;
        };
        let near = ROUNDING_OF_ROWS + self.scale * known.impacts.last().map_or(0.0, |(time, _)| *time);
        let unresolved = bout.impacts.last().is_some_and(|last| time >= last.time - near && time <= bout.end + near);
        let next = bout.impacts.partition_point(|impact| impact.time < time - near);
        unresolved || bout.impacts.get(next).is_some_and(|impact| impact.time <= time + near)
    }
}

fn plain(what: What, time: f64) -> Difference {
    Difference { time, what, found: f64::NAN, expected: f64::NAN, allowed: f64::NAN }
}
