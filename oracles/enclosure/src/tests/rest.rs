//! The proof of rest: wherever in the sequence it is made, its bounds contain what is found after many more impacts.

use contract::{Case, Normalisation, Slenderness};

use crate::{
    bounds::Bounds,
    digits::Digits,
    directed::Directed,
    sequence::{self, End, Wanted},
    twofold::Twofold,
};

/// The chattering time as soon as it is known to so many digits.
fn chattering_time<F: Directed>(case: &Case, width: f64) -> Bounds {
    let wanted = Wanted { impacts: 1, followed: 50_000, width };
    match sequence::follow::<F>(case, case.slenderness(), wanted).end {
        End::Complete(time) => Bounds::new(&time).unwrap(),
        _ => panic!("{case:?} is not proven to be complete"),
    }
}

fn check(case: &Case) {
    let fine = chattering_time::<Digits<192>>(case, 1e-24);
    let mut last = f64::INFINITY;
    // The first proof that is possible is as good as the last one, only wider.
    for width in [1.0, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-12] {
        let early = chattering_time::<Twofold>(case, width);
        assert!(early.contain(&fine), "{case:?} {width:e}");
        assert!(early.width() <= last && early.width() > fine.width());
        last = early.width();
    }
    // In doubles it is at least as wide as its own rounding.
    assert!(chattering_time::<f64>(case, 1.0).contain(&fine));
}

#[test]
fn an_early_tail_contains_a_late_one() {
    let slender = Slenderness::new(0.3, Normalisation::Threshold).unwrap();
    for (eta, share) in [(0.5, 0.08), (0.7, 0.06), (0.8, 0.05), (0.92, 0.025), (0.97, 0.005)] {
        for omega in [0.5, 2.0, 8.0] {
            let case = Case::from_epsilon(share, omega, eta).unwrap();
            check(&case);
            if eta < 0.9 {
                check(&case.with_slenderness(slender));
            }
        }
    }
}
