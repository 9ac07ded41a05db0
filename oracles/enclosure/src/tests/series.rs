//! The functions, against decimals made with mpmath, and against more digits.

use proptest::prelude::*;

use crate::{
    bounds::Bounds,
    digits::Digits,
    directed::Directed,
    functions::{pi, pi_to, sin_cos, sin_cos_to},
    interval::Interval,
    twofold::Twofold,
};

/// Sines and cosines to 50 digits.
const VALUES: [(f64, &str, &str); 7] = [
    (
        0.0009765625,
        "0.00097656234477957829890691016811978636680241804620826",
        "0.99999952316287969248636920294988906921551023520824",
    ),
    (
        0.75,
        "0.68163876002333416673324195277989393533838239465923",
        "0.73168886887382088631183875300008454384054127605077",
    ),
    (
        1.0,
        "0.84147098480789650665250232163029899962256306079837",
        "0.54030230586813971740093660744297660373231042061792",
    ),
    (
        3.0,
        "0.14112000805986722210074480280811027984693326425227",
        "-0.98999249660044545727157279473126130239367909661559",
    ),
    (
        10.5,
        "-0.87969575997167009801850868482599603469478050629749",
        "-0.47553692799599253552381149014885872607871774159348",
    ),
    (
        -2.25,
        "-0.77807319688792124141096667558775732080446074291022",
        "-0.62817362272273908891338905739640330678881528119223",
    ),
    (
        40.0,
        "0.74511316047934878698770940263634434223949904003021",
        "-0.66693806165226184438409278193369998785925478785487",
    ),
];

const PI: &str = "3.14159265358979323846264338327950288419716939937510582097494";

fn bounds<F: Directed>(interval: &Interval<F>) -> Bounds {
    Bounds::new(interval).unwrap()
}

#[test]
fn known_values_are_inside() {
    fn check<F: Directed>() {
        assert_eq!(bounds(&pi::<F>()).contains(PI), Some(true));
        for (x, sine, cosine) in VALUES {
            let (s, c) = sin_cos(&Interval::<F>::exactly(x));
            assert_eq!((bounds(&s).contains(sine), bounds(&c).contains(cosine)), (Some(true), Some(true)), "{x}");
            assert!(s.width() < (2.0_f64).powi(16 - F::BITS as i32));
        }
    }
    check::<f64>();
    check::<Twofold>();
    check::<Digits<128>>();
}

/// With digits to spare only the bound on what a short series leaves out keeps the value inside.
#[test]
fn what_a_series_leaves_out_is_bounded() {
    for bits in [4, 10, 20, 40] {
        for (x, sine, cosine) in VALUES {
            let (s, c) = sin_cos_to(&Interval::<Digits<256>>::exactly(x), bits);
            assert_eq!(
                (bounds(&s).contains(sine), bounds(&c).contains(cosine)),
                (Some(true), Some(true)),
                "{x}, {bits}"
            );
        }
        let pi = pi_to::<Digits<256>>(bits);
        assert_eq!(bounds(&pi).contains(PI), Some(true), "{bits}");
        assert!(pi.width() < 64.0 * (2.0_f64).powi(-bits) && pi.width() > 0.0);
    }
}

#[test]
fn more_digits_are_inside_fewer() {
    fn nested<F: Directed, G: Directed>(x: f64) {
        let (coarse, fine) = (sin_cos(&Interval::<F>::exactly(x)), sin_cos(&Interval::<G>::exactly(x)));
        assert!(bounds(&coarse.0).contain(&bounds(&fine.0)) && bounds(&coarse.1).contain(&bounds(&fine.1)), "{x}");
        assert!(bounds(&pi::<F>()).contain(&bounds(&pi::<G>())));
    }
    for x in [1e-200, -1e-20, 0.3, 0.5, 0.7, 2.0, -9.0, 1e3] {
        nested::<f64, Twofold>(x);
        nested::<Twofold, Digits<128>>(x);
        nested::<Digits<128>, Digits<256>>(x);
        nested::<Digits<256>, Digits<768>>(x);
    }
}

proptest! {
    #[test]
    fn interior_arguments_stay_inside(centre in -20.0..20.0_f64, half in 0.0..1.0_f64, t in -1.0..1.0_f64) {
        let (low, high) = (centre - half, centre + half);
        let x = (centre + t * half).clamp(low, high);
        let (s, c) = sin_cos(&Interval::<f64>::between(low, high));
        let (fine_s, fine_c) = sin_cos(&Interval::<Digits<128>>::exactly(x));
        prop_assert!(bounds(&s).contain(&bounds(&fine_s)) && bounds(&c).contain(&bounds(&fine_c)));
    }
}
