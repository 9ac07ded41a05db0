//! What a case may hold, to the last bit of each border, and that it holds what it was given.

use contract::{Case, Decline, History, Horizon, Invalid, Model, Normalisation, Oracle, Sensitivity, Slenderness};

/// The field that is refused, if one is.
fn refused<T>(result: Result<T, Invalid>) -> Option<&'static str> {
    result.err().map(|invalid| invalid.field)
}

#[test]
fn the_borders_of_each_parameter() {
    let least = f64::from_bits(1);
    for (epsilon, allowed) in
        [(-1.0, true), (0.0, true), (1e9, true), (-1.000_000_1, false), (1.000_000_1e9, false), (f64::NAN, false)]
    {
        assert_eq!(refused(Case::from_epsilon(epsilon, 1.0, 0.5)), (!allowed).then_some("epsilon"), "{epsilon}");
    }
    for (a, allowed) in [(0.0, true), (1.5, true), (1e9, true), (-1e-9, false), (1.1e9, false), (f64::NAN, false)] {
        assert_eq!(refused(Case::from_amplitude(a, 1.0, 0.5)), (!allowed).then_some("a"), "{a}");
    }
    for (omega, allowed) in
        [(least, true), (f64::MAX, true), (0.0, false), (-1.0, false), (f64::INFINITY, false), (f64::NAN, false)]
    {
        assert_eq!(refused(Case::from_epsilon(0.5, omega, 0.5)), (!allowed).then_some("omega"), "{omega}");
    }
    for (eta, allowed) in [
        (least, true),
        (1.0 - f64::EPSILON, true),
        (0.0, false),
        (1.0, false),
        (-0.5, false),
        (1.5, false),
        (f64::NAN, false),
    ] {
        assert_eq!(refused(Case::from_epsilon(0.5, 1.0, eta)), (!allowed).then_some("eta"), "{eta}");
    }
    let quarter = core::f64::consts::FRAC_PI_2;
    for (alpha, allowed) in [
        (1e-100, true),
        (0.99e-100, false),
        (least, false),
        (1.57, true),
        (0.0, false),
        (quarter, false),
        (-0.1, false),
        (2.0, false),
        (f64::NAN, false),
    ] {
        assert_eq!(refused(Slenderness::new(alpha, Normalisation::Slender)), (!allowed).then_some("alpha"), "{alpha}");
    }
    let case = Case::from_epsilon(0.5, 1.0, 0.5).unwrap();
    for (impacts, allowed) in [(1, true), (1_000_000, true), (0, false), (1_000_001, false)] {
        assert_eq!(refused(case.with_max_impacts(impacts)), (!allowed).then_some("impacts"), "{impacts}");
    }
    for (time, allowed) in
        [(least, true), (3.0, true), (0.0, false), (-1.0, false), (f64::INFINITY, false), (f64::NAN, false)]
    {
        assert_eq!(refused(case.with_horizon(Horizon::Until(time))), (!allowed).then_some("until"), "{time}");
    }
}

#[test]
fn a_case_holds_what_it_was_given() {
    let case = Case::from_epsilon(0.25, 2.0, 0.5).unwrap();
    assert_eq!((case.epsilon(), case.amplitude(), case.omega(), case.eta()), (0.25, 1.25, 2.0, 0.5));
    assert_eq!((case.slenderness(), case.max_impacts(), case.horizon()), (None, 60, Horizon::HalfPeriod));
    let slenderness = Slenderness::new(0.25, Normalisation::Slender).unwrap();
    assert_eq!((slenderness.alpha(), slenderness.normalisation()), (0.25, Normalisation::Slender));
    let other = Slenderness::new(0.25, Normalisation::Threshold).unwrap();
    assert_eq!(other.normalisation(), Normalisation::Threshold);
    let full =
        case.with_slenderness(slenderness).with_max_impacts(7).unwrap().with_horizon(Horizon::Until(3.0)).unwrap();
    assert_eq!((full.slenderness(), full.max_impacts(), full.horizon()), (Some(slenderness), 7, Horizon::Until(3.0)));
    assert_eq!((full.epsilon(), full.omega(), full.eta()), (0.25, 2.0, 0.5));
    // `a - 1` loses nothing; by `ε` the digits below those of `a` are kept as well.
    assert_eq!(Case::from_amplitude(1.25, 2.0, 0.5), Ok(case));
    assert_eq!(Case::from_amplitude(1.0 + f64::EPSILON, 2.0, 0.5).unwrap().epsilon(), f64::EPSILON);
    assert_eq!(Case::from_epsilon(1e-30, 2.0, 0.5).unwrap().epsilon(), 1e-30);
}

/// A refusal names the field, the value and what is allowed, in the words of the user.
#[test]
fn refusals_are_told_in_words() {
    let refusal = Case::from_epsilon(0.5, -2.0, 0.5).unwrap_err();
    assert_eq!(refusal.to_string(), "omega = -2.0 is outside the allowed range: omega > 0 and finite");
    let out = Decline::OutOfRange { field: "eta", value: 0.5, allowed: "eta > 1" };
    assert_eq!(out.to_string(), "eta = 0.5 is outside what this method can do: eta > 1");
    let reasons = [
        Decline::NeedsSlenderness,
        out,
        Decline::NotConvergent { why: String::from("1 > 0") },
        Decline::Unsupported { what: "this" },
        Decline::ByEngine { reason: String::from("too slender"), why: String::from("alpha = 0.001") },
        Decline::NoAnswer {
            breakdown: "timed out",
            happened: String::from("10 s"),
            advice: String::from("Wait longer."),
        },
    ];
    let told = reasons.each_ref().map(Decline::reason);
    assert_eq!(
        told,
        ["needs a slenderness", "out of range", "not convergent", "unsupported", "too slender", "timed out"]
    );
    assert_eq!(reasons.each_ref().map(Decline::is_breakdown), [false, false, false, false, false, true]);
    let [.., refused, broke] = reasons;
    assert_eq!(refused.to_string(), "too slender: alpha = 0.001");
    assert_eq!(broke.to_string(), "timed out: 10 s. Wait longer.");
}

/// An oracle that says nothing of derivatives has none.
#[test]
fn derivatives_are_not_made_up() {
    struct Silent;
    impl Oracle for Silent {
        fn name(&self) -> &str {
            "silent"
        }
        fn model(&self) -> Model {
            Model::Linear
        }
        fn history(&self, _: &Case) -> Result<History, Decline> {
            Err(Decline::Unsupported { what: "anything" })
        }
    }
    let none: Option<Vec<Sensitivity>> = None;
    assert_eq!(Silent.sensitivities(&Case::from_epsilon(0.25, 2.0, 0.5).unwrap()), none);
}
