//! Numbers from Eq. 6 evaluated with mpmath to 50 digits, of which a double holds 17.

use approx::assert_relative_eq;
use closed_form::ClosedForm;
use contract::{Case, Ending, Oracle};

/// `a`, `ω`, `η`, and impact times by their number.
type Reference = (f64, f64, f64, &'static [(usize, f64)]);

#[allow(clippy::excessive_precision)] // as they came
const REFERENCES: [Reference; 4] = [
    (1.03, 2.0, 0.92, &[(1, 0.4877647906326521013296), (10, 0.8390091001361982242952), (40, 1.10077703078160210366)]),
    (1.01, 5.0, 0.92, &[(1, 0.1128425857610844540629), (10, 0.1807613416941638884798), (40, 0.2222541162924374046055)]),
    (1.03, 2.0, 0.86, &[(10, 0.760780184583363389586), (40, 0.844569372103268919837)]),
    (
        1.001,
        0.5,
        0.97,
        &[(1, 0.3584360244377768882821), (10, 0.5987812839660429554468), (40, 0.8649909612745699616546)],
    ),
];

#[test]
fn the_impact_times_are_those_of_the_references_to_the_last_digits() {
    for (a, omega, eta, times) in REFERENCES {
        let case = Case::from_amplitude(a, omega, eta).unwrap();
        let history = ClosedForm.history(&case).unwrap();
        for (n, expected) in times {
            let impact = &history.impacts[n - 1];
            assert_relative_eq!(impact.time, *expected, max_relative = 4e-15);
            // Half a unit in the last place of the reference is lost in storing it.
            let error = (impact.time - expected).abs() - f64::EPSILON * expected;
            assert!(
                error <= impact.uncertainty.time,
                "a={a} n={n}: off by {error:e}, claims {:e}",
                impact.uncertainty.time
            );
        }
    }
}

/// The chattering time as the paper's Eq. 75 closes the sum, from impacts so late that its geometric ratio is exact.
#[test]
fn the_chattering_time_is_that_of_the_reference() {
    let case = Case::from_amplitude(1.03, 2.0, 0.92).unwrap().with_max_impacts(600).unwrap();
    let history = ClosedForm.history(&case).unwrap();
    assert_eq!(history.ending, Ending::AtRest);
    assert_relative_eq!(history.impacts.last().unwrap().time, 1.125_947_676_933_812_1, max_relative = 4e-15);
}
