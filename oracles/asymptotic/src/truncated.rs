use contract::Estimate;

/// How many coefficients beyond the last one used are computed, to see what is left out.
pub(crate) const BEYOND: usize = 4;

/// A truncated sum, and the ratio that its terms tend to.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sum {
    pub(crate) estimate: Estimate,
    pub(crate) ratio: f64,
}

/// The sum of the first `order` terms of a power series at `epsilon`, and how far from the whole sum it may be.
///
/// What is left out is nearly known: the coefficients beyond, and then a geometric sum with the ratio that theirs tend to. Their ratios grow
/// towards it as `1 - s/k` does (a branch point on the positive axis), so it is extrapolated in `1/k`; and it is `least_ratio` at least, for a series
/// that is known to converge no further than another. `None` where that ratio is 1 or more: outside the circle of convergence a sum says nothing.
pub(crate) fn sum(
    coefficients: impl Iterator<Item = f64>,
    order: usize,
    epsilon: f64,
    least_ratio: f64,
) -> Option<Sum> {
    let mut power = 1.0;
    let (mut value, mut size, mut left) = (0.0, 0.0, 0.0);
    let (mut last, mut terms) = ([0.0; WINDOW], 0_usize);
    for coefficient in coefficients {
        let term = coefficient * power;
        if terms < order {
            value += term;
            size += term.abs() * (ROUNDING + terms as f64);
        } else {
            left += term.abs();
        }
        power *= epsilon;
        if let Some(oldest) = last.get_mut(terms % WINDOW) {
            *oldest = term;
        }
        terms += 1;
    }
    // The last one first.
    let last: [f64; WINDOW] =
        std::array::from_fn(|back| last.get((terms + WINDOW - 1 - back) % WINDOW).copied().unwrap_or(0.0));
    let (beyond, ratio) = tail(&last, terms, least_ratio)?;
    let uncertainty = SAFETY * (left + beyond) + f64::EPSILON * size;
    Some(Sum { estimate: Estimate { value, uncertainty }, ratio })
}

/// How many of the last terms are looked at.
const WINDOW: usize = 16;

/// The geometric sum behind the last of so many terms, and its ratio.
fn tail(last: &[f64; WINDOW], terms: usize, least_ratio: f64) -> Option<(f64, f64)> {
    let [late, early, before, first, ..] = *last;
    if last.iter().all(|term| *term == 0.0) {
        return Some((0.0, least_ratio));
    }
    let k = terms as f64 - 1.0;
    let ratios = [late / early, early / before, before / first];
    let limit = k * ratios[0].abs() - (k - 1.0) * ratios[1].abs();
    // (The maximum leaves out what is not a number.)
    let largest = ratios.iter().fold(limit, |most, ratio| most.max(ratio.abs()));
    // The extrapolation is that of a branch point to within a few of its next order.
    let ratio = (largest * (1.0 + k.powf(-1.5))).max(least_ratio);
    // Ratios that fall, or signs that change, are of a singularity off the axis: terms swing, and the last ones may be small by chance.
    let swings = limit < ratios[0] || ratios.iter().any(|ratio| *ratio <= 0.0);
    let envelope = last.iter().rev().fold(0.0_f64, |most, term| (most * ratio).max(term.abs()));
    let term = if swings { envelope } else { late.abs() };
    (ratio < 1.0).then(|| (term * ratio / (1.0 - ratio), ratio))
}

/// What is left out by this count is the error nearly exactly; at worst, in intervals to the lowest order, the error was 1.4 times that
/// (`tests/asymptotic/orders.rs`).
const SAFETY: f64 = 1.5;
/// Of a coefficient and the sum, in units of the last place of the terms; each power of `ε` adds one.
const ROUNDING: f64 = 10.0;

#[cfg(test)]
mod tests {
    use super::*;

    /// `Σ x^k`.
    fn geometric(terms: usize, order: usize, x: f64, least_ratio: f64) -> Option<Sum> {
        sum(std::iter::repeat_n(1.0, terms), order, x, least_ratio)
    }

    /// The coefficients of `(1 - x)^s`.
    fn binomial(s: f64) -> impl Iterator<Item = f64> {
        (0..).scan(1.0, move |next, k| {
            let after = *next * (f64::from(k) - s) / (f64::from(k) + 1.0);
            Some(std::mem::replace(next, after))
        })
    }

    #[test]
    fn of_a_geometric_series_all_that_is_left_out_is_known() {
        for (terms, x) in [(40, 0.5_f64), (18, 0.25), (200, 0.9), (37, -0.5)] {
            for order in [terms, terms - 1, terms - 4] {
                let found = geometric(terms, order, x, 0.0).unwrap();
                let left = 1.0 / (1.0 - x) - found.estimate.value;
                // Of a series whose signs change the terms themselves, without their signs, are what may be left.
                let most = x.abs().powi(order as i32) / (1.0 - x.abs());
                assert!(left.abs() < 1.001 * most + 1e-15, "{terms} {order} {x}: {left}");
                let share = found.estimate.uncertainty / (SAFETY * most);
                assert!((0.999..1.1).contains(&share), "{terms} {order} {x}: {share}");
                assert!((found.ratio / x.abs() - 1.0).abs() < 0.02 && found.ratio > x.abs());
            }
        }
    }

    /// With nothing left out the claim is what rounding may do, more for each power of `ε`.
    #[test]
    fn what_rounding_does_is_claimed() {
        for x in [0.5, 0.25] {
            let found = geometric(400, 396, x, 0.0).unwrap();
            let expected = f64::EPSILON * (10.0 / (1.0 - x) + x / ((1.0 - x) * (1.0 - x)));
            assert!((found.estimate.uncertainty / expected - 1.0).abs() < 1e-12, "{x}: {found:?}");
            assert!((found.estimate.value - 1.0 / (1.0 - x)).abs() < 4e-16);
        }
        let signs = (0..400).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 });
        let found = sum(signs, 396, 0.5, 0.0).unwrap();
        assert!((found.estimate.uncertainty / (22.0 * f64::EPSILON) - 1.0).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn outside_the_circle_of_convergence_nothing_is_said() {
        assert!(geometric(64, 60, 1.0, 0.0).is_none() && geometric(64, 60, 1.3, 0.0).is_none());
        assert!(geometric(64, 60, 0.99, 0.0).is_some());
        // So near to it that the extrapolation can't tell.
        assert!(geometric(64, 60, 0.999, 0.0).is_none());
        assert!(geometric(3, 3, 0.5, 0.0).is_none() && geometric(4, 4, 0.5, 0.0).is_some());
    }

    /// A series that is known to converge no faster than another has its tail summed with that one's ratio.
    #[test]
    fn a_tail_falls_no_faster_than_it_is_told() {
        let found = geometric(20, 20, 0.5, 0.9).unwrap();
        assert_eq!(found.ratio, 0.9);
        assert!((found.estimate.uncertainty / (SAFETY * 0.5_f64.powi(19) * 9.0) - 1.0).abs() < 1e-6, "{found:?}");
        assert!(geometric(20, 20, 0.5, 1.0).is_none());
        // A polynomial has no tail, only a ratio.
        let polynomial = [2.0, 3.0].into_iter().chain(std::iter::repeat_n(0.0, WINDOW));
        let found = sum(polynomial, 18, 0.5, 0.7).unwrap();
        assert_eq!((found.estimate.value, found.ratio), (3.5, 0.7));
        assert!(found.estimate.uncertainty < 40.0 * f64::EPSILON);
    }

    /// Of a branch point on the axis, as of the chattering time, what is left out is claimed with little to spare; its ratio is known long before the
    /// ratios of the terms come near to it.
    #[test]
    fn behind_a_branch_point_the_claim_is_near() {
        for s in [0.6, 0.5, -0.5, 1.3] {
            for (terms, x) in [(20, 0.9), (45, 0.95), (90, 0.5), (90, 0.99)] {
                let found = sum(binomial(s).take(terms), terms - BEYOND, x, 0.0).unwrap();
                let error = ((1.0 - x).powf(s) - found.estimate.value).abs();
                let floor = 30.0 * f64::EPSILON;
                let claim = found.estimate.uncertainty;
                assert!(error <= claim && claim < 5.0 * error + floor, "{s} {terms} {x}: {error:e} of {claim:e}");
                assert!(found.ratio >= x && found.ratio < 1.02 * x, "{s} {terms} {x}: {}", found.ratio);
            }
        }
    }

    /// Of a pair of complex singularities the terms swing, and the last ones may be small by chance: the envelope counts.
    #[test]
    fn terms_that_are_small_by_chance_do_not_pass_for_a_small_tail() {
        // Re 1/(1 - x e^(iθ)) = (1 - x cos θ)/(1 - 2 x cos θ + x²)
        for angle in [0.3_f64, 0.5, 0.9, 2.0] {
            for terms in 30..60 {
                let coefficients = (0..terms).map(|k| (angle * f64::from(k)).cos());
                let x = 0.7;
                let Some(found) = sum(coefficients, terms as usize, x, 0.75) else { continue };
                let error =
                    ((1.0 - x * angle.cos()) / (1.0 - 2.0 * x * angle.cos() + x * x) - found.estimate.value).abs();
                let claim = found.estimate.uncertainty;
                assert!(error <= claim, "{angle} {terms}: {error:e} of {claim:e}");
            }
        }
    }
}
