//! Lines with dashes, cut at the edges of a panel; and hatching.

use plotters::style::RGBColor;

use super::{
    Draw, Error, Scale, Series,
    axis::Span,
    canvas::Canvas,
    geometry::{Place, Rect},
    palette::{GREY, Ink, PALE, Shape, WHITE},
};

/// The thickness of the line of a series.
pub(super) const LINE: f64 = 2.0;
/// Markers on a line are thinned if there are more points than this,
const MANY: usize = 24;
/// to one in so many pixels along it.
const APART: f64 = 40.0;

/// A `path` drawn and left out in turn, as `dash` says; whole if it is empty.
pub(super) fn dashed(
    canvas: &mut Canvas,
    path: &[Place],
    dash: &[f64],
    colour: RGBColor,
    thick: f64,
) -> Result<(), Error> {
    dashes(path, dash).iter().try_for_each(|piece| canvas.line(piece, colour, thick))
}

/// The drawn pieces of a path.
fn dashes(path: &[Place], dash: &[f64]) -> Vec<Vec<Place>> {
    let mut lengths = dash.iter().copied().cycle();
    let (Some(mut left), Some(start)) = (lengths.next(), path.first()) else {
        return vec![path.to_vec()];
    };
    let mut pieces = Vec::new();
    let mut piece = vec![*start];
    let mut is_drawn = true;
    for (from, to) in path.iter().zip(path.iter().skip(1)) {
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let place = (from.0 + (to.0 - from.0) * done / length, from.1 + (to.1 - from.1) * done / length);
            if is_drawn {
                piece.push(place);
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece = vec![place];
            }
            is_drawn = !is_drawn;
            left = lengths.next().unwrap_or(f64::INFINITY);
        }
        left -= length - done;
        if is_drawn {
            piece.push(*to);
        }
    }
    if is_drawn && piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}

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
    pub(super) fn series(&self, canvas: &mut Canvas, series: &Series, ink: Ink, phase: usize) -> Result<(), Error> {
        let places = self.places(series);
        if series.draw != Draw::Markers {
            for part in inside(&places, &self.area) {
                dashed(canvas, &part, ink.dash, ink.colour, LINE)?;
            }
        }
        for place in self.markers(&places, series.draw, phase) {
            canvas.marker(if series.draw == Draw::Line { Shape::Disc } else { ink.shape }, place, ink.colour)?;
        }
        Ok(())
    }

    /// The line of `series` with a pale edge, to be seen on any colour.
    pub(super) fn outlined(&self, canvas: &mut Canvas, series: &Series, ink: Ink) -> Result<(), Error> {
        for part in inside(&self.places(series), &self.area) {
            canvas.line(&part, WHITE, LINE + 2.4)?;
            dashed(canvas, &part, ink.dash, ink.colour, LINE)?;
        }
        Ok(())
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
            Draw::Line => {
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

/// Grey with slanted lines: no value here. The lines of neighbouring areas continue each other.
pub(super) fn hatch(canvas: &mut Canvas, area: &Rect) -> Result<(), Error> {
    const APART: f64 = 7.0;
    canvas.fill(area, PALE)?;
    let first = ((area.left + area.top) / APART).ceil() as i64;
    let last = ((area.right + area.bottom) / APART).floor() as i64;
    for index in first..=last {
        let sum = index as f64 * APART;
        if let Some((from, to)) = area.clip((sum - area.bottom, area.bottom), (sum - area.top, area.top)) {
            canvas.line(&[from, to], GREY, 1.0)?;
        }
    }
    Ok(())
}

/// Whether `value` can't be shown on a logarithmic scale because it is zero.
pub(super) fn is_off(scale: Scale, value: f64) -> bool {
    scale == Scale::Log && value == 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_go_round_corners() {
        let path = [(0.0, 0.0), (4.0, 0.0), (4.0, 10.0)];
        let pieces = dashes(&path, &[6.0, 3.0]);
        assert_eq!(pieces, [vec![(0.0, 0.0), (4.0, 0.0), (4.0, 2.0)], vec![(4.0, 5.0), (4.0, 10.0)]]);
        assert_eq!(dashes(&path, &[]), [path.to_vec()]);
    }

    #[test]
    fn a_line_breaks_at_a_failure_and_at_the_edge() {
        let rect = Rect { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
        let places = [Some((1.0, 1.0)), Some((2.0, 1.0)), None, Some((3.0, 1.0)), Some((3.0, 21.0)), Some((5.0, 1.0))];
        let parts = inside(&places, &rect);
        assert_eq!(parts.len(), 3);
        assert_eq!(parts[1], [(3.0, 1.0), (3.0, 10.0)]);
    }
}
