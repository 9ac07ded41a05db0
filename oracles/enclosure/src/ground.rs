//! The ground as a flight sees it.

use crate::{
    directed::Directed,
    interval::Interval,
    pull::{Pull, Side},
};

/// Ground that moves in a way that is known, each formula of which holds until it changes.
pub trait Ground<F: Directed> {
    /// A moment of it.
    type Moment: Clone;

    /// The moment `interval` later, if the ground does not change its formula before.
    fn later(&self, moment: &Self::Moment, interval: &Interval<F>) -> Self::Moment;

    /// The pull on the side `i = +1` or `i = -1`.
    fn pull(&self, moment: &Self::Moment, side: Side) -> Pull<F>;

    /// Every pull that there is within `length` of a moment, as this formula has it. Doubles are enough for bounds.
    fn any_pull(&self, moment: &Self::Moment, side: Side, length: f64) -> Pull<f64>;

    /// How long it is until the formula changes, and the moment when it does.
    fn change(&self, moment: &Self::Moment) -> Option<(Interval<F>, Self::Moment)>;

    /// Bounds for the pull within `length` of a moment at which it is `pull`; `None` where it may jump.
    fn window(&self, moment: &Self::Moment, side: Side, pull: &Pull<F>, length: &Interval<F>) -> Option<Window<F>>;

    /// A bound on `|f|` from any moment on.
    fn amplitude(&self) -> &Interval<F>;
}

/// What the pull is in a window of time.
pub struct Window<F> {
    /// Every value.
    pub value: Interval<F>,
    /// Every slope.
    pub slope: Interval<F>,
}

impl<F: Directed> Window<F> {
    /// From a pull at the start of the window, no second derivative of which is larger than `bend`.
    pub fn bent(pull: &Pull<F>, bend: &Interval<F>, length: &Interval<F>) -> Self {
        let time = length.down_to_zero();
        let bend = Interval::within(bend.magnitude());
        let half = &Interval::exactly(0.5) * &time.squared();
        let value = &(&pull.value + &(&pull.slope * &time)) + &(&bend * &half);
        Self { value, slope: &pull.slope + &(&bend * &time) }
    }
}
