//! How many samples there are and how far apart, where a header says so.

use super::{
    RecordError,
    error::shown,
    number, rows,
    text::{self, Numbered, place_of, words},
};

/// The number of samples and the time step in seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Counted {
    /// How many samples.
    pub count: usize,
    /// Their distance in seconds.
    pub dt: f64,
    /// The line that says so.
    pub line: usize,
}

/// Where a label ends that is a word of its own, whatever the case.
fn label(line: &[u8], label: &str) -> Option<usize> {
    let start = place_of(line, label)?;
    let is_letter = |byte: Option<&u8>| byte.is_some_and(u8::is_ascii_alphabetic);
    let end = start + label.len();
    let alone = !is_letter(start.checked_sub(1).and_then(|before| line.get(before))) && !is_letter(line.get(end));
    alone.then_some(end)
}

/// The number that follows a label, as in `DT= .005 SEC`, and the rest.
fn assigned(line: &[u8], end: usize) -> Option<(f64, &[u8])> {
    let rest = line.get(end..)?;
    let filling = rest.iter().take_while(|byte| byte.is_ascii_whitespace() || b"=:".contains(byte)).count();
    let rest = rest.get(filling..)?;
    let is_number = rest.first().is_some_and(|byte| byte.is_ascii_digit() || b"+-.".contains(byte));
    text::first_number(rest).filter(|_| is_number)
}

/// Whether a line is the one of a PEER header with the number of points and the time step.
pub fn is_npts_dt(line: &[u8]) -> bool {
    label(line, "NPTS").is_some() && label(line, "DT").is_some()
}

/// Reads the line of a PEER header: `NPTS=  4000, DT= .00500 SEC`, or the older `4000 0.005 NPTS, DT`.
pub fn npts_dt(number: usize, line: &[u8]) -> Result<Counted, RecordError> {
    let wrong = || {
        let message = format!("`{}`; expected is a line such as NPTS= 4000, DT= .00500 SEC", shown(line));
        RecordError::at(number, message)
    };
    let (npts, dt) = (label(line, "NPTS").ok_or_else(wrong)?, label(line, "DT").ok_or_else(wrong)?);
    let (count, (step, unit)) = match (assigned(line, npts), assigned(line, dt)) {
        (Some((count, _)), Some(step)) => (count, step),
        (None, None) => {
            // In the order of their names.
            let (first, rest) = text::first_number(line).ok_or_else(wrong)?;
            let (second, _) = text::first_number(rest).ok_or_else(wrong)?;
            let (count, step) = if npts < dt { (first, second) } else { (second, first) };
            (count, (step, &b""[..]))
        }
        _ => return Err(wrong()),
    };
    let unit = unit.trim_ascii_start();
    let unit = unit.get(..unit.iter().take_while(|byte| byte.is_ascii_alphabetic()).count()).unwrap_or_default();
    let in_seconds = ["", "s", "sec", "secs", "second", "seconds", "npts"]
        .iter()
        .any(|known| unit.eq_ignore_ascii_case(known.as_bytes()));
    if step <= 0.0 && in_seconds {
        return Err(RecordError::at(number, format!("DT = {step} s in `{}`; expected is a step above 0", shown(line))));
    }
    counted(number, count, step).filter(|_| in_seconds).ok_or_else(wrong)
}

/// Reads a line that is only the number of samples and the time step, `4684 0.0100`.
pub fn count_and_step(number: usize, line: &[u8]) -> Option<Counted> {
    let mut fields = rows::fields(line);
    let (count, step, None) = (fields.next()?, fields.next()?, fields.next()) else { return None };
    if !count.iter().all(u8::is_ascii_digit) {
        return None;
    }
    counted(number, number::value(count)?, number::value(step)?).filter(|counted| counted.count > 1)
}

/// Reads prose such as `1559 points at equal spacing of 0.02 sec`.
pub fn equal_spacing(number: usize, line: &[u8]) -> Option<Counted> {
    let (points, spacing) = (place_of(line, " points at equal spacing of ")?, place_of(line, " spacing of ")?);
    let count = words(line.get(..points)?).last().and_then(number::value)?;
    let (step, rest) = text::first_number(line.get(spacing..)?)?;
    let unit = words(rest).next()?;
    counted(number, count, step).filter(|_| unit.get(..3).is_some_and(|unit| unit.eq_ignore_ascii_case(b"sec")))
}

/// Reads the labels `SAMPLING_INTERVAL_S` and `NDATA` of the European and Italian databases (ESM, ITACA: the "dyna" format).
pub fn labelled(head: &[Numbered<'_>]) -> Option<Counted> {
    let value = |label: &str| {
        let (number, line) = head.iter().find(|(_, line)| place_of(line, label) == Some(0))?;
        Some((*number, number::value(line.get(label.len()..)?.trim_ascii())?))
    };
    let (line, dt) = value("SAMPLING_INTERVAL_S:")?;
    counted(line, value("NDATA:")?.1, dt)
}

/// Both numbers, if the first is whole and the second is above 0.
fn counted(line: usize, count: f64, dt: f64) -> Option<Counted> {
    let is_count = count.fract() == 0.0 && (0.0..=1e15).contains(&count);
    (is_count && dt > 0.0).then_some(Counted { count: count as usize, dt, line })
}

impl Counted {
    /// Compares with the number of samples that follow, the last of them in a line.
    pub fn check(self, found: usize, last: usize) -> Result<(), RecordError> {
        if self.count == found {
            return Ok(());
        }
        Err(RecordError::at(
            self.line,
            format!(
                "{} numbers are announced, and {found} follow, the last in line {last}; expected is as many",
                self.count
            ),
        ))
    }
}
