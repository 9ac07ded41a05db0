//! A line becomes a message, or a verdict that says where it is wrong.

use serde::Deserialize;
use serde_json::error::Category;

use crate::{
    object::{TWICE, UNKNOWN},
    verdict::{Breakdown, Verdict},
};

/// How much of a line is shown on either side of a mistake.
const SHOWN: usize = 40;

/// The message in this line.
pub fn read<'line, T: Deserialize<'line>>(line: &'line [u8]) -> Result<T, Breakdown> {
    let text = std::str::from_utf8(line).map_err(|error| {
        let at = error.valid_up_to();
        let around = excerpt(&String::from_utf8_lossy(line), at);
        Breakdown::new(Verdict::BrokenUtf8, format!("byte {} of the line {around}", at + 1))
    })?;
    serde_json::from_str(text).map_err(|error| wrong(text, &error))
}

fn wrong(text: &str, error: &serde_json::Error) -> Breakdown {
    let message = error.to_string();
    let is_object = text.trim_start().starts_with('{');
    let verdict = match error.classify() {
        Category::Eof if is_object => Verdict::HalfLine,
        _ if !is_object => Verdict::Garbage,
        Category::Syntax if message.starts_with("number out of range") => Verdict::NumberTooLarge,
        Category::Syntax if has_bare_nan(text) => Verdict::BareNan,
        Category::Data if message.starts_with(UNKNOWN) => Verdict::UnknownField,
        Category::Data if message.starts_with(TWICE) => Verdict::FieldTwice,
        Category::Data => Verdict::WrongKind,
        _ => Verdict::Garbage,
    };
    if text.trim().is_empty() {
        return Breakdown::new(verdict, "an empty line");
    }
    if !is_object {
        return Breakdown::new(verdict, excerpt(text, 0));
    }
    // The line of the error is always the first: the column says it all.
    let message = message.split(" at line ").next().unwrap_or_default();
    Breakdown::new(verdict, format!("{message}, at byte {} of {}", error.column(), excerpt(text, error.column())))
}

/// The line around this byte, in quotes.
fn excerpt(text: &str, at: usize) -> String {
    let from = text.floor_char_boundary(at.saturating_sub(SHOWN));
    let to = text.floor_char_boundary(at.saturating_add(SHOWN));
    let cut = |is_cut| if is_cut { "…" } else { "" };
    format!("{:?}", format!("{}{}{}", cut(from > 0), text.get(from..to).unwrap_or_default(), cut(to < text.len())))
}

/// Whether NaN or infinity stands outside of quotes.
fn has_bare_nan(text: &str) -> bool {
    // Every other piece between quotes is outside; a quote inside of a string has a backslash in front.
    let text = text.replace("\\\\", "").replace("\\\"", "");
    text.split('"').step_by(2).any(|outside| {
        let words = outside.split(|character: char| !character.is_ascii_alphabetic());
        words.map(str::to_ascii_lowercase).any(|word| matches!(word.as_str(), "nan" | "inf" | "infinity"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reply::Reply;

    fn verdict(line: &[u8]) -> Verdict {
        read::<Reply>(line).unwrap_err().verdict
    }

    /// Each way in which a line can be wrong has its verdict.
    #[test]
    fn every_wrong_line_has_its_verdict() {
        for (line, expected) in [
            (&b"Loading model"[..], Verdict::Garbage),
            (b"", Verdict::Garbage),
            (b"3.14", Verdict::Garbage),
            (b"nan", Verdict::Garbage),
            (b"{\"seq\":1}{\"seq\":2}", Verdict::Garbage),
            (b"{seq:1}", Verdict::Garbage),
            (b"{\"seq\":1,\"hist", Verdict::HalfLine),
            (b"{\"seq\":1,\"ns\":NaN}", Verdict::BareNan),
            (b"{\"seq\":1,\"ns\":-Infinity}", Verdict::BareNan),
            (b"{\"seq\":1,\"ns\":1e999}", Verdict::NumberTooLarge),
            (b"{\"seq\":1,\"histroy\":{}}", Verdict::UnknownField),
            (b"{\"seq\":1,\"history\":{\"tme\":[]}}", Verdict::UnknownField),
            (b"{\"seq\":1,\"seq\":1}", Verdict::FieldTwice),
            (b"{\"seq\":\"1\"}", Verdict::WrongKind),
            (b"{\"seq\":1,\"history\":{\"time\":[1,true]}}", Verdict::WrongKind),
            (b"{\"seq\":1,\"ns\":\"0.1\"}", Verdict::WrongKind),
            (b"{\"seq\":1,\"ns\":\"\xff\"}", Verdict::BrokenUtf8),
        ] {
            assert_eq!(verdict(line), expected, "{}", String::from_utf8_lossy(line));
        }
    }

    /// The mistake is shown where it is.
    #[test]
    fn a_mistake_is_shown_where_it_is() {
        let told = read::<Reply>(b"{\"seq\":1,\"history\":{\"tme\":[]}}").unwrap_err().happened;
        assert!(told.starts_with("unknown field \"tme\", the protocol has time, interval, velocity"), "{told}");
        assert!(told.contains("at byte 25 of"), "{told}");
        assert!(!has_bare_nan(r#"{"message":"a \"quoted\" nan\\","seq":1}"#));
    }

    /// A name that starts with x- is free, at every depth.
    #[test]
    fn names_of_ones_own_are_free() {
        let reply: Reply = read(br#"{"x-mine":{"a":[1]},"seq":1,"decline":{"reason":"r","x-more":null}}"#).unwrap();
        assert_eq!((reply.seq.map(|seq| seq.0), reply.decline.unwrap().reason.as_deref()), (Some(1), Some("r")));
    }
}
