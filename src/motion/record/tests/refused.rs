//! What is no record, and numbers that can't be used.

use std::path::Path;

use super::{super::read_file, FILE, GIVEN, read, text, wrong};

#[test]
fn what_is_no_text_of_numbers_is_refused() {
    for (file, said) in [
        ("", "an empty file"),
        (" \n\r\n", "an empty file"),
        ("PK\u{3}\u{4}\n0.1\n", "line 1: a binary file (byte 3 is no text)"),
        ("0.1\n0.2\n\0\n", "line 3: a binary file"),
        ("<!DOCTYPE html>\n<html>\n0.1\n", "line 1: `<!DOCTYPE html>` begins a page in HTML or XML"),
        ("\n{\"a\": [0.1]}", "line 1: `{\"a\": [0.1]}` begins a file in JSON or RTF"),
        ("%PDF-1.4\n0.1", "line 1: `%PDF-1.4` begins a PDF"),
        ("not found\n", "line 1: `not found`, and no line of numbers follows"),
        ("A\nNPTS= 4, DT= 0.01\n", "line 2: `NPTS= 4, DT= 0.01`, and no line of numbers follows"),
        ("0.5\n", "1 numbers; a record has at least 2"),
    ] {
        assert!(wrong(file, GIVEN).starts_with(said), "{}", wrong(file, GIVEN));
    }
    let utf_16: Vec<u8> = "\u{feff}0.1\n0.2".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert!(read(&utf_16, &GIVEN).unwrap_err().to_string().starts_with("a text in UTF-16"));
}

#[test]
fn numbers_that_can_not_be_used_are_named_with_their_line() {
    for bad in ["NaN", "-inf", "Infinity", "0x1.8p3", "********", "1e999", "1.5D+400"] {
        for (file, line) in [
            (format!("0.1\n{bad}\n0.3\n"), 2),
            (format!("{bad}\n0.1\n0.3\n"), 1),
            (format!("title\n0.1 0.2 0.3\n0.1 {bad}\n"), 3),
        ] {
            let told = wrong(&file, GIVEN);
            assert!(
                told.starts_with(&format!("line {line}: `{bad}`: ")) && told.contains("expected is a finite number"),
                "{told}"
            );
        }
    }
    for bad in ["0.1o2", "1.2.3", "0.5g", "--0.1", "1.0e", "abc", "12-03-1994"] {
        assert!(wrong(&format!("0.1\n0.2\n{bad}\n0.3\n"), GIVEN).starts_with(&format!("line 3: `{bad}`")), "{bad}");
    }
}

#[test]
fn a_first_sample_with_a_slip_is_no_title() {
    assert!(wrong("0.1o2\n0.2\n0.3\n", GIVEN).starts_with("line 1: `0.1o2`; expected are a title or numbers"));
    assert_eq!(text("2011_tohoku\n0.2\n0.3\n", GIVEN).unwrap().samples, [0.2, 0.3]);
}

#[test]
fn prose_between_numbers_is_refused() {
    assert!(wrong("0.1\n0.2\nthe second part\n0.3\n", GIVEN).starts_with("line 3: `the` in `the second part`"));
    assert!(wrong("0.1\n0.2\n*** end ***\n0.3\n", GIVEN).starts_with("line 3: "));
}

#[test]
fn volumes_that_are_laid_out_otherwise_are_refused() {
    let told = wrong("Uncorrected Accelerogram Data\nsomewhere\n 1 2 3\n 0.1 0.2 0.3\n", GIVEN);
    assert!(
        told.starts_with("line 1: `Uncorrected Accelerogram Data` begins a file that is laid out otherwise"),
        "{told}"
    );
}

#[test]
fn what_a_terminal_would_obey_is_not_shown() {
    let told = wrong(&format!("0.1\n\u{202e}\u{9b}31m{}\n", "ü".repeat(500)), GIVEN);
    assert!(told.contains("...`") && told.len() < 400 && !told.contains('\u{202e}'), "{told}");
}

#[test]
fn units_that_contradict_each_other_are_refused() {
    let told = wrong("units: g\nunits: cm/s2\n0.1\n0.2\n", GIVEN);
    assert!(told.starts_with("line 2: the file says that its units are cm/s2, and g at line 1"), "{told}");
    // Only one of them speaks of units.
    assert_eq!(text("peak 0.3 [g]\nunits: cm/s2\n3 0.1\n1\n2\n3\n", FILE).unwrap().units.to_string(), "cm/s2");
}

#[test]
fn a_file_that_can_not_be_read_is_named() {
    let told = read_file(Path::new("no/such\nfile"), &GIVEN).unwrap_err().to_string();
    assert!(told.starts_with("no/such\u{fffd}file: the record can't be read: "), "{told}");
}
