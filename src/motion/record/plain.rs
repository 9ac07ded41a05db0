//! Files that no format claims: header lines, if any, and numbers in rows or columns.
//!
//! A header may count the samples and give the step: the line with `NPTS` and `DT` of a PEER file, a line that is only `4684 0.0100` (as eqsig and many
//! teaching examples write), or prose such as `1559 points at equal spacing of 0.02 sec`.

use super::{
    Asked, Found, RecordError, at2,
    cells::{column, columns, separator},
    error::shown,
    header::{self, Counted},
    number, one_series, refuse,
    rows::{self, Block},
    table,
    text::{Numbered, Text, contains},
    units,
};

/// Reads a file.
pub fn read(text: &Text<'_>, asked: &Asked) -> Result<Found, RecordError> {
    let first = table::first_line(text, asked.column).ok_or_else(|| nothing(text))?;
    let head = text.before(first);
    refuse::other_than_acceleration(&head)?;
    refuse::unknown_volume(&head)?;
    let mut candidates = head.iter().filter(|(_, line)| header::is_npts_dt(line));
    // Prose may speak of both before the line that gives them.
    let is_given = |(number, line): &&Numbered<'_>| header::npts_dt(*number, line).is_ok();
    if let Some((line, _)) = candidates.clone().find(is_given).or_else(|| candidates.next()) {
        return one_series(at2::read(text, *line)?, asked.column);
    }
    almost_a_number(text, first)?;
    let numbered = counted(text, first);
    if numbered.is_none() && table::is(text, first, asked.column) {
        return table::read(text, first, asked);
    }
    let prose = || head.iter().find_map(|(number, line)| header::equal_spacing(*number, line));
    let counted = numbered.or_else(|| header::labelled(&head)).or_else(prose);
    let start = numbered.and_then(|counted| rows::first(text, counted.line + 1)).unwrap_or(first);
    one_series(series(text, &head, start, counted)?, asked.column)
}

/// Reads numbers in rows, after a header.
fn series(
    text: &Text<'_>,
    head: &[Numbered<'_>],
    start: usize,
    counted: Option<Counted>,
) -> Result<Found, RecordError> {
    let block = rows::numbers(text, start)?;
    let lone = lone_count(text, start);
    let is_counted = counted.is_some() || lone.is_some();
    let Block { numbers: mut samples, last, end, .. } = if is_counted { block } else { block.even()? };
    let mut dt = counted.map(|counted| (counted.dt, counted.line));
    if let Some(counted) = counted {
        counted.check(samples.len(), last)?;
    } else if let Some(count) = lone {
        // The count, or the count and the step, each in a line of its own.
        let step = samples.get(1).copied().filter(|step| *step > 0.0 && samples.len() == count + 2);
        dt = step.map(|step| (step, start + 1));
        samples.drain(..1 + usize::from(step.is_some()));
        Counted { count, dt: 0.0, line: start }.check(samples.len(), last)?;
    }
    Ok(Found {
        format: "numbers in rows",
        dt,
        units: units::of_header(head)?,
        samples,
        start,
        notes: end.into_iter().collect(),
        ..Found::default()
    })
}

/// The number of samples, if the first line of numbers is only that: whole and above 1, before numbers that have a point.
fn lone_count(text: &Text<'_>, first: usize) -> Option<usize> {
    let line = text.line(first).trim_ascii();
    let is_alone = line.iter().all(u8::is_ascii_digit) && text.line(rows::first(text, first + 1)?).contains(&b'.');
    std::str::from_utf8(line).ok()?.parse().ok().filter(|count| is_alone && *count > 1)
}

/// The count and the step, if the first line of numbers is only that: whole, above 1, and followed by lines of another kind or by as many numbers.
fn counted(text: &Text<'_>, first: usize) -> Option<Counted> {
    let counted = header::count_and_step(first, text.line(first))?;
    let fields = |line: usize| rows::fields(text.line(line)).count();
    let next = rows::first(text, first + 1)?;
    let as_many = || rows::numbers(text, next).is_ok_and(|block| block.numbers.len() == counted.count);
    (fields(next) != 2 || as_many()).then_some(counted)
}

/// Refuses a last header line that is a row with a slip in it: a sample that would be lost.
fn almost_a_number(text: &Text<'_>, first: usize) -> Result<(), RecordError> {
    let Some((line, content)) = text.from(1).take(first - 1).filter(|(_, line)| !line.is_empty()).last() else {
        return Ok(());
    };
    let begins_with_a_slip = rows::fields(content).next().is_some_and(|field| {
        let field = field.strip_prefix(b"-").or(field.strip_prefix(b"+")).unwrap_or(field);
        let digits = field.iter().take_while(|byte| byte.is_ascii_digit()).count();
        field.get(digits) == Some(&b'.') && field.get(digits + 1).is_some_and(u8::is_ascii_digit)
    });
    let is_row = begins_with_a_slip || separator(content).is_some() && begins_with_a_number(content);
    match no_number(content).filter(|_| is_row && columns(content) == columns(text.line(first))) {
        Some(field) => Err(slip(line, field, content, "a title or numbers")),
        None => Ok(()),
    }
}

fn begins_with_a_number(line: &[u8]) -> bool {
    column(line, 1).is_some_and(|field| number::value(field).is_some())
}

/// The first field that is no number.
fn no_number(line: &[u8]) -> Option<&[u8]> {
    rows::fields(line).find(|field| number::value(field).is_none())
}

/// What is wrong with a row that has a slip in it.
fn slip(line: usize, field: &[u8], content: &[u8], expected: &str) -> RecordError {
    let inside = if field == content.trim_ascii() { String::new() } else { format!(" in `{}`", shown(content)) };
    let hint = if number::is_hexadecimal(field) { ", perhaps a hexadecimal number" } else { "" };
    RecordError::at(line, format!("`{}`{inside}{hint}; expected are {expected}", shown(field)))
}

/// There are no numbers.
fn nothing(text: &Text<'_>) -> RecordError {
    // Rows that begin with numbers, each with a field that is none.
    let lines: Vec<Numbered<'_>> = text.from(1).filter(|(_, line)| !line.is_empty()).collect();
    let is_row = |line: &[u8]| columns(line) > 1 && begins_with_a_number(line) && !header::is_npts_dt(line);
    let rows = lines.iter().zip(lines.iter().skip(1));
    let row = rows
        .map(|(row, next)| (*row, next.1))
        .find(|((_, row), next)| is_row(row) && is_row(next) && columns(row) == columns(next));
    if let Some(((line, content), _)) = row {
        return slip(line, no_number(content).unwrap_or(content), content, "numbers");
    }
    let counted = text.from(1).find(|(_, line)| header::is_npts_dt(line));
    let prose = text.from(1).find(|(_, line)| !line.is_empty());
    let (line, content) = counted.or(prose).unwrap_or((1, b""));
    let title = if contains(content, "html") { ", a web page" } else { "" };
    RecordError::at(
        line,
        format!("`{}`{title}, and no line of numbers follows; expected are the samples", shown(content)),
    )
}
