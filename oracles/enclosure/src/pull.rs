//! What pulls a block back to its base, and how that goes on: its Taylor series in local time.

use crate::{directed::Directed, interval::Interval};

/// `i`, the sign of the rotation in a flight.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    Plus,
    Minus,
}

impl Side {
    /// The side of the next flight.
    pub fn other(self) -> Self {
        if self == Self::Plus { Self::Minus } else { Self::Plus }
    }

    /// `±1`.
    pub fn sign(self) -> f64 {
        if self == Self::Plus { 1.0 } else { -1.0 }
    }

    /// `i x`.
    pub fn of<F: Directed>(self, x: &Interval<F>) -> Interval<F> {
        if self == Self::Plus { x.clone() } else { -x }
    }
}

/// The pull at one moment, seen from the side `i` on which the block rotates.
#[derive(Clone)]
pub struct Pull<F> {
    /// `b = 1 + i f`: what pulls the block back to its base, in units of what gravity alone does.
    pub value: Interval<F>,
    /// `b' = i f'`.
    pub slope: Interval<F>,
    /// What its higher derivatives follow from.
    pub bend: Bend<F>,
}

/// How a pull bends.
#[derive(Clone)]
pub enum Bend<F> {
    /// As a sum of waves does; not at all, if there is none.
    Waves(Vec<Wave<F>>),
    /// As a polynomial times a Gaussian does.
    Wavelet(Wavelet<F>),
}

/// A part of a pull that obeys `g'' = -ω² g`.
#[derive(Clone)]
pub struct Wave<F> {
    pub omega_squared: Interval<F>,
    pub value: Interval<F>,
    pub slope: Interval<F>,
}

/// A part of a pull that is `P(x) E(x)`, with `x` the time over the width of the wavelet, `P` a cubic, and `E' = -(y + x) E`.
#[derive(Clone)]
pub struct Wavelet<F> {
    /// Those of `P`.
    pub polynomial: [Interval<F>; 4],
    /// `E(0) = exp(-y²/2)`.
    pub gauss: Interval<F>,
    /// `y`.
    pub middle: Interval<F>,
    /// `1/width`.
    pub rate: Interval<F>,
}

impl<F: Directed> Pull<F> {
    /// A pull that stays as it grows now.
    pub fn straight(value: Interval<F>, slope: Interval<F>) -> Self {
        Self { value, slope, bend: Bend::Waves(Vec::new()) }
    }
}

/// The Taylor coefficients of a pull, as many as have been asked for.
pub struct PullSeries<F> {
    coefficients: Vec<Interval<F>>,
    next: Next<F>,
}

/// What the next coefficient follows from.
enum Next<F> {
    /// Of each wave `-ω²`, and its last two coefficients.
    Waves(Vec<[Interval<F>; 3]>),
    /// The coefficients of `E` in `x` so far, and the power of the rate that belongs to the next one.
    Wavelet { of: Wavelet<F>, gauss: Vec<Interval<F>>, scale: Interval<F> },
}

impl<F: Directed> PullSeries<F> {
    /// That of `pull`, with its first two coefficients.
    pub fn new(pull: &Pull<F>) -> Self {
        let next = match &pull.bend {
            Bend::Waves(waves) => Next::Waves(
                waves.iter().map(|wave| [-&wave.omega_squared, wave.value.clone(), wave.slope.clone()]).collect(),
            ),
            Bend::Wavelet(of) => {
                let second = -&(&of.middle * &of.gauss);
                let gauss = vec![of.gauss.clone(), second];
                Next::Wavelet { of: of.clone(), gauss, scale: of.rate.squared() }
            }
        };
        Self { coefficients: vec![pull.value.clone(), pull.slope.clone()], next }
    }

    /// Those so far.
    pub fn coefficients(&self) -> &[Interval<F>] {
        &self.coefficients
    }

    /// Adds the next one.
    pub fn extend(&mut self) {
        let n = self.coefficients.len();
        let coefficient = match &mut self.next {
            Next::Waves(waves) => {
                let places = Interval::whole(n * (n - 1));
                waves.iter_mut().fold(Interval::zero(), |sum, [factor, before, last]| {
                    let next = &(&*factor * &*before) / &places;
                    *before = core::mem::replace(last, next.clone());
                    if is_nothing(&sum) { next } else { &sum + &next }
                })
            }
            Next::Wavelet { of, gauss, scale } => {
                // (n+1) E_(n+1) = -y E_n - E_(n-1)
                if let [.., before, last] = gauss.as_slice() {
                    let next = -&(&(&(&of.middle * last) + before) / &Interval::whole(n));
                    gauss.push(next);
                }
                let products = of.polynomial.iter().zip(gauss.iter().rev()).map(|(p, e)| p * e);
                let product = products.fold(Interval::zero(), |sum, product| &sum + &product);
                let coefficient = &product * scale;
                *scale = &*scale * &of.rate;
                coefficient
            }
        };
        self.coefficients.push(coefficient);
    }
}

fn is_nothing<F: Directed>(sum: &Interval<F>) -> bool {
    let zero = F::exactly(0.0);
    sum.lower == zero && sum.upper == zero
}
