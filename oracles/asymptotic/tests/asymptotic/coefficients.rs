//! Each coefficient of the series by itself: an error of one hides in the sum of all, and a claim of what is left out does not cover it.

use crate::effort::pick;
use asymptotic::{Asymptotic, Expansion, Order};
use contract::{Case, Oracle};

/// `ω`, `η`, the order and the coefficient, from `coefficients.py`: flights with complex `ε`, no series in `ε` at all.
const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/asymptotic/coefficients.csv");

#[test]
fn every_coefficient_is_that_of_stepping_with_complex_amplitudes() {
    let table = std::fs::read_to_string(TABLE).unwrap();
    let rows = table.lines().filter(|line| !line.starts_with('#')).skip(1);
    let mut checked = 0;
    let mut expansion: Option<Expansion> = None;
    for row in rows {
        let fields: Vec<f64> = row.split(',').map(|field| field.parse().unwrap()).collect();
        let [omega, eta, order, known] = fields[..] else { panic!("{row}") };
        let current = expansion
            .take_if(|known| (known.omega(), known.eta()) == (omega, eta))
            .unwrap_or_else(|| Expansion::new(omega, eta, 80, 0).unwrap());
        let coefficient = current.coefficients()[order as usize];
        let error = (coefficient.value - known).abs();
        // The reference is rounded to a double as well.
        let allowed = coefficient.error + 0.5 * f64::EPSILON * known;
        assert!(error <= allowed, "omega {omega}, eta {eta}: c_{order} is off by {:e}", error / known);
        assert!(coefficient.error < 1.4e-16 * known, "{coefficient:?}");
        expansion = Some(current);
        checked += 1;
    }
    assert!(checked == 216, "{checked} coefficients");
}

/// Impacts and chattering times to orders at which the claim is next to rounding, against references of many digits.
#[test]
fn high_orders_are_right_to_what_they_claim() {
    let read = |name: &str| {
        let path = format!("{}/../../data/reference/{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(path).unwrap()
    };
    let rows = |text: &str| -> Vec<Vec<f64>> {
        let numbers = text.lines().filter(|line| !line.starts_with('#')).skip(1);
        numbers.map(|line| line.split(',').map(|field| field.parse().unwrap_or(f64::NAN)).collect()).collect()
    };
    let (mut fine, mut checked) = (0, 0);
    let mut check = |found: f64, known: f64, claim: f64, what: &str| {
        // Half a unit in the last place is lost in reading the reference.
        let error = (found - known).abs() - 0.5 * f64::EPSILON * known.abs();
        assert!(error <= claim, "{what}: {found:e} is off by {error:e}, claims {claim:e}");
        checked += 1;
        fine += usize::from(claim < 2e-14 * known.abs());
    };
    let each = pick("one of so many references", 3, 1);
    for order in [24, 64] {
        let oracle = Asymptotic::new().with_order(Order::Terms(order)).unwrap();
        for row in rows(&read("linear_chattering_times.csv")).into_iter().step_by(each) {
            let case = Case::from_epsilon(row[0], row[1], row[2]).unwrap().with_max_impacts(1).unwrap();
            let Ok(history) = oracle.history(&case) else { continue };
            let time = history.chattering_time.unwrap();
            check(time.value, row[3], time.uncertainty, &format!("order {order}, tau_ch of {row:?}"));
        }
        // The rows of a case follow one another.
        let impacts: Vec<_> = rows(&read("linear_impacts.csv")).into_iter().filter(|row| row[3] <= 60.0).collect();
        for of_case in impacts.chunk_by(|one, other| one[..3] == other[..3]).step_by(each) {
            let case = Case::from_epsilon(of_case[0][0], of_case[0][1], of_case[0][2]).unwrap();
            let Ok(history) = oracle.history(&case) else { continue };
            for row in of_case {
                let impact = history.impacts[row[3] as usize - 1];
                let (claim, what) = (impact.uncertainty, format!("order {order}, {row:?}"));
                check(impact.time, row[4], claim.time, &what);
                check(impact.interval, row[5], claim.interval * row[5], &what);
                check(impact.velocity, row[6], claim.velocity * row[6].abs(), &what);
            }
        }
    }
    assert!(checked > 300 / each && fine > 100 / each, "{checked} numbers, {fine} of them claimed to 2e-14");
}
