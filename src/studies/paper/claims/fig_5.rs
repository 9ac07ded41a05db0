//! Section 5.1 up to Fig. 5: how the chattering time depends on the amplitude and on the frequency.

use contract::{Case, Ending, Horizon, Model};
use rayon::prelude::*;

use super::{Measured, Measurement, verdict::rounded};
use crate::{
    measure::{asking::ask, critical::interpolated},
    panel,
    studies::{
        diagnose::{
            spread,
            truth::{FEW_DIGITS, proven, proven_to, stepped},
        },
        paper::{
            Error, half_period,
            limits::{at_zero, order},
            missing, phase,
        },
    },
};

pub(super) const ALL: &[Measurement] = &[
    ("within-half-period", within_half_period),
    ("does-not-stop", stops_above_critical),
    ("depends-on-a-and-eta", dependence_on_frequency),
    ("increases-with-a", increase),
    ("agreement", agreement),
    ("at-the-threshold", at_the_threshold),
    ("throughout", throughout),
    ("fails-at-a-cr", at_the_critical_amplitude),
    ("two-asymptotes", asymptotes),
];

const OMEGA: f64 = 2.0;
const ETA: f64 = 0.92;
const ETAS: [f64; 5] = [0.5, 0.7, 0.8, 0.92, 0.97];

/// The proven chattering time over half a period.
fn share(epsilon: f64, omega: f64, eta: f64) -> Result<f64, Error> {
    of_half_period(proven(epsilon, omega, eta), epsilon, omega)
}

/// The same to the digits that are printed, and some more.
fn share_to_digits(epsilon: f64, omega: f64, eta: f64) -> Result<f64, Error> {
    of_half_period(proven_to(FEW_DIGITS, epsilon, omega, eta), epsilon, omega)
}

fn of_half_period(time: Option<f64>, epsilon: f64, omega: f64) -> Result<f64, Error> {
    let time = time.ok_or_else(|| missing(format!("tau_ch at epsilon = {epsilon}, omega = {omega}")))?;
    Ok(time / half_period(omega))
}

fn within_half_period() -> Result<Measured, Error> {
    let (mut later, mut longest) = (0, 0.0_f64);
    for (omega, eta) in [0.5, 2.0, 8.0].into_iter().flat_map(|omega| ETAS.map(|eta| (omega, eta))) {
        for gap in [1e-2, 1e-4, 1e-6] {
            let share = share_to_digits(interpolated(omega, eta)? * (1.0 - gap), omega, eta)?;
            longest = longest.max(share);
            later += usize::from(share >= 1.0);
        }
    }
    // Where the excitation stands at T/2, and whether it grows.
    let (sin, cos) = (phase(1.03) + std::f64::consts::PI).sin_cos();
    let grows = 1.03 * sin < -1.0 + 1e-12 && cos < 0.0;
    let found = format!(
        "a millionth of a_cr − 1 below a_cr τ_ch is {longest:.4} T/2; at T/2 the excitation {} the threshold of the other sign",
        if grows { "passes" } else { "does not pass" }
    );
    Ok(Measured::new((later + usize::from(!grows)) as f64, found))
}

fn stops_above_critical() -> Result<Measured, Error> {
    // Far enough for some bouts, and near enough for the enclosure to follow the unstable motion.
    const HALF_PERIODS: f64 = 6.0;
    let amplitudes: Vec<f64> = spread(1.0385, 1.2, 323).collect();
    let rests = amplitudes.par_iter().map(|&a| {
        let case = Case::from_amplitude(a, OMEGA, ETA)?;
        let horizon = Horizon::Until(HALF_PERIODS * half_period(OMEGA));
        let case = case.with_max_impacts(2000)?.with_horizon(horizon)?;
        let answer = ask(panel::stepper().as_ref(), &case);
        if answer.observed().is_none_or(|observed| observed.history.ending != Ending::AtRest) {
            return Ok(None);
        }
        let enclosure = enclosure::Enclosure::new(Model::Linear).with_digits(FEW_DIGITS)?;
        let proven = enclosure.enclose(&case.with_max_impacts(1)?)?;
        Ok(proven.chattering_time.map(|time| time.lower() / half_period(OMEGA)))
    });
    let rests: Vec<f64> = rests.collect::<Result<Vec<_>, Error>>()?.into_iter().flatten().collect();
    let first = rests.iter().copied().fold(f64::INFINITY, f64::min);
    let found = format!(
        "it does not by T/2, but at {} of {} amplitudes from 1.0385 to 1.2 (ω = 2, η = 0.92) the chattering of a later lobe is proven to be complete \
         within {HALF_PERIODS} T/2, the earliest after {first:.2} T/2",
        rests.len(),
        amplitudes.len()
    );
    Ok(Measured::new(rests.len() as f64, found))
}

fn dependence_on_frequency() -> Result<Measured, Error> {
    let at = |a: f64, omega: f64| share(a - 1.0, omega, ETA);
    let of = |a: f64| Ok::<_, Error>([at(a, 0.5)?, at(a, 1.0)?, at(a, 2.0)?, at(a, 8.0)?]);
    let (middle, strong) = (of(1.02)?, of(1.03)?);
    let spread = |of: [f64; 4]| of[0] / of[3] - 1.0;
    let list = |of: [f64; 4]| of.map(|share| format!("{share:.4}")).join(", ");
    let found = format!(
        "at η = 0.92 and ω = 0.5, 1, 2, 8 it is {} for a = 1.02 and {} for a = 1.03, where it still changes by {} % from ω = 2 to 8",
        list(middle),
        list(strong),
        rounded(100.0 * (strong[2] / strong[3] - 1.0))
    );
    Ok(Measured::new(spread(strong).max(spread(middle)), found))
}

fn increase() -> Result<Measured, Error> {
    let (mut falls, mut all) = (0, 0);
    for (omega, eta) in [0.5, 2.0, 8.0].into_iter().flat_map(|omega| ETAS.map(|eta| (omega, eta))) {
        let critical = interpolated(omega, eta)?;
        let shares: Vec<f64> = spread(0.01, 0.99, 98).collect();
        let times: Option<Vec<f64>> = shares.par_iter().map(|share| stepped(share * critical, omega, eta)).collect();
        let times = times.ok_or_else(|| missing(format!("tau_ch below a_cr at omega = {omega}, eta = {eta}")))?;
        all += times.len() - 1;
        falls += times.windows(2).filter(|two| two.last() <= two.first()).count();
    }
    let found = format!("it rises in each of {all} steps towards a_cr, at ω of 0.5, 2 and 8 and η from 0.5 to 0.97");
    Ok(Measured::new(falls as f64, if falls == 0 { found } else { format!("it falls in {falls} of {all} steps") }))
}

/// The relative error of Eq. 65 at a share of the way from the threshold to the critical amplitude, with its sign, against `truth`.
fn error(share_of_way: f64, truth: impl Fn(f64, f64, f64) -> Result<f64, Error>) -> Result<f64, Error> {
    let epsilon = share_of_way * interpolated(OMEGA, ETA)?;
    let sums = asymptotic::coefficients(ETA).ok_or_else(|| missing("the sums of Eq. 65"))?;
    let exact = truth(epsilon, OMEGA, ETA)? * half_period(OMEGA);
    Ok(sums.chattering_time(epsilon, OMEGA) / exact - 1.0)
}

/// The amplitude from which on Eq. 65 is always off by more than `bound`.
fn exceeded(bound: f64) -> Result<f64, Error> {
    let (mut low, mut high) = (0.6, 0.9999);
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        if error(middle, share_to_digits)?.abs() > bound { high = middle } else { low = middle }
    }
    Ok(1.0 + high * interpolated(OMEGA, ETA)?)
}

/// The largest error up to a share of the way.
fn largest_error(to: f64) -> Result<f64, Error> {
    let shares: Vec<f64> = spread(0.01, to, 60).collect();
    let errors: Vec<f64> = shares.par_iter().map(|share| error(*share, share_to_digits)).collect::<Result<_, _>>()?;
    Ok(errors.into_iter().fold(0.0, |most, error| most.max(error.abs())))
}

fn agreement() -> Result<Measured, Error> {
    let found = format!(
        "Eq. 65 is off by up to {} % for a < 1.03, by 1 % from a = {:.4}, 5 % from a = {:.4} on, 10 % from {:.4} on (a_cr = {:.4})",
        rounded(100.0 * largest_error(0.03 / interpolated(OMEGA, ETA)?)?),
        exceeded(0.01)?,
        exceeded(0.05)?,
        exceeded(0.1)?,
        1.0 + interpolated(OMEGA, ETA)?
    );
    Ok(Measured::new(largest_error(0.9)?, found))
}

fn at_the_threshold() -> Result<Measured, Error> {
    let slope = at_zero(|epsilon| Ok(error(epsilon / interpolated(OMEGA, ETA)?, share)? / epsilon), 1e-5)?;
    let found = format!("its relative error tends to {slope:.3} (a − 1) at η = 0.92, ω = 2");
    Ok(Measured::new(error(0.01, share)?.abs(), found))
}

fn throughout() -> Result<Measured, Error> {
    let found = format!(
        "up to 0.5, 0.9, 0.99 and 0.9999 of the way from 1 to a_cr the largest error is {}, {}, {} and {} %",
        rounded(100.0 * largest_error(0.5)?),
        rounded(100.0 * largest_error(0.9)?),
        rounded(100.0 * largest_error(0.99)?),
        rounded(100.0 * largest_error(0.9999)?)
    );
    Ok(Measured::new(largest_error(0.9999)?, found))
}

fn at_the_critical_amplitude() -> Result<Measured, Error> {
    let mut good = 0;
    let mut shares = Vec::new();
    for eta in ETAS {
        let sums = asymptotic::coefficients(eta).ok_or_else(|| missing("the sums of Eq. 65"))?;
        let share = sums.chattering_time(interpolated(OMEGA, eta)?, OMEGA) / half_period(OMEGA);
        if (share - 1.0).abs() < 0.01 {
            good += 1;
        }
        shares.push(format!("{share:.3}"));
    }
    let found = format!("at a_cr Eq. 65 gives {} of T/2 for η = 0.5, 0.7, 0.8, 0.92, 0.97", shares.join(", "));
    Ok(Measured::new(f64::from(good), found))
}

fn asymptotes() -> Result<Measured, Error> {
    let mut flat = 0;
    let mut exponents = Vec::new();
    let mut begins = Vec::new();
    for eta in ETAS {
        let critical = interpolated(OMEGA, eta)?;
        let begin = at_zero(|step| order(|epsilon| share(epsilon, OMEGA, eta), step), 1e-5)?;
        begins.push(begin);
        let end = order(|gap| Ok(1.0 - share(critical * (1.0 - gap), OMEGA, eta)?), 1e-6)?;
        if begin >= 1.0 || end >= 1.0 {
            flat += 1;
        }
        exponents.push(format!("{end:.2}"));
    }
    let found = format!(
        "τ_ch rises as (a − 1)^{:.4} and reaches T/2 as 1 − K (a_cr − a)^β, β = {} for η = {}: upright at \
         both ends, but τ_ch stays finite",
        begins.iter().sum::<f64>() / begins.len() as f64,
        exponents.join(", "),
        ETAS.map(|eta| eta.to_string()).join(", ")
    );
    Ok(Measured::new(f64::from(flat), found))
}
