//! Series in a panel: their lines, cut and marked where they leave it, and their markers; and hatching.

use super::{
    Draw, Scale, Series,
    axis::Span,
    canvas::{Canvas, Stroke},
    colour::{BLACK, GREY, LIGHT, PALE, WHITE},
    geometry::{Place, Rect},
    marker::{ARROW, Shape},
    palette::{Ink, LINE},
};

/// Markers on a line are thinned if there are more points than this,
const MANY: usize = 24;
/// to one in so many pixels along it.
const APART: f64 = 40.0;

/// The parts inside `rect` of the line through `places`, which is broken where there is none.
fn inside(places: &[Option<Place>], rect: &Rect) -> Vec<Vec<Place>> {
    let mut parts: Vec<Vec<Place>> = Vec::new();
    for pair in places.iter().zip(places.iter().skip(1)) {
        let (Some(from), Some(to)) = pair else { continue };
        let Some((enter, leave)) = rect.clip(*from, *to) else { continue };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&enter) => part.push(leave),
            _ => parts.push(vec![enter, leave]),
        }
    }
    parts
}

/// A panel to draw in: its area, and the axes across and up it.
pub(super) struct Plot<'a> {
    pub(super) area: Rect,
    pub(super) x: &'a Span,
    pub(super) y: &'a Span,
}

impl Plot<'_> {
    /// The place of a value; none if it is off a logarithmic scale.
    fn place(&self, x: f64, y: f64) -> Option<Place> {
        let place = self.area.at(self.x.fraction(x), self.y.fraction(y));
        (place.0.is_finite() && place.1.is_finite()).then_some(place)
    }

    /// The points of `series` that have a value.
    pub(super) fn series(&self, canvas: &mut Canvas, series: &Series, ink: Ink, phase: usize) {
        let places = self.places(series);
        if series.draw != Draw::Markers {
            for part in inside(&places, &self.area) {
                canvas.line(&part, ink.stroke(series.draw));
            }
        }
        for place in self.markers(&places, series.draw, phase) {
            let is_line = matches!(series.draw, Draw::Line | Draw::Broad);
            canvas.marker(if is_line { Shape::Disc } else { ink.shape }, place, ink.colour);
        }
        for (shape, place) in self.leaves(series) {
            canvas.marker(shape, place, ink.colour);
        }
    }

    /// The line of `series` with a pale edge, to be seen on any colour.
    pub(super) fn outlined(&self, canvas: &mut Canvas, series: &Series, ink: Ink) {
        for part in inside(&self.places(series), &self.area) {
            canvas.line(&part, Stroke::whole(WHITE, LINE + 2.4));
            canvas.line(&part, ink.stroke(Draw::Line));
        }
    }

    /// Where a series leaves the panel upwards or downwards: on its way to a point beyond, or at a marker that has no room.
    pub(super) fn leaves(&self, series: &Series) -> Vec<(Shape, Place)> {
        let places = self.places(series);
        let Rect { top, bottom, .. } = self.area;
        // With its tip at the edge.
        let arrow = |(x, y): Place| match y {
            y if y < top - 0.5 => Some((Shape::LeavesUp, (x, top + ARROW))),
            y if y > bottom + 0.5 => Some((Shape::LeavesDown, (x, bottom - ARROW))),
            _ => None,
        };
        if series.draw == Draw::Markers {
            let across = |place: &Place| self.area.holds((place.0, bottom));
            return places.into_iter().flatten().filter(across).filter_map(arrow).collect();
        }
        // From the segments that cross an edge: the place where they do.
        let crossing = |from: Place, to: Place| {
            let (_, leave) = self.area.clip(from, to)?;
            let at_an_edge = (leave.1 - top).abs() < 1e-6 || (leave.1 - bottom).abs() < 1e-6;
            let (shape, (_, y)) = arrow(to).filter(|_| at_an_edge)?;
            Some((shape, (leave.0, y)))
        };
        let pairs = places.iter().zip(places.iter().skip(1));
        let pairs = pairs.filter_map(|(from, to)| Some(((*from)?, (*to)?)));
        pairs.flat_map(|(from, to)| [crossing(from, to), crossing(to, from)]).flatten().collect()
    }

    /// Whether a line has a point without a neighbour to be joined to, which is a disc.
    pub(super) fn has_lone(&self, series: &Series) -> bool {
        let is_line = matches!(series.draw, Draw::Line | Draw::Broad);
        is_line && !self.markers(&self.places(series), series.draw, 0).is_empty()
    }

    fn places(&self, series: &Series) -> Vec<Option<Place>> {
        series.points.iter().map(|point| self.place(point.x, point.y?)).collect()
    }

    /// Where the markers are: at all points; on a line with many points at some, those of neighbouring series (by `phase`) not at the same
    /// places; on a line that should have none, where a point has no neighbour to be joined to.
    fn markers(&self, places: &[Option<Place>], draw: Draw, phase: usize) -> Vec<Place> {
        let seen: Vec<Place> = places.iter().flatten().copied().filter(|place| self.area.holds(*place)).collect();
        match draw {
            Draw::Markers => seen,
            Draw::Both if seen.len() <= MANY => seen,
            Draw::Both => thinned(&seen, phase),
            Draw::Line | Draw::Broad => {
                let neighbour = |index: Option<usize>| index.and_then(|index| places.get(index)).copied().flatten();
                let is_alone = |index: usize| {
                    neighbour(index.checked_sub(1)).is_none() && neighbour(index.checked_add(1)).is_none()
                };
                let alone = places.iter().enumerate().filter(|(index, _)| is_alone(*index));
                alone.filter_map(|(_, place)| *place).filter(|place| self.area.holds(*place)).collect()
            }
        }
    }
}

/// Some of `places`, [`APART`] along the line through them.
fn thinned(places: &[Place], phase: usize) -> Vec<Place> {
    const PHASES: usize = 5;
    let mut since = APART * (1.0 - (phase % PHASES) as f64 / PHASES as f64);
    let mut last = places.first().copied().unwrap_or_default();
    let mut kept = Vec::new();
    for place in places {
        since += (place.0 - last.0).hypot(place.1 - last.1);
        last = *place;
        if since >= APART {
            kept.push(*place);
            since = 0.0;
        }
    }
    kept
}

/// Grey with lines, of each kind in another direction, and on another grey: no value here. The lines of neighbouring areas continue each other.
pub(super) fn hatch(canvas: &mut Canvas, area: &Rect, kind: usize) {
    const APART: f64 = 7.0;
    // By how much a line goes down where it goes right: x + slope y is the same all along it.
    let lines: &[(f64, f64)] = match kind % 5 {
        0 => &[(1.0, 1.0)],
        1 => &[(1.0, -1.0)],
        2 => &[(0.0, 1.0)],
        3 => &[(1.0, 0.0)],
        _ => &[(1.0, 1.0), (1.0, -1.0)],
    };
    canvas.fill(area, if kind.is_multiple_of(2) { PALE } else { LIGHT });
    let Rect { left, top, right, bottom } = *area;
    for (across, down) in lines {
        let at = |x: f64, y: f64| across * x + down * y;
        let sums = [at(left, top), at(left, bottom), at(right, top), at(right, bottom)];
        let (low, high) = sums.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(*s), h.max(*s)));
        for index in (low / APART).ceil() as i64..=(high / APART).floor() as i64 {
            let sum = index as f64 * APART;
            // From the top to the bottom, or level from side to side.
            let ends = match across {
                0.0 => [(left, sum / down), (right, sum / down)],
                _ => [((sum - down * bottom) / across, bottom), ((sum - down * top) / across, top)],
            };
            if let Some((from, to)) = area.clip(ends[0], ends[1]) {
                canvas.line(&[from, to], Stroke::whole(GREY, 1.0));
            }
        }
    }
}

/// A short stroke that stands on a place at the foot of a panel.
pub(super) fn at_foot(canvas: &mut Canvas, (x, y): Place) {
    const HEIGHT: f64 = 10.0;
    canvas.line(&[(x, y), (x, y - HEIGHT)], Stroke::whole(BLACK, 1.0));
}

/// Whether `value` can't be shown on a logarithmic scale because it is zero.
pub(super) fn is_off(scale: Scale, value: f64) -> bool {
    scale == Scale::Log && value == 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_breaks_at_a_failure_and_at_the_edge() {
        let rect = Rect { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
        let places = [Some((1.0, 1.0)), Some((2.0, 1.0)), None, Some((3.0, 1.0)), Some((3.0, 21.0)), Some((5.0, 1.0))];
        let parts = inside(&places, &rect);
        assert_eq!(parts.len(), 3);
        assert_eq!(parts[1], [(3.0, 1.0), (3.0, 10.0)]);
    }

    #[test]
    fn where_a_line_leaves_upwards_or_downwards_is_marked() {
        let span = Span { scale: Scale::Linear, from: 0.0, to: 1.0 };
        let area = Rect { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
        let plot = Plot { area, x: &span, y: &span };
        let point = |x, y| super::super::Point { x, y: Some(y) };
        let line = Series::new("x", vec![point(0.0, 0.5), point(0.5, 1.5), point(1.0, 0.5), point(2.0, 0.5)]);
        let up = |x| (Shape::LeavesUp, (x, ARROW));
        assert_eq!(plot.leaves(&line), [up(2.5), up(7.5)], "not where it leaves to the right");
        let markers = Series::new("x", vec![point(0.5, 0.5), point(0.7, -3.0)]).with_draw(Draw::Markers);
        assert_eq!(plot.leaves(&markers), [(Shape::LeavesDown, (7.0, 10.0 - ARROW))]);
    }
}
