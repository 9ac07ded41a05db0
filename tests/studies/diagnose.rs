//! What `diagnose` measures: the tables say what they should, and the charts are drawn from the files.

use std::sync::OnceLock;

use crate::effort::pick;

use assert_cmd::Command;
use chattercheck::studies::chart::Table;
use chattercheck::studies::diagnose::{CHARTS, Scope, Tables};

fn small() -> &'static Tables {
    static TABLES: OnceLock<Tables> = OnceLock::new();
    let scope = || Scope {
        etas: vec![0.8, 0.92],
        grid: 2,
        exponents: pick("restitutions of the exponents", vec![0.5, 0.92], Scope::default().exponents),
        local: pick("restitutions of the local exponents", vec![0.5], Scope::default().local),
        steps: pick("steps of the local exponents", 14, Scope::default().steps),
        ..Scope::default()
    };
    TABLES.get_or_init(|| Tables::measure(&scope(), || ()).unwrap())
}

/// The claims that the captions make, on two restitutions.
#[test]
fn the_tables_show_what_the_captions_claim() {
    let tables = small();
    for eta in [0.8, 0.92] {
        let of = |method: &str, share: f64| {
            let rows = tables.errors.iter().filter(|row| row.eta == eta && row.method == method);
            let nearest = rows.min_by(|a, b| (a.share - share).abs().total_cmp(&(b.share - share).abs())).unwrap();
            nearest.error.unwrap()
        };
        let orders = ["order 1", "order 2", "order 4", "order 8", "order 16", "order 32"];
        for two in orders.windows(2) {
            for share in [0.3, 0.6, 0.9, 0.99, 0.999] {
                assert!(of(two[1], share) < of(two[0], share) + 1e-15, "{two:?} at {share} of eta = {eta}");
            }
        }
        assert!((0.1..0.2).contains(&of("paper (Eq. 65)", 0.9999)));
        for two in orders.windows(2) {
            let gain = of(two[1], 0.999_999_9) / of(two[0], 0.999_999_9);
            assert!((0.6..0.75).contains(&gain), "each doubling takes off about a third: {gain}");
        }
        assert!(of("resummed", 0.99) < 1e-6 && of("resummed", 0.999) < 1e-4);
        for other in ["order 32", "H cut off", "reverted series"] {
            assert!(of("resummed", 0.999) < 1e-2 * of(other, 0.999), "{other}, eta = {eta}");
        }
    }
    for row in &tables.errors {
        if let (Some(error), Some(claim)) = (row.error, row.claim) {
            assert!(error <= claim, "{row:?}");
        }
    }
    for row in &tables.exponents {
        assert!((row.stepping.unwrap() - row.formula).abs() < 3e-6, "{row:?}");
        assert!((row.coefficients.unwrap() - row.formula).abs() < row.coefficients_uncertainty.unwrap(), "{row:?}");
        assert!(row.coefficients_uncertainty.unwrap() < 1.4e-3, "{row:?}");
        // Three digits, in all three columns.
        assert!((row.coefficients.unwrap() - row.formula).abs() < 5e-4, "{row:?}");
        assert!((row.coefficients.unwrap() - row.stepping.unwrap()).abs() < 5e-4, "{row:?}");
    }
    for row in &tables.local_exponents {
        // A fit from afar finds another exponent; close to a_cr it is that of the formula.
        assert!(row.off < if row.to_go < 1e-6 { 3e-4 } else { 0.1 }, "{row:?}");
    }
    assert!(tables.coefficients.iter().all(|row| row.coefficient > 0.0));
    let paper = tables.truncation.iter().find(|row| row.eta == 0.92 && row.truncation.starts_with("paper")).unwrap();
    let consistent = tables.truncation.iter().find(|row| row.eta == 0.92 && row.truncation == "consistent").unwrap();
    assert!((paper.coefficient - 64.107).abs() < 1e-3 && (consistent.coefficient - 40.030).abs() < 1e-3);
}

#[test]
fn where_an_order_first_errs_by_one_percent_it_does() {
    let tables = small();
    let orders: Vec<_> = tables.first_error.iter().filter(|row| row.omega == 2.0 && row.eta == 0.74).collect();
    assert_eq!(orders.len(), 7);
    let shares: Vec<f64> = orders[1..].iter().map(|row| row.share.unwrap()).collect();
    assert!(shares.windows(2).all(|two| two[0] < two[1]) && shares[0] > 0.02 && shares[5] < 1.0, "{shares:?}");
}

#[test]
fn every_chart_is_drawn_from_its_file() {
    let files = small().files().unwrap();
    for chart in &CHARTS {
        let table = Table::from_reader(chart.table, files[chart.table].as_bytes()).unwrap();
        let svg = (chart.draw)(&table).unwrap();
        assert!(svg.starts_with("<svg") && svg.contains("ω"), "{}", chart.name);
        // A chart of something else if the file says something else.
        let header = files[chart.table].lines().next().unwrap();
        let empty = Table::from_reader(chart.table, header.as_bytes()).unwrap();
        assert!((chart.draw)(&empty).is_err(), "{}", chart.name);
    }
}

#[test]
fn requests_out_of_range_are_refused_and_nothing_is_written() {
    for (flags, field) in [
        (["--omega", "9"], "omega = 9 is outside the allowed range: 0.5 to 8"),
        (["--eta", "0.3"], "eta = 0.3"),
        (["--eta", "0.9,0.9"], "eta = 0.9"),
        (["--eta", "x"], "'x'"),
        (["--grid", "0"], "grid = 0"),
        (["--grid", "1e9"], "'1e9'"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("out");
        let output = Command::cargo_bin("chattercheck")
            .unwrap()
            .arg("diagnose")
            .arg("--out")
            .arg(&out)
            .args(flags)
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(2), "{flags:?}");
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(message.contains(field) && message.lines().count() == 1, "{message}");
        assert!(!out.exists());
    }
}
