//! Whole responses on ground that moves in any way, as proven.

use contract::{Body, Decline, Followed, Model, Motion};

use crate::{
    bounds::Bounds,
    bouts::{self, Asked, Bout, BoutEnd},
    directed::Directed,
    enclosed_impact::{EnclosedImpact, enclosed_impact, estimate},
    interval::Interval,
    judge::{Enclosure, within},
    ladder::{Attempt, bits_for, climb},
};

/// Everything that is proven of a bout of a response.
#[derive(Debug, Clone, PartialEq)]
pub struct EnclosedBout {
    /// When it begins.
    pub begin: Bounds,
    /// The sign of its first rotation, 1 or -1.
    pub side: f64,
    /// The impacts in order, with the times since the start of the motion.
    pub impacts: Vec<EnclosedImpact>,
    /// How it ends.
    pub end: EnclosedEnd,
}

/// How a bout ends.
#[derive(Debug, Clone, PartialEq)]
pub enum EnclosedEnd {
    /// With rest, at that time.
    Rest(Bounds),
    /// With overturning.
    Overturned,
    /// With the end of the response, while the block rocks.
    Aloft,
    /// Undecided, with the digits that are tried.
    Undecided,
}

impl Enclosure {
    /// Bounds for every bout of a block on ground that moves in any way, as far as they are proven.
    ///
    /// # Errors
    /// A [`Decline`] when the model needs a slenderness that the block does not have, or it is not even decided whether it rocks.
    pub fn enclose_on(&self, body: &Body, motion: &Motion, asked: &Followed) -> Result<Vec<EnclosedBout>, Decline> {
        let body = match (self.model, body.alpha()) {
            (Model::Nonlinear, None) => return Err(Decline::NeedsSlenderness),
            (Model::Nonlinear, Some(_)) => *body,
            (Model::Linear, _) => {
                Body::new(body.eta(), None).map_err(|invalid| Decline::NotConvergent { why: invalid.to_string() })?
            }
        };
        within("eta", body.eta(), 1e-6, 1.0, "1e-6 <= eta < 1")?;
        let width = (0.1_f64).powi(self.digits as i32);
        let attempt = FollowingBouts { body, motion, asked, width, patience: self.patience };
        let bits = if self.digits <= 12 { 53 } else { bits_for(self.digits) + 12 };
        climb(&attempt, bits)
    }
}

/// Why it is not known whether a block rocks at all.
const TOUCHES: &str = "the ground reaches the threshold so narrowly that it is not decided whether the block rocks";

/// A whole response followed with some number of digits.
struct FollowingBouts<'a> {
    body: Body,
    motion: &'a Motion,
    asked: &'a Followed,
    width: f64,
    patience: usize,
}

impl Attempt for FollowingBouts<'_> {
    type Answer = Result<Vec<EnclosedBout>, Decline>;

    fn with<F: Directed>(&self) -> (Self::Answer, bool) {
        let (followed, patience) = (self.asked, self.patience);
        let asked = Asked { body: &self.body, motion: self.motion, followed, width: 0.5 * self.width, patience };
        let Some(bouts) = bouts::follow::<F>(&asked) else {
            return (Err(Decline::NotConvergent { why: TOUCHES.to_owned() }), false);
        };
        let narrow = |interval: &Interval<F>| interval.relative_width() <= self.width;
        let good = |bout: &Bout<F>| {
            let impacts = bout.impacts.iter().all(|i| narrow(&i.time) && narrow(&i.interval) && narrow(&i.speed));
            let begins = bout.begin.width() <= self.width * bout.begin.magnitude();
            impacts
                && begins
                && match &bout.end {
                    BoutEnd::Rest(time) => narrow(time),
                    BoutEnd::Unclear => false,
                    BoutEnd::Overturned | BoutEnd::Aloft | BoutEnd::Exhausted => true,
                }
        };
        let good = bouts.iter().all(good);
        let enclosed: Option<Vec<_>> = bouts.into_iter().map(enclosed_bout).collect();
        let answer = enclosed.ok_or_else(|| Decline::NotConvergent { why: "a bound is not a number".to_owned() });
        (answer, good)
    }
}

fn enclosed_bout<F: Directed>(bout: Bout<F>) -> Option<EnclosedBout> {
    Some(EnclosedBout {
        begin: Bounds::new(&bout.begin)?,
        side: bout.side.sign(),
        impacts: bout.impacts.into_iter().map(enclosed_impact).collect::<Option<_>>()?,
        end: match &bout.end {
            BoutEnd::Rest(time) => EnclosedEnd::Rest(Bounds::new(time)?),
            BoutEnd::Overturned => EnclosedEnd::Overturned,
            BoutEnd::Aloft => EnclosedEnd::Aloft,
            BoutEnd::Exhausted | BoutEnd::Unclear => EnclosedEnd::Undecided,
        },
    })
}

impl EnclosedBout {
    /// The same in doubles: the middle of each interval, and half its width as what is claimed.
    pub fn bout(&self) -> contract::Bout {
        contract::Bout {
            begin: estimate(&self.begin),
            side: self.side,
            impacts: self.impacts.iter().map(EnclosedImpact::impact).collect(),
            end: match &self.end {
                EnclosedEnd::Rest(time) => contract::BoutEnd::Rest(estimate(time)),
                EnclosedEnd::Overturned => contract::BoutEnd::Overturned,
                EnclosedEnd::Aloft => contract::BoutEnd::Aloft,
                EnclosedEnd::Undecided => contract::BoutEnd::Undecided,
            },
        }
    }
}
