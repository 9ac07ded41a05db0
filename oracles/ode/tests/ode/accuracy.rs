//! How right the impacts are, and how honest the claims.

use crate::common::{Random, case, impacts, linear};
use contract::{Case, Ending, History, Normalisation, Oracle, Slenderness};
use ode::{Equation, Ode, Solver};

/// Some impacts of a case in the linear model: number, time, interval, speed after it. From Eq. 6 in local time, with 100 digits.
struct Truth {
    case: (f64, f64, f64),
    impacts: &'static [(usize, f64, f64, f64)],
}

const TRUTHS: [Truth; 6] = [
    Truth {
        case: (0.00010093659098697749, 2.7260778178769463, 0.6627463263553325),
        impacts: &[
            (1, 0.020847394416732556, 0.020847394416732556, 1.85937904726956e-06),
            (2, 0.020849254546800512, 1.860130067955137e-06, 1.2322965884768695e-06),
            (3, 0.023539022973150883, 0.002689768426350369, 9.175299582130441e-07),
            (10, 0.025165309245000943, 8.27094988902332e-08, 5.4777641847541164e-08),
            (30, 0.025306372091072973, 2.2217381538729707e-11, 1.4714186464131975e-11),
            (60, 0.025306409613502154, 9.707632486518675e-17, 6.429196612684063e-17),
        ],
    },
    Truth {
        case: (0.00046137624882547357, 5.4121051146069785, 0.7676516631604975),
        impacts: &[
            (1, 0.022448290391323206, 0.022448290391323206, 1.0598275343937213e-05),
            (2, 0.02245890826181125, 1.061787048804598e-05, 8.135776585372247e-06),
            (3, 0.026204560708561576, 0.003745652446750324, 7.228457035821359e-06),
            (10, 0.029560259654035324, 1.6525013420638524e-06, 1.2635156079488436e-06),
            (30, 0.030317699435683756, 8.531438626551065e-09, 6.521441162209745e-09),
            (60, 0.030321459779753875, 3.0619279148546036e-12, 2.340537906369458e-12),
        ],
    },
    Truth {
        case: (0.0017348572312703148, 4.393725850020597, 0.9136737312224752),
        impacts: &[
            (1, 0.05360205291394768, 0.05360205291394768, 0.00011318524367336706),
            (2, 0.05371602937082234, 0.00011397645687465751, 0.00010341285169173029),
            (3, 0.0656944260875921, 0.011978396716769767, 0.00011391612765833499),
            (10, 0.08323327911378482, 8.253860745143512e-05, 7.371589500410336e-05),
            (30, 0.09801495502572516, 1.558307178950625e-05, 1.3763036369773892e-05),
            (60, 0.10037695605864438, 1.0594060660225717e-06, 9.338161633472695e-07),
        ],
    },
    Truth {
        case: (0.008005937376166283, 5.630192503745601, 0.6338695457608847),
        impacts: &[
            (1, 0.08970878940179429, 0.08970878940179429, 0.0006044151600112435),
            (2, 0.09033316912637838, 0.000624379724584088, 0.00038303350841224505),
            (3, 0.10089136821698151, 0.010558199090603128, 0.00026956720148120375),
            (10, 0.10702465003736747, 1.937334266524597e-05, 1.1640124228119286e-05),
            (30, 0.10740973875469934, 2.131938851426177e-09, 1.2802470513901466e-09),
            (60, 0.10740978084949253, 2.4477751072016424e-15, 1.4699092688881155e-15),
        ],
    },
    Truth {
        case: (0.028049679982082854, 0.6420521291038696, 0.8190044778258538),
        impacts: &[
            (1, 1.521627259490893, 1.521627259490893, 0.04936022020400036),
            (2, 1.578094820047035, 0.05646756055614184, 0.04022814022438143),
            (3, 1.8388113610210308, 0.26071654097399577, 0.037590864174410196),
            (10, 2.2318434095527655, 0.01793736574678958, 0.01011667609952616),
            (30, 2.3616604512405472, 0.00036054041949418246, 0.00019085554916529904),
            (60, 2.364027449794516, 9.041296170932484e-07, 4.780270028662415e-07),
        ],
    },
    Truth {
        case: (0.03463602393539711, 3.138647730819082, 0.7723552840395433),
        impacts: &[
            (1, 0.3328273084285162, 0.3328273084285162, 0.011684270946315167),
            (2, 0.34640375237046095, 0.013576443941944717, 0.00896879412856063),
            (3, 0.3986784676978852, 0.05227471532742427, 0.007828152612526399),
            (10, 0.4677252350147837, 0.0025955460722401893, 0.0013724862196560967),
            (30, 0.4820817792290596, 1.5536715083547624e-05, 7.936221063701006e-06),
            (60, 0.4821627956192002, 6.6987028691985706e-09, 3.421038336220338e-09),
        ],
    },
];

/// The sum of the intervals and, for the rest, the last two continued with the ratio `eta^2` (Eq. 75).
fn chattering_time(history: &History, eta: f64) -> f64 {
    let intervals: Vec<f64> = history.impacts.iter().map(|impact| impact.interval).collect();
    let [.., before, last] = intervals[..] else { panic!("too few impacts") };
    let eta2 = eta * eta;
    history.impacts.last().map_or(0.0, |impact| impact.time) + (before + last) * eta2 / (1.0 - eta2)
}

fn canonical(n: usize) -> Case {
    case(1.03, 2.0, 0.92).with_max_impacts(n).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn every_method_claims_no_less_than_its_error() {
    for method in Solver::ALL {
        let ode = linear(method);
        for truth in &TRUTHS {
            let (epsilon, omega, eta) = truth.case;
            let history = ode.history(&Case::from_epsilon(epsilon, omega, eta).unwrap()).unwrap();
            for &(n, time, interval, speed) in truth.impacts {
                let impact = history.impacts[n - 1];
                let claim = impact.uncertainty;
                let context = format!("{method} impact {n} of {:?}: {impact:?}", truth.case);
                assert!((impact.time - time).abs() <= claim.time, "{context}");
                assert!((impact.interval / interval - 1.0).abs() <= claim.interval, "{context}");
                assert!((impact.velocity.abs() / speed - 1.0).abs() <= claim.velocity, "{context}");
                assert!(claim.interval < 0.1, "a claim of everything claims nothing: {context}");
            }
        }
    }
}

#[test]
fn tsit45_is_accurate_to_ten_digits() {
    for truth in &TRUTHS {
        let (epsilon, omega, eta) = truth.case;
        let history = impacts(&linear(Solver::Tsit45), &Case::from_epsilon(epsilon, omega, eta).unwrap());
        for &(n, time, interval, speed) in truth.impacts {
            let impact = history.impacts[n - 1];
            assert!((impact.time / time - 1.0).abs() < 1e-10, "{n} {impact:?}");
            assert!((impact.interval / interval - 1.0).abs() < 1e-10, "{n} {impact:?}");
            assert!((impact.velocity.abs() / speed - 1.0).abs() < 1e-10, "{n} {impact:?}");
        }
    }
}

#[test]
fn claims_follow_from_the_difference_to_a_finer_run() {
    let mut random = Random(20);
    for n in 0..60 {
        let block = Slenderness::new(random.between(0.01, 0.8), Normalisation::Threshold).unwrap();
        let case = random.case().with_slenderness(block);
        let equation = [Equation::Linear, Equation::Nonlinear][n % 2];
        let truth = impacts(&Ode::new(equation, Solver::Tsit45).with_rtol(1e-13).unwrap(), &case);
        for method in Solver::ALL {
            let history = Ode::new(equation, method).history(&case).unwrap();
            for (found, truth) in history.impacts.iter().zip(&truth.impacts) {
                let slack = 1e-10;
                assert!((found.time - truth.time).abs() <= found.uncertainty.time + slack, "{method} {case:?}");
                let interval = (found.interval / truth.interval - 1.0).abs();
                assert!(interval <= found.uncertainty.interval + slack, "{method} {case:?} {found:?} {truth:?}");
                let velocity = (found.velocity / truth.velocity - 1.0).abs();
                assert!(velocity <= found.uncertainty.velocity + slack, "{method} {case:?} {found:?} {truth:?}");
            }
        }
    }
}

#[test]
fn chattering_time_of_the_linear_block() {
    for (method, tolerance) in
        [(Solver::Tsit45, 2e-12), (Solver::Esdirk34, 5e-8), (Solver::Bdf, 1e-7), (Solver::TrBdf2, 1e-5)]
    {
        let history = impacts(&linear(method), &canonical(400));
        assert_eq!(history.ending, Ending::AtRest);
        let relative = chattering_time(&history, 0.92) / 1.125_947_676_933_812 - 1.0;
        assert!(relative.abs() < tolerance, "{method}: {relative:e}");
    }
}

#[test]
fn chattering_time_of_the_block_as_it_is() {
    let of = |normalisation| {
        let case = canonical(400).with_slenderness(Slenderness::new(0.2, normalisation).unwrap());
        let times = Solver::ALL.map(|method| {
            let history = impacts(&Ode::new(Equation::Nonlinear, method), &case);
            assert_eq!(history.ending, Ending::AtRest);
            chattering_time(&history, 0.92)
        });
        assert!(times.iter().all(|time| (time / times[0] - 1.0).abs() < 1e-5), "{times:?}");
        times[0] / 1.125_947_676_933_812 - 1.0
    };
    let threshold = of(Normalisation::Threshold);
    assert!((threshold.abs() - 1.2e-4).abs() < 0.1e-4, "{threshold:e}");
    let slender = of(Normalisation::Slender);
    assert!((slender + 0.34).abs() < 0.01, "{slender}");
}

#[test]
fn resolves_every_impact_to_intervals_of_1e_20_and_far_below() {
    let history = impacts(&linear(Solver::Tsit45), &canonical(3000));
    let intervals: Vec<f64> = history.impacts.iter().map(|impact| impact.interval).collect();
    assert_eq!(history.ending, Ending::AtRest);
    assert!(intervals.last().is_some_and(|&last| last < 1e-100), "{:?}", intervals.last());
    for pair in intervals.windows(3).skip(300) {
        assert!((pair[2] / pair[0] / (0.92 * 0.92) - 1.0).abs() < 1e-10, "{pair:?}");
    }
    for method in [Solver::Bdf, Solver::TrBdf2, Solver::Esdirk34] {
        let history = impacts(&linear(method), &canonical(540));
        for (coarse, fine) in history.impacts.iter().zip(&intervals) {
            assert!((coarse.interval / fine - 1.0).abs() < 1e-4, "{method} {coarse:?} {fine}");
        }
        assert!(history.impacts.last().is_some_and(|last| last.interval < 1e-20));
    }
}
