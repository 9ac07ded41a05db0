//! Ground that moves in any way: sums of sinusoids, Ricker wavelets, records. Time is absolute, from the start of the motion; each stretch, the wavelet, each
//! segment of a record and the stillness after them is a part, with one formula.

mod push;
mod record;
mod sinusoids;
mod wavelet;

pub use push::Push;

use contract::Motion;

use crate::{
    directed::Directed,
    functions::pi,
    ground::{Ground, Window},
    interval::Interval,
    pull::{Pull, Side},
};
use record::Record;
use sinusoids::Sinusoids;
use wavelet::Ricker;

/// A motion of the ground with everything that its parts need to know.
pub struct Shaking<F> {
    kind: Kind<F>,
    amplitude: Interval<F>,
    /// How fast it changes at the most; 0 for straight lines.
    pub rate: f64,
}

enum Kind<F> {
    Sinusoids(Sinusoids<F>),
    Ricker(Ricker<F>),
    Record(Record<F>),
}

/// A moment, and the part that it is in.
#[derive(Clone)]
pub struct Moment<F> {
    pub time: Interval<F>,
    pub part: usize,
}

/// `f`, and what it changes by.
pub struct Acceleration<F> {
    pub value: Interval<F>,
    pub slope: Interval<F>,
}

impl<F: Directed> Shaking<F> {
    pub fn new(motion: &Motion) -> Self {
        let circle = &Interval::exactly(2.0) * &pi();
        match motion {
            Motion::Sinusoids(stretches) => {
                let sums = Sinusoids::new(stretches, circle);
                let (amplitude, rate) = (sums.amplitude(), sums.rate());
                Self { kind: Kind::Sinusoids(sums), amplitude, rate }
            }
            Motion::Ricker(ricker) => {
                let wavelet = Ricker::new(ricker);
                let (amplitude, rate) = (wavelet.strongest(), 2.0 * ricker.omega);
                Self { kind: Kind::Ricker(wavelet), amplitude, rate }
            }
            Motion::Record(record) => {
                let record = Record::new(record);
                let amplitude = record.amplitude();
                Self { kind: Kind::Record(record), amplitude, rate: 0.0 }
            }
        }
    }

    /// The moment at which the motion starts.
    pub fn start(&self) -> Moment<F> {
        Moment { time: Interval::zero(), part: 0 }
    }

    /// How many parts there are before the stillness.
    pub fn parts(&self) -> usize {
        match &self.kind {
            Kind::Sinusoids(sums) => sums.parts(),
            Kind::Ricker(_) => 1,
            Kind::Record(record) => record.parts(),
        }
    }

    /// When a part ends; `None` if it does not.
    fn end(&self, part: usize) -> Option<Interval<F>> {
        match &self.kind {
            Kind::Sinusoids(sums) => sums.end(part),
            Kind::Ricker(wavelet) => (part == 0).then(|| wavelet.end()),
            Kind::Record(record) => record.end(part),
        }
    }

    /// `f` at a moment.
    pub fn acceleration(&self, moment: &Moment<F>) -> Acceleration<F> {
        let Moment { time, part } = moment;
        let found = match &self.kind {
            Kind::Sinusoids(sums) => sums.acceleration(time, *part),
            Kind::Ricker(wavelet) => (*part == 0).then(|| wavelet.acceleration(time)),
            Kind::Record(record) => record.acceleration(time, *part),
        };
        found.unwrap_or_else(|| Acceleration { value: Interval::zero(), slope: Interval::zero() })
    }

    /// `f` just after a part has begun: as it is given, where it is.
    fn at_start(&self, moment: &Moment<F>) -> Acceleration<F> {
        match &self.kind {
            Kind::Record(record) => record.first(moment.part),
            Kind::Sinusoids(_) | Kind::Ricker(_) => None,
        }
        .unwrap_or_else(|| self.acceleration(moment))
    }

    /// A bound on `|f|` in a part.
    fn most(&self, part: usize) -> Interval<F> {
        match &self.kind {
            Kind::Sinusoids(sums) => sums.most(part),
            Kind::Record(record) => record.most(part),
            Kind::Ricker(_) => self.amplitude.clone(),
        }
    }

    /// A bound on `|f''|` in a part.
    pub fn bend(&self, part: usize) -> Interval<F> {
        match &self.kind {
            Kind::Sinusoids(sums) => sums.bend(part),
            Kind::Ricker(wavelet) if part == 0 => wavelet.bend(),
            Kind::Ricker(_) | Kind::Record(_) => Interval::zero(),
        }
    }

    /// The time in which a part changes.
    fn scale(&self) -> f64 {
        1.0 / self.rate.max(1e-9)
    }
}

/// The pull of a straight line.
fn straight<F: Directed>(Acceleration { value, slope }: &Acceleration<F>, side: Side) -> Pull<F> {
    Pull::straight(&Interval::exactly(1.0) + &side.of(value), side.of(slope))
}

impl<F: Directed> Ground<F> for Shaking<F> {
    type Moment = Moment<F>;

    fn later(&self, moment: &Moment<F>, interval: &Interval<F>) -> Moment<F> {
        Moment { time: &moment.time + interval, part: moment.part }
    }

    fn pull(&self, moment: &Moment<F>, side: Side) -> Pull<F> {
        let Moment { time, part } = moment;
        match &self.kind {
            Kind::Sinusoids(sums) => sums.pull(time, *part, side),
            Kind::Ricker(wavelet) if *part == 0 => wavelet.pull(time, side),
            Kind::Ricker(_) | Kind::Record(_) => straight(&self.acceleration(moment), side),
        }
    }

    fn any_pull(&self, moment: &Moment<F>, side: Side, length: f64) -> Pull<f64> {
        match &self.kind {
            Kind::Sinusoids(sums) => sums.any_pull(moment.part),
            Kind::Ricker(wavelet) if moment.part == 0 => {
                let from: Interval<f64> = moment.time.convert();
                wavelet.coarse().pull(&(&from + &Interval::between(0.0, length)), side)
            }
            Kind::Ricker(_) | Kind::Record(_) => {
                let Acceleration { value, slope } = self.acceleration(moment);
                let (value, slope): (Interval<f64>, Interval<f64>) = (value.convert(), slope.convert());
                let value = &value + &(&slope * &Interval::between(0.0, length));
                straight(&Acceleration { value, slope }, side)
            }
        }
    }

    fn change(&self, moment: &Moment<F>) -> Option<(Interval<F>, Moment<F>)> {
        let end = self.end(moment.part)?;
        Some((&end - &moment.time, Moment { time: end, part: moment.part + 1 }))
    }

    fn window(&self, moment: &Moment<F>, side: Side, pull: &Pull<F>, length: &Interval<F>) -> Option<Window<F>> {
        let window = Window::bent(pull, &self.bend(moment.part), length);
        let Some((left, next)) = self.change(moment).filter(|(left, _)| !length.is_below(left)) else {
            return Some(window);
        };
        // Over a kink of a record, but not over anything that may be a jump.
        let Kind::Record(record) = &self.kind else { return None };
        if next.part >= record.parts() {
            return None;
        }
        let here = Window::bent(pull, &self.bend(moment.part), &left);
        let there = self.window(&next, side, &self.pull(&next, side), &(length - &left))?;
        Some(Window { value: here.value.or(&there.value), slope: here.slope.or(&there.slope) })
    }

    fn amplitude(&self) -> &Interval<F> {
        &self.amplitude
    }
}
