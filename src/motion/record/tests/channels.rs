//! SMC, COSMOS, CSMIP and K-NET.

use std::fmt::Write;

use super::{Asked, FILE, Step, Units, text, wrong};

/// A block of header values in which some, counted from 1, are given and the others not known.
fn block(count: usize, a_line: usize, width: usize, unknown: &str, known: &[(usize, &str)]) -> String {
    (1..=count).fold(String::new(), |mut block, number| {
        let value = known.iter().find(|(place, _)| *place == number).map_or(unknown, |(_, value)| value);
        let end = if number % a_line == 0 || number == count { "\n" } else { "" };
        write!(block, "{value:>width$}{end}").unwrap();
        block
    })
}

pub fn smc(first: &str, count: usize, rate: &str, digits: &str, rows: &str) -> String {
    let integers = block(48, 8, 10, "-32768", &[(16, "2"), (17, &count.to_string()), (47, digits)]);
    let reals = block(50, 5, 15, "0.1700000E+39", &[(2, rate), (30, "0.2000000E+01"), (32, "-0.3000000E+01")]);
    format!("{first}\n{}{integers}{reals}|\n|ref - somebody, 1989\n{rows}\n", "*\n".repeat(10))
}

const CORRECTED: &str = "2 CORRECTED ACCELEROGRAM       ";
const SMC_ROWS: &str = " 1.5057E+0-2.2223E+0-1.9234E-2-3.0000E+0 2.0000E+0-3.5638E-9 0.0000E+0-5.7933E-1\n-5.5295E-1";

#[test]
fn smc_has_columns_that_touch() {
    let read = text(&smc(CORRECTED, 9, "0.2000000E+03", "-32768", SMC_ROWS), FILE).unwrap();
    assert_eq!(read.samples, [1.5057, -2.2223, -0.019234, -3.0, 2.0, -3.5638e-9, 0.0, -0.57933, -0.55295]);
    assert_eq!((read.dt, read.units, read.format), (Some(0.005), Units::CentimetresPerSecondSquared, "SMC"));
    assert!(!read.notes.iter().any(|note| note.starts_with("line")), "{:?}", read.notes);
    let wide = text(&smc(CORRECTED, 2, "0.2000000E+03", "8", "  1.5057123E+0 -2.2223456E+0"), FILE).unwrap();
    assert_eq!(wide.samples, [1.5057123, -2.2223456]);
    assert!(
        wide.notes[0].starts_with("line 23 says that the peak is 3, but the largest sample is 2.2223456"),
        "{:?}",
        wide.notes
    );
}

#[test]
fn smc_that_is_something_else_is_refused() {
    for first in ["3 VELOCITY", "4 DISPLACEMENT", "5 RESPONSE SPECTRA", "0 UNKNOWN"] {
        let told = wrong(&smc(first, 9, "0.2000000E+03", "-32768", SMC_ROWS), FILE);
        assert!(told.starts_with(&format!("line 1: `{first}`; expected is 2 CORRECTED ACCELEROGRAM")), "{told}");
    }
    let pairs = smc("1 UNCORRECTED ACCELEROGRAM", 9, "0.1700000E+39", "-32768", SMC_ROWS);
    assert!(wrong(&pairs, FILE).contains("pairs of unevenly spaced times and accelerations"));
    let asked = Asked { units: Some(Units::G), ..FILE };
    assert!(
        wrong(&smc(CORRECTED, 9, "0.2000000E+03", "-32768", SMC_ROWS), asked)
            .contains("cm/s2, the scene units = \"g\"")
    );
}

#[test]
fn smc_with_another_number_of_values_is_refused() {
    let told = wrong(&smc(CORRECTED, 10, "0.2000000E+03", "-32768", SMC_ROWS), FILE);
    assert!(told.starts_with("line 14: 10 numbers are announced, and 9 follow"), "{told}");
    let told = wrong(&smc(CORRECTED, 8, "0.2000000E+03", "-32768", SMC_ROWS), FILE);
    assert!(told.starts_with("line 31: `-5.5295E-1`; expected is the end after 8 values"), "{told}");
    let overflow = SMC_ROWS.replace("-5.5295E-1", "**********");
    let told = wrong(&smc(CORRECTED, 9, "0.2000000E+03", "-32768", &overflow), FILE);
    assert!(told.starts_with("line 31: `**********`: a number that did not fit"), "{told}");
}

fn cosmos(title: &str, code: &str, interval: &str, announced: &str, rows: &str) -> String {
    let integers = block(100, 10, 8, "-999", &[(1, "2"), (2, "1"), (3, code)]);
    let reals = block(100, 5, 15, "-999.000000", &[(34, "0.020000"), (62, interval), (64, "-102.5")]);
    format!(
        "{title}    (Format v01.20 with 13 text lines)\n{}\
         100 Integer-header values follow on  10 lines, Format= (10I8)\n{integers}\
         100 Real-header values follow on  20 lines, Format= (5F15.6)\n{reals}\
         1 Comment line(s) follow, each starting with a \"|\":\n|<SCNL>BMR.BNZ\n{announced}\n{rows}\n\
         End-of-data for Chan  1 acceleration\n",
        "some text\n".repeat(12)
    )
}

const ACCELERATION: &str = "Corrected acceleration";
const CM: &str = "    3 acceleration pts, approx  0 secs, units=cm/sec2(04),Format=(2F10.5)";

#[test]
fn cosmos_takes_the_interval_of_this_series_and_the_announced_format() {
    let file = cosmos(ACCELERATION, "4", "5.000000", CM, " 100.12345-102.50000\n   0.00001");
    let read = text(&file, FILE).unwrap();
    assert_eq!(read.samples, [100.12345, -102.5, 0.00001]);
    assert_eq!((read.dt, read.units, read.format), (Some(0.005), Units::CentimetresPerSecondSquared, "COSMOS V2"));
    let exponents = CM.replace("2F10.5", "1E15.6");
    let read =
        text(&cosmos(ACCELERATION, "4", "5.0", &exponents, "   3.437285e-04\n  -1.025000e+02\n   0.000000e+00"), FILE)
            .unwrap();
    assert_eq!(read.samples, [3.437285e-4, -102.5, 0.0]);
    let touching = CM.replace("2F10.5", "3F9.5");
    let read = text(&cosmos(ACCELERATION, "-999", "5.0", &touching, "100.12345102.50000-10.00000"), FILE).unwrap();
    assert_eq!(read.samples, [100.12345, 102.5, -10.0]);
    assert!(wrong(&cosmos(ACCELERATION, "4", "-999.0", CM, "0.1 "), FILE).contains("announced"));
}

#[test]
fn cosmos_without_an_interval_needs_one() {
    let file = cosmos(ACCELERATION, "4", "-999.000000", CM, " 100.12345-102.50000\n   0.00001");
    assert!(wrong(&file, FILE).starts_with("the file does not give its time step"));
    assert_eq!(text(&file, Asked { step: Step::Seconds(0.01), ..FILE }).unwrap().dt, Some(0.01));
}

#[test]
fn cosmos_of_velocities_counts_and_contradictory_units_is_refused() {
    let rows = " 100.12345-102.50000\n   0.00001";
    let velocity = CM.replace("acceleration pts", "velocity pts");
    assert!(
        wrong(&cosmos("Corrected velocity", "5", "5.0", &velocity, rows), FILE)
            .contains("expected is a number and acceleration pts")
    );
    let counts = CM.replace("cm/sec2(04)", "counts(50)");
    assert!(
        wrong(&cosmos("Raw acceleration counts", "50", "5.0", &counts, rows), FILE).contains("the units are `counts`")
    );
    assert!(
        wrong(&cosmos(ACCELERATION, "2", "5.0", CM, rows), FILE)
            .contains("the units are cm/s2, and g by the third integer")
    );
}

#[test]
fn a_channel_is_asked_of_several() {
    let one = cosmos(ACCELERATION, "4", "5.0", CM, " 100.12345-102.50000\n   0.00001");
    let two = cosmos(ACCELERATION, "4", "5.0", CM, "   1.00000-102.50000\n   0.00002");
    let both = format!("{one}{two}");
    assert_eq!(wrong(&both, FILE), "the file has 2 channels; expected is column = 1 to 2 in the scene");
    assert_eq!(text(&both, Asked { column: Some(2), ..FILE }).unwrap().samples, [1.0, -102.5, 0.00002]);
    assert!(wrong(&both, Asked { column: Some(3), ..FILE }).contains("column = 3 asks for none of them"));
}

fn csmip(announced: &str) -> String {
    format!(
        "Corrected accelerogram   89486   Chan  1: 180 Deg\n 3 points of instrument- and baseline-corrected accel, veloc and displ data\n    \
         1  100    1\n{announced}\n-100.12345 200.00000\n   0.00067\n    3 points of veloc data equally spaced at 0.010 sec, in cm/sec. (8f10.6)\n  0.1\n\
         /&  ----------  End of data for channel  1  ----------\n"
    )
}

#[test]
fn csmip_has_its_accelerations_before_its_velocities() {
    let read =
        text(&csmip("    3 points of accel data equally spaced at  .010 sec, in cm/sec2. (2f10.5)"), FILE).unwrap();
    assert_eq!((read.samples.as_slice(), read.dt), (&[-100.12345, 200.0, 0.00067][..], Some(0.01)));
    assert_eq!((read.units, read.format), (Units::CentimetresPerSecondSquared, "CSMIP V2"));
    let told = wrong(&csmip("    4 points of accel data equally spaced at  .010 sec, in cm/sec2. (2f10.5)"), FILE);
    assert!(told.starts_with("line 4: 4 numbers are announced, and 3 follow"), "{told}");
    let unnamed = csmip("    3 POINTS OF ACCEL DATA EQUALLY SPACED AT  .010 SEC. (2f10.5)");
    assert!(wrong(&unnamed, FILE).contains("does not name its units"));
}

pub fn knet(scale: &str, duration: &str, rows: &str) -> String {
    format!(
        "Origin Time       2006/01/18 23:25:00\nLat.              37.798\nLong.             142.200\nDepth. (km)       36\nMag.              5.7\n\
         Station Code      MYG002\nStation Lat.      38.7262\nStation Long.     141.5109\nStation Height(m) 79\nRecord Time       2006/01/18 23:25:46\n\
         Sampling Freq(Hz) 4Hz\nDuration Time(s)  {duration}\nDir.              N-S\nScale Factor      {scale}\nMax. Acc. (gal)   0.004\n\
         Last Correction   2006/01/18 23:25:31\nMemo.             \n{rows}"
    )
}

#[test]
fn knet_counts_become_gals_and_keep_their_offset() {
    let read = text(
        &knet("3920(gal)/6182761", "2", "    8009     8006     7998     8001 \n    8009     8007     8002     8005 \n"),
        FILE,
    )
    .unwrap();
    assert_eq!(read.samples[0], 8009.0 * 3920.0 / 6182761.0);
    assert_eq!((read.samples.len(), read.dt, read.units), (8, Some(0.25), Units::CentimetresPerSecondSquared));
    assert_eq!(read.notes.len(), 1, "{:?}", read.notes);
    assert!(
        read.notes[0].starts_with("the mean of the record is 5.075 cm/s2")
            && read.notes[0].ends_with("the mean is not removed")
    );
}

#[test]
fn a_peak_that_is_not_that_of_the_header_is_told() {
    let rows = "    8009     8006     7998     8001 \n";
    let read = text(&knet("3920(gal)/3091380", "1", rows), FILE).unwrap();
    assert!(
        read.notes[0].starts_with("line 15 says that the peak is 0.004, but the largest sample is 0.00"),
        "{:?}",
        read.notes
    );
}

#[test]
fn knet_with_another_count_or_scale_is_refused() {
    let rows = "    8009     8006     7998     8001\n";
    assert!(
        wrong(&knet("3920(gal)/6182761", "2", rows), FILE)
            .starts_with("line 12: 8 numbers are announced, and 4 follow")
    );
    for scale in ["3920(mm)/6182761", "3920(gal)/0", "", "-1(gal)/5"] {
        assert!(wrong(&knet(scale, "1", rows), FILE).starts_with("line 14: `Scale Factor"), "{scale}");
    }
    assert!(
        wrong(&knet("3920(gal)/6182761", "1", "8009 8006 7998 80.5\n"), FILE)
            .contains("80.5; expected are whole numbers")
    );
}
