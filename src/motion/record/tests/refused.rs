//! What is no record, and numbers that can't be used.

use std::path::Path;

use super::{super::read_file, Asked, FILE, GIVEN, Step, read, text, wrong};

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

#[test]
fn a_line_that_names_two_units_is_refused() {
    for (line, both) in [
        ("IN UNITS OF G (CM/S2)", "`G` and `CM/S2`"),
        ("units: cm/s2, g", "`cm/s2` and `g`"),
        ("UNITS OF G (MM/S2)", "`G` and `MM/S2`"),
        ("peak [g] of [m/s2]", "`g` and `m/s2`"),
    ] {
        let told = wrong(&format!("A\n{line}\nNPTS= 2, DT= .01 SEC\n.1 .2\n"), FILE);
        assert_eq!(told, format!("line 2: two units are named, {both}; expected is one of them"));
    }
    assert!(
        wrong("time, acc (g) [cm/s2]\n0,1\n1,2\n", FILE).starts_with("line 1: two units are named, `g` and `cm/s2`")
    );
    assert!(wrong("UNITS OF 0.01 G\n.1\n.2\n", GIVEN).starts_with("line 1: the units are `0.01`"));
    // The same twice, a quantity, and other quantities than an acceleration contradict nothing.
    for line in
        ["UNITS OF CM/S2 (GAL)", "units: cm/s2, peak 0.3 g", "UNITS: CM/SEC/SEC, CM/SEC, CM", "units=cm/sec2(04)"]
    {
        let read = text(&format!("{line}\nNPTS= 2, DT= .01 SEC\n.1 .2\n"), FILE).unwrap();
        assert_eq!(read.units.to_string(), "cm/s2", "{line}");
    }
}

#[test]
fn a_mark_of_the_end_is_told_and_only_taken_at_the_end() {
    for file in [
        "0.1\n0.2\nEnd of record\n",
        "NPTS= 2, DT= .02\n0.1 0.2\nEnd of record\n\n",
        "0.00, 0.1\n0.02, 0.2\nEnd of record\n",
    ] {
        let read = text(file, GIVEN).unwrap_or_else(|error| panic!("{error} in {file:?}"));
        assert_eq!(read.samples, [0.1, 0.2], "{file:?}");
        assert!(
            read.notes.iter().any(|note| note.ends_with(", `End of record`, ends the numbers")),
            "{:?}",
            read.notes
        );
    }
    for (file, line) in [
        ("0.1\nEnd of record\n0.2\n", 2),
        ("NPTS= 2, DT= .02\nEnd of record\n0.1 0.2\n", 2),
        ("0.00, 0.1\nEnd of record\n0.02, 0.2\n", 2),
        // A row of numbers, and a word that only has the letters in it.
        ("0.1 0.2\n-0.1 0.2 end\n", 2),
        ("0.1\n0.2\nSendai\n", 3),
    ] {
        assert!(wrong(file, GIVEN).starts_with(&format!("line {line}: ")), "{}", wrong(file, GIVEN));
    }
}

#[test]
fn a_row_with_a_slip_is_no_header() {
    for (file, said) in [
        (
            "NPTS= 4, DT= .01\n.1 abc\n.3 .4\n",
            "line 1: 4 numbers are announced, and 2 follow, the last in line 3; expected is as many; none is in line 2, `.1 abc`",
        ),
        ("NPTS= 6, DT= .01\n.1 abc .2\n.3 .4 .5\n", "line 2: `abc` in `.1 abc .2`"),
        (
            "NPTS= 3, DT= .01\nabc\n.3\n.4\n",
            "line 1: 3 numbers are announced, and 2 follow, the last in line 4; expected is as many; none is in line 2, `abc`",
        ),
        (
            "time, acc\n0.00, abc\n0.01, 0.2\n0.02, 0.3\n",
            "line 2: `abc` in `0.00, abc`; expected are a title or numbers",
        ),
        ("time, acc\n0, 1F\n0.01, 0.2\n0.02, 0.3\n", "line 2: `1F` in `0, 1F`, perhaps a hexadecimal number"),
    ] {
        let told = wrong(file, Asked { step: Step::OfFile, ..GIVEN });
        assert!(told.starts_with(said), "{told}");
    }
}

#[test]
fn hexadecimal_numbers_are_called_so() {
    for (file, said) in [
        ("time,acc\n0.0,0x1F\n0.1,0x2A\n", "line 2: `0x1F`: a hexadecimal number; expected is a finite number"),
        ("time,acc\n0.0,1F\n0.1,2A\n", "line 2: `1F` in `0.0,1F`, perhaps a hexadecimal number; expected are numbers"),
        ("0.1\n3FB9\n0.2\n", "line 2: `3FB9`: a hexadecimal number"),
    ] {
        assert!(wrong(file, Asked { step: Step::OfFile, ..GIVEN }).starts_with(said), "{}", wrong(file, GIVEN));
    }
}

#[test]
fn a_step_of_nothing_is_called_so() {
    for line in ["NPTS= 4, DT= 0 SEC", "npts=4 dt=-0.01", "4 0.0 NPTS, DT"] {
        let told = wrong(&format!("UNITS OF G\n{line}\n.1 .2\n.3 .4\n"), FILE);
        assert!(
            told.starts_with("line 2: DT = ") && told.ends_with(&format!("s in `{line}`; expected is a step above 0")),
            "{told}"
        );
    }
}
