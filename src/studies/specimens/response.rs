//! Where the rotation goes in the half period after `T/2`: what a wrong verdict comes to (Fig. 11).

use contract::Case;

use super::{Landing, half_period};

/// At how many times the response is looked at.
pub const SAMPLES: usize = 64;

/// The rotation `φ` at each of [`sample_times`].
#[derive(Debug, Clone, PartialEq)]
pub struct Response(pub Vec<f64>);

/// Evenly over the half period after `T/2`, its end included.
pub fn sample_times(case: &Case) -> impl Iterator<Item = f64> {
    let half_period = half_period(case);
    (1..=SAMPLES).map(move |k| half_period * (1.0 + k as f64 / SAMPLES as f64))
}

impl Response {
    /// That of a block that hits at `impacts`, in order, up to the end of the period, and rests from `rests` on until the excitation lifts it
    /// again, at the next multiple of `T/2`: then it repeats what it did from the start, mirrored.
    pub fn of(case: &Case, impacts: &[Landing], rests: Option<f64>) -> Self {
        Self(sample_times(case).map(|time| rotation(case, impacts, rests, time)).collect())
    }

    /// The largest difference to the `true` response, over the largest rotation of that.
    pub fn error(&self, truth: &Self) -> f64 {
        let largest = truth.0.iter().fold(0.0, |most: f64, phi| most.max(phi.abs()));
        let off = self.0.iter().zip(&truth.0).map(|(phi, exact)| (phi - exact).abs());
        // Not `f64::max`, which would drop what is not a number.
        off.fold(0.0, |most: f64, off| if off <= most { most } else { off }) / largest
    }
}

fn rotation(case: &Case, impacts: &[Landing], rests: Option<f64>, time: f64) -> f64 {
    if let Some(rests) = rests.filter(|rests| time >= *rests) {
        let lifted = (time / half_period(case)).floor() * half_period(case);
        return if lifted < rests { 0.0 } else { -rotation(case, impacts, Some(rests), time - lifted) };
    }
    let flights = impacts.partition_point(|impact| impact.time <= time);
    let start = flights.checked_sub(1).and_then(|last| impacts.get(last));
    let (from, velocity) = start.map_or((0.0, 0.0), |impact| (impact.time, impact.velocity));
    // The sign of flight n is (-1)^(n+1).
    let sign = if flights % 2 == 0 { -1.0 } else { 1.0 };
    in_flight(case, sign, from, velocity, time - from)
}

/// Eq. 6 in local time, for flights of order one: the rotation `s` after a start at `tau` with the velocity `velocity`.
fn in_flight(case: &Case, sign: f64, tau: f64, velocity: f64, s: f64) -> f64 {
    let (a, omega) = (case.amplitude(), case.omega());
    let psi = (1.0 / a).asin();
    let scale = a / (omega * omega + 1.0);
    let particular = |time: f64| scale * (omega * time + psi).sin();
    let slope = scale * omega * (omega * tau + psi).cos();
    sign + particular(tau + s) - (sign + particular(tau)) * s.cosh() + (velocity - slope) * s.sinh()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use contract::{Ending, Horizon};

    use super::*;
    use crate::panel;

    fn case(a: f64) -> Case {
        let case = Case::from_amplitude(a, 2.0, 0.92).unwrap().with_max_impacts(400).unwrap();
        case.with_horizon(Horizon::Until(2.0 * half_period(&case))).unwrap()
    }

    fn landings(case: &Case) -> (Vec<Landing>, Ending) {
        let history = panel::stepper().history(case).unwrap();
        (history.impacts.iter().map(Landing::from).collect(), history.ending)
    }

    #[test]
    fn the_rotation_vanishes_at_each_impact_and_has_the_sign_of_the_flight_between() {
        let case = case(1.05);
        let (impacts, _) = landings(&case);
        for (n, two) in impacts.windows(2).take(12).enumerate() {
            let [before, after] = two else { unreachable!() };
            let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
            let middle = rotation(&case, &impacts, None, 0.5 * (before.time + after.time));
            assert!(sign * middle > 0.0, "flight {}", n + 1);
            let end = in_flight(&case, sign, before.time, before.velocity, after.interval);
            assert!(end.abs() < 1e-14, "impact {}: {end}", n + 2);
        }
    }

    #[test]
    fn a_block_at_rest_is_lifted_half_a_period_later_as_its_mirror_image() {
        let case = case(1.03);
        let (impacts, ending) = landings(&case);
        assert_eq!(ending, Ending::AtRest);
        let rests = Some(1.126);
        assert_eq!(rotation(&case, &impacts, rests, 1.3), 0.0);
        let (first, mirrored) =
            (rotation(&case, &impacts, rests, 0.3), rotation(&case, &impacts, rests, 0.3 + half_period(&case)));
        assert!(first < 0.0 && (first + mirrored).abs() < 1e-15);
        let response = Response::of(&case, &impacts, rests);
        assert_eq!(response.error(&response), 0.0);
        let still = Response(vec![0.0; SAMPLES]);
        assert!((still.error(&response) - 1.0).abs() < 1e-12);
        assert!(Response(vec![f64::NAN; SAMPLES]).error(&response).is_nan());
    }
}
