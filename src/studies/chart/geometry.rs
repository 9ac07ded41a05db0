//! Places on the sheet, in pixels: `x` to the right, `y` down.

/// A place.
pub(super) type Place = (f64, f64);

/// An upright rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Rect {
    /// The place `across` of the way from left to right and `up` of the way from the bottom to the top.
    pub(super) fn at(&self, across: f64, up: f64) -> Place {
        (self.left + across * self.width(), self.bottom - up * self.height())
    }

    pub(super) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(super) fn height(&self) -> f64 {
        self.bottom - self.top
    }

    pub(super) fn holds(&self, (x, y): Place) -> bool {
        (self.left - 0.5..=self.right + 0.5).contains(&x) && (self.top - 0.5..=self.bottom + 0.5).contains(&y)
    }

    /// The part that lies in `other`, if any.
    pub(super) fn within(&self, other: &Self) -> Option<Self> {
        let part = Self {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        };
        (part.left < part.right && part.top < part.bottom).then_some(part)
    }

    /// The part of the segment between two places that lies inside (Liang and Barsky).
    pub(super) fn clip(&self, (x, y): Place, to: Place) -> Option<(Place, Place)> {
        let (dx, dy) = (to.0 - x, to.1 - y);
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (step, room) in [(-dx, x - self.left), (dx, self.right - x), (-dy, y - self.top), (dy, self.bottom - y)] {
            if step == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if step < 0.0 {
                enter = enter.max(room / step);
            } else {
                leave = leave.min(room / step);
            }
        }
        (enter <= leave).then_some(((x + enter * dx, y + enter * dy), (x + leave * dx, y + leave * dy)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_is_cut_at_the_edges() {
        let rect = Rect { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
        assert_eq!(rect.clip((-5.0, 5.0), (15.0, 5.0)), Some(((0.0, 5.0), (10.0, 5.0))));
        assert_eq!(rect.clip((2.0, 2.0), (3.0, 4.0)), Some(((2.0, 2.0), (3.0, 4.0))));
        assert_eq!(rect.clip((-5.0, 1.0), (-1.0, 9.0)), None);
        assert_eq!(rect.clip((-4.0, 3.0), (5.0, -6.0)), None, "past the corner");
    }
}
