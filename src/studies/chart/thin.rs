//! Lines with more points than can be seen.

use super::Point;

/// The points of a line that show: of those that fall into one column the first, the lowest, the highest and the last, in their order. A point without a value breaks the
/// line and stays.
pub(super) fn seen(points: &[Point], column: impl Fn(f64) -> i64) -> Vec<Point> {
    let same = |one: &Point, next: &Point| one.y.is_some() == next.y.is_some() && column(one.x) == column(next.x);
    let shown = points.chunk_by(same).flat_map(|run| {
        let values = || run.iter().enumerate().filter_map(|(place, point)| Some((place, point.y?)));
        let lowest = values().min_by(|(_, one), (_, other)| one.total_cmp(other));
        let highest = values().max_by(|(_, one), (_, other)| one.total_cmp(other));
        let extremes = [lowest, highest].into_iter().flatten().map(|(place, _)| place);
        let mut places: Vec<usize> = extremes.chain([0, run.len() - 1]).collect();
        places.sort_unstable();
        places.dedup();
        places.into_iter().filter_map(|place| run.get(place).copied())
    });
    shown.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_can_be_seen_stays() {
        let wave: Vec<Point> = (0..1000)
            .map(|k| Point { x: f64::from(k), y: Some(f64::from((k * 37) % 101)) })
            .chain([Point { x: 1000.0, y: None }, Point { x: 1000.5, y: Some(7.0) }])
            .collect();
        let shown = seen(&wave, |x| (x / 100.0) as i64);
        assert!(shown.len() <= 43, "{}", shown.len());
        for first in (0..1000).step_by(100) {
            let part = |points: &[Point]| -> Vec<f64> {
                let column = |point: &&Point| (first as f64..first as f64 + 100.0).contains(&point.x);
                points.iter().filter(column).filter_map(|point| point.y).collect()
            };
            let (all, few) = (part(&wave), part(&shown));
            let extremes =
                |of: &[f64]| (of.iter().copied().fold(f64::NAN, f64::min), of.iter().copied().fold(f64::NAN, f64::max));
            assert_eq!(extremes(&all), extremes(&few));
            assert_eq!((all.first(), all.last()), (few.first(), few.last()));
        }
        assert!(shown.is_sorted_by(|one, next| one.x <= next.x) && shown.iter().any(|point| point.y.is_none()));
    }
}
