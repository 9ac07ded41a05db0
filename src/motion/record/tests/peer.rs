//! PEER AT2 in its dialects.

use super::{Asked, FILE, Step, Units, text, wrong};

const SAMPLES: [f64; 7] = [0.001297983, -0.1742817, 0.5, 0.0, -0.0012, 3e-5, 0.25];

fn rows(end: &str) -> String {
    format!("  .1297983E-02  -.1742817E+00   .5000000E+00{end}   .0 -.12D-2 .3-4 .25")
}

fn reads(file: &str) {
    let read = text(file, FILE).unwrap_or_else(|error| panic!("{error} in {file}"));
    assert_eq!((read.samples.as_slice(), read.dt, read.units), (&SAMPLES[..], Some(0.005), Units::G), "{file}");
    assert_eq!(read.format, "PEER AT2");
}

#[test]
fn every_dialect_of_the_header_is_read() {
    let counted = [
        "NPTS=  7, DT= .00500 SEC",
        "NPTS=      7, DT=   .0050 SEC,                    ",
        "NPTS=   7, dt=  .00500",
        "npts = 7 dt = 5.0E-03 s",
        "7    0.0050    NPTS, DT",
        "  7 0.005 NPTS, DT",
        "DT= 0.005 SEC, NPTS= 7",
        "0.005 7 DT, NPTS",
        "RECORD 12: NPTS= 7, DT= .005 SEC, FILTER 0.1 Hz",
        "NPTS=7,DT=.005SEC",
        "the line with NPTS and DT comes next\nNPTS= 7, DT= .005",
    ];
    for line in counted {
        reads(&format!(
            "PEER\nNORTHRIDGE 01/17/94, ARLETA, 360\nACCELERATION TIME HISTORY IN UNITS OF G\n{line}\n{}\n",
            rows("\n")
        ));
    }
}

#[test]
fn lines_of_prose_and_marks_around_the_data_do_not_matter() {
    let rows = rows("\n");
    reads(&format!("Data for El Centro 1940, 7 points\nThe units are (g)\nNPTS= 7, DT= .005 SEC\n{rows}"));
    reads(&format!(
        "a\nb\nc\nd\nUNITS OF G\n*** Begin data ***\nNPTS= 7, DT= .005 SEC\n{rows}\n*** End Data ***\n\n\n"
    ));
    reads(&format!("UNITS OF G\nNPTS= 7, DT= .005 SEC\n*** Begin data ***\n{rows}\n"));
    reads(&format!("UNITS OF G\nNPTS= 7, DT= .005 SEC\n\n{rows}     \n"));
}

#[test]
fn every_end_of_line_counts_as_one_line() {
    for end in ["\n", "\r\n", "\r\r\n", "\r"] {
        reads(&format!("A{end}UNITS OF G{end}NPTS= 7, DT= .005 SEC{end}{}", rows(end)));
        let told = wrong(&format!("A{end}UNITS OF G{end}NPTS= 7, DT= .005 SEC{end}0.1{end}0.2 x{end}"), FILE);
        assert!(told.starts_with("line 5: `x`"), "{told}");
    }
}

#[test]
fn a_count_that_is_not_that_of_the_numbers_is_said_with_both() {
    for (count, found) in [(8, 7), (6, 7)] {
        let told = wrong(&format!("A\nUNITS OF G\nNPTS= {count}, DT= .005 SEC\n{}", rows("\n")), FILE);
        assert!(
            told.starts_with(&format!("line 3: {count} numbers are announced, and {found} follow, the last in line 5")),
            "{told}"
        );
    }
}

#[test]
fn numbers_that_touch_are_two() {
    let read = text("UNITS OF G\nNPTS= 4, DT= .005\n0.1-0.2\n1.5E-3-2.5\n", FILE).unwrap();
    assert_eq!(read.samples, [0.1, -0.2, 0.0015, -2.5]);
}

#[test]
fn what_the_scene_says_has_to_agree_with_the_file() {
    let file = format!("ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 7, DT= .005 SEC\n{}", rows("\n"));
    let units = Asked { units: Some(Units::CentimetresPerSecondSquared), ..FILE };
    assert!(wrong(&file, units).starts_with("line 1: the file says that its units are g, the scene units = \"cm/s2\""));
    let step = Asked { step: Step::Seconds(0.01), ..FILE };
    assert!(
        wrong(&file, step).starts_with("line 2: the file says that its time step is 0.005 s, the scene dt = 0.01 s")
    );
    let both = Asked { units: Some(Units::G), step: Step::Seconds(0.005 * (1.0 + 1e-12)), column: None };
    assert_eq!(text(&file, both).unwrap().dt, Some(0.005));
    assert!(wrong(&file, Asked { column: Some(2), ..FILE }).contains("one series"));
}

#[test]
fn other_units_are_read_and_no_units_are_refused() {
    for (named, units) in [
        ("UNITS OF CM/S/S", Units::CentimetresPerSecondSquared),
        ("UNITS: cm/s^2", Units::CentimetresPerSecondSquared),
        ("units = Gal", Units::CentimetresPerSecondSquared),
        ("in m/s2 (units: m/sec^2)", Units::MetresPerSecondSquared),
        ("Acceleration [m/s**2]", Units::MetresPerSecondSquared),
    ] {
        let read = text(&format!("{named}\nNPTS= 2, DT= .005 SEC\n0.1 0.2\n"), FILE).unwrap();
        assert_eq!(read.units, units, "{named}");
    }
    let told = wrong("ACCELERATION\nNPTS= 2, DT= .005 SEC\n0.1 0.2\n", FILE);
    assert!(told.contains("does not name its units") && told.contains("\"threshold\""), "{told}");
    let told = wrong("ACCELERATION, UNITS OF MG\nNPTS= 2, DT= .005 SEC\n0.1 0.2\n", FILE);
    assert!(told.starts_with("line 1: the units are `MG`"), "{told}");
}

#[test]
fn velocities_displacements_and_spectra_are_refused() {
    for (line, what) in [
        ("VELOCITY TIME SERIES IN UNITS OF CM/S", "velocity"),
        ("DISPLACEMENT TIME HISTORY IN UNITS OF CM", "displacement"),
        ("Pseudo spectral acceleration in units of g", "spectrum"),
    ] {
        let told = wrong(&format!("PEER\n{line}\nNPTS= 2, DT= .005 SEC\n0.1 0.2\n"), FILE);
        assert!(told.starts_with(&format!("line 2: `{line}` is of a {what}")), "{told}");
    }
}

#[test]
fn a_line_of_count_and_step_that_is_none_is_refused() {
    for line in ["NPTS= , DT= .005", "NPTS= 7.5, DT= .005", "NPTS= 7, DT= 5 MSEC", "NPTS= 7, DT", "NPTS, DT"] {
        let told = wrong(&format!("UNITS OF G\n{line}\n0.1 0.2\n"), FILE);
        assert!(told.starts_with(&format!("line 2: `{line}`; expected is a line such as NPTS= 4000")), "{told}");
    }
}
