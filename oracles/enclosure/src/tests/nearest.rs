//! A broken format for controls: doubles rounded to the nearest, with no move outward; and what the whole pipeline makes of it.

use contract::Case;
use dashu_int::IBig;

use crate::{
    bounds::Bounds,
    digits::Digits,
    directed::Directed,
    equation::Start,
    excitation::{Excitation, HalfPhase},
    ground::Ground,
    interval::Interval,
    piece::Motion,
    pull::Side,
    sequence::{self, Impact, Wanted},
};

#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub struct Nearest(pub f64);

impl Directed for Nearest {
    const BITS: u32 = 53;

    fn exactly(value: f64) -> Self {
        Self(value)
    }

    fn negated(&self) -> Self {
        Self(-self.0)
    }

    fn plus_below(&self, other: &Self) -> Self {
        Self(self.0 + other.0)
    }

    fn plus_above(&self, other: &Self) -> Self {
        Self(self.0 + other.0)
    }

    fn times_below(&self, other: &Self) -> Self {
        Self(self.0 * other.0)
    }

    fn times_above(&self, other: &Self) -> Self {
        Self(self.0 * other.0)
    }

    fn over_below(&self, other: &Self) -> Self {
        Self(self.0 / other.0)
    }

    fn over_above(&self, other: &Self) -> Self {
        Self(self.0 / other.0)
    }

    fn root_below(&self) -> Self {
        Self(self.0.sqrt())
    }

    fn root_above(&self) -> Self {
        Self(self.0.sqrt())
    }

    fn double_below(&self) -> f64 {
        self.0
    }

    fn double_above(&self) -> f64 {
        self.0
    }

    fn exact_parts(&self) -> Option<(IBig, isize)> {
        self.0.exact_parts()
    }
}

/// Bounds of the impacts, the pulls and the ends of pieces that `F` finds for a case; `None` where there are none, or the ends lie the
/// wrong way round.
fn found<F: Directed>(case: &Case) -> Vec<Option<Bounds>> {
    let wanted = Wanted { impacts: 20, followed: 20, width: 1.0 };
    let impacts = sequence::follow::<F>(case, None, wanted).impacts;
    let mut all: Vec<_> = (0..20)
        .flat_map(|n| {
            let impact = impacts.get(n);
            let bounds = |of: fn(&Impact<F>) -> &Interval<F>| impact.and_then(|impact| Bounds::new(of(impact)));
            [bounds(|i| &i.time), bounds(|i| &i.interval), bounds(|i| &i.speed)]
        })
        .collect();
    let excitation = Excitation::<F>::new(&Interval::exactly(case.epsilon()), case.omega());
    let motion = Motion::new(&excitation.amplitude, case.omega(), None);
    let any_pull = |length| excitation.any_pull(&HalfPhase::start(), Side::Minus, length);
    let pull = excitation.pull(&HalfPhase::start(), Side::Minus);
    let start = Start { distance: Interval::zero(), velocity: Interval::zero(), pull };
    for n in 1..=40 {
        let time = 0.01 * f64::from(n);
        let phase = excitation.later(&HalfPhase::start(), &Interval::exactly(time));
        let pull = excitation.pull(&phase, Side::Plus);
        let piece = motion.piece(&start, &any_pull, 3, 0.1 * time).unwrap();
        let (distance, velocity) = piece.at(&Interval::exactly(piece.length));
        all.extend([pull.value, pull.slope, distance, velocity].iter().map(Bounds::new));
    }
    all
}

/// The control: the same pipeline with rounding to the nearest does not contain the truth, with outward rounding it does.
#[test]
fn the_pipeline_rounded_to_the_nearest_is_found_out() {
    for (epsilon, omega, eta) in [(0.03, 2.0, 0.92), (0.01, 0.7, 0.8), (0.1, 5.0, 0.6)] {
        let case = Case::from_epsilon(epsilon, omega, eta).unwrap();
        let truth = found::<Digits<192>>(&case);
        let wrong = |found: Vec<Option<Bounds>>, missing: bool| {
            let holds = |bounds: &Option<Bounds>, truth: &Option<Bounds>| match (bounds, truth) {
                (Some(bounds), Some(truth)) => bounds.contain(truth),
                (bounds, _) => missing && bounds.is_none(),
            };
            found.iter().zip(&truth).filter(|(bounds, truth)| !holds(bounds, truth)).count()
        };
        assert!(truth.len() == 220 && truth.iter().all(Option::is_some));
        assert_eq!(wrong(found::<f64>(&case), false), 0);
        // Bounds that are missing claim nothing: only those that are there and wrong count.
        let broken = wrong(found::<Nearest>(&case), true);
        assert!(broken > 40, "only {broken} bounds are violated");
    }
}
