//! What is printed in a format is read back bit for bit.

use std::fmt::Write;

use proptest::prelude::*;

use super::{Asked, FILE, GIVEN, Step, channels, text};

fn samples() -> impl Strategy<Value = Vec<f64>> {
    let finite = prop_oneof![
        -2.0..2.0_f64,
        any::<f64>().prop_filter("finite", |value| value.is_finite()),
        Just(0.0),
        Just(-0.0),
    ];
    prop::collection::vec(finite, 2..60)
}

fn bits(samples: &[f64]) -> Vec<u64> {
    samples.iter().map(|sample| sample.to_bits()).collect()
}

/// Rows of so many numbers.
fn rows(samples: &[f64], a_line: usize, print: impl Fn(f64) -> String) -> String {
    let row = |row: &[f64]| row.iter().map(|value| print(*value)).collect::<Vec<_>>().join(" ");
    samples.chunks(a_line).map(row).collect::<Vec<_>>().join("\n")
}

proptest! {
    #[test]
    fn peer(samples in samples(), a_line in 1..9_usize, letter in prop::sample::select(vec!["E", "e", "D", "d"])) {
        let print = |value: f64| format!("{value:e}").replace('e', letter);
        let file = format!("A\nUNITS OF G\nNPTS= {}, DT= .005 SEC\n{}", samples.len(), rows(&samples, a_line, print));
        prop_assert_eq!(bits(&text(&file, FILE).unwrap().samples), bits(&samples));
    }

    #[test]
    fn one_column(samples in samples()) {
        // A point in each, so that none looks like a count.
        let file = rows(&samples, 1, |value| format!("{value:?}"));
        prop_assert_eq!(bits(&text(&file, GIVEN).unwrap().samples), bits(&samples));
    }

    #[test]
    fn counted(samples in samples(), a_line in 1..9_usize) {
        let file = format!("name\n{} 0.01\n{}", samples.len(), rows(&samples, a_line, |value| value.to_string()));
        let read = text(&file, Asked { step: Step::OfFile, ..GIVEN }).unwrap();
        prop_assert_eq!((bits(&read.samples), read.dt), (bits(&samples), Some(0.01)));
    }

    #[test]
    fn columns(samples in samples(), separator in prop::sample::select(vec![" ", "\t", ",", ";", ", "]), dt in 1..1000_u32, column in 2..4_usize) {
        let dt = f64::from(dt) / 10_000.0;
        let file = samples.iter().enumerate().fold(String::new(), |mut file, (place, value)| {
            let time = place as f64 * dt;
            let (one, other) = if column == 2 { (value, &0.5) } else { (&0.5, value) };
            writeln!(file, "{time}{separator}{one}{separator}{other}").unwrap();
            file
        });
        let read = text(&file, Asked { step: Step::OfFile, column: Some(column), ..GIVEN }).unwrap();
        prop_assert_eq!((bits(&read.samples), read.dt), (bits(&samples), Some(dt)));
    }

    #[test]
    fn smc(samples in prop::collection::vec((-99_999..99_999_i32, -9..9_i32), 2..60)) {
        let printed: Vec<String> = samples.iter().map(|(digits, exponent)| {
            format!("{:>7.4}E{exponent:+}", f64::from(*digits) / 10_000.0)
        }).collect();
        let rows = printed.chunks(8).map(<[String]>::concat).collect::<Vec<_>>().join("\n");
        let values: Vec<f64> = printed.iter().map(|printed| printed.trim().parse().unwrap()).collect();
        let file = channels::smc("2 CORRECTED ACCELEROGRAM", values.len(), "0.1000000E+03", "-32768", &rows);
        prop_assert_eq!(bits(&text(&file, FILE).unwrap().samples), bits(&values));
    }

    #[test]
    fn knet(counts in prop::collection::vec(-8_388_608..8_388_608_i32, 1..15)) {
        let counts: Vec<i32> = counts.iter().flat_map(|count| [*count; 4]).collect();
        let rows = counts.chunks(8).map(|row| row.iter().map(|count| format!("{count:>9}")).collect::<String>() + " \n").collect::<String>();
        let file = channels::knet("2000(gal)/8388608", &(counts.len() / 4).to_string(), &rows);
        let values: Vec<f64> = counts.iter().map(|count| f64::from(*count) * 2000.0 / 8_388_608.0).collect();
        prop_assert_eq!(bits(&text(&file, FILE).unwrap().samples), bits(&values));
    }

    #[test]
    fn fortran_numbers(digits in 1..9_999_999_i32, exponent in -30..30_i32) {
        let expected: f64 = format!("0.{digits:07}e{exponent}").parse().unwrap();
        for printed in [format!(".{digits:07}E{exponent:+03}"), format!("0.{digits:07}D{exponent:+}"), format!("+.{digits:07}{exponent:+04}")] {
            let read = text(&format!("{printed}\n-{}\n", printed.trim_start_matches('+')), GIVEN).unwrap();
            prop_assert_eq!(bits(&read.samples), bits(&[expected, -expected]), "{}", printed);
        }
    }
}
