//! A series: points under one name.

/// How the points of a series are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Draw {
    /// As a line with markers; of many points only some get a marker.
    #[default]
    Both,
    /// As a line.
    Line,
    /// As markers, one each.
    Markers,
    /// As a broad pale line: one that coincides with it, and comes later, leaves it to be seen.
    Broad,
}

/// A point; without a `y`, a failure at `x`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The place along the first axis.
    pub x: f64,
    /// The value, if there is one.
    pub y: Option<f64>,
}

/// Points under one name. The line joins them in the order in which they stand, and breaks where a value is missing.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// What the legend calls it. The same name in another panel means the same look.
    pub name: String,
    /// The points.
    pub points: Vec<Point>,
    /// How they are shown.
    pub draw: Draw,
    /// Which colour, dash and marker it has; in order of appearance if `None`. Two series may share one: a line and the points it fits.
    pub slot: Option<usize>,
}

impl Series {
    /// A line with markers, in the next colour.
    pub fn new(name: impl Into<String>, points: Vec<Point>) -> Self {
        Self { name: name.into(), points, draw: Draw::Both, slot: None }
    }

    /// This series, shown as `draw` says.
    pub fn with_draw(self, draw: Draw) -> Self {
        Self { draw, ..self }
    }

    /// This series with values below `least` at that: errors below the resolution of a double are chance.
    pub fn with_least(mut self, least: f64) -> Self {
        for point in &mut self.points {
            point.y = point.y.map(|value| value.max(least));
        }
        self
    }

    /// This series with the look of a slot.
    pub fn with_slot(self, slot: usize) -> Self {
        Self { slot: Some(slot), ..self }
    }
}

/// The names of `series` in order of first appearance, each with its slot and how it is first drawn. Those without a slot of their own get
/// the free ones.
pub(super) fn slots<'a>(series: impl Iterator<Item = &'a Series> + Clone) -> Vec<(&'a str, usize, Draw)> {
    let taken: Vec<usize> = series.clone().filter_map(|one| one.slot).collect();
    let mut free = (0..).filter(|slot| !taken.contains(slot));
    let mut slots: Vec<(&str, usize, Draw)> = Vec::new();
    for one in series {
        if !slots.iter().any(|(name, ..)| *name == one.name) {
            let slot = one.slot.or_else(|| free.next()).unwrap_or(0);
            slots.push((&one.name, slot, one.draw));
        }
    }
    slots
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_keeps_its_slot() {
        let all = ["b", "a", "b"].map(|name| Series::new(name, Vec::new()));
        let fit = Series::new("fit", Vec::new()).with_slot(0);
        let slots = slots(all.iter().chain([&fit]));
        assert_eq!(slots, [("b", 1, Draw::Both), ("a", 2, Draw::Both), ("fit", 0, Draw::Both)]);
    }
}
