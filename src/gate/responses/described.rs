//! A motion of the ground in a line.

use contract::{Motion, Record, Ricker};

use crate::cases::shaking::AnyMotion;

/// What a motion is, and how the block starts on it.
pub(super) fn described(asked: &AnyMotion) -> String {
    let motion = match asked.motion.as_ref() {
        Motion::Sinusoids(stretches) => {
            let stretch = |of: &contract::Stretch| {
                let term =
                    |of: &contract::Sinusoid| format!("{:?} sin({:?} τ + {:?})", of.amplitude, of.omega, of.phase);
                let terms: Vec<String> = of.terms.iter().map(term).collect();
                format!(
                    "{} up to τ = {:?}",
                    if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") },
                    of.until
                )
            };
            stretches.iter().map(stretch).collect::<Vec<_>>().join(", ")
        }
        Motion::Ricker(Ricker { amplitude, omega, center, antisymmetric }) => {
            let kind = if *antisymmetric { "antisymmetric Ricker" } else { "Ricker" };
            format!("{kind} wavelet of {amplitude:?}, omega = {omega:?}, center = {center:?}")
        }
        Motion::Record(Record { dt, scale, samples }) => {
            format!("record of {} samples, dt = {dt:?}, times {scale:?}", samples.len())
        }
    };
    let (rotation, velocity) = asked.start;
    let start = if asked.start == (0.0, 0.0) {
        String::new()
    } else {
        format!(", from phi = {rotation:?}, phi' = {velocity:?}")
    };
    motion + &start
}
