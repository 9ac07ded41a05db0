use contract::Case;

/// Windows tried, as multiples of what the remaining flights would take in a forcing that does not change.
const WINDOWS: [f64; 6] = [1.1, 1.25, 1.5, 2.0, 3.0, 4.0];

/// Whether infinitely many impacts certainly follow, all of them within `left`, after an impact with the `velocity` just after it, where the
/// forcing of Eq. 4 is `forcing`.
///
/// In a window of length `r` the forcing stays within `aωr` of what it is. That bounds the acceleration towards the base from below,
/// `|φ''| = 1 ± f - |φ| >= m`, for the flights of each sign. A flight that leaves with speed `v` lasts `2v/m` at the most and rises to
/// `v²/(2m)` at the most, so that within the flight the acceleration varies by `δ = 2aωv/m + v²/(2m)` at the most; it comes back with
/// `v sqrt(1 + δ/m)` at the most. A pair of flights takes at most a known multiple of `v`, and leaves at most `q v`, with
/// `q = η² sqrt(1 + δ₊/m₊) sqrt(1 + δ₋/m₋)`. If neither flight speeds the block up, and the sum over all pairs fits into the window and the
/// window into `left`, then nothing ever left the window.
pub(crate) fn is_certain(case: &Case, forcing: f64, velocity: f64, left: f64) -> bool {
    is_certain_under(case.amplitude() * case.omega(), case.eta(), forcing, velocity, left)
}

/// The same under a forcing that is nowhere steeper than `steepest`, which is `aω` of a sinusoid.
pub(crate) fn is_certain_under(steepest: f64, eta: f64, forcing: f64, velocity: f64, left: f64) -> bool {
    let speed = velocity.abs();
    let toward = [1.0 + forcing * velocity.signum(), 1.0 - forcing * velocity.signum()];
    // The next flight has the sign of the velocity; `growth` is what a flight makes of a speed.
    let total = |[this, other]: [f64; 2], [growth_of_this, growth_of_other]: [f64; 2]| {
        let pair = eta * eta * growth_of_this * growth_of_other;
        2.0 * speed * (1.0 / this + eta * growth_of_this / other) / (1.0 - pair)
    };
    let unchanged = total(toward, [1.0, 1.0]);
    WINDOWS.iter().any(|factor| {
        let window = factor * unchanged;
        let rise = |m: f64| speed * speed / (2.0 * m);
        let on_base = toward.map(|now| now - steepest * window);
        let least = on_base.map(|m| m - rise(0.5 * m));
        let growth = least.map(|m| (1.0 + (2.0 * steepest * speed / m + rise(m)) / m).sqrt());
        // Comparisons with NaN are false.
        on_base.iter().zip(&least).all(|(on_base, m)| *on_base > 0.0 && *m > 0.5 * on_base)
            && growth.iter().all(|growth| eta * growth < 1.0)
            && total(least, growth) < window
            && window < left
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_velocities_in_a_gentle_forcing_are_certain_and_others_are_not() {
        let case = Case::from_amplitude(1.03, 2.0, 0.92).unwrap();
        assert!(is_certain(&case, 0.43, -1.6e-4, 0.4));
        assert!(!is_certain(&case, 0.43, -1.6e-4, 0.004), "it takes longer than is left");
        assert!(!is_certain(&case, 0.43, -0.02, 0.4), "the forcing changes");
        assert!(!is_certain(&case, 1.01, 1.6e-8, 0.4), "the forcing lifts the block");
        assert!(!is_certain(&case, f64::NAN, 1.6e-8, 0.4));
    }

    /// The time that infinitely many flights take under a forcing that does not change, one after the other.
    fn time_of_all(forcing: f64, velocity: f64, eta: f64) -> f64 {
        let (mut speed, mut side, mut time) = (velocity.abs(), velocity.signum(), 0.0);
        while speed > 1e-18 * velocity.abs() {
            time += 2.0 * speed / (1.0 + side * forcing);
            speed *= eta;
            side = -side;
        }
        time
    }

    #[test]
    fn a_forcing_that_hardly_changes_needs_a_tenth_more_time_than_the_flights_take() {
        for (forcing, eta) in [(0.43, 0.92), (-0.8, 0.7), (0.0, 0.3), (0.9, 0.97)] {
            let case = Case::from_amplitude(1.03, 1e-4, eta).unwrap();
            for velocity in [1e-7, -1e-7] {
                let time = time_of_all(forcing, velocity, eta);
                assert!(is_certain(&case, forcing, velocity, 1.11 * time), "{forcing} {eta} {velocity}");
                assert!(!is_certain(&case, forcing, velocity, 1.09 * time), "{forcing} {eta} {velocity}");
            }
        }
    }

    /// Where the forcing could come up to what the block resists before the flights end, nothing is certain; well before that, it is.
    #[test]
    fn the_forcing_may_not_come_near_the_threshold_within_the_window() {
        for (forcing, omega, eta) in [(0.43, 2.0, 0.92), (-0.9, 8.0, 0.7), (0.9, 0.5, 0.5)] {
            let case = Case::from_amplitude(1.03, omega, eta).unwrap();
            for side in [1.0, -1.0] {
                // The speed at which the forcing, as steep as it can be, covers the distance to the threshold in just the time that all flights take.
                let reaching = (1.0 - f64::abs(forcing)) / (1.03 * omega) / time_of_all(forcing, side, eta);
                assert!(!is_certain(&case, forcing, side * reaching / 1.1, f64::INFINITY), "{forcing} {omega} {side}");
                assert!(is_certain(&case, forcing, side * reaching / 5.0, f64::INFINITY), "{forcing} {omega} {side}");
            }
        }
    }

    /// Without a forcing and with one that stays: a flight rises to `v²/(2m)`, which weakens the pull by as much; not by more than half is allowed,
    /// and no more than restitution takes away again.
    #[test]
    fn a_flight_may_not_rise_so_high_that_its_return_is_in_doubt() {
        let certain = |eta: f64, velocity: f64| {
            is_certain(&Case::from_amplitude(1.03, 1e-6, eta).unwrap(), 0.0, velocity, f64::INFINITY)
        };
        for side in [1.0, -1.0] {
            // 1 - v² > 1/2, with m >= 1/2 on the way up.
            assert!(certain(0.1, 0.70 * side) && !certain(0.1, 0.72 * side));
            // Restitution is nearly 1: v²/(2m²) may add less to the speed than it takes.
            assert!(certain(0.99, 0.15 * side) && !certain(0.99, 0.2 * side) && !certain(0.99, 0.5 * side));
            assert!(certain(0.9, 0.42 * side) && !certain(0.9, 0.48 * side));
        }
    }

    /// Where little is left of the pull, `m` here, what the forcing takes of it within a flight, `2aωv/m`, counts as a part of `m`: it makes the
    /// block come back faster by `v sqrt(1 + 2aωv/m²)`. That halves the speed that the window alone would allow.
    #[test]
    fn a_forcing_that_falls_within_a_flight_speeds_the_block_up() {
        for omega in [0.5, 2.0, 8.0] {
            let case = Case::from_amplitude(1.03, omega, 0.9).unwrap();
            assert!(is_certain(&case, 0.97, 1.6e-5 / omega, f64::INFINITY));
            assert!(!is_certain(&case, 0.97, 1.9e-5 / omega, f64::INFINITY));
        }
    }

    /// The largest speed of which rest is certain, by the documented inequalities evaluated once more outside of this program.
    #[test]
    fn the_largest_certain_speed_is_where_the_inequalities_have_it() {
        for (amplitude, omega, eta, forcing, side, left, largest) in [
            (1.03, 2.0, 0.92, 0.43, -1.0, 1.0, 1.855_569_28e-3),
            (1.2, 8.0, 0.5, 0.3, 1.0, 1.0, 4.678_251_52e-3),
            (1.01, 0.5, 0.7, -0.6, 1.0, 5.0, 1.509_668_89e-2),
            (1.03, 0.01, 0.3, 0.5, -1.0, 50.0, 3.197_707_56e-1),
            (1.03, 0.01, 0.5, -0.2, 1.0, 50.0, 5.156_144_50e-1),
            (1.1, 1.0, 0.8, 0.9, 1.0, 2.0, 3.792_568_30e-4),
            (1.03, 2.0, 0.6, 0.1, -1.0, 0.4, 1.818_373_45e-2),
            (2.0, 0.3, 0.2, 0.6, -1.0, 9.0, 2.963_879_44e-2),
        ] {
            let case = Case::from_amplitude(amplitude, omega, eta).unwrap();
            let certain = |part: f64| is_certain(&case, forcing, side * part * largest, left);
            assert!(certain(1.0 - 1e-6) && !certain(1.0 + 1e-6), "{amplitude} {omega} {eta} {forcing} {side}");
        }
    }
}
