//! Where and how a response differs from what it has to be.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::whole::BoutEnding;

/// What rounding leaves in any number, beside what grows out of it.
pub(super) const ROUNDING: f64 = 1e-13;
/// The same of a state that is interpolated, and of the times of impacts beside it.
pub(super) const ROUNDING_OF_STATES: f64 = 1e-10;

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

/// The difference, if it is more than is allowed; what is not a number is always more.
pub(super) fn unless_near(what: What, time: f64, found: f64, expected: f64, allowed: f64) -> Option<Difference> {
    let near = (found - expected).abs() <= allowed;
    (!near).then_some(Difference { time, what, found, expected, allowed })
}

/// One that is no matter of numbers.
pub(super) fn plain(what: What, time: f64) -> Difference {
    Difference { time, what, found: f64::NAN, expected: f64::NAN, allowed: f64::NAN }
}
