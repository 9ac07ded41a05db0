//! Rows and columns of numbers.

use super::{Asked, FILE, GIVEN, Step, Units, read, text, wrong};

const ELSEWHERE: Asked = Asked { units: Some(Units::Threshold), step: Step::Elsewhere, column: None };

#[test]
fn one_column_and_rows_of_numbers_need_units_and_a_step() {
    for file in [
        "0.1\n-.2\n3.E-1\n",
        "  0.1 -0.2 0.3",
        "title\n\n0.1,\n-0.2,\n0.3\n",
        "\u{feff}0.1\n-0.2\n0.3\u{1a}",
        "% a\n0.1\n-0.2\n+0.3\n# end\n",
    ] {
        let read = text(file, GIVEN).unwrap_or_else(|error| panic!("{error} in {file:?}"));
        assert_eq!(
            (read.samples.as_slice(), read.dt, read.units),
            (&[0.1, -0.2, 0.3][..], Some(0.02), Units::G),
            "{file:?}"
        );
        assert!(wrong(file, Asked { units: None, ..GIVEN }).starts_with("the file does not name its units"));
        assert!(wrong(file, Asked { step: Step::OfFile, ..GIVEN }).starts_with("the file does not give its time step"));
        assert_eq!(text(file, ELSEWHERE).unwrap().dt, None);
    }
    let rows = "0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8\n0.9 0.8 0.7 0.6 0.5 0.4 0.3 0.2\n0.3 0.2\n";
    assert_eq!(text(rows, GIVEN).unwrap().samples.len(), 18);
}

#[test]
fn a_count_in_front_is_no_sample() {
    for file in [
        "test-motion\n3 0.0100\n2.42E-07\n1.46E-07\n-3.15E-05",
        "3 0.01\n2.42E-07 1.46E-07 -3.15E-05\n",
        "name\n3, 0.01\n2.42E-07 1.46E-07\n-3.15E-05\n",
        "3\n0.01\n2.42E-07\n1.46E-07\n-3.15E-05\n",
        "3 points at equal spacing of 0.01 sec\n2.42E-07\n1.46E-07\n-3.15E-05\n",
        "NDATA: 3\nSAMPLING_INTERVAL_S: 0.01\nDATA_TYPE: ACCELERATION\n2.42E-07\n1.46E-07\n-3.15E-05\n",
    ] {
        let read =
            text(file, Asked { step: Step::OfFile, ..GIVEN }).unwrap_or_else(|error| panic!("{error} in {file:?}"));
        assert_eq!((read.samples.as_slice(), read.dt), (&[2.42e-7, 1.46e-7, -3.15e-5][..], Some(0.01)), "{file:?}");
    }
    assert_eq!(text("3\n0.1\n0.2\n0.3\n", GIVEN).unwrap().samples, [0.1, 0.2, 0.3]);
    for (file, line) in [("name\n4 0.01\n0.1\n0.2\n0.3\n", 2), ("4\n0.1\n0.2\n0.3\n", 1)] {
        let told = wrong(file, Asked { step: Step::OfFile, ..GIVEN });
        assert!(told.starts_with(&format!("line {line}: 4 numbers are announced, and 3 follow")), "{told}");
    }
}

#[test]
fn times_and_accelerations_stand_between_blanks_tabs_commas_or_semicolons() {
    for file in [
        "prose\nTime[s] Accel[g]\n0.0000\t-0.0012\n0.0100\t-0.0007\n0.0200\t-0.0003",
        "Time (s)  Acceleration (g)\n 0.0 -0.0012\n .01 -0.0007\n .02 -0.0003\n",
        "time,acc [g]\n0,-0.0012\n0.01,-0.0007\n0.02,-0.0003\n",
        "\"time\";\"acc [g]\"\n\"0\";\"-0.0012\"\n\"0.01\";\"-0.0007\"\n\"0.02\";\"-0.0003\"\n",
        "t, acc (g)\n0.00, -0.0012,\n0.01, -0.0007,\n0.02, -0.0003,\n*** end ***\n",
    ] {
        let read = text(file, FILE).unwrap_or_else(|error| panic!("{error} in {file:?}"));
        assert_eq!(
            (read.samples.as_slice(), read.dt, read.units),
            (&[-0.0012, -0.0007, -0.0003][..], Some(0.01), Units::G),
            "{file:?}"
        );
    }
}

#[test]
fn a_column_is_asked_of_several() {
    let file = "time,ns (g),ew (cm/s2),vel (cm/s),disp (g)\n0.0,0.1,1,2,3\n0.5,0.2,2,3,4\n1.0,0.3,3,4,5\n";
    assert!(wrong(file, FILE).contains("5 columns, the first with times; expected is column = 2 to 5"));
    let column = |column| Asked { column: Some(column), ..FILE };
    let read = text(file, column(3)).unwrap();
    assert_eq!(
        (read.samples.as_slice(), read.units, read.dt),
        (&[1.0, 2.0, 3.0][..], Units::CentimetresPerSecondSquared, Some(0.5))
    );
    assert_eq!(text(file, column(2)).unwrap().units, Units::G);
    assert!(wrong(file, column(4)).contains("`vel (cm/s)`; expected is an acceleration"));
    assert!(wrong(file, column(5)).contains("`disp (g)`; expected is an acceleration"));
    for other in [0, 1, 6] {
        assert!(
            wrong(file, column(other)).contains(&format!("column = {other} is asked; expected is column = 2 to 5"))
        );
    }
}

#[test]
fn a_first_column_that_counts_is_no_time() {
    for file in
        ["k,f,f_hex\n0,0.1,0x1p-4\n1,0.2,0x1p-3\n2,0.3,0x1p-2\n", "0 0.1\n1 0.2\n2 0.3\n", "1;0.1\n2;0.2\n3;0.3\n"]
    {
        let read = text(file, Asked { column: Some(2), ..ELSEWHERE }).unwrap();
        assert_eq!((read.samples.as_slice(), read.dt), (&[0.1, 0.2, 0.3][..], None));
        assert!(read.notes[0].contains("counts the samples"));
    }
    assert_eq!(text("time acc\n0 0.1\n1 0.2\n2 0.3\n", Asked { step: Step::OfFile, ..GIVEN }).unwrap().dt, Some(1.0));
}

#[test]
fn titles_with_blanks_in_them_belong_to_their_columns() {
    for titles in [
        "Time [s]\tAccel [g]\tVel [cm/s]",
        "Time (s)   Acceleration (g)   Velocity (cm/s)",
        "Time [s] Accel [g] Vel [cm/s]",
    ] {
        let file = format!("{titles}\n0.00 0.1 1\n0.01 -0.2 2\n0.02 0.3 3\n");
        let column = |column| Asked { column: Some(column), ..FILE };
        assert_eq!(text(&file, column(2)).unwrap().units, Units::G, "{titles}");
        assert!(wrong(&file, column(3)).contains("expected is an acceleration"), "{titles}");
    }
}

#[test]
fn a_count_with_a_slip_is_named_with_its_line() {
    let asked = Asked { column: Some(2), ..ELSEWHERE };
    for (file, said) in [
        ("k,f\n0,0.1\n1,0.2\n3,0.3\n", "line 4: the count 3 follows 1; expected is one more"),
        ("0 0.1\n1 0.2\n2 0.3\n2 0.3\n3 0.1\n4 0.2\n", "line 4: the count 2 follows 2"),
        ("k,f\n0,0.1\nx,0.2\n", "line 3: `x`; expected is a finite number"),
        ("0.00 0.1\n0.01 0.2\nx 0.3\n", "line 3: `x`; expected is a finite number"),
    ] {
        assert!(wrong(file, asked).starts_with(said), "{}", wrong(file, asked));
    }
}

#[test]
fn the_only_column_may_be_asked_for() {
    let column = |column| Asked { column: Some(column), ..GIVEN };
    assert_eq!(text("0.1\n0.2\n0.3\n", column(1)).unwrap().samples, [0.1, 0.2, 0.3]);
    assert!(
        wrong("0.1\n0.2\n0.3\n", column(2))
            .contains("column = 2 is asked, and the file (numbers in rows) has one series")
    );
}

#[test]
fn a_header_in_another_encoding_is_a_header() {
    let file = b"Acelerograma de Bah\xeda, estaci\xf3n \xd1\n0.1\n0.2\n";
    assert_eq!(read(file, &GIVEN).unwrap().samples, [0.1, 0.2]);
}

#[test]
fn columns_without_times_are_asked_for() {
    let file = "0.1 0.5\n-0.2 0.6\n0.3 0.1\n0.1 0.2\n";
    assert!(wrong(file, GIVEN).contains("2 columns, none with times; expected is column = 1 to 2"));
    assert_eq!(text(file, Asked { column: Some(1), ..GIVEN }).unwrap().samples, [0.1, -0.2, 0.3, 0.1]);
    assert_eq!(text(file, Asked { column: Some(2), ..GIVEN }).unwrap().samples, [0.5, 0.6, 0.1, 0.2]);
}

#[test]
fn a_table_with_holes_is_refused() {
    let asked = Asked { column: Some(2), ..GIVEN };
    assert!(wrong("0.00,0.1,1\n0.02,,1\n0.04,0.3,1\n", asked).starts_with("line 2: ``; expected is a finite number"));
    assert!(
        wrong("0.00 0.1 1\n0.02 0.1\n0.04 0.3 1\n", asked)
            .starts_with("line 2: `0.02 0.1` has 2 columns, line 1 has 3")
    );
    assert!(wrong("0.00,0.1\n0.02,0.1\nfooter\n0.04,0.1\n", GIVEN).starts_with("line 3: `footer` has 1 columns"));
}

#[test]
fn lines_with_other_counts_may_be_a_header_and_are_refused() {
    assert!(wrong("1 2 3\n0.1 0.2\n0.3 0.4\n", GIVEN).starts_with("line 2: 2 numbers, after 3 in the first line"));
    assert!(
        wrong("1 2 3\n0.1 0.2 0.3 0.4\n0.3 0.4 0.1\n", GIVEN)
            .starts_with("line 2: 4 numbers, after 3 in the first line")
    );
    assert_eq!(text("0.1 0.2 0.3\n\n-0.4 0.5 0.6\n0.7\n", GIVEN).unwrap().samples.len(), 7);
}

#[test]
fn decimal_commas_are_refused() {
    assert!(wrong("t;a\n0,00;0,1\n0,02;0,2\n", GIVEN).starts_with("line 2: `0,00;0,1` has decimal commas"));
    assert!(wrong("0,00\t0,1\n0,02\t0,2\n", GIVEN).starts_with("line 1: `0,00 0,1` has decimal commas"));
    assert!(wrong("0,123\n0,456\n0,012\n", GIVEN).contains("a decimal comma has to be a point"));
}

#[test]
fn an_offset_is_told_and_left() {
    let read = text("1.1\n0.9\n1.1\n0.9\n", GIVEN).unwrap();
    assert_eq!(
        (read.samples[0], read.notes[0].as_str()),
        (1.1, "the mean of the record is 1.0 g, and its peak from there 0.1 g; the mean is not removed")
    );
    assert!(text("0.1\n-0.1\n0.1\n-0.1\n", GIVEN).unwrap().notes.is_empty());
}
