//! A response as an engineer tells it: in seconds, degrees and g.

use contract::{Invalid, Model};
use serde::Serialize;

use super::{Amplitude, Ground, Scene};
use crate::{
    measure::ground::strongest,
    motion::response::{Bout, BoutEnd, Peak, Response},
};

/// How many rests are listed by [`Account::told`].
const MOST_RESTS: usize = 8;

/// What happens to a block. Times are in seconds since the start of the motion, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Account {
    /// The width of the block, in metres.
    pub width: f64,
    /// Its height, in metres.
    pub height: f64,
    /// What an impact leaves of the velocity.
    pub restitution: f64,
    /// What the ground does.
    pub ground: &'static str,
    /// How long it does; `null` for without end.
    pub duration: Option<f64>,
    /// Its strongest acceleration, or a bound on that of a sum of sinusoids, in g.
    pub strongest: f64,
    /// When it begins to rock; `null` if it never does.
    pub begins_to_rock: Option<f64>,
    /// The ground acceleration at which it does, in g.
    pub threshold: f64,
    /// The largest rotation; `null` if it never rocks.
    pub largest_rotation: Option<Largest>,
    /// The rotation at which it stands on its corner, `α`.
    pub alpha: f64,
    /// From rest to rest.
    pub times_of_rocking: usize,
    /// How many of these end with rest by infinitely many impacts, complete chattering.
    pub complete: usize,
    /// Those impacts that are resolved.
    pub impacts: usize,
    /// When it rests.
    pub rests: Vec<Stretch>,
    /// When the response ends.
    pub end: f64,
    /// How: `at-rest`, `rocking`, `overturned`, `lying`, or `not-known` where the impacts are too many or rounding alone changes how it goes.
    pub ending: End,
}

/// The largest rotation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Largest {
    /// In degrees, with its sign.
    pub degrees: f64,
    /// As a share of `α`, without: at 1 it stands on its corner.
    pub share_of_alpha: f64,
    /// When.
    pub seconds: f64,
}

/// A stretch of time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Stretch {
    /// Its beginning.
    pub from: f64,
    /// Its end.
    pub to: f64,
}

/// How a response ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum End {
    /// At rest on its base.
    AtRest,
    /// It still rocks.
    Rocking,
    /// It is certain to fall.
    Overturned,
    /// It lies on its side.
    Lying,
    /// It was lost, or rounding alone changes how it goes.
    NotKnown,
}

impl Scene {
    /// The acceleration of the ground at which the block begins to rock, in g: what 1 is in a response to this scene.
    pub fn threshold(&self) -> f64 {
        let is_slender = match &self.ground {
            Ground::Sinusoid(sine) => matches!(sine.amplitude, Amplitude::OverSlenderThreshold(_)),
            Ground::Shaking(shaking) => shaking.over_slender.is_some(),
        };
        let alpha = self.block.slenderness;
        if is_slender && self.ask.model == Model::Linear { alpha } else { alpha.tan() }
    }

    /// What happens in a response to this scene, of which the largest rotation is known.
    ///
    /// # Errors
    /// When its numbers are out of range.
    pub fn account(&self, response: &Response, peak: Option<Peak>) -> Result<Account, Invalid> {
        let (motion, _) = self.motion()?;
        let (sin, cos) = self.block.slenderness.sin_cos();
        let diagonal = 2.0 * self.block.radius;
        let seconds = |tau: f64| tau / self.block.frequency_parameter();
        let alpha = self.block.slenderness.to_degrees();
        let last = response.bouts.last();
        Ok(Account {
            width: diagonal * sin,
            height: diagonal * cos,
            restitution: self.block.restitution,
            ground: self.ground_name(),
            duration: Some(seconds(motion.duration())).filter(|duration| duration.is_finite()),
            strongest: self.threshold() * strongest(&motion),
            begins_to_rock: response.bouts.first().map(|bout| seconds(bout.begin())),
            threshold: self.threshold(),
            largest_rotation: peak.map(|Peak { time, rotation }| Largest {
                degrees: rotation * alpha,
                share_of_alpha: rotation.abs(),
                seconds: seconds(time),
            }),
            alpha,
            times_of_rocking: response.bouts.len(),
            complete: response.bouts.iter().filter(|bout| matches!(bout.outcome, BoutEnd::Complete { .. })).count(),
            impacts: response.bouts.iter().map(Bout::impacts).sum(),
            rests: response
                .rests()
                .into_iter()
                .map(|(from, to)| Stretch { from: seconds(from), to: seconds(to) })
                .collect(),
            end: seconds(response.end),
            ending: match last.map(|bout| bout.outcome) {
                _ if response.bouts.iter().any(Bout::is_unsure) => End::NotKnown,
                Some(BoutEnd::Lost(_) | BoutEnd::TooManyImpacts) => End::NotKnown,
                Some(BoutEnd::Cut) => End::Rocking,
                Some(BoutEnd::Overturned) if response.lying.is_some() => End::Lying,
                Some(BoutEnd::Overturned) => End::Overturned,
                _ => End::AtRest,
            },
        })
    }
}

impl Account {
    /// The account in words: what each thing is called, and what it is.
    pub fn told(&self) -> Vec<(&'static str, String)> {
        let Self { width, height, threshold, alpha, times_of_rocking, complete, impacts, rests, end, .. } = self;
        let lasts = self.duration.map_or("without end".to_owned(), |duration| format!("{duration:.4} s"));
        let (width, height) = (short(*width), short(*height));
        let block =
            format!("{width} m wide, {height} m high; an impact leaves {:.4} of the velocity", self.restitution);
        let ground = format!("{}, {lasts}, at most {:.4} g", self.ground, self.strongest);
        let asked = [("block", block), ("ground", ground)];
        let (Some(begin), Some(largest)) = (self.begins_to_rock, self.largest_rotation) else {
            let never =
                format!("never: that takes {threshold:.4} g, which the ground does not exceed up to {end:.4} s");
            return asked.into_iter().chain([("begins to rock", never)]).collect();
        };
        let Largest { degrees, share_of_alpha, seconds } = largest;
        let falls = matches!(self.ending, End::Lying | End::Overturned);
        let closest =
            if falls { "it overturns".to_owned() } else { format!("{:.1} % of the way", 100.0 * share_of_alpha) };
        let times = if *times_of_rocking == 1 { "time" } else { "times" };
        let endless = match complete {
            0 => String::new(),
            1 => "; one ends with rest, after infinitely many more".to_owned(),
            _ => format!("; {complete} end with rest, each after infinitely many more"),
        };
        let resting = rests.iter().filter(|rest| rest.to > rest.from);
        let listed: Vec<String> =
            resting.clone().take(MOST_RESTS).map(|rest| format!("{:.4} to {:.4} s", rest.from, rest.to)).collect();
        let more = resting.count().saturating_sub(MOST_RESTS);
        let rests = match (listed.is_empty(), more) {
            (true, _) => "never".to_owned(),
            (_, 0) => listed.join(", "),
            _ => format!("{}, and {more} more", listed.join(", ")),
        };
        let happens = [
            ("begins to rock", format!("at {begin:.4} s; on its base it takes {threshold:.4} g to begin")),
            ("largest rotation", format!("{} degrees, at {seconds:.4} s", short(degrees))),
            ("to overturning", format!("{closest}; it stands on its corner at alpha = {alpha:.4} degrees")),
            ("impacts", format!("{impacts} resolved, in {times_of_rocking} {times} of rocking{endless}")),
            ("rests", rests),
            ("in the end", self.ending()),
        ];
        asked.into_iter().chain(happens).collect()
    }

    fn ending(&self) -> String {
        let at = format!("{:.4} s", self.end);
        match self.ending {
            End::AtRest => match self.rests.last().filter(|rest| rest.to >= self.end) {
                Some(rest) => format!("at rest, from {:.4} s on", rest.from),
                None => format!("at rest, from {at} on"),
            },
            End::Rocking => format!("still rocking at {at}, where the response ends"),
            End::Overturned => format!("overturned: no return is possible any more at {at}, where the response ends"),
            End::Lying => format!("overturned: it lies on its side from {at} on"),
            End::NotKnown => "NOT KNOWN: where it is not, rounding alone changes how the rocking goes".to_owned(),
        }
    }
}

/// A number with the four digits of it that count.
fn short(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
