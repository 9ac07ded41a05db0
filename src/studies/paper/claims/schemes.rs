//! Section 5.2: the response, and the two schemes that end chattering.

use contract::{Arrival, Case, Ending};
use rayon::prelude::*;

use super::{Measured, Measurement, verdict::rounded};
use crate::{
    measure::{
        asking::ask,
        critical::{eq76, interpolated},
    },
    motion::response::{Bout, BoutEnd, Response, Window},
    panel,
    studies::{
        diagnose::{spread, truth::stepped},
        paper::{
            Error, half_period,
            history::{CHATTERING, COARSE, ETA, EXACT, FINE, OMEGA, Scheme, duration, response},
            missing,
        },
    },
};

pub(super) const ALL: &[Measurement] = &[
    ("fig-9-rest", rest_after_chattering_time),
    ("fig-9-again", second_initiation),
    ("fig-9-finite", finitely_many),
    ("fig-10", both_schemes),
    ("fig-11-rest", rest_that_should_not_be),
    ("fig-11-different", another_response),
    ("fig-11-fine", fine_threshold),
    ("chattering-threshold-ends", whether_the_threshold_is_reached),
    ("chattering-threshold-robust", robustness),
];

const BELOW: f64 = 1.03;
const ABOVE: f64 = 1.05;

fn first_bout(response: &Response) -> Result<&Bout, Error> {
    response.bouts.first().ok_or_else(|| missing("rocking"))
}

/// When the block first comes to rest by a scheme, the impacts until then, and the speed `|φ'|` with which it is stopped.
fn first_rest(a: f64, scheme: Scheme) -> Result<(f64, usize, f64), Error> {
    let (response, _) = response(a, scheme)?;
    let bout = first_bout(&response)?;
    let speed = bout.flights.last().map_or(0.0, |flight| match flight.arrival {
        Arrival::Impact { speed, .. } => ETA * speed,
        _ => 0.0,
    });
    Ok((bout.end(), bout.impacts(), speed))
}

fn rest_after_chattering_time() -> Result<Measured, Error> {
    let (exact, ..) = first_rest(BELOW, EXACT)?;
    let (rest, impacts, speed) = first_rest(BELOW, CHATTERING)?;
    let found = format!(
        "it is called at rest at {:.4} T/2, after {impacts} impacts and with a speed of {speed:.4}; the impacts accumulate at {:.4} T/2",
        rest / half_period(OMEGA),
        exact / half_period(OMEGA)
    );
    Ok(Measured::new((rest / exact - 1.0).abs(), found))
}

fn second_initiation() -> Result<Measured, Error> {
    let (response, _) = response(BELOW, CHATTERING)?;
    let half_period = half_period(OMEGA);
    let wrong = response.bouts.iter().zip(0..).filter(|(bout, k)| {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        (bout.begin() - f64::from(*k) * half_period).abs() > 1e-12 || bout.lobe.mirror != sign || bout.start != 0.0
    });
    let found = format!(
        "from rest at each multiple of T/2, to one side and the other by turns: {} times in 2.5 T",
        response.bouts.len()
    );
    Ok(Measured::new(wrong.count() as f64, found))
}

fn finitely_many() -> Result<Measured, Error> {
    let (_, by_time, _) = first_rest(BELOW, CHATTERING)?;
    let (_, by_speed, _) = first_rest(BELOW, FINE)?;
    let (_, coarse, _) = first_rest(BELOW, COARSE)?;
    let found = format!(
        "{by_time} impacts with the chattering threshold, {by_speed} with VelTol/(pα) = 5e-10, {coarse} with 5e-2; the exact sum needs no threshold"
    );
    let infinite = [by_time, by_speed, coarse].into_iter().filter(|impacts| *impacts > 1000).count();
    Ok(Measured::new(infinite as f64, found))
}

fn both_schemes() -> Result<Measured, Error> {
    let (exact, ..) = first_rest(BELOW, EXACT)?;
    let off = |scheme| Ok::<_, Error>((first_rest(BELOW, scheme)?.0 / exact - 1.0).abs());
    let (by_time, by_speed) = (off(CHATTERING)?, off(FINE)?);
    let found = format!(
        "both do, the chattering threshold {} % too early, VelTol/(pα) = 5e-10 {} %",
        rounded(100.0 * by_time),
        rounded(100.0 * by_speed)
    );
    Ok(Measured::new(by_time.max(by_speed), found))
}

fn rest_that_should_not_be() -> Result<Measured, Error> {
    let (exact, _) = response(ABOVE, EXACT)?;
    let (coarse, _) = response(ABOVE, COARSE)?;
    let stopped = first_bout(&coarse)?;
    let as_said = first_bout(&exact)?.end() > half_period(OMEGA) && stopped.outcome == BoutEnd::VelocityThreshold;
    let found = format!(
        "with 5e-2 it is put to rest at {:.3} T/2; it should rock through T/2",
        stopped.end() / half_period(OMEGA)
    );
    Ok(Measured::new(f64::from(u8::from(!as_said)), found))
}

/// The largest difference of two responses in rotation, over the largest rotation.
fn largest_difference(a: f64, one: Scheme, other: Scheme) -> Result<f64, Error> {
    const STEPS: usize = 2000;
    let stepper = panel::stepper();
    let rotations = |scheme| {
        let (response, request) = response(a, scheme)?;
        let times: Vec<f64> = spread(0.0, duration(), STEPS).collect();
        let window = Window { from: 0.0, to: duration(), steps: 4 * STEPS };
        let samples = response.samples(stepper.as_ref(), &request, &window)?;
        // The nearest sample: they are denser than the times.
        let at = |time: &f64| {
            let after = samples.partition_point(|sample| sample.tau < *time).min(samples.len() - 1);
            samples.get(after).map_or(f64::NAN, |sample| sample.phi)
        };
        Ok::<_, Error>(times.iter().map(at).collect::<Vec<f64>>())
    };
    let (one, other) = (rotations(one)?, rotations(other)?);
    let largest = one.iter().chain(&other).fold(0.0_f64, |most, phi| most.max(phi.abs()));
    Ok(one.iter().zip(&other).fold(0.0_f64, |most, (one, other)| most.max((one - other).abs())) / largest)
}

fn another_response() -> Result<Measured, Error> {
    let difference = largest_difference(ABOVE, EXACT, COARSE)?;
    let found = format!("within 2.5 T the two rotations differ by up to {difference:.1} of the largest rotation");
    Ok(Measured::new((1.0 - difference).max(0.0), found))
}

fn fine_threshold() -> Result<Measured, Error> {
    let difference = largest_difference(ABOVE, EXACT, FINE)?.max(largest_difference(ABOVE, EXACT, CHATTERING)?);
    Ok(Measured::to_digits(difference, 9, "both give the response without a threshold"))
}

fn whether_the_threshold_is_reached() -> Result<Measured, Error> {
    let critical = interpolated(OMEGA, ETA)?;
    let sums = asymptotic::coefficients(ETA).ok_or_else(|| missing("the sums of Eq. 65"))?;
    let shares: Vec<f64> = spread(0.01, 0.99, 98).collect();
    let never = shares.par_iter().map(|share| {
        let epsilon = share * critical;
        let exact = stepped(epsilon, OMEGA, ETA).ok_or_else(|| missing("tau_ch below a_cr"))?;
        Ok((sums.chattering_time(epsilon, OMEGA) >= exact).then_some(1.0 + epsilon))
    });
    let never: Vec<f64> = never.collect::<Result<Vec<_>, Error>>()?.into_iter().flatten().collect();
    let last = never.iter().copied().fold(1.0, f64::max);
    let found = format!(
        "at {} of {} amplitudes below a_cr (those up to a = {last:.4}; ω = 2, η = 0.92) the τ_ch of Eq. 65 is later than the accumulation point, \
         so no impact ever exceeds it",
        never.len(),
        shares.len()
    );
    Ok(Measured::new(never.len() as f64, found))
}

fn robustness() -> Result<Measured, Error> {
    let places: Vec<(f64, f64)> =
        spread(0.5, 8.0, 30).flat_map(|omega| spread(0.76, 0.98, 22).map(move |eta| (omega, eta))).collect();
    // Half-way between the critical amplitude and what the criterion takes for it.
    let wrong = places.par_iter().map(|&(omega, eta)| {
        let critical = interpolated(omega, eta)?;
        let taken = eq76(omega, eta) - 1.0;
        if taken <= critical {
            return Ok(false);
        }
        let case = Case::from_epsilon(0.5 * (critical + taken), omega, eta)?.with_max_impacts(2000)?;
        let answer = ask(panel::stepper().as_ref(), &case);
        Ok(answer.observed().is_some_and(|observed| observed.history.ending != Ending::AtRest))
    });
    let wrong = wrong.collect::<Result<Vec<_>, Error>>()?.into_iter().filter(|wrong| *wrong).count();
    let found = format!(
        "at {wrong} of {} pairs of ω and η (0.5 to 8, 0.76 to 0.98) Eq. 76 is above a_cr, and for amplitudes between the two the scheme ends a \
         chattering that is incomplete",
        places.len()
    );
    Ok(Measured::new(wrong as f64, found))
}
