use super::*;

/// Every motion, by name.
fn motions() -> Vec<(&'static str, Motion)> {
    let ricker = |antisymmetric| Ricker { amplitude: 1.2, omega: 3.0, center: 2.5, antisymmetric };
    vec![
        ("one-sine", Motion::one_sine(1.3, 2.0).unwrap()),
        ("one-cosine", Motion::one_cosine(1.3, 2.0).unwrap()),
        ("ricker", Motion::ricker(ricker(false)).unwrap()),
        ("ricker-antisymmetric", Motion::ricker(ricker(true)).unwrap()),
        ("mavroeidis-papageorgiou", Motion::mavroeidis_papageorgiou(1.4, 3.0, 1.5, 0.3).unwrap()),
        ("mavroeidis-papageorgiou, one cycle", Motion::mavroeidis_papageorgiou(1.4, 3.0, 0.8, -1.1).unwrap()),
        ("record", Motion::record(0.1, 1.0, (0..80).map(|k| 1.3 * (f64::from(k) * 0.37).sin()).collect()).unwrap()),
    ]
}

/// The formulas as they are written.
#[test]
fn pulses_are_their_formulas() {
    let (a, omega, gamma, nu) = (1.4, 3.0, 1.5, 0.3);
    let motion = Motion::mavroeidis_papageorgiou(a, omega, gamma, nu).unwrap();
    let end = 2.0 * std::f64::consts::PI * gamma / omega;
    assert!((motion.duration() - end).abs() < 1e-14);
    for k in 0..100 {
        let tau = end * f64::from(k) / 100.0;
        let x = tau - std::f64::consts::PI * gamma / omega;
        let b = omega * x + nu;
        let expected = -a / (2.0 * gamma)
            * ((omega * x / gamma).sin() * b.cos() + gamma * b.sin() * (1.0 + (omega * x / gamma).cos()));
        assert!((acceleration(&motion, tau) - expected).abs() < 1e-13, "{tau}");
    }
    let wavelet =
        |antisymmetric| Motion::ricker(Ricker { amplitude: 1.2, omega: 3.0, center: 2.5, antisymmetric }).unwrap();
    for tau in [0.0_f64, 0.4, 2.0, 2.5, 3.1, 4.9] {
        let y = 3.0 * (tau - 2.5) / 2.0_f64.sqrt();
        assert!((acceleration(&wavelet(false), tau) - 1.2 * (1.0 - y * y) * (-y * y / 2.0).exp()).abs() < 1e-14);
        let y = 3.0 * (tau - 2.5) / 3.0_f64.sqrt();
        let expected = 1.2 / 1.3801 * (y * y * y - 3.0 * y) * (-y * y / 2.0).exp();
        assert!((acceleration(&wavelet(true), tau) - expected).abs() < 1e-14);
    }
    assert_eq!(acceleration(&Motion::one_cosine(1.3, 2.0).unwrap(), 0.0), 1.3);
    for (name, motion) in motions() {
        assert_eq!(
            (acceleration(&motion, -1e-9), acceleration(&motion, motion.duration() + 1e-9)),
            (0.0, 0.0),
            "{name}"
        );
    }
}

/// Between one push and the next look nothing exceeds the threshold, and just after it something does.
#[test]
fn the_next_push_is_where_the_threshold_is_first_passed() {
    for (name, motion) in motions() {
        let mut from = 0.0;
        let mut pushes = 0;
        while let Some(Push { time, side }) = next_push(&motion, from) {
            assert!(time >= from);
            // Nothing is in between where it begins with a jump.
            for k in (1..50).filter(|_| time > from) {
                let tau = from + (time - from) * f64::from(k) / 50.0;
                assert!(acceleration(&motion, tau).abs() <= 1.0 + 1e-12, "{name} {tau} before {time}");
            }
            let after = -side * acceleration(&motion, time + 1e-6);
            assert!(after > 1.0, "{name} {time}: {after}");
            pushes += 1;
            // Out of this lobe.
            from = time + 1e-3;
            while acceleration(&motion, from).abs() > 1.0 {
                from += 1e-3;
            }
        }
        assert!(pushes >= 1, "{name}");
    }
    // One that only just reaches it, or nearly does.
    let sine = |a: f64| Motion::one_sine(a, 2.0).unwrap();
    assert_eq!(next_push(&sine(1.0), 0.0), None);
    assert_eq!(next_push(&sine(0.999_999), 0.0), None);
    let push = next_push(&sine(1.0 + 1e-9), 0.0).unwrap();
    assert!((push.time - (1.0_f64 / (1.0 + 1e-9)).asin() / 2.0).abs() < 1e-9 && push.side == -1.0);
}

/// A sine that has passed the threshold comes back to it after `(π - 2 asin(1/a))/ω`; a motion that stays above it has no gap before it ends.
#[test]
fn the_next_gap_is_where_the_ground_holds_the_block_again() {
    let (a, omega) = (1.3, 2.0);
    let motion = Motion::one_sine(a, omega).unwrap();
    let push = next_push(&motion, 0.0).unwrap().time;
    let expected = (std::f64::consts::PI - (1.0_f64 / a).asin()) / omega;
    assert!((next_gap(&motion, push, 10.0).unwrap() - expected).abs() < 1e-14);
    assert_eq!(next_gap(&motion, push, 0.5 * (push + expected)), None);
    let constant = |until: f64| {
        let terms = vec![Sinusoid { amplitude: 2.0, omega: 0.0, phase: std::f64::consts::FRAC_PI_2 }];
        Motion::sinusoids(vec![Stretch { until, terms }]).unwrap()
    };
    assert_eq!(next_gap(&constant(3.0), 0.0, 10.0), Some(3.0));
    assert_eq!(next_gap(&constant(f64::INFINITY), 0.0, 10.0), None);
}
