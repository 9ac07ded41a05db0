//! No file makes the reader panic, and whatever is said about it is one line.

use proptest::prelude::*;

use super::{Asked, Step, Units, channels, read};

/// Reads with everything asked and with nothing.
fn survives(bytes: &[u8]) -> Result<(), TestCaseError> {
    let asked = [
        Asked::default(),
        Asked { units: Some(Units::G), step: Step::Seconds(0.01), column: Some(2) },
        Asked { units: Some(Units::Threshold), step: Step::Elsewhere, column: None },
    ];
    for asked in asked {
        match read(bytes, &asked) {
            Ok(read) => prop_assert!(read.samples.len() > 1 && read.samples.iter().all(|sample| sample.is_finite())),
            Err(error) => {
                let error = error.to_string();
                prop_assert!(error.lines().count() == 1 && !error.contains(char::is_control), "{:?}", error);
            }
        }
    }
    Ok(())
}

/// Pieces that readers look for, in any order.
fn pieces() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "\n",
        "\r\n",
        "\r",
        " ",
        "\t",
        ",",
        ";",
        "0.1",
        "-.5E-3",
        "1.2-3",
        "1-2",
        "***",
        "NaN",
        "0x1",
        "e",
        "E+",
        ".",
        "-",
        "+",
        "9e999999999999",
        "7",
        "NPTS",
        "DT",
        "= ",
        "SEC",
        "UNITS OF ",
        "g",
        "(g",
        "[cm/s]",
        "time",
        "Period",
        "VELOCITY",
        "2 CORRECTED ACCELEROGRAM\n",
        "(Format v01",
        "100 Integer-header values follow on 1 lines, (10I8)\n",
        "3 Real-header values follow (1P5E0.0)\n",
        "0 Comment line(s) follow\n",
        "99999999999999999999 acceleration pts, units=g (9F1)\n",
        "5 points of accel data equally spaced at .01 (0F0)\n",
        "Scale Factor 1(gal)/2\n",
        "Sampling Freq(Hz) 100Hz\n",
        "Duration Time(s) 1e300\n",
        "Memo.\n",
        "12 points at equal spacing of ",
        "NDATA: 4\n",
        "end",
        "\u{feff}",
        "ü",
        "\u{1a}",
    ]);
    prop::collection::vec(piece, 0..40).prop_map(|pieces| pieces.concat())
}

proptest! {
    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        survives(&bytes)?;
    }

    #[test]
    fn any_text(text in "[ -~\n\t]{0,400}") {
        survives(text.as_bytes())?;
    }

    #[test]
    fn any_pieces(text in pieces()) {
        survives(text.as_bytes())?;
    }

    #[test]
    fn a_file_with_a_byte_changed(place in 0..2000_usize, byte in any::<u8>(), of in 0..2_usize) {
        let file = match of {
            0 => channels::smc("2 CORRECTED ACCELEROGRAM", 2, "0.1000000E+03", "-32768", " 1.5057E+0-2.2223E+0"),
            _ => channels::knet("2000(gal)/8388608", "1", "1 2 3 4\n"),
        };
        let mut file = file.into_bytes();
        let place = place % file.len();
        file[place] = byte;
        survives(&file)?;
    }
}
