//! Text without a font: how wide it may be, where lines break, and subscripts (`_{...}`) and superscripts (`^{...}`).
//!
//! The viewer's font is not known, so widths are those of a wide one (DejaVu Sans). Many fonts have no `⁻`, and viewers then take the whole line
//! from another one; so raised characters are written as superscripts too.

/// The size of a subscript or superscript.
pub(super) const SMALL: f64 = 0.72;

/// Where a piece of a line stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Level {
    Base,
    Subscript,
    Superscript,
}

impl Level {
    /// The size of its letters, by that of the line.
    pub(super) fn size(self) -> f64 {
        if self == Self::Base { 1.0 } else { SMALL }
    }

    /// How far its letters stand below the line, by the size of the line.
    pub(super) fn below(self) -> f64 {
        match self {
            Self::Base => 0.0,
            Self::Subscript => 0.24,
            Self::Superscript => -0.38,
        }
    }
}

/// A piece of a line, and where it stands.
pub(super) type Piece = (Level, String);

/// The pieces of a line, raised characters among the superscripts.
pub(super) fn pieces(line: &str) -> Vec<Piece> {
    let lowered = |(level, text): Piece| match level {
        Level::Base => with_raised(&text),
        _ => vec![(level, text)],
    };
    marked(line).into_iter().flat_map(lowered).collect()
}

/// A text taken apart into what is raised in it, as plain characters, and the rest.
fn with_raised(text: &str) -> Vec<Piece> {
    const RAISED: [char; 11] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹', '⁻'];
    const PLAIN: [char; 11] = ['0', '1', '2', '3', '4', '5', '6', '7', '8', '9', '−'];
    let mut pieces: Vec<Piece> = Vec::new();
    for letter in text.chars() {
        let plain = RAISED.iter().zip(PLAIN).find(|(raised, _)| **raised == letter).map(|(_, plain)| plain);
        let (level, letter) = plain.map_or((Level::Base, letter), |plain| (Level::Superscript, plain));
        match pieces.last_mut() {
            Some((last, piece)) if *last == level => piece.push(letter),
            _ => pieces.push((level, letter.into())),
        }
    }
    pieces
}

/// The pieces of a line as they are marked, without control characters. A mark that is not closed is text.
fn marked(line: &str) -> Vec<Piece> {
    let clean: String = line.chars().filter(|letter| !letter.is_control()).collect();
    let mut pieces = Vec::new();
    let mut add = |level, text: &str| {
        if !text.is_empty() {
            pieces.push((level, text.to_owned()));
        }
    };
    let mut rest = clean.as_str();
    while let Some((before, level, small, after)) = first_script(rest) {
        add(Level::Base, before);
        add(level, small);
        rest = after;
    }
    add(Level::Base, rest);
    pieces
}

/// What stands before, in and after the first subscript or superscript.
fn first_script(text: &str) -> Option<(&str, Level, &str, &str)> {
    let open = [("_{", Level::Subscript), ("^{", Level::Superscript)];
    let starts = open.into_iter().filter_map(|(mark, level)| Some((text.find(mark)?, mark, level)));
    let (_, mark, level) = starts.min_by_key(|(start, ..)| *start)?;
    let (before, rest) = text.split_once(mark)?;
    let (small, after) = rest.split_once('}')?;
    Some((before, level, small, after))
}

/// The line where nothing can be lowered or raised: `a_cr`, `ε^(3/2)`.
pub(super) fn plain(line: &str) -> String {
    let spelt = |(level, text)| match level {
        Level::Base => text,
        Level::Subscript => format!("_{text}"),
        Level::Superscript => format!("^({text})"),
    };
    marked(line).into_iter().map(spelt).collect()
}

/// The greatest width that `text` at `size` pixels may take.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let of_one = |(level, text): &Piece| text.chars().map(advance).sum::<f64>() * level.size();
    pieces(text).iter().map(of_one).sum::<f64>() * size
}

/// The width of a letter at size 1.
fn advance(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' | 'I' | '|' | '\'' | ' ' | '.' | ',' | ':' | ';' | '/' | '!' => 0.34,
        'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '-' => 0.42,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scripts_are_taken_apart() {
        use Level::{Base, Subscript, Superscript};
        let of = |line: &str| pieces(line);
        let piece = |level, text: &str| (level, text.to_owned());
        assert_eq!(
            of("τ_{ch}/ε^{1/2}, a_{cr}"),
            [
                piece(Base, "τ"),
                piece(Subscript, "ch"),
                piece(Base, "/ε"),
                piece(Superscript, "1/2"),
                piece(Base, ", a"),
                piece(Subscript, "cr")
            ]
        );
        assert_eq!(of("a_cr and _{"), [piece(Base, "a_cr and _{")]);
        assert_eq!(of("one\ntwo"), [piece(Base, "onetwo")]);
        assert_eq!(
            of("2×10⁻¹² η²"),
            [piece(Base, "2×10"), piece(Superscript, "−12"), piece(Base, " η"), piece(Superscript, "2")]
        );
        assert_eq!(plain("η² of τ_{ch}"), "η² of τ_ch");
        assert_eq!(plain("τ_{ch} of ε^{3/2}"), "τ_ch of ε^(3/2)");
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
