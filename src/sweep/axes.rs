//! Reading the table `[axes]`, in the order in which it is written.

use std::ops;

use toml::{
    Spanned,
    de::{DeTable, DeValue},
};

use super::{Axis, Range, Spread, SweepError, Text, Value};

/// The most values of an axis.
const MOST_VALUES: usize = 1_000_000_000;
/// How an axis is written.
const AXES: &str = "a number, a list [..], or one of { linear = [low, high, how many] }, { log = [..] }, { random = [..] } and { random-log = [..] }";

/// An axis, and where it is written.
pub(super) struct Written {
    pub axis: Axis,
    pub span: ops::Range<usize>,
}

/// The axes of a sweep that is TOML.
///
/// # Errors
/// What is wrong with the first that is.
pub(super) fn read(text: &Text) -> Result<Vec<Written>, SweepError> {
    // It has been read before.
    let document = DeTable::parse(text.0).map_err(|error| SweepError(error.message().to_owned()))?.into_inner();
    let table = document.iter().find(|(key, _)| key.get_ref() == "axes").map(|(_, value)| value);
    let mut axes = Vec::new();
    if let Some(DeValue::Table(table)) = table.map(Spanned::get_ref) {
        flatten("", table, text, &mut axes)?;
    }
    axes.sort_by_key(|written: &Written| written.span.start);
    if axes.is_empty() {
        return Err(SweepError("axes: there are none; allowed is one at least".to_owned()));
    }
    Ok(axes)
}

/// The axes of a table; a table in it that is no axis is a part of the names of others.
fn flatten(above: &str, table: &DeTable, text: &Text, axes: &mut Vec<Written>) -> Result<(), SweepError> {
    for (key, value) in table {
        let name = if above.is_empty() { key.get_ref().to_string() } else { format!("{above}.{}", key.get_ref()) };
        match value.get_ref() {
            DeValue::Table(inner) if !is_axis(inner) && !inner.is_empty() => flatten(&name, inner, text, axes)?,
            _ => {
                let span = key.span().start..value.span().end.max(key.span().end);
                let spread = spread(&name, value, text)?;
                axes.push(Written { axis: Axis { name, spread }, span });
            }
        }
    }
    Ok(())
}

/// Whether a table says how values are spread.
fn is_axis(table: &DeTable) -> bool {
    let words = ["linear", "log", "random", "random-log"];
    table.iter().any(|(key, _)| words.contains(&key.get_ref().as_ref()) || key.get_ref() == "list")
}

fn spread(name: &str, value: &Spanned<DeValue>, text: &Text) -> Result<Spread, SweepError> {
    let wrong = || text.wrong(&format!("axes.{name}"), &value.span(), AXES);
    match value.get_ref() {
        DeValue::Array(values) => {
            let values: Option<Vec<Value>> = values.iter().map(|value| plain(value.get_ref())).collect();
            let values = values.filter(|values| !values.is_empty()).ok_or_else(wrong)?;
            let twice = values.iter().enumerate().any(|(place, one)| values.iter().take(place).any(|two| two == one));
            if twice {
                return Err(text.wrong(&format!("axes.{name}"), &value.span(), "a list of values that differ"));
            }
            Ok(Spread::List(values))
        }
        DeValue::Table(table) => {
            let mut entries = table.iter();
            let (Some((word, range)), None) = (entries.next(), entries.next()) else { return Err(wrong()) };
            let field = format!("axes.{name}.{}", word.get_ref());
            Ok(match word.get_ref().as_ref() {
                "linear" => Spread::Linear(self::range(&field, range, text, false, 2)?),
                "log" => Spread::Log(self::range(&field, range, text, true, 2)?),
                "random" => Spread::Random(self::range(&field, range, text, false, 1)?),
                "random-log" => Spread::RandomLog(self::range(&field, range, text, true, 1)?),
                _ => return Err(wrong()),
            })
        }
        other => Ok(Spread::List(vec![plain(other).ok_or_else(wrong)?])),
    }
}

/// A value that is no list and no table; none that is not finite.
fn plain(value: &DeValue) -> Option<Value> {
    match value {
        DeValue::Float(float) => {
            float.to_string().replace('_', "").parse().ok().filter(|v: &f64| v.is_finite()).map(Value::Number)
        }
        DeValue::Integer(whole) => i64::from_str_radix(whole.as_str(), whole.radix()).ok().map(Value::Whole),
        // It becomes a field of a CSV, on one line.
        DeValue::String(text) if !text.chars().any(crate::cases::toml_error::is_control) => {
            Some(Value::Text(text.to_string()))
        }
        _ => None,
    }
}

fn range(field: &str, value: &Spanned<DeValue>, text: &Text, is_log: bool, fewest: usize) -> Result<Range, SweepError> {
    let allowed = match (is_log, fewest) {
        (false, 2) => "[low, high, how many] with low < high and 2 to 1e9 values",
        (true, 2) => "[low, high, how many] with 0 < low < high and 2 to 1e9 values",
        (false, _) => "[low, high, how many] with low < high and 1 to 1e9 values",
        (true, _) => "[low, high, how many] with 0 < low < high and 1 to 1e9 values",
    };
    let wrong = || text.wrong(field, &value.span(), allowed);
    let DeValue::Array(parts) = value.get_ref() else { return Err(wrong()) };
    let parts: Option<Vec<Value>> = parts.iter().map(|part| plain(part.get_ref())).collect();
    let Some([low, high, Value::Whole(count)]) = parts.as_deref() else { return Err(wrong()) };
    let (Some(low), Some(high), Ok(count)) = (low.number(), high.number(), usize::try_from(*count)) else {
        return Err(wrong());
    };
    // What is between has to be a number, too.
    let is_finite = (high - low).is_finite() && (!is_log || (high / low).is_finite());
    let is_range = low < high && is_finite && (!is_log || low > 0.0);
    if is_range && (fewest..=MOST_VALUES).contains(&count) { Ok(Range { low, high, count }) } else { Err(wrong()) }
}
