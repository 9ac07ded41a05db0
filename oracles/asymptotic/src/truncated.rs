use contract::Estimate;

/// How many coefficients beyond the last one used are computed, to see what is left out.
pub(crate) const BEYOND: usize = 4;

/// The sum of the first `order` terms of a power series at `epsilon`, and how far from the whole sum it may be.
///
/// What is left out is nearly known: the coefficients beyond, and then a geometric sum with the ratio that theirs tend to. Their ratios grow
/// towards it as `1 - s/k` does (a branch point on the positive axis), so it is extrapolated in `1/k`. `None` where that ratio is 1 or more:
/// outside the circle of convergence a sum says nothing.
pub(crate) fn sum(coefficients: impl Iterator<Item = f64>, order: usize, epsilon: f64) -> Option<Estimate> {
    let mut power = 1.0;
    let (mut value, mut size, mut left) = (0.0, 0.0, 0.0);
    // The last three terms, and how many there are.
    let (mut last, mut terms) = ([f64::NAN; 3], 0);
    for coefficient in coefficients {
        let term = coefficient * power;
        if terms < order {
            value += term;
            size += term.abs() * (ROUNDING + terms as f64);
        } else {
            left += term;
        }
        power *= epsilon;
        last = [last[1], last[2], term];
        terms += 1;
    }
    let beyond = tail(last, terms)?;
    Some(Estimate { value, uncertainty: SAFETY * (left.abs() + beyond) + f64::EPSILON * size })
}

/// The geometric sum behind the last of so many terms.
fn tail([before, early, late]: [f64; 3], terms: usize) -> Option<f64> {
    if late == 0.0 {
        return Some(0.0);
    }
    let k = terms as f64 - 1.0;
    let (last, before) = ((late / early).abs(), (early / before).abs());
    let limit = k * last - (k - 1.0) * before;
    // A series that has just begun may have ratios that fall.
    let ratio = if limit.is_finite() { last.max(limit) } else { last };
    (ratio < 1.0).then(|| late.abs() * ratio / (1.0 - ratio))
}

/// What is left out by this count is the error nearly exactly; to high orders and near the critical amplitude the error was up to 1.3 times that.
const SAFETY: f64 = 1.5;
/// Of a coefficient and the sum, in units of the last place of the terms; each power of `ε` adds one.
const ROUNDING: f64 = 10.0;
