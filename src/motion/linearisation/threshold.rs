//! The linear case with the same excitation in multiples of the threshold of Eq. 1.

use contract::{Case, Decline, History, Invalid, Normalisation, Oracle, Slenderness};

/// That case, and its history by `stepper`.
///
/// Under the slender normalisation the amplitude is `a α/tan α` thresholds. What rounding that quotient does to each impact is added to what the
/// oracle claims.
pub(super) fn linear(stepper: &dyn Oracle, case: &Case, slenderness: Slenderness) -> Result<(Case, History), Decline> {
    let (linear, rounding) = of(case, slenderness)?;
    let mut history = stepper.history(&linear)?;
    if rounding > 0.0 {
        let sensitivities = stepper.sensitivities(&linear).unwrap_or_default();
        let mut sensitivities = sensitivities.iter();
        for impact in &mut history.impacts {
            // Without derivatives nothing is claimed.
            let by_a = sensitivities.next().map_or([f64::INFINITY; 3], |of| {
                let [[time, ..], [interval, ..], [velocity, ..]] = [of.time, of.interval, of.velocity];
                [time, interval / impact.interval, velocity / impact.velocity]
            });
            let [time, interval, velocity] = by_a.map(|by| rounding * by.abs());
            impact.uncertainty.time += time;
            impact.uncertainty.interval += interval;
            impact.uncertainty.velocity += velocity;
        }
    }
    Ok((linear, history))
}

/// The linear case, and the rounding of the quotient.
pub(super) fn of(case: &Case, slenderness: Slenderness) -> Result<(Case, f64), Decline> {
    let (epsilon, rounding) = match slenderness.normalisation() {
        Normalisation::Threshold => (case.epsilon(), 0.0),
        Normalisation::Slender => {
            let alpha = slenderness.alpha();
            let quotient = alpha / alpha.tan();
            (case.epsilon() * quotient - (1.0 - quotient), 4.0 * f64::EPSILON)
        }
    };
    let linear = Case::from_epsilon(epsilon, case.omega(), case.eta()).map_err(refused)?;
    let linear = linear.with_max_impacts(case.max_impacts()).and_then(|linear| linear.with_horizon(case.horizon()));
    let linear = linear.map_err(refused)?;
    Ok((linear, rounding))
}

/// The contract refuses the linear case.
pub(super) fn refused(invalid: Invalid) -> Decline {
    Decline::NotConvergent { why: format!("the linear case is refused: {invalid}") }
}
