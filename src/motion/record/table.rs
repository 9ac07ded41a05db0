//! Numbers in columns: times and accelerations, or several quantities of which one is asked for; between blanks, tabs, commas or semicolons.
//!
//! The first column is read as times if its title says so, or if it rises evenly; whole numbers that rise by one only count the samples.

use super::{
    Asked, Found, MOST_SAMPLES, RecordError, Step,
    cells::{column, columns, separator},
    error::{self, shown},
    header,
    number::{self, Field},
    rows::{self, Kind},
    text::{Numbered, Text, contains},
    time_column::{self, Time},
    titles::{self, Title},
};

/// The first line of data: of numbers only, or with a number in the first column and in the one that is asked.
pub fn first_line(text: &Text<'_>, asked: Option<usize>) -> Option<usize> {
    let is_number = |field: Option<&[u8]>| field.is_some_and(|field| number::field(field) != Field::Other);
    let has = |line: &[u8], asked: usize| {
        is_number(column(line, 1)) && is_number(column(line, asked)) && !header::is_npts_dt(line)
    };
    let is_data =
        |line: &[u8]| rows::kind(&unquoted_line(line)) == Kind::Numbers || asked.is_some_and(|asked| has(line, asked));
    text.from(1).find(|(_, line)| is_data(line)).map(|(line, _)| line)
}

/// The line without quotes, for those that have any.
fn unquoted_line(line: &[u8]) -> std::borrow::Cow<'_, [u8]> {
    if line.contains(&b'"') {
        return line.iter().copied().filter(|byte| *byte != b'"').collect::<Vec<u8>>().into();
    }
    line.into()
}

/// Whether the numbers from a line on are a table, and not one series written in rows: a column is asked, commas separate, there are two columns, or the
/// first of several rises evenly as times do.
pub fn is(text: &Text<'_>, first: usize, asked: Option<usize>) -> bool {
    let line = text.line(first);
    let number = columns(line);
    if number < 2 {
        return false;
    }
    if number == 2 || asked.is_some() || separator(line).is_some() || titles::first(text, first) == Title::Time {
        return true;
    }
    let firsts: Option<Vec<Time<'_>>> =
        data(text, first, 50).0.iter().map(|(line, content)| time(*line, content)).collect();
    firsts.is_some_and(|times| times.len() > 2 && time_column::step(&times, Step::OfFile).is_ok())
}

/// The lines of data, up to a mark of the end, and what to tell of that.
fn data<'a>(text: &Text<'a>, first: usize, most: usize) -> (Vec<Numbered<'a>>, Option<String>) {
    let mut end = None;
    let lines = text.from(first).filter(|(_, content)| !content.is_empty()).take(most);
    let data = lines.take_while(|(line, _)| {
        end = rows::end(text, *line);
        end.is_none()
    });
    (data.collect(), end)
}

/// The time in the first column of a line.
fn time(line: usize, content: &[u8]) -> Option<Time<'_>> {
    let typed = column(content, 1)?;
    Some(Time { typed, value: number::value(typed)?, line })
}

/// Reads a table whose data begin at a line.
pub fn read(text: &Text<'_>, first: usize, asked: &Asked) -> Result<Found, RecordError> {
    let number = columns(text.line(first));
    let role = titles::first(text, first);
    titles::check(text, first)?;
    let (data, end) = data(text, first, MOST_SAMPLES + 1);
    if data.len() > MOST_SAMPLES {
        return Err(error::too_many());
    }
    for (line, content) in &data {
        let here = columns(content);
        if here != number {
            let message =
                format!("`{}` has {here} columns, line {first} has {number}; expected are as many", shown(content));
            return Err(RecordError::at(*line, message));
        }
        decimal_comma(*line, content)?;
    }
    let times = times(&data, role)?;
    let wanted = wanted(text, first, number, asked.column, &times)?;
    let sample = |(line, content): &Numbered<'_>| {
        let field = column(content, wanted).unwrap_or_default();
        number::value(field).ok_or_else(|| number::error(*line, field))
    };
    let samples = data.iter().map(sample).collect::<Result<_, _>>()?;
    let mut notes: Vec<String> = end.into_iter().collect();
    let dt = match &times {
        First::Times(times) => {
            let dt = time_column::step(times, asked.step)?;
            let start = times.first().filter(|start| start.value != 0.0);
            notes.extend(
                start.map(|start| format!("the times begin at {} s; sample 0 is put at 0", shown(start.typed))),
            );
            Some((dt, first))
        }
        First::Count => {
            notes.push("column 1 counts the samples, and is not read as times".to_owned());
            None
        }
        First::Data => None,
    };
    let units = titles::units(text, first, number, wanted)?;
    Ok(Found { format: "columns", dt, units, samples, start: first, notes, has_offset: false })
}

/// What the first column is.
enum First<'a> {
    Times(Vec<Time<'a>>),
    Count,
    Data,
}

/// Reads the first column: by its title, or else by whether it rises from line to line.
fn times<'a>(data: &[Numbered<'a>], title: Title) -> Result<First<'a>, RecordError> {
    let mut times = Vec::new();
    for (line, content) in data {
        match time(*line, content) {
            Some(time) => times.push(time),
            None => return Err(number::error(*line, column(content, 1).unwrap_or_default())),
        }
    }
    let pairs = || times.iter().zip(times.iter().skip(1));
    // Noise rises at every second line; a column that nearly always does is one of times or counts, with a slip in it if not always.
    let nearly_all = |is: &dyn Fn(&Time<'_>, &Time<'_>) -> bool| {
        times.len() > 1 && 4 * pairs().filter(|(before, next)| is(before, next)).count() >= 3 * (times.len() - 1)
    };
    let is_whole = times.iter().all(|time| time.typed.iter().all(u8::is_ascii_digit));
    let by_one = |before: &Time<'_>, next: &Time<'_>| next.value - before.value == 1.0;
    let counts = title == Title::Count || (title == Title::Other && is_whole && nearly_all(&by_one));
    if counts {
        return match pairs().find(|(before, next)| !by_one(before, next)) {
            Some((before, next)) => {
                let (next_typed, before_typed) = (shown(next.typed), shown(before.typed));
                let message = format!("the count {next_typed} follows {before_typed}; expected is one more");
                Err(RecordError::at(next.line, message))
            }
            None => Ok(First::Count),
        };
    }
    let rises = |before: &Time<'_>, next: &Time<'_>| next.value > before.value;
    Ok(if title == Title::Time || nearly_all(&rises) { First::Times(times) } else { First::Data })
}

/// The column of the acceleration.
fn wanted(
    text: &Text<'_>,
    first: usize,
    number: usize,
    asked: Option<usize>,
    times: &First<'_>,
) -> Result<usize, RecordError> {
    let lowest = if matches!(times, First::Data) { 1 } else { 2 };
    let line = shown(text.line(first));
    match asked {
        Some(asked) if (lowest..=number).contains(&asked) => Ok(asked),
        None if number == 2 && lowest == 2 => Ok(2),
        _ => {
            let said = asked.map_or_else(String::new, |asked| format!(", and column = {asked} is asked"));
            let what = match times {
                First::Times(_) => "the first with times",
                First::Count => "the first counting the samples",
                First::Data if line.contains(',') && !line.contains('.') => {
                    "none with times (a decimal comma has to be a point)"
                }
                First::Data => "none with times",
            };
            let message = format!(
                "`{line}` has {number} columns, {what}{said}; expected is column = {lowest} to {number} in the scene"
            );
            Err(RecordError::at(first, message))
        }
    }
}

/// Refuses decimal commas: a comma between digits where a semicolon, a tab or a blank separates.
fn decimal_comma(line: usize, content: &[u8]) -> Result<(), RecordError> {
    if content.contains(&b'.') || !content.contains(&b',') {
        return Ok(());
    }
    let is_between = |three: &[u8]| matches!(three, [a, b',', b] if a.is_ascii_digit() && b.is_ascii_digit());
    let separates = content.iter().any(|byte| matches!(byte, b';' | b'\t' | b' '));
    if content.windows(3).any(is_between) && separates && !contains(content, ", ") {
        let message = format!("`{}` has decimal commas; expected are decimal points", shown(content));
        return Err(RecordError::at(line, message));
    }
    Ok(())
}
