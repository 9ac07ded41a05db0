//! A block on its ground, and how its flights end.

use crate::{directed::Directed, excitation::Excitation, interval::Interval, piece::Motion};

/// The block and the ground.
pub struct Scene<'a, F> {
    pub motion: &'a Motion<F>,
    pub excitation: &'a Excitation<F>,
    /// Both in doubles.
    pub coarse_motion: Motion<f64>,
    pub coarse_excitation: Excitation<f64>,
    pub eta: f64,
}

/// How a flight ends, with what is known of the block then.
pub enum Flown<F, K> {
    /// With an impact after this interval.
    Landed(Interval<F>, K),
    /// It is in the air at the horizon.
    Aloft,
    /// No return is possible.
    Overturned,
    /// Not with these digits.
    Unclear,
}

impl<'a, F: Directed> Scene<'a, F> {
    pub fn new(motion: &'a Motion<F>, excitation: &'a Excitation<F>, (omega, eta): (f64, f64)) -> Self {
        let coarse_excitation = excitation.convert::<f64>();
        let coarse_motion = Motion::new(&coarse_excitation.amplitude, omega, None);
        Self { motion, excitation, coarse_motion, coarse_excitation, eta }
    }
}

impl<F, K> Flown<F, K> {
    /// The same, known in another way.
    pub fn map<L>(self, known: impl FnOnce(K) -> L) -> Flown<F, L> {
        match self {
            Self::Landed(interval, landed) => Flown::Landed(interval, known(landed)),
            Self::Aloft => Flown::Aloft,
            Self::Overturned => Flown::Overturned,
            Self::Unclear => Flown::Unclear,
        }
    }
}
