//! The printed solution against itself at other lengths, against the paper's expansion, and at its ends.

use crate::effort::pick;
use contract::{Case, Decline, Ending, Horizon, Limit, Oracle};
use printed::Printed;

fn case(a: f64, omega: f64, eta: f64) -> Case {
    Case::from_amplitude(a, omega, eta).unwrap()
}

/// Computed with mpmath in local time, a form of the solution that this crate does not use, for the exact values of the doubles.
#[test]
fn impact_times_agree_with_another_form_in_50_digits() {
    for (case, n, time) in [
        (case(1.03, 2.0, 0.92), 1, "0.48776479063265210132959773886104836408972845039782"),
        (case(1.03, 2.0, 0.92), 10, "0.83900910013619822429519140584371125581161340489983"),
        (case(1.03, 2.0, 0.92), 40, "1.1007770307816021036596355100976417094340732580866"),
        (case(1.01, 5.0, 0.92), 40, "0.22225411629243740460545091452488289775141355371756"),
        (case(1.03, 2.0, 0.86), 40, "0.84456937210326891983698044932791033085385567827591"),
        (case(1.001, 0.5, 0.97), 40, "0.86499096127456996165456613687155321586028837712232"),
    ] {
        let impacts = Printed::with_digits(50).unwrap().decimals(&case.with_max_impacts(n).unwrap()).unwrap();
        assert_eq!(impacts[n - 1].time, time);
    }
}

#[test]
fn the_chattering_time_is_that_of_the_exact_doubles() {
    let tau_ch = Printed::with_digits(40).unwrap().chattering_time_decimal(&case(1.03, 2.0, 0.92)).unwrap();
    assert!(tau_ch.starts_with("1.125947676933812085652"), "{tau_ch}");
    assert!(tau_ch.len() >= 30 + 2, "{tau_ch}");
    for case in [case(1.2, 2.0, 0.92), case(1.0, 2.0, 0.92)] {
        assert!(matches!(Printed::default().chattering_time_decimal(&case), Err(Decline::NotConvergent { .. })));
    }
}

/// From `data/reference/linear_chattering_times.csv`.
const REFERENCES: [(f64, f64, f64, &str); 3] = [
    (0.08448750000000001, 2.0, 0.5, "0.976381453474175714361998368552763974960168183166996907750117"),
    (0.06825422249999992, 0.5, 0.65, "5.19480405251331432143447092921036954471762976773533044923774"),
    (0.0039026399999999906, 0.5, 0.8, "1.01154050003963100096446165048794593678083651892002421924076"),
];

/// As many digits as are asked for, where they can be had; all of them those of the reference, but for the rounding of the last one.
#[test]
fn the_chattering_time_has_the_digits_that_were_asked_for() {
    for (epsilon, omega, eta, reference) in REFERENCES {
        let case = Case::from_epsilon(epsilon, omega, eta).unwrap();
        let mut found = Vec::new();
        for digits in pick("digits", vec![15, 22], vec![15, 22, 30]) {
            let decimal = Printed::with_digits(digits).unwrap().chattering_time_decimal(&case).unwrap();
            assert_eq!(significant(&decimal).len(), digits, "{decimal}");
            let (last, truth): (u128, u128) =
                (significant(&decimal).parse().unwrap(), significant(reference)[..digits].parse().unwrap());
            assert!(last.abs_diff(truth) <= 1, "{decimal} {reference}");
            found.push(decimal);
        }
        // The limits of the case are not those of the chattering time.
        let short = case.with_max_impacts(2).unwrap().with_horizon(Horizon::Until(0.01)).unwrap();
        assert_eq!(Printed::with_digits(15).unwrap().chattering_time_decimal(&short).as_ref(), Ok(&found[0]));
    }
}

/// The significant digits of a decimal.
fn significant(decimal: &str) -> String {
    let digits: String = decimal.chars().take_while(|c| *c != 'e').filter(char::is_ascii_digit).collect();
    digits.trim_start_matches('0').to_owned()
}

#[test]
fn fewer_digits_are_the_first_of_more() {
    let case = case(1.02, 3.0, 0.9).with_max_impacts(30).unwrap();
    let short = Printed::with_digits(40).unwrap().decimals(&case).unwrap();
    let long = Printed::with_digits(80).unwrap().decimals(&case).unwrap();
    assert_eq!((short.len(), long.len()), (30, 30));
    for (short, long) in short.iter().zip(&long) {
        for (short, long) in
            [(&short.time, &long.time), (&short.interval, &long.interval), (&short.velocity, &long.velocity)]
        {
            assert_eq!(short.split('e').nth(1), long.split('e').nth(1));
            let (short, long) = (significant(short), significant(long));
            assert_eq!((short.len(), long.len()), (40, 80));
            // The last digit is rounded.
            assert_eq!(short[..10], long[..10]);
            let [short, long] = [&short[10..], &long[10..40]].map(|digits| digits.parse::<u128>().unwrap());
            assert!(short.abs_diff(long) <= 1);
        }
    }
}

/// Eq. 32, `τ_1 = 4√2 ε^(1/2)/ω - (√2/ω) [-1 + 32 (ω²-1)/(15 ω²)] ε^(3/2)`: with 15 where the paper prints 5. The next term is of relative
/// order `ε²`.
#[test]
fn the_first_impact_is_that_of_eq_32_with_15_for_5() {
    for omega in [0.5_f64, 1.0, 2.0, 5.0] {
        for epsilon in pick("distances to the threshold", vec![1e-3, 1e-5], vec![1e-3, 1e-4, 1e-5]) {
            let history = Printed::default().history(&Case::from_epsilon(epsilon, omega, 0.9).unwrap()).unwrap();
            let next = |divisor: f64| -(-1.0 + 32.0 * (omega * omega - 1.0) / (divisor * omega * omega)) / 4.0;
            let error = |divisor: f64| {
                let expansion = 4.0 * (2.0 * epsilon).sqrt() / omega * (1.0 + epsilon * next(divisor));
                (history.impacts[0].time / expansion - 1.0).abs() / (epsilon * epsilon)
            };
            assert!(error(15.0) < 20.0, "omega {omega}, epsilon {epsilon}: {}", error(15.0));
            assert!(omega == 1.0 || error(5.0) > 50.0, "as printed it is wrong in the second term");
            // Eq. 34, the velocity before the impact, is right as printed.
            let bracket = 1.0 - 32.0 * (omega * omega - 1.0) / (15.0 * omega * omega);
            let velocity =
                0.9 * (16.0 / 3.0 * epsilon.powf(1.5) + 4.0 * bracket * epsilon.powf(2.5)) * 2_f64.sqrt() / omega;
            assert!((history.impacts[0].velocity / velocity - 1.0).abs() < 30.0 * epsilon * epsilon);
        }
    }
}

#[test]
fn doubles_are_the_decimals_rounded() {
    let case = case(1.03, 2.0, 0.92);
    let history = Printed::default().history(&case).unwrap();
    let decimals = Printed::default().decimals(&case).unwrap();
    assert_eq!((history.impacts.len(), decimals.len()), (60, 60));
    for (impact, decimal) in history.impacts.iter().zip(&decimals) {
        assert_eq!(impact.time, decimal.time.parse().unwrap());
        assert_eq!(impact.interval, decimal.interval.parse().unwrap());
        assert_eq!(impact.velocity, decimal.velocity.parse().unwrap());
        let claim = impact.uncertainty;
        assert_eq!(
            (claim.time, claim.interval, claim.velocity),
            (f64::EPSILON * impact.time, f64::EPSILON, f64::EPSILON)
        );
    }
}

#[test]
fn it_answers_to_the_name_by_which_it_is_asked() {
    assert_eq!((Printed::default().name(), Printed::default().model()), ("printed", contract::Model::Linear));
}

#[test]
fn every_history_has_the_ending_of_the_contract() {
    let ending = |case: Case| Printed::default().history(&case).map(|history| (history.ending, history.impacts.len()));
    let complete = case(1.03, 2.0, 0.92);
    assert_eq!(ending(complete), Ok((Ending::AtRest, 60)));
    assert_eq!(ending(complete.with_max_impacts(5).unwrap()), Ok((Ending::LimitReached(Limit::Impacts), 5)));
    assert_eq!(ending(case(1.0, 2.0, 0.92)), Ok((Ending::NeverRocks, 0)));
    assert_eq!(ending(case(1.05, 2.0, 0.92)).unwrap().0, Ending::Incomplete);
    assert_eq!(ending(case(3.0, 0.5, 0.92)).unwrap().0, Ending::Overturned);

    let until = |case: Case, time| case.with_horizon(Horizon::Until(time)).unwrap();
    assert_eq!(ending(until(complete, 0.4)), Ok((Ending::LimitReached(Limit::Time), 0)));
    assert_eq!(ending(until(complete, 0.5)), Ok((Ending::LimitReached(Limit::Time), 1)));
    assert_eq!(ending(until(complete, 3.0)), Ok((Ending::AtRest, 60)));
    assert_eq!(ending(until(case(1.05, 2.0, 0.92), 3.0)).unwrap_err().reason(), "unsupported");
    assert_eq!(ending(complete.with_max_impacts(1_000_000).unwrap()).unwrap_err().reason(), "out of range");
    assert_eq!(ending(case(1.03, 1e-9, 0.92)).unwrap_err().reason(), "out of range");
}

#[test]
fn it_answers_or_declines_at_the_corners() {
    let (few, all) = (vec![1e-60, 1.0, 1e9], vec![f64::MIN_POSITIVE, 1e-60, 1e-16, 1.0, 1e9]);
    for epsilon in pick("distances to the threshold", few, all) {
        for omega in [f64::MIN_POSITIVE, 0.01, 1.0, 1e6, 1e300] {
            for eta in [f64::MIN_POSITIVE, 0.5, 1.0 - f64::EPSILON] {
                let case = Case::from_epsilon(epsilon, omega, eta).unwrap().with_max_impacts(6).unwrap();
                if let Ok(history) = Printed::default().history(&case) {
                    assert!(!matches!(history.ending, Ending::Lost(_)), "{case:?}: {}", history.ending);
                }
            }
        }
    }
}
