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
        if part >= self.parts() {
            return None;
        }
        let from = self.sample(part);
        let slope = &(&self.sample(part + 1) - &from) / &self.dt;
        let since = time - &self.time(part);
        Some(Acceleration { value: &from + &(&slope * &since), slope })
    }

    pub fn amplitude(&self) -> Interval<F> {
        let most = self.samples.iter().fold(0.0, |most: f64, sample| most.max(sample.abs()));
        &Interval::exactly(most) * &Interval::exactly(self.scale.magnitude())
    }
}
