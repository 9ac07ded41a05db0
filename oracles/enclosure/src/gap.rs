//! A proof that chattering is incomplete, before the flight that passes the end of the half period, on Eq. 4.
//!
//! There the pull on one side vanishes. Let it be between `g_lo` and `g_hi` times the time `s` that is left, and a flight of that side leave with
//! `v = y g_hi s²`. Under a pull of `g_hi` times the time left it would last the share `x` of `s` with `x/2 - x²/6 = y`, and it lasts longer. It lands with
//! `∫ b(r) sinh r dr / sinh T`, which is at least `g_lo (s/sinh s) (x/2 - x²/3) s²`. The flight of the other side gains, as the pull there grows, and takes time. So the
//! next `y` is at least `e² (x/2 - x²/3)/(1-x)²`, with `e² = η² (g_lo/g_hi) s/sinh s`: where that is above `y`, which is to say `(1-x)² (3-x) < e² (3-2x)`, it is so
//! at each flight to come, by more and more, until one passes the end.

use crate::{directed::Directed, excitation::Excitation, functions::sinh_cosh, interval::Interval, pull::Side};

/// From so large a `y` on the flight itself passes the end.
const PASSES: f64 = 1.0 / 3.0;

/// Whether some flight is proven to pass the end of the half period, which is `left` after an impact that leaves this `speed`.
pub fn is_missed<F: Directed>(
    excitation: &Excitation<F>,
    left: &Interval<F>,
    side: Side,
    speed: &Interval<F>,
    eta: f64,
) -> bool {
    let Some(fall) = excitation.fall_to_half_period(left, side).filter(Interval::is_positive) else { return false };
    let [one, two, three] = [1.0, 2.0, 3.0].map(Interval::exactly);
    let (least, most) = (Interval::at(&fall.lower), Interval::at(&fall.upper));
    let share = speed / &(&most * &left.squared());
    let from = share.lower.double_below();
    if from > PASSES {
        return true;
    }
    // A little less than the root of x/2 - x²/6 = y, which is checked.
    let x = Interval::exactly((1.0 - 1e-12) * 0.5 * (3.0 - (9.0 - 24.0 * from).sqrt()));
    let needed = &(&x / &two) - &(&x.squared() / &Interval::exactly(6.0));
    let (sinh, _) = sinh_cosh(left);
    let kept = &(&(&Interval::exactly(eta).squared() * &least) / &most) * &(left / &sinh);
    let grows = (&(&one - &x).squared() * &(&three - &x)).is_below(&(&kept * &(&three - &(&two * &x))));
    x.is_positive() && needed.is_below(&share) && grows
}

#[cfg(test)]
mod tests;
