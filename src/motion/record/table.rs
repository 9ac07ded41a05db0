//! Numbers in columns: times and accelerations, or several quantities of which one is asked for; between blanks, tabs, commas or semicolons.
//!
//! The first column is read as times if its title says so, or if it rises evenly; whole numbers that rise by one only count the samples.

use super::{
    Asked, Found, MOST_SAMPLES, RecordError, Step,
    error::{self, shown},
    number::{self, Field},
    rows::{self, Kind},
    text::{Numbered, Text, contains, words},
    time_column::{self, Time},
    units::{self, Named},
};

/// The columns of a line: between commas or semicolons, where an empty one counts, and otherwise between blanks.
fn columns(line: &[u8]) -> Vec<&[u8]> {
    let separator = if line.contains(&b';') { b';' } else { b',' };
    if !line.contains(&separator) {
        return words(line).collect();
    }
    let line = line.strip_suffix(&[separator]).unwrap_or(line);
    line.split(|byte| *byte == separator).map(unquoted).collect()
}

/// A field without blanks and quotes around it.
fn unquoted(field: &[u8]) -> &[u8] {
    let field = field.trim_ascii();
    field.strip_prefix(b"\"").and_then(|field| field.strip_suffix(b"\"")).unwrap_or(field).trim_ascii()
}

/// A column of a line, the first being 1.
fn column(line: &[u8], number: usize) -> Option<&[u8]> {
    let separator = if line.contains(&b';') { b';' } else { b',' };
    let place = number.checked_sub(1)?;
    if line.contains(&separator) {
        return line.split(|byte| *byte == separator).nth(place).map(unquoted);
    }
    words(line).nth(place)
}

/// The first line of data: of numbers only, or with a number in the first column and in the one that is asked.
pub fn first_line(text: &Text<'_>, asked: Option<usize>) -> Option<usize> {
    let is_number = |field: Option<&[u8]>| field.is_some_and(|field| number::field(field) != Field::Other);
    let has =
        |line: &[u8], asked: usize| is_number(column(line, 1)) && is_number(column(line, asked)) && !header_like(line);
    let is_data =
        |line: &[u8]| rows::kind(&unquoted_line(line)) == Kind::Numbers || asked.is_some_and(|asked| has(line, asked));
    text.from(1).find(|(_, line)| is_data(line)).map(|(line, _)| line)
}

/// The old PEER header has a number in front.
fn header_like(line: &[u8]) -> bool {
    contains(line, "NPTS")
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
    let number = columns(line).len();
    let separated = line.contains(&b',') || line.contains(&b';');
    if number < 2 || asked.is_some() || separated || number == 2 || title(text, first) == Title::Time {
        return number > 1 || asked.is_some();
    }
    let firsts: Option<Vec<Time<'_>>> =
        data(text, first, 50).iter().map(|(line, content)| time(*line, content)).collect();
    firsts.is_some_and(|times| times.len() > 2 && time_column::step(&times, Step::OfFile).is_ok())
}

/// What the title of the first column says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Title {
    Time,
    Count,
    Spectrum,
    Other,
}

/// The last header line: the titles of the columns, if it is that.
fn titles<'a>(text: &Text<'a>, first: usize) -> Option<Numbered<'a>> {
    text.from(1).take(first - 1).filter(|(_, line)| !line.is_empty()).last()
}

fn title(text: &Text<'_>, first: usize) -> Title {
    let line = titles(text, first).map_or(&b""[..], |(_, line)| line);
    let is_letter = |byte: &u8| byte.is_ascii_alphabetic();
    let word: Vec<u8> =
        line.iter().skip_while(|byte| !is_letter(byte)).take_while(|byte| is_letter(byte)).copied().collect();
    let is = |known: &[&str]| known.iter().any(|known| word.eq_ignore_ascii_case(known.as_bytes()));
    if is(&["t", "time", "times", "sec", "secs", "second", "seconds", "zeit", "temps", "tiempo", "tempo"]) {
        Title::Time
    } else if is(&["period", "periods", "freq", "frequency", "frequencies"]) {
        Title::Spectrum
    } else if is(&["k", "i", "n", "index", "no", "nr", "number", "sample", "point", "id"]) {
        Title::Count
    } else {
        Title::Other
    }
}

/// The lines of data, up to a mark of the end.
fn data<'a>(text: &Text<'a>, first: usize, most: usize) -> Vec<Numbered<'a>> {
    let lines = text.from(first).filter(|(_, content)| !content.is_empty()).take(most);
    lines.take_while(|(line, _)| !rows::is_end(text, *line)).collect()
}

/// The time in the first column of a line.
fn time(line: usize, content: &[u8]) -> Option<Time<'_>> {
    let typed = column(content, 1)?;
    Some(Time { typed, value: number::value(typed)?, line })
}

/// Reads a table whose data begin at a line.
pub fn read(text: &Text<'_>, first: usize, asked: &Asked) -> Result<Found, RecordError> {
    let number = columns(text.line(first)).len();
    let role = title(text, first);
    if role == Title::Spectrum {
        let (line, content) = titles(text, first).unwrap_or((first, b""));
        return Err(RecordError::at(
            line,
            format!("`{}` is of a spectrum; expected is an acceleration in time", shown(content)),
        ));
    }
    let data = data(text, first, MOST_SAMPLES + 1);
    if data.len() > MOST_SAMPLES {
        return Err(error::too_many());
    }
    for (line, content) in &data {
        let here = columns(content).len();
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
    let mut notes = Vec::new();
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
    let units = units_of(text, first, number, wanted)?;
    Ok(Found { format: "columns", dt, units, samples, notes, has_offset: false })
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
            None if title == Title::Time => {
                return Err(number::error(*line, column(content, 1).unwrap_or_default()));
            }
            None => return Ok(First::Data),
        }
    }
    let pairs = || times.iter().zip(times.iter().skip(1));
    let rises = pairs().filter(|(before, next)| next.value > before.value).count();
    let counts = || times.iter().all(|time| time.typed.iter().all(u8::is_ascii_digit));
    let by_one = || pairs().all(|(before, next)| next.value - before.value == 1.0);
    Ok(match title {
        Title::Time => First::Times(times),
        Title::Count => First::Count,
        _ if counts() && by_one() => First::Count,
        // Noise rises at every second line; a column that nearly always does is one of times, with a slip in it if not always.
        _ if times.len() > 1 && 4 * rises >= 3 * (times.len() - 1) => First::Times(times),
        _ => First::Data,
    })
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

/// The units in the title of the column, if the titles are as many as the columns; otherwise in the header.
fn units_of(
    text: &Text<'_>,
    first: usize,
    number: usize,
    wanted: usize,
) -> Result<Option<(units::Units, usize)>, RecordError> {
    let title = titles(text, first).filter(|(_, line)| columns(line).len() == number);
    let Some((line, title)) = title.and_then(|(line, titles)| Some((line, column(titles, wanted)?))) else {
        return units::of_header(&text.before(first));
    };
    if is_of_other(title) {
        return Err(RecordError::at(
            line,
            format!("the title of the column is `{}`; expected is an acceleration", shown(title)),
        ));
    }
    match units::of_title(title) {
        Some((Named::Known(units), _)) => Ok(Some((units, line))),
        Some((Named::Other, word)) => Err(units::other(line, word)),
        None => units::of_header(&text.before(line)),
    }
}

/// Whether a title has a word such as `vel` or `displacement` in it.
fn is_of_other(title: &[u8]) -> bool {
    let mut words = title.split(|byte| !byte.is_ascii_alphabetic());
    let starts =
        |word: &[u8], with: &[u8]| word.get(..with.len()).is_some_and(|start| start.eq_ignore_ascii_case(with));
    words.any(|word| starts(word, b"vel") || starts(word, b"disp"))
}

/// Refuses decimal commas: a comma between digits where a semicolon, a tab or a blank separates.
fn decimal_comma(line: usize, content: &[u8]) -> Result<(), RecordError> {
    let between =
        content.windows(3).any(|three| matches!(three, [a, b',', b] if a.is_ascii_digit() && b.is_ascii_digit()));
    let separates = content.iter().any(|byte| matches!(byte, b';' | b'\t' | b' '));
    let spaced = content.windows(2).any(|two| two == b", ");
    if between && separates && !spaced && !content.contains(&b'.') {
        let message = format!("`{}` has decimal commas; expected are decimal points", shown(content));
        return Err(RecordError::at(line, message));
    }
    Ok(())
}
