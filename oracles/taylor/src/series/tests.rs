//! The arithmetic of series in whole numbers.

use super::*;

fn series(coefficients: &[f64]) -> Series {
    let mut series = Series::new();
    coefficients.iter().for_each(|c| series.push(*c));
    series
}

/// None of them negligible.
fn all(most: usize) -> Terms {
    Terms { most, negligible: 0.0 }
}

#[test]
fn products_ends_and_values() {
    let a = series(&[1.0, 2.0, 3.0]);
    let mut products = Products::new();
    for (k, (rate, of)) in [1.0, 2.0, 3.0].into_iter().zip([[4.0, 1.0], [5.0, 0.0], [6.0, -1.0]]).enumerate() {
        products.add(k, 4, rate, of);
    }
    assert_eq!([0, 1, 2].map(|k| products.at(k)), [[4.0, 1.0], [13.0, 2.0], [28.0, 2.0]]);
    assert_eq!((a.last(), series(&[]).last()), (3.0, 0.0));
    assert_eq!((a.from(0), a.from(1), a.from(3)), (&[1.0, 2.0, 3.0][..], &[2.0, 3.0][..], &[][..]));
    assert_eq!(a.from(4), &[0.0; 0]);
    // 1 + 2x + 3x² and 2 + 6x at 2
    assert_eq!(evaluate(a.from(0), 2.0), (17.0, 14.0));
    let full = series(&[1.0; 30]);
    assert_eq!(full.from(0).len(), ORDER + 1);
}

/// An order has as many coefficients and one more, and no more than are held.
#[test]
fn a_series_is_as_long_as_its_order() {
    let block = Block::new(0.03, 2.0, 0.9, 0.2);
    let scale = Scale { time: 0.1, velocity: 0.5 };
    let forcing = block.forcing(1.0, 0.3);
    let full = expand(&block, &forcing, &scale, (0.1, 0.2), all(ORDER));
    for order in [6, 12, 23, 24, 40] {
        let found = expand(&block, &forcing, &scale, (0.1, 0.2), all(order));
        assert_eq!(found.from(0), &full.from(0)[..=order.min(ORDER)], "{order}");
    }
}

/// A series that ends early ends with the first two terms that are negligible at twice the unit of time, and is otherwise the same.
#[test]
fn no_more_terms_are_made_than_tell() {
    let block = Block::new(0.03, 2.0, 0.9, 0.2);
    let scale = Scale { time: 0.02, velocity: 0.5 };
    let forcing = block.forcing(1.0, 0.3);
    let full = expand(&block, &forcing, &scale, (0.0, 1.0), all(ORDER));
    let size = |k: usize| full.from(0)[k].abs() * f64::powi(2.0, i32::try_from(k).unwrap());
    for negligible in [1e-6, 1e-12, 1e-18] {
        let found = expand(&block, &forcing, &scale, (0.0, 1.0), Terms { most: ORDER, negligible });
        let len = found.from(0).len();
        assert_eq!(found.from(0), &full.from(0)[..len]);
        assert!((len - 2..len).all(|k| size(k) <= negligible), "{negligible:e}: {len}");
        assert!(len == 5 || size(len - 3) > negligible || size(len - 2) > negligible, "{negligible:e}: {len}");
        assert!((5..20).contains(&len));
    }
}

/// Without a forcing the equation is `χ'' = T² tan-like σ/cos α`, `σ = sin(αPχ)/(αP)`: to the last digits, by its series or by the sine
/// itself, and where `P` has underflowed.
#[test]
fn the_sine_of_a_small_angle_keeps_its_digits() {
    let block = Block::new(0.03, 2.0, 0.9, 0.5);
    let still = Forcing { gravity: 0.0, value: 0.0, slope: 0.0 };
    for z in [1e-9, 9e-6, 1.1e-5, 3e-4, 9e-4, 1e-3, 9e-3, 0.4f64] {
        let scale = Scale { time: 0.5, velocity: 2.0 };
        let found = expand(&block, &still, &scale, (z / 0.5, 0.0), all(6)).from(0)[2];
        let expected = 0.5 * 0.25 / 0.5f64.cos() * z.sin() / 0.5;
        assert!((found / expected - 1.0).abs() < 4e-16, "{z}: {:e}", found / expected - 1.0);
    }
    let scale = Scale { time: 1e-200, velocity: 1e-200 };
    let found = expand(&block, &still, &scale, (1.0, 1.0), all(6));
    assert_eq!(found.from(0)[..2], [1.0, 1.0]);
    assert!(found.from(0).iter().all(|c| c.is_finite()));
}
