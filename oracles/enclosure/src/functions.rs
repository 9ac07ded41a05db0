//! The functions that the motion needs, each from a series with a bound on what is left out.

use crate::{directed::Directed, interval::Interval};

/// The sine and the cosine.
///
/// The series are those at a small fraction of the argument, which doubling brings back to it. By Taylor's theorem what is left out
/// after the term of degree `n` is at most `|x|^(n+1)/(n+1)!` for both, because no derivative exceeds 1.
pub fn sin_cos<F: Directed>(x: &Interval<F>) -> (Interval<F>, Interval<F>) {
    sin_cos_to(x, F::BITS as i32 + 4)
}

/// The same from a series that leaves out what is below `2^-bits`.
pub(crate) fn sin_cos_to<F: Directed>(x: &Interval<F>, bits: i32) -> (Interval<F>, Interval<F>) {
    let (sine, cosine) = by_doubling(x, bits, -1.0, 1.0);
    let unit = Interval::within(1.0);
    (sine.and(&unit), cosine.and(&unit))
}

/// The hyperbolic sine and cosine. Their terms fall by more than half each, so that twice the first one left out bounds the rest.
pub fn sinh_cosh<F: Directed>(x: &Interval<F>) -> (Interval<F>, Interval<F>) {
    by_doubling(x, F::BITS as i32 + 4, 1.0, 2.0)
}

/// The odd and the even solution of `y'' = sign y`, of which `beyond` times the first term that is left out bounds all that is.
fn by_doubling<F: Directed>(x: &Interval<F>, bits: i32, sign: f64, beyond: f64) -> (Interval<F>, Interval<F>) {
    let mut halvings = 0;
    let mut small = x.clone();
    let half = Interval::exactly(0.5);
    while small.magnitude() > 0.5 && halvings < 64 {
        small = &small * &half;
        halvings += 1;
    }
    let square = small.squared();
    let one = Interval::exactly(1.0);
    let signed = |term: &Interval<F>| if sign < 0.0 { -term } else { term.clone() };
    // sin x = x S(x²), cos x = C(x²), with the terms of both side by side.
    let (mut sine, mut cosine) = (one.clone(), one.clone());
    let (mut sine_term, mut cosine_term) = (one.clone(), one.clone());
    let mut n = 0;
    loop {
        n += 2;
        cosine_term = signed(&(&(&cosine_term * &square) / &Interval::whole((n - 1) * n)));
        sine_term = signed(&(&(&sine_term * &square) / &Interval::whole(n * (n + 1))));
        let left_out = cosine_term.magnitude();
        if n > 4 && left_out < (2.0_f64).powi(-bits) || n > 1000 {
            // The terms of this degree are bounds on all from here on.
            let bound = Interval::within(beyond * left_out);
            sine = &sine + &bound;
            cosine = &cosine + &bound;
            break;
        }
        sine = &sine + &sine_term;
        cosine = &cosine + &cosine_term;
    }
    let mut sine = &small * &sine;
    let two = Interval::exactly(2.0);
    for _ in 0..halvings {
        let twice = &two * &(&sine * &cosine);
        cosine = &one + &signed(&(&two * &sine.squared()));
        sine = twice;
    }
    (sine, cosine)
}

/// `exp(-y²/2)`.
pub fn gauss<F: Directed>(y: &Interval<F>) -> Interval<F> {
    let half_square = &y.squared() * &Interval::exactly(0.5);
    // It falls with the square.
    let (least, most) = (fall(&Interval::at(&half_square.upper)), fall(&Interval::at(&half_square.lower)));
    Interval { lower: least.lower, upper: most.upper }.not_below_zero()
}

/// `exp(-z)` of a number that is not negative, from the series at a small fraction of it, which squaring brings back to it. The terms fall and alternate, so that
/// the first one left out bounds the rest.
fn fall<F: Directed>(z: &Interval<F>) -> Interval<F> {
    let (mut small, mut halvings) = (z.clone(), 0);
    while small.magnitude() > 0.5 && halvings < 64 {
        small = &small * &Interval::exactly(0.5);
        halvings += 1;
    }
    let (mut sum, mut term, mut n) = (Interval::exactly(1.0), Interval::exactly(1.0), 0);
    loop {
        n += 1;
        term = -&(&(&term * &small) / &Interval::whole(n));
        let left_out = term.magnitude();
        if left_out < (2.0_f64).powi(-(F::BITS as i32) - 8) || n > 1000 {
            sum = &sum + &Interval::within(left_out);
            break;
        }
        sum = &sum + &term;
    }
    for _ in 0..halvings {
        sum = sum.squared();
    }
    sum
}

/// `π = 16 atan(1/5) - 4 atan(1/239)` (Machin).
pub fn pi<F: Directed>() -> Interval<F> {
    pi_to(F::BITS as i32 + 8)
}

/// The same from series that leave out what is below `2^-bits`.
pub(crate) fn pi_to<F: Directed>(bits: i32) -> Interval<F> {
    let (far, near) = (arctangent_of_inverse(5, bits), arctangent_of_inverse(239, bits));
    &(&Interval::exactly(16.0) * &far) - &(&Interval::exactly(4.0) * &near)
}

/// `atan(1/n)`: an alternating series of falling terms, so that the first one left out bounds the rest.
fn arctangent_of_inverse<F: Directed>(n: usize, bits: i32) -> Interval<F> {
    let square = Interval::whole(n * n);
    let mut power = &Interval::exactly(1.0) / &Interval::whole(n);
    let mut sum = Interval::zero();
    let mut odd = 1;
    loop {
        let term = &power / &Interval::whole(odd);
        if term.magnitude() < (2.0_f64).powi(-bits) {
            return &sum + &Interval::within(term.magnitude());
        }
        sum = if odd % 4 == 1 { &sum + &term } else { &sum - &term };
        power = &power / &square;
        odd += 2;
    }
}
