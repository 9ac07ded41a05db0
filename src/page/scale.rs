//! Axes of the map: where a value lies, and what stands beside them.

/// An axis of the map.
pub(super) struct Scale {
    is_log: bool,
    low: f64,
    high: f64,
}

/// How many steps an axis has at the most.
const STEPS: f64 = 6.0;

impl Scale {
    /// In powers of ten, around values above 0; none without any.
    pub fn log(values: impl Iterator<Item = f64>) -> Option<Self> {
        let (low, high) = span(values.filter(|value| *value > 0.0).map(f64::log10))?;
        Some(Self { is_log: true, low: low.floor(), high: high.ceil().max(low.floor() + 1.0) })
    }

    /// Around values, to tenths.
    pub fn linear(values: impl Iterator<Item = f64>) -> Option<Self> {
        let (low, high) = span(values)?;
        let (low, high) = ((10.0 * low).floor() / 10.0, (10.0 * high).ceil() / 10.0);
        Some(Self { is_log: false, low, high: high.max(low + 0.1) })
    }

    /// The share of the axis at which a value lies; below 0 where it has no place.
    pub fn share(&self, value: f64) -> f64 {
        let at = if self.is_log { value.log10() } else { value };
        let share = (at - self.low) / (self.high - self.low);
        if share.is_finite() { share } else { -1.0 }
    }

    /// Values to be written beside the axis, with the share at which each lies.
    pub fn ticks(&self) -> Vec<(String, f64)> {
        let width = self.high - self.low;
        let unit = if self.is_log { 1.0 } else { 0.1 };
        let step = unit * (width / unit / STEPS).ceil().max(1.0);
        let count = (width / step + 1e-9).floor() as usize;
        let tick = |number: usize| {
            let at = self.low + number as f64 * step;
            let text = if self.is_log { power(at) } else { format!("{:.1}", at) };
            (text, (at - self.low) / width)
        };
        (0..=count).map(tick).collect()
    }
}

/// A power of ten as it is read best.
fn power(exponent: f64) -> String {
    let value = 10f64.powf(exponent);
    if (-2.5..3.5).contains(&exponent) {
        format!("{}", (value * 100.0).round() / 100.0)
    } else {
        format!("1e{exponent:.0}")
    }
}

fn span(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let finite = values.filter(|value| value.is_finite());
    finite.fold(None, |span, value| {
        let (low, high): (f64, f64) = span.unwrap_or((value, value));
        Some((low.min(value), high.max(value)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ticks(scale: &Scale) -> Vec<String> {
        scale.ticks().into_iter().map(|(text, _)| text).collect()
    }

    #[test]
    fn axes_hold_their_values_between_round_ones() {
        let log = Scale::log([0.0, 3e-12, 20.0].into_iter()).unwrap();
        assert_eq!(ticks(&log), ["1e-12", "1e-9", "1e-6", "1e-3", "1"]);
        assert!((log.share(1e-12), log.share(100.0)) == (0.0, 1.0) && log.share(0.0) < 0.0 && log.share(-1.0) < 0.0);
        let linear = Scale::linear([0.42, 0.97].into_iter()).unwrap();
        assert_eq!(ticks(&linear), ["0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1.0"]);
        assert!((linear.share(0.7) - 0.5).abs() < 1e-15);
        assert_eq!(ticks(&Scale::linear([0.5].into_iter()).unwrap()), ["0.5", "0.6"]);
        assert!(Scale::log([0.0].into_iter()).is_none());
    }
}
