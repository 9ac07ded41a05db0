//! More digits are inside fewer, for cases at random.

use contract::{Case, Model, Normalisation, Slenderness};
use enclosure::{Bounds, Enclosed, Enclosure};

/// Numbers between 0 and 1, always the same (a multiplicative generator).
struct Seeded(u64);

impl Seeded {
    fn next(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// The outer bounds contain the inner ones, up to the last impact that both have.
fn check(outer: &Enclosed, inner: &Enclosed, case: &Case) {
    let contain = |outer: &Bounds, inner: &Bounds| {
        assert!(outer.contain(inner), "{case:?}: {:?} {:?}", outer.decimals(60), inner.decimals(60));
    };
    assert_eq!((outer.ending, outer.impacts.len()), (inner.ending, inner.impacts.len()), "{case:?}");
    for (one, two) in outer.impacts.iter().zip(&inner.impacts) {
        contain(&one.time, &two.time);
        contain(&one.interval, &two.interval);
        contain(&one.velocity, &two.velocity);
    }
    if let (Some(one), Some(two)) = (&outer.chattering_time, &inner.chattering_time) {
        contain(one, two);
    }
}

fn nested(model: Model, seed: u64, cases: usize, precisions: &[u32]) {
    let mut random = Seeded(seed);
    let mut complete = 0;
    for _ in 0..cases {
        let eta = random.next(0.3, 0.93);
        let epsilon = random.next(-7.0, -1.2).exp() * (1.0 - eta) * 4.0;
        let block = Slenderness::new(random.next(0.05, 0.5), Normalisation::Threshold).unwrap();
        let case = Case::from_epsilon(epsilon, random.next(0.5, 8.0), eta)
            .unwrap()
            .with_slenderness(block)
            .with_max_impacts(30)
            .unwrap();
        let found = precisions
            .iter()
            .map(|&digits| Enclosure::new(model).with_digits(digits).unwrap().enclose(&case).expect("decided"));
        let found: Vec<Enclosed> = found.collect();
        for pair in found.windows(2) {
            check(&pair[0], &pair[1], &case);
        }
        complete += usize::from(found[0].chattering_time.is_some());
        for (enclosed, &digits) in found.iter().zip(precisions) {
            for impact in &enclosed.impacts {
                assert!(impact.interval.width() <= (0.1_f64).powi(digits as i32) * impact.interval.upper());
            }
        }
    }
    assert!(complete > cases / 3, "{complete} of {cases} are complete");
}

#[test]
fn linear() {
    nested(Model::Linear, 1, 14, &[12, 17, 30, 50]);
}

#[test]
fn nonlinear() {
    nested(Model::Nonlinear, 2, 8, &[12, 17, 30]);
    nested(Model::Nonlinear, 5, 3, &[17, 50]);
}
