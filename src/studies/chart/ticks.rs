//! Which values of an axis are written beside it: as many round ones as there is room for.

use super::{
    Axis,
    axis::{Scale, Span},
    number, text,
};

/// The ticks of an axis.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Ticks {
    /// Values with a label and a grid line.
    pub(super) major: Vec<Tick>,
    /// Values with a short stroke only.
    pub(super) minor: Vec<f64>,
}

/// A value and what is written at it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) label: String,
}

impl Ticks {
    /// Those of `axis`: its own, or the most that fit.
    pub(super) fn of(axis: &Axis, span: &Span, length: f64, room: impl Fn(&str) -> f64) -> Self {
        match &axis.ticks {
            None => Self::new(span, length, room),
            Some(own) => {
                let shown = own.iter().filter(|(value, _)| span.holds(*value));
                let major = shown.map(|(value, label)| Tick { value: *value, label: label.clone() }).collect();
                Self { major, minor: Vec::new() }
            }
        }
    }

    /// The width of the widest label at a size.
    pub(super) fn widest(&self, size: f64) -> f64 {
        self.major.iter().map(|tick| text::width(&tick.label, size)).fold(0.0, f64::max)
    }

    /// The most ticks that fit an axis `length` long, a label taking `room` of it.
    fn new(span: &Span, length: f64, room: impl Fn(&str) -> f64) -> Self {
        let fits = |ticks: &Vec<Tick>| {
            ticks.iter().zip(ticks.iter().skip(1)).all(|(one, next)| {
                let apart = (span.fraction(next.value) - span.fraction(one.value)) * length;
                apart >= 0.5 * (room(&one.label) + room(&next.label))
            })
        };
        let mut choices: Vec<_> = choices(span).into_iter().filter(|ticks| !ticks.is_empty()).collect();
        let sparsest = choices.pop().unwrap_or_default();
        let major = choices.into_iter().find(|ticks| ticks.len() > 1 && fits(ticks)).unwrap_or(sparsest);
        let minor = minor(span, &major);
        Self { major, minor }
    }
}

/// Sets of ticks, from many to few.
fn choices(span: &Span) -> Vec<Vec<Tick>> {
    let decades = span.to - span.from;
    match span.scale {
        Scale::Linear => (1..=8).rev().map(|count| round(span, span.from, span.to, count)).collect(),
        Scale::Log if decades < 0.9 => {
            let (low, high) = (10_f64.powf(span.from), 10_f64.powf(span.to));
            (1..=6).rev().map(|count| round(span, low, high, count)).collect()
        }
        Scale::Log => {
            const STRIDES: [i32; 14] = [1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 25, 50, 100, 200];
            let parts = (decades < 2.5).then(|| one_two_five(span));
            parts.into_iter().chain(STRIDES.iter().map(|stride| powers(span, *stride))).collect()
        }
    }
}

/// Multiples of the least step of 1, 2 or 5 times a power of ten that makes no more than `count` steps.
fn round(span: &Span, low: f64, high: f64, count: i32) -> Vec<Tick> {
    let least = (high - low) / f64::from(count);
    let power = 10_f64.powf(least.log10().floor());
    let step = [1.0, 2.0, 5.0].map(|factor| factor * power).into_iter().find(|step| *step >= least * (1.0 - 1e-9));
    let step = step.unwrap_or(10.0 * power);
    let first = (low / step - 1e-9).ceil();
    let largest = low.abs().max(high.abs());
    (0..=count)
        .map(|index| (first + f64::from(index)) * step)
        .filter(|value| span.holds(*value))
        .map(|value| Tick { value, label: number::multiple(value, step, largest) })
        .collect()
}

/// The exponents of the powers of ten that may be on a logarithmic axis.
fn exponents(span: &Span) -> std::ops::RangeInclusive<i32> {
    span.from.floor() as i32..=span.to.ceil() as i32
}

fn one_two_five(span: &Span) -> Vec<Tick> {
    let values = exponents(span).flat_map(|exponent| [1, 2, 5].map(|factor| parse(factor, exponent)));
    values.filter(|value| span.holds(*value)).map(|value| Tick { value, label: number::short(value, 1) }).collect()
}

fn powers(span: &Span, stride: i32) -> Vec<Tick> {
    exponents(span)
        .filter(|exponent| exponent % stride == 0)
        .map(|exponent| Tick { value: parse(1, exponent), label: number::power_of_ten(exponent) })
        .filter(|tick| span.holds(tick.value))
        .collect()
}

/// `factor * 10^exponent`, to the nearest double.
fn parse(factor: i32, exponent: i32) -> f64 {
    format!("{factor}e{exponent}").parse().unwrap_or(f64::NAN)
}

/// On a logarithmic axis: the powers of ten without a label, and if all have one and there are few, their multiples.
fn minor(span: &Span, major: &[Tick]) -> Vec<f64> {
    /// With more decades the multiples would be a smear.
    const FEW: f64 = 6.0;
    if span.scale == Scale::Linear || span.to - span.from < 0.9 {
        return Vec::new();
    }
    let has_label = |value: f64| major.iter().any(|tick| (tick.value / value - 1.0).abs() < 1e-6);
    let powers = || exponents(span).map(|exponent| parse(1, exponent)).filter(|value| span.holds(*value));
    let multiples = if span.to - span.from <= FEW && powers().all(has_label) { 1..=9 } else { 1..=1 };
    exponents(span)
        .flat_map(|exponent| multiples.clone().map(move |factor| parse(factor, exponent)))
        .filter(|value| span.holds(*value) && !has_label(*value))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: Scale, from: f64, to: f64, room: f64) -> Vec<String> {
        Ticks::new(&Span { scale, from, to }, 400.0, |_| room).major.into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn round_values() {
        assert_eq!(labels(Scale::Linear, 1.0, 1.038, 60.0), ["1.00", "1.01", "1.02", "1.03"]);
        assert_eq!(labels(Scale::Linear, -0.2, 1.1, 110.0), ["0.0", "0.5", "1.0"]);
        assert_eq!(labels(Scale::Log, -16.0, 0.0, 30.0).len(), 9, "every second power");
        assert_eq!(labels(Scale::Log, -16.0, 0.0, 100.0), ["10⁻¹⁶", "10⁻¹²", "10⁻⁸", "10⁻⁴", "1"]);
        assert_eq!(labels(Scale::Log, -1.0, 0.5, 50.0), ["0.1", "0.2", "0.5", "1", "2"]);
        assert_eq!(labels(Scale::Log, 0.301, 0.6, 80.0), ["2.0", "2.5", "3.0", "3.5"]);
    }

    #[test]
    fn powers_without_a_label_are_minor() {
        let ticks = Ticks::new(&Span { scale: Scale::Log, from: -4.0, to: 0.0 }, 400.0, |_| 150.0);
        assert_eq!(ticks.major.len(), 3);
        assert_eq!(ticks.minor, [1e-3, 1e-1]);
    }
}
