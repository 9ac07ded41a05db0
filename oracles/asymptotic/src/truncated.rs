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
/// (`tests/orders.rs`).
const SAFETY: f64 = 1.5;
/// Of a coefficient and the sum, in units of the last place of the terms; each power of `ε` adds one.
const ROUNDING: f64 = 10.0;
