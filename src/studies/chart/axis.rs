//! An axis: its label, its scale and its range; and how a value becomes a place on it.

use super::Error;

/// How values are spread over an axis or over colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By the decimal logarithm.
    Log,
}

/// An axis of a chart, or the colours of a heat map.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The title of the axis.
    pub label: String,
    /// How values are spread.
    pub scale: Scale,
    /// The lower and upper end; taken from what is drawn if `None`. The same for all panels.
    pub range: Option<(f64, f64)>,
    /// The values that are written beside it, and how; round ones if `None`.
    pub ticks: Option<Vec<(f64, String)>>,
}

impl Axis {
    /// A linear axis that takes its range from what is drawn.
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Linear, range: None, ticks: None }
    }

    /// A logarithmic axis that takes its range from what is drawn.
    pub fn log(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Log, range: None, ticks: None }
    }

    /// This axis from `low` to `high`.
    pub fn with_range(self, low: f64, high: f64) -> Self {
        Self { range: Some((low, high)), ..self }
    }

    /// This axis with these values written beside it.
    pub fn with_ticks(self, ticks: Vec<(f64, String)>) -> Self {
        Self { ticks: Some(ticks), ..self }
    }

    /// The range of the axis in `chart`: the given one, or that of `values` with the fraction `margin` added at either end.
    pub(super) fn span(&self, chart: &str, values: impl Iterator<Item = f64>, margin: f64) -> Result<Span, Error> {
        let scale = self.scale;
        if let Some((low, high)) = self.range {
            let (from, to) = (scale.apply(low), scale.apply(high));
            if !(from.is_finite() && to.is_finite() && from < to) {
                return Err(Error::Range { chart: chart.to_owned(), axis: self.label.clone(), low, high });
            }
            return Ok(Span { scale, from, to });
        }
        let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values.map(|value| scale.apply(value)).filter(|value| value.is_finite()) {
            (from, to) = (from.min(value), to.max(value));
        }
        if from > to {
            (from, to) = (0.0, 1.0); // nothing but failures: any range shows them
        }
        let extra = match (to > from, scale) {
            (true, _) => margin * (to - from),
            (false, Scale::Log) => 0.5,
            (false, Scale::Linear) if from == 0.0 => 1.0,
            (false, Scale::Linear) => 0.05 * from.abs(),
        };
        Ok(Span { scale, from: from - extra, to: to + extra })
    }

    /// Refuses a `value`, of something called `of` in `chart`, that has no place on this axis.
    pub(super) fn check(&self, chart: &str, of: &str, value: f64) -> Result<(), Error> {
        let (chart, of, axis) = (chart.to_owned(), of.to_owned(), self.label.clone());
        if !value.is_finite() {
            Err(Error::NotFinite { chart, of, axis, value })
        } else if self.scale == Scale::Log && value <= 0.0 {
            Err(Error::NotPositive { chart, of, axis, value })
        } else {
            Ok(())
        }
    }
}

impl Scale {
    /// The value on the scale: itself, or its logarithm.
    pub(super) fn apply(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Log => value.log10(),
        }
    }
}

/// The range of an axis; the ends are on the scale (so the logarithms, if it is logarithmic).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    pub(super) scale: Scale,
    pub(super) from: f64,
    pub(super) to: f64,
}

impl Span {
    /// The place of `value`: 0 at the lower end, 1 at the upper.
    pub(super) fn fraction(&self, value: f64) -> f64 {
        (self.scale.apply(value) - self.from) / (self.to - self.from)
    }

    /// Whether `value` lies on the axis (with a hair of room for rounding at its ends).
    pub(super) fn holds(&self, value: f64) -> bool {
        const HAIR: f64 = 1e-9;
        (-HAIR..=1.0 + HAIR).contains(&self.fraction(value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_range_is_given_or_found() {
        let span = Axis::log("error").span("c", [1e-4, 0.0, 1.0].into_iter(), 0.0).unwrap();
        assert_eq!((span.from, span.to), (-4.0, 0.0), "zero does not count on a logarithmic axis");
        assert_eq!(span.fraction(1e-2), 0.5);
        let span = Axis::linear("a").with_range(1.0, 3.0).span("c", [9.0].into_iter(), 0.1).unwrap();
        assert_eq!((span.fraction(2.0), span.holds(3.0), span.holds(3.1)), (0.5, true, false));
        let span = Axis::linear("a").span("c", [2.0].into_iter(), 0.1).unwrap();
        assert!(span.from < 2.0 && span.to > 2.0, "one value still has a range");
    }

    #[test]
    fn a_range_that_is_none_is_refused() {
        for (axis, low, high) in
            [(Axis::log("error"), 0.0, 1.0), (Axis::linear("a"), 2.0, 2.0), (Axis::linear("a"), f64::NAN, 2.0)]
        {
            assert!(matches!(axis.with_range(low, high).span("c", [].into_iter(), 0.0), Err(Error::Range { .. })));
        }
    }
}
