//! What a flight is given and what comes of it, whoever flies it.

use contract::Loss;
use diffsol::{NalgebraContext, NalgebraMat, NalgebraVec, OdeEquationsImplicit};

use crate::equation::Motion;

/// The matrices that the solvers work with.
pub(crate) type Matrix = NalgebraMat<f64>;

/// The equations of a diffsol problem on the small dense types used here.
pub(crate) trait Equations:
    OdeEquationsImplicit<M = Matrix, V = NalgebraVec<f64>, T = f64, C = NalgebraContext>
{
}
impl<E: OdeEquationsImplicit<M = Matrix, V = NalgebraVec<f64>, T = f64, C = NalgebraContext>> Equations for E {}

/// How a flight starts: its sign, the time, and the velocity just after the impact (0 in the first). The rotation is 0, but for a flight that is taken
/// up in the air.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Launch {
    pub i: f64,
    pub tau: f64,
    pub rotation: f64,
    pub velocity: f64,
}

/// How a flight ended.
pub(crate) enum Outcome {
    /// With an impact, `interval` after its start, at the speed `speed`.
    Impact { interval: f64, speed: f64 },
    /// It was still in the air when the time was up.
    TimeIsUp,
    /// Past the point from which no return is possible, so long after its start.
    Overturned { after: f64 },
    /// It was lost.
    Lost(Loss),
}

impl Outcome {
    /// The impact, if it is one, and if it comes in time.
    pub fn landed(interval: f64, speed: f64, time_left: f64) -> Self {
        if !(interval.is_finite() && speed.is_finite() && speed > 0.0) {
            Self::Lost(Loss::NotFinite)
        } else if interval <= 0.0 {
            Self::Lost(Loss::Stalled)
        } else if interval >= time_left {
            Self::TimeIsUp
        } else {
            Self::Impact { interval, speed }
        }
    }
}

/// Something that flies one flight of a case after the other.
pub(crate) trait Flight<'a, E> {
    fn fly(&mut self, motion: &Motion, launch: &Launch, time_left: f64) -> Outcome;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_landing_is_an_impact_only_if_it_makes_sense_and_comes_in_time() {
        let of = |interval, speed| match Outcome::landed(interval, speed, 1.0) {
            Outcome::Impact { interval, speed } => Ok((interval, speed)),
            Outcome::TimeIsUp => Err(None),
            Outcome::Lost(loss) => Err(Some(loss)),
            Outcome::Overturned { .. } => panic!("nothing overturns here"),
        };
        assert_eq!((of(0.25, 3.0), of(1e-300, 1e-300)), (Ok((0.25, 3.0)), Ok((1e-300, 1e-300))));
        assert_eq!((of(1.0, 3.0), of(7.0, 3.0)), (Err(None), Err(None)));
        for (interval, speed) in [(f64::NAN, 1.0), (0.5, f64::NAN), (0.5, f64::INFINITY), (0.5, 0.0), (0.5, -1.0)] {
            assert_eq!(of(interval, speed), Err(Some(Loss::NotFinite)), "{interval} {speed}");
        }
        for interval in [0.0, -0.5] {
            assert_eq!(of(interval, 1.0), Err(Some(Loss::Stalled)));
        }
    }
}
