//! Records: sample `k` at `k dt`, an exact product, and straight lines between them.

use core::f64;

use super::Acceleration;
use crate::{directed::Directed, interval::Interval};

pub struct Record<F> {
    dt: Interval<F>,
    scale: Interval<F>,
    samples: std::sync::Arc<[f64]>,
}

impl<F: Directed> Record<F> {
    pub fn new(record: &contract::Record) -> Self {
        Self {
            dt: Interval::exactly(record.dt),
            scale: Interval::exactly(record.scale),
            samples: record.samples.clone(),
        }
    }

    pub fn parts(&self) -> usize {
        self.samples.len().saturating_sub(1)
    }

    fn sample(&self, k: usize) -> Interval<F> {
        self.samples.get(k).map_or_else(Interval::zero, |sample| &Interval::exactly(*sample) * &self.scale)
    }

    fn time(&self, k: usize) -> Interval<F> {
        &Interval::whole(k) * &self.dt
    }

    pub fn end(&self, part: usize) -> Option<Interval<F>> {
        (part < self.parts()).then(|| self.time(part + 1))
    }

    pub fn acceleration(&self, time: &Interval<F>, part: usize) -> Option<Acceleration<F>> {
        let Acceleration { value, slope } = self.first(part)?;
        let since = time - &self.time(part);
        Some(Acceleration { value: &value + &(&slope * &since), slope })
    }

    /// What the line of a part ends at: the sample itself, without the error of going there.
    pub fn last(&self, part: usize) -> Interval<F> {
        if part < self.parts() { self.sample(part + 1) } else { Interval::zero() }
    }

    /// What the line of a part starts at, and its slope.
    pub fn first(&self, part: usize) -> Option<Acceleration<F>> {
        let (value, last) = (self.sample(part), self.last(part));
        (part < self.parts()).then(|| Acceleration { slope: &(&last - &value) / &self.dt, value })
    }

    /// A bound on `|f|` in a part.
    pub fn most(&self, part: usize) -> Interval<F> {
        self.sample(part).absolute().or(&self.last(part).absolute())
    }

    pub fn amplitude(&self) -> Interval<F> {
        let most = self.samples.iter().fold(0.0, |most: f64, sample| most.max(sample.abs()));
        &Interval::exactly(most) * &Interval::exactly(self.scale.magnitude())
    }
}
