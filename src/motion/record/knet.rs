//! K-NET and KiK-net (NIED, Japan): 17 header lines with their labels in the first 18 characters, and integer counts, eight a line.
//!
//! `Scale Factor 3920(gal)/6182761` makes gals of counts; `Sampling Freq(Hz) 100Hz` and `Duration Time(s)` tell how many there are. The offset of the
//! instrument is in the counts, `Max. Acc. (gal)` is counted from their mean (NIED, "About K-NET ASCII format", and its page for KiK-net).

use super::{
    Found, RecordError, Units,
    error::shown,
    fixed, number, peak, rows,
    text::{Text, contains, first_number, place_of},
};

const HEADER: usize = 17;

/// Whether a file has the header.
pub fn is(text: &Text<'_>) -> bool {
    text.find(1, HEADER, "Scale Factor").is_some() && text.find(1, HEADER, "Sampling Freq").is_some()
}

/// Reads a file.
pub fn read(text: &Text<'_>) -> Result<Found, RecordError> {
    let (scale_line, (gal, divisor)) = scale(text)?;
    let (frequency_line, frequency) = value(text, "Sampling Freq(Hz)")?;
    let first = text.find(1, HEADER, "Memo").map_or(HEADER + 1, |memo| memo + 1);
    let rows::Block { numbers: counts, end, .. } = rows::numbers(text, first)?;
    if let Some(count) = counts.iter().find(|count| count.fract() != 0.0) {
        return Err(RecordError::at(first, format!("the count {count}; expected are whole numbers from here on")));
    }
    let (duration_line, duration) = value(text, "Duration Time(s)")?;
    let announced = (duration * frequency).round();
    if announced != counts.len() as f64 {
        return Err(fixed::fewer(duration_line, announced as usize, counts.len()));
    }
    // Counts are whole: the product is exact, and the quotient the only rounding.
    let samples: Vec<f64> = counts.iter().map(|count| count * gal / divisor).collect();
    let mean = samples.iter().sum::<f64>() / samples.len().max(1) as f64;
    let from_mean: Vec<f64> = samples.iter().map(|sample| sample - mean).collect();
    let said = value(text, "Max. Acc.").or_else(|_| value(text, "Max Acc.")).ok();
    let notes = end.into_iter().chain(said.and_then(|(line, said)| peak::differs(said, 1e-3, line, &from_mean)));
    Ok(Found {
        format: "K-NET",
        dt: Some((1.0 / frequency, frequency_line)),
        units: Some((Units::CentimetresPerSecondSquared, scale_line)),
        samples,
        start: first,
        notes: notes.collect(),
        has_offset: true,
    })
}

/// The number behind a label, which has to be above 0, and its line.
fn value(text: &Text<'_>, label: &str) -> Result<(usize, f64), RecordError> {
    let wrong = |line: usize| {
        let message = format!("`{}`; expected is {label} and a number above 0", shown(text.line(line)));
        RecordError::at(line, message)
    };
    let line = text.find(1, HEADER, label).ok_or_else(|| wrong(1))?;
    let content = text.line(line);
    // `Max. Acc. (gal)` has its unit before the number.
    let after = place_of(content, label).and_then(|place| content.get(place + label.len()..)).unwrap_or_default();
    match first_number(after.trim_ascii_start().strip_prefix(b"(gal)").unwrap_or(after)) {
        Some((value, _)) if value > 0.0 => Ok((line, value)),
        _ => Err(wrong(line)),
    }
}

/// The scale factor as `3920(gal)/6182761`, and its line.
fn scale(text: &Text<'_>) -> Result<(usize, (f64, f64)), RecordError> {
    let line = text.find(1, HEADER, "Scale Factor").unwrap_or(1);
    let content = text.line(line);
    let parts = || {
        let (gal, rest) = first_number(content)?;
        let divisor = rest.strip_prefix(b"(gal)/").or(rest.strip_prefix(b"(Gal)/"))?;
        let divisor = number::value(divisor.trim_ascii()).filter(|divisor| *divisor > 0.0)?;
        (gal > 0.0 && !contains(rest, "null")).then_some((line, (gal, divisor)))
    };
    parts().ok_or_else(|| {
        RecordError::at(line, format!("`{}`; expected is a scale factor such as 3920(gal)/6182761", shown(content)))
    })
}
