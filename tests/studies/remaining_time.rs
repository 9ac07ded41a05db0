//! What the local series says is left, along responses.

use chattercheck::studies::remaining_time::{Row, rows};

/// To order n the error falls as the n-th power of what is left, and where the series is trusted order 8 is right to a millionth and better.
#[test]
fn the_error_falls_at_the_order_of_the_series() {
    let rows = rows().unwrap();
    let mut motions: Vec<&str> = rows.iter().map(|row| row.motion).collect();
    motions.dedup();
    motions.sort_unstable();
    motions.dedup();
    assert_eq!(motions.len(), 3);
    for motion in motions {
        for order in [1, 2, 4] {
            // Far enough from the initiation, and from the digits of a double.
            let is_clear = |row: &&Row| {
                row.motion == motion && row.order == order && row.trusted && row.error > 1e-12 && row.error < 1e-3
            };
            let clear: Vec<&Row> = rows.iter().filter(is_clear).collect();
            let (first, last) = (clear[0], clear[clear.len() - 1]);
            let falls = (first.error / last.error).ln() / (first.left / last.left).ln();
            assert!((falls - order as f64).abs() < 0.35, "{motion} {order}: {falls}");
        }
        let trusted: Vec<&Row> =
            rows.iter().filter(|row| row.motion == motion && row.order == 8 && row.trusted).collect();
        assert!(!trusted.is_empty() && trusted.iter().all(|row| row.error < 1e-6), "{motion}: {trusted:?}");
    }
}
