//! Text without a font: how wide it may be, where lines break, and subscripts.
//!
//! The viewer's font is not known, so widths are those of a wide one (DejaVu Sans). A subscript is written `_{...}`; on its way through
//! the drawing library, which escapes tags, it is marked by characters for private use.

const SUBSCRIPT: char = '\u{E000}';
const CLOSE: char = '\u{E001}';
const RAISE: char = '\u{E002}';
/// The size of a subscript.
const SMALL: f64 = 0.72;

/// The greatest width that `text` at `size` pixels may take.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let mut small = false;
    let mut sum = 0.0;
    for letter in encode(text).chars() {
        match letter {
            SUBSCRIPT => small = true,
            CLOSE => small = false,
            RAISE => {}
            _ => sum += advance(letter) * if small { SMALL } else { 1.0 },
        }
    }
    sum * size
}

/// The width of a letter at size 1.
fn advance(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' | 'I' | '|' | '\'' | ' ' | '.' | ',' | ':' | ';' | '/' | '!' => 0.34,
        'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '-' => 0.42,
        '⁰'..='⁹' | '⁻' | '¹' | '²' | '³' => 0.45,
        'm' | 'w' | 'M' | 'W' | '@' | '—' | '%' => 1.0,
        '+' | '−' | '×' | '=' | '<' | '>' | '≤' | '≥' | '≈' | '±' | '→' => 0.84,
        'A'..='Z' | 'ω' | 'Γ'..='Ω' => 0.8,
        'a'..='z' | '0'..='9' => 0.64,
        '\u{1100}'.. => 1.0,
        _ => 0.68,
    }
}

/// `text` in lines no wider than `room` where words allow; a no-break space joins. At least one line unless `text` is blank.
pub(super) fn wrap(text: &str, size: f64, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_ascii_whitespace() {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// `text` with its subscripts marked.
pub(super) fn encode(text: &str) -> String {
    let is_plain = |letter: &char| !letter.is_control() && ![SUBSCRIPT, CLOSE, RAISE].contains(letter);
    let clean: String = text.chars().filter(is_plain).collect();
    let mut marked = String::new();
    let mut rest = clean.as_str();
    let mut raised = false;
    while let Some((before, small, after)) = subscript(rest) {
        marked.push_str(before);
        if raised {
            marked.push(CLOSE);
        }
        marked.push(SUBSCRIPT);
        marked.push_str(small);
        marked.push(CLOSE);
        raised = !after.is_empty();
        if raised {
            marked.push(RAISE);
        }
        rest = after;
    }
    marked.push_str(rest);
    if raised {
        marked.push(CLOSE);
    }
    marked
}

/// What stands before, in and after the first subscript.
fn subscript(text: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = text.split_once("_{")?;
    let (small, after) = rest.split_once('}')?;
    Some((before, small, after))
}

/// The finished `svg` with the marks of [`encode`] as SVG.
pub(super) fn decode(svg: &str) -> String {
    const DOWN: f64 = 0.25;
    svg.replace(SUBSCRIPT, &format!(r#"<tspan dy="{DOWN}em" font-size="{SMALL}em">"#))
        .replace(RAISE, &format!(r#"<tspan dy="{}em">"#, -DOWN * SMALL))
        .replace(CLOSE, "</tspan>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subscripts_become_spans() {
        let marked = decode(&encode("τ_{ch}/T < a_{cr}"));
        let (down, up) = (r#"<tspan dy="0.25em" font-size="0.72em">"#, r#"<tspan dy="-0.18em">"#);
        assert_eq!(marked, format!("τ{down}ch</tspan>{up}/T < a</tspan>{down}cr</tspan>"));
        assert_eq!(decode(&encode("a_cr and _{")), "a_cr and _{");
    }

    #[test]
    fn lines_keep_to_the_room() {
        let lines = wrap("one two  three four", 10.0, 60.0);
        assert_eq!(lines.join(" "), "one two three four");
        assert!(lines.len() > 1 && lines.iter().all(|line| width(line, 10.0) <= 60.0));
        assert_eq!(wrap("incomprehensibilities", 10.0, 5.0).len(), 1);
        assert!(wrap(" ", 10.0, 5.0).is_empty());
    }

    #[test]
    fn a_subscript_is_narrower() {
        assert!(width("a_{cr}", 10.0) < width("acr", 10.0));
    }
}
