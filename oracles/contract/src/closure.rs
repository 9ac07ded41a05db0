use crate::{Decline, Departure, Estimate};

/// A method that closes a sequence from one impact: how long it takes until infinitely many more have accumulated, without following them.
///
/// It is of one block and one motion of the ground, and holds while the ground goes on as that says. Times are counted from the start of the motion; on
/// [`Ground::Still`](crate::Ground::Still) the block rocks freely, whenever that is.
pub trait Closure: Send + Sync {
    /// How long it takes, in `τ`, from a departure from the base after an impact, with the largest error that is claimed for it. The departure is taken as exact.
    ///
    /// # Errors
    /// A [`Decline`] where the method would not stand by an answer, with the reason and the numbers: no such sequence begins there, or it cannot tell yet.
    fn time_left(&self, departure: &Departure) -> Result<Estimate, Decline>;

    /// The least and the most that it takes, proven; and with that, that the impacts accumulate at all.
    ///
    /// # Errors
    /// A [`Decline`] where that is not proven, or from a method that proves nothing.
    fn bounds(&self, _departure: &Departure) -> Result<(f64, f64), Decline> {
        Err(Decline::Unsupported { what: "bounds on the time that is left" })
    }
}
