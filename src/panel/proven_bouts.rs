//! What the judge proves of a whole response.

use contract::{Body, Decline, Estimate, Followed, Model, Motion};
use enclosure::{EnclosedBout, EnclosedEnd};

use super::{Refused, Role, Settings, enclosure, lookup};

/// A bout as it is proven.
pub struct ProvenBout {
    /// The middles of the bounds, and half their widths.
    pub bout: contract::Bout,
    /// Bounds on when it begins, with the digits that were asked for, rounded outward.
    pub begin: [String; 2],
    /// The same on when the block rests; `None` where it does not.
    pub rest: Option<[String; 2]>,
    /// How long it is until then.
    pub lasts: Option<ProvenTime>,
}

/// A time with its bounds.
pub struct ProvenTime {
    /// The middle of the bounds, and half their width.
    pub estimate: contract::Estimate,
    /// With the digits that were asked for, rounded outward.
    pub bounds: [String; 2],
}

/// The name of the judge, and what it proves.
pub type ProvenResponse = (String, Result<Vec<ProvenBout>, Decline>);

/// The bouts of a block on ground that moves in any way, if the judge is the method that `name` names; with the name of the oracle.
///
/// # Errors
/// When the judge does not use one of the settings.
pub fn proven_bouts(
    name: &str,
    settings: &Settings,
    model: Model,
    (body, motion, asked): (&Body, &Motion, &Followed),
) -> Result<Option<ProvenResponse>, Refused> {
    let Some((method, settings, model)) = lookup::resolve(name, settings, model)? else { return Ok(None) };
    if !method.roles.contains(&Role::Judge) {
        return Ok(None);
    }
    let judge = enclosure(&settings, model)?.patient();
    let digits = judge.digits();
    let decimals = |bounds: &enclosure::Bounds| bounds.decimals(bounds.places(digits));
    let lasts = |time: enclosure::Bounds| {
        let (value, uncertainty) = time.middle();
        ProvenTime { estimate: Estimate { value, uncertainty }, bounds: decimals(&time) }
    };
    let proven = |found: &EnclosedBout| {
        let rest = if let EnclosedEnd::Rest(time) = &found.end { Some(time) } else { None };
        ProvenBout {
            bout: found.bout(),
            begin: decimals(&found.begin),
            rest: rest.map(decimals),
            lasts: rest.map(|time| lasts(time.since(&found.begin))),
        }
    };
    let bouts = judge.enclose_on(body, motion, asked).map(|bouts| bouts.iter().map(proven).collect());
    Ok(Some((contract::Oracle::name(&judge).to_owned(), bouts)))
}
