//! Sums of sinusoids, a stretch of time each.

use contract::Stretch;

use super::Acceleration;
use crate::{
    directed::Directed,
    functions::sin_cos,
    interval::Interval,
    pull::{Bend, Pull, Side, Wave},
};

pub struct Sinusoids<F> {
    stretches: Vec<(f64, Vec<Term<F>>)>,
    /// `2π`.
    circle: Interval<F>,
}

struct Term<F> {
    amplitude: Interval<F>,
    omega: Interval<F>,
    omega_squared: Interval<F>,
    phase: Interval<F>,
}

impl<F: Directed> Sinusoids<F> {
    pub fn new(stretches: &[Stretch], circle: Interval<F>) -> Self {
        let of = |stretch: &Stretch| {
            let terms = stretch.terms.iter().map(|term| {
                let omega = Interval::exactly(term.omega);
                Term {
                    amplitude: Interval::exactly(term.amplitude),
                    omega_squared: omega.squared(),
                    omega,
                    phase: Interval::exactly(term.phase),
                }
            });
            (stretch.until, terms.collect())
        };
        Self { stretches: stretches.iter().map(of).collect(), circle }
    }

    pub fn parts(&self) -> usize {
        self.stretches.len()
    }

    pub fn end(&self, part: usize) -> Option<Interval<F>> {
        let (until, _) = self.stretches.get(part)?;
        until.is_finite().then(|| Interval::exactly(*until))
    }

    fn terms(&self, part: usize) -> &[Term<F>] {
        self.stretches.get(part).map_or(&[], |(_, terms)| terms)
    }

    /// Each term and its slope.
    fn waves(&self, time: &Interval<F>, part: usize) -> impl Iterator<Item = (&Term<F>, Acceleration<F>)> {
        self.terms(part).iter().map(move |term| {
            let angle = &(&term.omega * time) + &term.phase;
            let turns = (angle.middle() / core::f64::consts::TAU).round();
            let (sine, cosine) = sin_cos(&(&angle - &(&Interval::exactly(turns) * &self.circle)));
            let slope = &(&term.amplitude * &term.omega) * &cosine;
            (term, Acceleration { value: &term.amplitude * &sine, slope })
        })
    }

    pub fn acceleration(&self, time: &Interval<F>, part: usize) -> Option<Acceleration<F>> {
        let sum = |one: Acceleration<F>, other: Acceleration<F>| Acceleration {
            value: &one.value + &other.value,
            slope: &one.slope + &other.slope,
        };
        self.waves(time, part).map(|(_, wave)| wave).reduce(sum)
    }

    pub fn pull(&self, time: &Interval<F>, part: usize, side: Side) -> Pull<F> {
        let (mut value, mut slope) = (Interval::exactly(1.0), Interval::zero());
        let mut waves = Vec::new();
        for (term, wave) in self.waves(time, part) {
            let wave = Wave {
                omega_squared: term.omega_squared.clone(),
                value: side.of(&wave.value),
                slope: side.of(&wave.slope),
            };
            (value, slope) = (&value + &wave.value, &slope + &wave.slope);
            waves.push(wave);
        }
        Pull { value, slope, bend: Bend::Waves(waves) }
    }

    /// Whatever the phase of each term is.
    pub fn any_pull(&self, part: usize) -> Pull<f64> {
        let (mut value, mut slope) = (Interval::exactly(1.0), Interval::zero());
        let waves = self.terms(part).iter().map(|term| {
            let omega: Interval<f64> = term.omega.convert();
            let size = Interval::within(term.amplitude.magnitude());
            let wave = Wave { omega_squared: omega.squared(), slope: &omega * &size, value: size };
            (value, slope) = (&value + &wave.value, &slope + &wave.slope);
            wave
        });
        let waves = waves.collect();
        Pull { value, slope, bend: Bend::Waves(waves) }
    }

    pub fn bend(&self, part: usize) -> Interval<F> {
        let size = |term: &Term<F>| &Interval::exactly(term.amplitude.magnitude()) * &term.omega_squared;
        self.terms(part).iter().fold(Interval::zero(), |sum, term| &sum + &size(term))
    }

    pub fn amplitude(&self) -> Interval<F> {
        (0..self.parts()).fold(Interval::zero(), |most, part| most.or(&self.most(part)))
    }

    /// A bound on `|f|` in a part.
    pub fn most(&self, part: usize) -> Interval<F> {
        let sizes = self.terms(part).iter().map(|term| Interval::exactly(term.amplitude.magnitude()));
        sizes.fold(Interval::zero(), |sum, size| &sum + &size)
    }

    pub fn rate(&self) -> f64 {
        self.stretches.iter().flat_map(|(_, terms)| terms).map(|term| term.omega.magnitude()).fold(0.0, f64::max)
    }
}
