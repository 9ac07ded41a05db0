//! The proof of rest: wherever in the sequence it is made, its bounds contain what is found after many more impacts.

use super::effort::pick;
use contract::{Case, Normalisation, Slenderness};

use crate::{
    bounds::Bounds,
    digits::Digits,
    directed::Directed,
    interval::Interval,
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
        for omega in pick("frequencies", vec![2.0], vec![0.5, 2.0, 8.0]) {
            let case = Case::from_epsilon(share, omega, eta).unwrap();
            check(&case);
            if eta < 0.9 {
                check(&case.with_slenderness(slender));
            }
        }
    }
}

/// However few the digits, what is proven is true: next to the critical amplitude they may leave it open, but never take one side for the
/// other.
#[test]
fn no_number_of_digits_takes_one_ending_for_the_other() {
    fn ending<F: Directed>(case: &Case) -> Option<bool> {
        let wanted = Wanted { impacts: 1, followed: 50_000, width: 1.0 };
        match sequence::follow::<F>(case, None, wanted).end {
            End::Complete(_) => Some(true),
            End::HalfPeriod | End::Overturned => Some(false),
            _ => None,
        }
    }
    let mut open = 0;
    for (omega, eta) in [(2.0, 0.5), (0.5, 0.6), (8.0, 0.7), (2.0, 0.8)] {
        let critical = crate::critical_amplitude(omega, eta).unwrap();
        for away in (0..44).step_by(pick("one of so many distances", 4, 1)).map(|step| 1e-3 * 0.5_f64.powi(step)) {
            for (epsilon, complete) in
                [(critical.epsilon_complete - away, true), (critical.epsilon_incomplete + away, false)]
            {
                let case = Case::from_epsilon(epsilon, omega, eta).unwrap();
                for found in [ending::<f64>(&case), ending::<Twofold>(&case), ending::<Digits<128>>(&case)] {
                    assert!(found.is_none_or(|found| found == complete), "{case:?}");
                    open += usize::from(found.is_none());
                }
            }
        }
    }
    assert!(open > pick("ends left open", 5, 20), "doubles were never at their end: {open}");
}

/// The two amplitudes that are reported are those that were proven.
#[test]
fn the_certified_bracket_is_the_one_that_was_tried() {
    for (omega, eta) in [(2.0, 0.5), (1.0, 0.7)] {
        let critical = crate::critical_amplitude(omega, eta).unwrap();
        let of = |epsilon: f64| Bounds::new(&(&Interval::<Digits<192>>::exactly(1.0) + &Interval::exactly(epsilon)));
        let (complete, incomplete) = (of(critical.epsilon_complete).unwrap(), of(critical.epsilon_incomplete).unwrap());
        assert_eq!(critical.amplitude.decimals(30)[0], complete.decimals(30)[0]);
        assert_eq!(critical.amplitude.decimals(30)[1], incomplete.decimals(30)[1]);
    }
}

/// As another method measured it, and 3/5 where restitution is nearly perfect.
#[test]
fn the_exponent_of_the_approach() {
    for (eta, exponent, off) in [(0.92, 0.60018, 5e-6), (0.7, 0.60321, 5e-6), (0.8, 0.60125, 1e-4), (0.9999, 0.6, 1e-6)]
    {
        let found = crate::critical::exponent(eta);
        assert!((found - exponent).abs() < off, "{eta}: {found}");
    }
}
