//! Whole responses on ground that moves in any way, against values that another method found to 24 digits and more, and against laws.

use contract::{Body, Followed, Model, Motion, Ricker, Sinusoid, Stretch};
use enclosure::{EnclosedBout, EnclosedEnd, Enclosure};

const ASKED: Followed = Followed { start: (0.0, 0.0), until: f64::INFINITY, most_impacts: 12 };

fn bouts(digits: u32, eta: f64, motion: &Motion, asked: &Followed) -> Vec<EnclosedBout> {
    let enclosure = Enclosure::new(Model::Linear).with_digits(digits).unwrap();
    enclosure.enclose_on(&Body::new(eta, None).unwrap(), motion, asked).unwrap()
}

fn rest(bout: &EnclosedBout) -> &enclosure::Bounds {
    match &bout.end {
        EnclosedEnd::Rest(time) => time,
        other => panic!("no rest: {other:?}"),
    }
}

#[test]
fn a_sine_pulse_and_what_follows_it() {
    let bouts = bouts(20, 0.6, &Motion::one_sine(1.02, 2.0).unwrap(), &ASKED);
    let [one, two] = bouts.as_slice() else { panic!("{} bouts", bouts.len()) };
    assert_eq!(rest(one).settled(18).unwrap(), "1.15829610235734598");
    assert_eq!(two.begin.settled(18).unwrap(), "2.25701722911294252");
    assert_eq!(rest(two).settled(18).unwrap(), "2.72909242915224260");
    assert_eq!((one.side, two.side), (-1.0, 1.0));
}

/// Released from half of its slenderness on ground that does not move: `u = 1 - cosh(τ)/2`, impacts at `acosh 2` and so on.
#[test]
fn free_rocking() {
    let still = Motion::sinusoids(vec![Stretch { until: 1.0, terms: Vec::new() }]).unwrap();
    let asked = Followed { start: (0.5, 0.0), until: 1e3, ..ASKED };
    let bouts = bouts(18, 0.9, &still, &asked);
    let [bout] = bouts.as_slice() else { panic!("{} bouts", bouts.len()) };
    let times: Vec<f64> = bout.impacts.iter().take(2).map(|impact| impact.time.middle().0).collect();
    assert!((times[0] - 2.0_f64.acosh()).abs() < 1e-15 && (times[1] - 3.404_754_794_04).abs() < 1e-10, "{times:?}");
    assert_eq!(rest(bout).settled(12).unwrap(), "18.5189610108");
}

/// One motion, said in another way: the same response, whatever it is made of.
#[test]
fn a_stretch_in_two_is_the_stretch_and_a_sum_in_another_order_is_the_sum() {
    let terms =
        vec![Sinusoid { amplitude: 1.3, omega: 0.9, phase: 0.4 }, Sinusoid { amplitude: 0.5, omega: 2.6, phase: -1.0 }];
    let whole = Motion::sinusoids(vec![Stretch { until: 6.0, terms: terms.clone() }]).unwrap();
    let other = terms.iter().rev().copied().collect();
    let parts = vec![Stretch { until: 0.7, terms: other }, Stretch { until: 6.0, terms }];
    let [one, two] = [whole, Motion::sinusoids(parts).unwrap()].map(|motion| bouts(17, 0.7, &motion, &ASKED));
    assert!(one.len() == two.len() && !one.is_empty());
    for (one, two) in one.iter().zip(&two) {
        assert!(same(&one.begin, &two.begin) && one.impacts.len() == two.impacts.len());
        assert!(one.impacts.iter().zip(&two.impacts).all(|(one, two)| same(&one.time, &two.time)));
        match (&one.end, &two.end) {
            (EnclosedEnd::Rest(one), EnclosedEnd::Rest(two)) => assert!(same(one, two)),
            (one, two) => assert_eq!(one, two),
        }
    }
}

/// Whether two intervals can contain the same number.
fn same(one: &enclosure::Bounds, two: &enclosure::Bounds) -> bool {
    one.lower() <= two.upper() && two.lower() <= one.upper()
}

/// A triangle of ground acceleration, from 0 to 2 and back: on the way up, `f = t`, the block starts at `t = 1`, and with `s = t - 1` rises as `sinh s - s`; from
/// `t = 2` on it falls by the kink besides.
#[test]
fn a_record_of_three_samples() {
    let record = Motion::record(2.0, 1.0, vec![0.0, 2.0, 0.0]).unwrap();
    let bouts = bouts(17, 0.6, &record, &ASKED);
    let first = &bouts[0];
    assert!(first.begin.contains("1").unwrap() && first.side == -1.0);
    // u = sinh s - s - 2 [sinh(s - 1) - (s - 1)] up to t = 4, and its first root by halving.
    let rotation = |s: f64| s.sinh() - s - 2.0 * ((s - 1.0).sinh() - (s - 1.0)) * f64::from(u8::from(s > 1.0));
    let (mut low, mut high) = (1.5, 3.0);
    assert!(rotation(low) > 0.0);
    if rotation(high) < 0.0 {
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if rotation(middle) > 0.0 { low = middle } else { high = middle }
        }
        assert!((first.impacts[0].time.middle().0 - 1.0 - low).abs() < 1e-13);
    } else {
        assert!(first.impacts.is_empty() || first.impacts[0].time.lower() > 4.0);
    }
}

/// A ground that touches the threshold and turns back pushes nothing: neither at a sample of a record nor at the peak of a sinusoid of amplitude 1. What comes
/// after is not lost. Once the line of `f = 1.3 - 13 s` has ended, the block rocks free.
#[test]
fn what_follows_a_touch_is_not_lost() {
    for (before, starts) in
        [(vec![], "0.076923"), (vec![0.0, 0.5, 1.0, 0.5], "0.576923"), (vec![0.0, 1.0, 1.0, -1.0], "0.576923")]
    {
        let samples = before.into_iter().chain([0.0, 0.0, 1.3, 0.0, 0.0]).collect();
        let bouts = bouts(17, 0.8, &Motion::record(0.1, 1.0, samples).unwrap(), &ASKED);
        let [bout] = bouts.as_slice() else { panic!("{} bouts", bouts.len()) };
        let begins: f64 = starts.parse().unwrap();
        assert!(
            (bout.begin.middle().0 - if begins > 0.5 { begins } else { 0.1 + begins }).abs() < 1e-6,
            "{:?}",
            bout.begin
        );
        let lasts = rest(bout).middle().0 - bout.begin.middle().0;
        assert!((lasts - 0.274_666).abs() < 1e-6, "{lasts}");
    }
    let touching = Stretch { until: 4.0, terms: vec![Sinusoid { amplitude: 1.0, omega: 2.0, phase: 0.3 }] };
    let beyond = Stretch { until: 7.0, terms: vec![Sinusoid { amplitude: 1.2, omega: 2.0, phase: 0.0 }] };
    let bouts = bouts(17, 0.6, &Motion::sinusoids(vec![touching, beyond]).unwrap(), &ASKED);
    assert!(bouts[0].begin.lower() >= 4.0 && matches!(bouts[0].end, EnclosedEnd::Rest(_)), "{bouts:?}");
}

/// `9/8 cos 2t - 1/8 cos 4t` is 1 at its peak at `t = pi`, but for the rounding of the phases: nobody knows whether the block rocks there, and nothing is said
/// of it, nor of what follows.
#[test]
fn a_touch_that_is_not_decided_is_told() {
    let wave = |amplitude, omega| Sinusoid { amplitude, omega, phase: core::f64::consts::FRAC_PI_2 };
    let motion = |first| {
        let first = Stretch { until: 2.5, terms: vec![Sinusoid { amplitude: first, omega: 3.0, phase: 0.0 }] };
        let touching = Stretch { until: 4.0, terms: vec![wave(1.125, 2.0), wave(-0.125, 4.0)] };
        let beyond = Stretch { until: 7.0, terms: vec![wave(1.2, 2.0)] };
        Motion::sinusoids(vec![first, touching, beyond]).unwrap()
    };
    let enclosure = Enclosure::new(Model::Linear).with_digits(17).unwrap();
    let ask = |first| enclosure.enclose_on(&Body::new(0.6, None).unwrap(), &motion(first), &ASKED);
    assert!(ask(0.5).unwrap_err().to_string().contains("not decided whether the block rocks"));
    let known = ask(1.05).unwrap();
    assert!(known.last().unwrap().begin.lower() < 2.5);
    assert_eq!(known.last().map(|bout| &bout.end), Some(&EnclosedEnd::Undecided));
}

/// The wavelets against their formulas: where they start to push, and that a mirror image is one.
#[test]
fn wavelets_push_where_their_formula_passes_the_threshold() {
    for antisymmetric in [false, true] {
        let of = |amplitude| Ricker { amplitude, omega: 3.0, center: 2.0, antisymmetric };
        let [one, other] = [1.4, -1.4].map(|amplitude| bouts(17, 0.6, &Motion::ricker(of(amplitude)).unwrap(), &ASKED));
        assert!(!one.is_empty() && one.len() == other.len());
        for (one, other) in one.iter().zip(&other) {
            assert!(same(&one.begin, &other.begin) && one.side == -other.side);
        }
        let begin = one[0].begin.middle().0;
        let f = |time: f64| {
            if antisymmetric {
                let y = 3.0 * (time - 2.0) / 3.0_f64.sqrt();
                1.4 / 1.3801 * (y.powi(3) - 3.0 * y) * (-0.5 * y * y).exp()
            } else {
                let y = 3.0 * (time - 2.0) / 2.0_f64.sqrt();
                1.4 * (1.0 - y * y) * (-0.5 * y * y).exp()
            }
        };
        assert!((f(begin).abs() - 1.0).abs() < 1e-13, "{begin}: {}", f(begin));
        assert!((0..1000).all(|k| f(begin * f64::from(k) / 1000.0).abs() < 1.0));
    }
}

/// Fewer digits enclose more.
#[test]
fn bounds_with_fewer_digits_contain_those_with_more() {
    let samples = (0..60).map(|k| 1.6 * (0.35 * f64::from(k)).sin() * (1.0 + 0.3 * f64::from(k % 3))).collect();
    let motions = [
        Motion::record(0.11, 1.0, samples).unwrap(),
        Motion::ricker(Ricker { amplitude: 1.3, omega: 2.0, center: 3.0, antisymmetric: true }).unwrap(),
        Motion::mavroeidis_papageorgiou(1.2, 2.0, 1.5, 0.3).unwrap(),
    ];
    for motion in motions {
        for model in [Model::Linear, Model::Nonlinear] {
            let body = Body::new(0.6, Some(0.3)).unwrap();
            let of =
                |digits: u32| Enclosure::new(model).with_digits(digits).unwrap().enclose_on(&body, &motion, &ASKED);
            let (coarse, fine) = (of(9).unwrap(), of(25).unwrap());
            assert!(!fine.is_empty() && coarse.len() == fine.len());
            for (coarse, fine) in coarse.iter().zip(&fine) {
                assert!(coarse.begin.contain(&fine.begin));
                for (coarse, fine) in coarse.impacts.iter().zip(&fine.impacts) {
                    assert!(coarse.time.contain(&fine.time) && coarse.velocity.contain(&fine.velocity));
                }
                match (&coarse.end, &fine.end) {
                    (EnclosedEnd::Rest(coarse), EnclosedEnd::Rest(fine)) => assert!(coarse.contain(fine)),
                    (coarse, fine) => assert_eq!(coarse, fine),
                }
            }
        }
    }
}
