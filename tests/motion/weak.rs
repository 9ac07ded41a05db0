//! The law of weak excitation against what stepping finds: on pulses, sums of sinusoids, wavelets and records whose highest peak is just above the threshold.

use asymptotic::{Asymptotic, Order};
use chattercheck::{
    cases::generate,
    motion::response::{BoutEnd as Stepped, Response},
    panel,
};
use contract::{Body, Bout, BoutEnd, Decline, Followed, Motion, Oracle, Ricker, Sinusoid, Stretch};

use crate::{closing::request, effort::pick};

fn weak(order: usize) -> Asymptotic {
    Asymptotic::new().with_order(Order::Terms(order)).unwrap()
}

const FROM_REST: Followed = Followed { start: (0.0, 0.0), until: f64::INFINITY, most_impacts: 1 };

fn stepped(motion: &Motion, eta: f64) -> Response {
    let request = request(motion.clone(), eta);
    Response::on_motion(panel::stepper_on(&request.body, motion).as_ref(), &request).unwrap()
}

/// `f`, by its definition.
fn at(motion: &Motion, time: f64) -> f64 {
    match motion {
        Motion::Sinusoids(of) => of.iter().find(|one| time < one.until).map_or(0.0, |one| {
            one.terms.iter().map(|term| term.amplitude * (term.omega * time + term.phase).sin()).sum()
        }),
        Motion::Ricker(Ricker { amplitude, omega, center, antisymmetric }) => {
            let y = omega * (time - center) / if *antisymmetric { 3.0_f64 } else { 2.0 }.sqrt();
            let shape = if *antisymmetric { (y.powi(3) - 3.0 * y) / 1.3801 } else { 1.0 - y * y };
            amplitude * shape * (-0.5 * y * y).exp()
        }
        Motion::Record(of) => {
            let k = (time / of.dt) as usize;
            let sample = |k: usize| of.samples.get(k).map_or(0.0, |sample| of.scale * sample);
            sample(k) + (sample(k + 1) - sample(k)) * (time / of.dt - k as f64)
        }
    }
}

/// Random motions, each as strong as makes its highest peak `1 + ε`, and restitutions from 0.3 to 0.97.
fn just_above(seed: u64, count: usize) -> Vec<(Motion, f64, f64)> {
    let scaled = |(n, asked): (usize, chattercheck::cases::shaking::AnyMotion)| {
        const LOOKS: u32 = 40_000;
        let motion = asked.motion.as_ref();
        let most = match motion {
            Motion::Record(of) => of.samples.iter().map(|sample| (of.scale * sample).abs()).fold(0.0, f64::max),
            _ => (0..LOOKS)
                .map(|k| at(motion, motion.duration() * f64::from(k) / f64::from(LOOKS)).abs())
                .fold(0.0, f64::max),
        };
        let share = |step: f64| (n as f64 * step).fract();
        let epsilon = 10_f64.powf(-0.5 - 6.0 * share(0.618_033_988_749_895));
        (motion.scaled((1.0 + epsilon) / most).unwrap(), 0.3 + 0.67 * share(0.414_213_562_373_095), epsilon)
    };
    generate::motions(seed, count).into_iter().enumerate().map(scaled).collect()
}

/// What is known of a motion's bouts, held against stepping: the largest share of a claim that an error uses, and how many were answered.
fn largest_share(oracle: &Asymptotic, (motion, eta): (&Motion, f64)) -> (f64, usize) {
    let (mut share, mut answered) = (0.0_f64, 0);
    let Ok(bouts) = oracle.bouts_on(&Body::new(eta, None).unwrap(), motion, &FROM_REST) else {
        return (share, answered);
    };
    let response = stepped(motion, eta);
    for (place, bout) in bouts.iter().enumerate() {
        let truth = response.bouts.get(place).unwrap_or_else(|| panic!("no bout {place}: {motion:?}"));
        let begin = (bout.begin.value - truth.begin()).abs();
        assert!(begin <= 2.0 * bout.begin.uncertainty + 1e-15, "{begin:e} {bout:?}: {motion:?}");
        assert_eq!(bout.side, truth.lobe.mirror * truth.flights[0].departure.side, "{motion:?}");
        let BoutEnd::Rest(rest) = bout.end else { continue };
        let Stepped::Complete { uncertainty } = truth.outcome else { panic!("{}: {motion:?}", truth.outcome.name()) };
        share = share.max(((rest.value - truth.end()).abs() - uncertainty) / rest.uncertainty);
        answered += 1;
    }
    (share, answered)
}

/// No error is larger than what is claimed, and the claims are not far above them. The numbers in `oracles/asymptotic/src/weak/sum.rs` are from here.
#[test]
fn claims_hold_on_random_motions() {
    let all = just_above(7, pick("weak", 400, 5000));
    for order in [1, 2, 3, 4, 8] {
        let shares: Vec<_> = all.iter().map(|(motion, eta, _)| largest_share(&weak(order), (motion, *eta))).collect();
        let worst = shares.iter().fold(0.0_f64, |worst, (share, _)| worst.max(*share));
        let answered: usize = shares.iter().map(|(_, answered)| answered).sum();
        println!("order {order}: {answered} bouts, {worst:.3} of the claim");
        assert!(worst < 0.8 && worst > 0.2, "order {order}: {worst} of the claim");
        let of_kind = |is: fn(&Motion) -> bool| {
            all.iter().zip(&shares).filter(|((motion, ..), (_, answered))| is(motion) && *answered > 0).count()
        };
        assert!(of_kind(|motion| matches!(motion, Motion::Sinusoids(_))) > all.len() / 4, "order {order}");
        assert!(of_kind(|motion| matches!(motion, Motion::Ricker(_))) > all.len() / 20, "order {order}");
        assert!(of_kind(|motion| matches!(motion, Motion::Record(_))) > all.len() / 5, "order {order}");
    }
}

/// The first chattering time to an order, and the error relative to it.
fn error(motion: &Motion, eta: f64, order: usize) -> f64 {
    let bouts = weak(order).bouts_on(&Body::new(eta, None).unwrap(), motion, &FROM_REST).unwrap();
    let BoutEnd::Rest(rest) = bouts[0].end else { panic!("{bouts:?}") };
    let truth = &stepped(motion, eta).bouts[0];
    (rest.value - truth.end()).abs() / (truth.end() - truth.begin())
}

/// To two terms the error falls as `ε²` of symmetric and kinked peaks, and as `ε^(3/2)` of others; from the threshold as from a jump at the peak.
#[test]
fn errors_fall_as_they_have_to() {
    let asymmetric = |a: f64| {
        let terms = vec![
            Sinusoid { amplitude: a, omega: 1.0, phase: 0.0 },
            Sinusoid { amplitude: 0.4 * a, omega: 2.0, phase: 0.5 },
        ];
        Motion::sinusoids(vec![Stretch { until: 6.0, terms }]).unwrap()
    };
    let peak = (0..2_000_000).map(|k| at(&asymmetric(1.0), 3e-6 * f64::from(k)).abs()).fold(0.0, f64::max);
    /// A name, the motion of which the highest peak is `1 + ε`, and the power of `ε` as which the error falls.
    type Case<'a> = (&'static str, Box<dyn Fn(f64) -> Motion + 'a>, f64);
    let cases: [Case; 5] = [
        ("sine", Box::new(|epsilon| Motion::one_sine(1.0 + epsilon, 2.0).unwrap()), 2.0),
        ("cosine, which starts at its peak", Box::new(|epsilon| Motion::one_cosine(1.0 + epsilon, 2.0).unwrap()), 2.0),
        (
            "symmetric wavelet",
            Box::new(|epsilon| {
                let of = Ricker { amplitude: 1.0 + epsilon, omega: 4.0, center: 2.5, antisymmetric: false };
                Motion::ricker(of).unwrap()
            }),
            2.0,
        ),
        ("asymmetric sum", Box::new(|epsilon| asymmetric((1.0 + epsilon) / peak)), 1.5),
        (
            "kinked peak",
            Box::new(|epsilon| Motion::record(1.0, 1.0, vec![0.0, 0.8, 1.0 + epsilon, 0.1, 0.3]).unwrap()),
            2.0,
        ),
    ];
    for (name, motion, power) in &cases {
        for eta in [0.3, 0.6, 0.92] {
            let [coarse, fine] = [1e-3, 1e-4].map(|epsilon| error(&motion(epsilon), eta, 2));
            let found = (coarse / fine).log10();
            assert!((found - power).abs() < 0.12, "{name}, eta {eta}: as the power {found}, {coarse:e} {fine:e}");
            // More terms are nearer.
            assert!(error(&motion(1e-3), eta, 4) < 0.05 * coarse, "{name}, eta {eta}");
        }
    }
}

#[test]
fn a_mirrored_motion_has_the_same_times_and_the_other_side() {
    for (motion, eta, _) in just_above(11, 60) {
        let bouts = |motion: &Motion| weak(3).bouts_on(&Body::new(eta, None).unwrap(), motion, &FROM_REST);
        match (bouts(&motion), bouts(&motion.scaled(-1.0).unwrap())) {
            (Ok(one), Ok(other)) => {
                let mirrored: Vec<Bout> = one.into_iter().map(|bout| Bout { side: -bout.side, ..bout }).collect();
                assert_eq!(mirrored, other);
            }
            (one, other) => assert_eq!(one, other),
        }
    }
}

fn why(motion: &Motion, asked: &Followed) -> String {
    let found: Result<Vec<Bout>, Decline> = weak(2).bouts_on(&Body::new(0.92, None).unwrap(), motion, asked);
    found.unwrap_err().to_string()
}

#[test]
fn what_is_not_weak_is_declined_and_says_why() {
    let sine = |a: f64| Motion::one_sine(a, 2.0).unwrap();
    // At omega = 2 and eta = 0.92 the chattering is complete up to 1.038.
    assert!(why(&sine(1.037), &FROM_REST).contains("is not weak"), "{}", why(&sine(1.037), &FROM_REST));
    assert!(why(&sine(3.0), &FROM_REST).contains("is not weak"));
    let moving = Followed { start: (0.1, 0.0), ..FROM_REST };
    assert!(why(&sine(1.001), &moving).contains("move at the start"));
    // A record that goes on rising, and one whose next sample comes before the block rests.
    let record = |samples: Vec<f64>| Motion::record(0.5, 1.0, samples).unwrap();
    assert!(why(&record(vec![0.0, 1.2]), &FROM_REST).contains("no peak"));
    assert!(why(&record(vec![0.0, 1.1, 0.7, 0.69, 0.0]), &FROM_REST).contains("the motion changes at tau = 1"));
    let resummed = Asymptotic::new().with_order(Order::Resummed).unwrap();
    assert!(resummed.bouts_on(&Body::new(0.9, None).unwrap(), &sine(1.001), &FROM_REST).is_err());
    // A ground that does not push has no bouts, and nothing to decline.
    assert_eq!(weak(2).bouts_on(&Body::new(0.9, None).unwrap(), &sine(0.9), &FROM_REST), Ok(Vec::new()));
    // A response that ends before the block rests says so.
    let short = Followed { until: 0.85, ..FROM_REST };
    let bouts = weak(3).bouts_on(&Body::new(0.9, None).unwrap(), &sine(1.001), &short).unwrap();
    assert!(bouts.len() == 1 && bouts[0].end == BoutEnd::Aloft, "{bouts:?}");
}
