//! What happens in a scene where that is not the history of a case: the motion of the ground starts elsewhere or ends, or the block rocks on after half a period.

use anyhow::anyhow;
use chattercheck::motion::{
    response::{Bout, Response, Termination},
    scene::Scene,
};
use contract::{Decline, Ending, Invalid, Limit, Oracle};

use super::{case_flags::CaseFlags, motion_facts::Facts, oracle_flags::OracleFlags};

/// The response of a scene by an oracle.
pub(super) struct Followed {
    /// The scene.
    pub scene: Scene,
    /// Its response.
    pub response: Response,
    /// That to the scene moved by some roundings, which claims come from.
    pub moved: Response,
}

impl Followed {
    /// What the scene was, for answers that are collected.
    pub fn facts(&self) -> Result<Facts, Invalid> {
        Facts::of(&self.scene)
    }

    /// The first rocking, if the block ever rocks.
    pub fn first(&self) -> Option<&Bout> {
        self.response.bouts.first()
    }
}

/// The response of a scene whose ground is no sinusoid, or whose block is in motion, with the name of who followed it; `None` if the flags give none.
///
/// # Errors
/// When an option is not used, or the oracle can't follow the scene.
pub(super) fn on_motion(
    flags: &CaseFlags,
    oracle: &OracleFlags,
    digits: Option<i64>,
) -> anyhow::Result<Option<(String, Followed)>> {
    let Some(scene) = flags.scene()?.filter(|scene| scene.sine().is_err()) else { return Ok(None) };
    let request = scene.on_motion(flags.until(), Termination::Exact)?;
    let oracle = oracle.on_motion(flags, &request, digits)?;
    let (response, moved) = Response::and_moved_on_motion(oracle.as_ref(), &request).map_err(|decline| {
        let hint = if matches!(decline, Decline::Unsupported { .. }) { "; --oracle auto does it" } else { "" };
        anyhow!("{} declines {}: {decline}{hint}", oracle.name(), scene.ground_name())
    })?;
    Ok(Some((oracle.name().to_owned(), Followed { scene, response, moved })))
}

/// The response of the scene of the flags by `oracle`; `None` if there is no scene, or it is no more than a case: one with the ending given, or if none is given, one
/// that the oracle has yet to be asked.
///
/// # Errors
/// When the oracle can't follow the scene.
pub(super) fn follow(
    flags: &CaseFlags,
    oracle: &dyn Oracle,
    ending: Option<Ending>,
) -> anyhow::Result<Option<Followed>> {
    let Some(scene) = flags.scene()? else { return Ok(None) };
    let goes_on = match ending {
        None => scene.question()?.request.is_some(),
        Some(ending) => goes_on(ending),
    };
    if !goes_on {
        return Ok(None);
    }
    let request = scene.response(flags.until(), Termination::Exact)?;
    let (response, moved) = Response::and_moved(oracle, &request).map_err(|decline| {
        anyhow!(
            "{} declines what the scene has beyond a case, a motion that starts elsewhere than at the threshold or ends, or goes on after half a period: {decline}; --oracle auto does it",
            oracle.name()
        )
    })?;
    Ok(Some(Followed { scene, response, moved }))
}

/// Whether a block that ends its case so rocks on after half a period, which a case knows nothing of.
pub(super) fn goes_on(ending: Ending) -> bool {
    matches!(ending, Ending::Incomplete | Ending::Overturned | Ending::LimitReached(Limit::Time))
}
