//! The work-precision charts: what they measure, on one distance, and the command.

use std::{collections::BTreeSet, sync::OnceLock};

use assert_cmd::Command;
use chattercheck::studies::{
    atlas,
    chart::Table,
    diagnose, plan_map, remaining_time,
    work_precision::{CHARTS, Scope, WorkRow, files, measure, read},
};

fn small() -> &'static [WorkRow] {
    static ROWS: OnceLock<Vec<WorkRow>> = OnceLock::new();
    let request = Scope { percents: vec![(50.0, 80)], patience: 0.0, ..Scope::default() };
    ROWS.get_or_init(|| measure(&request, || ()).unwrap())
}

fn family(name: &str) -> Vec<&'static WorkRow> {
    small().iter().filter(|row| row.family == name).collect()
}

fn tau_ch(name: &str, setting: &str) -> f64 {
    family(name).into_iter().find(|row| row.setting == setting).unwrap().tau_ch_error.unwrap()
}

#[test]
fn every_row_has_a_cost_and_an_error_or_a_reason() {
    let mut seen = BTreeSet::new();
    for row in small() {
        assert!(row.seconds > 0.0, "{row:?}");
        assert!(row.tau_ch_error.is_some() || !row.outcome.is_empty(), "{row:?}");
        assert!(seen.insert((&row.family, &row.setting)), "{row:?} twice");
    }
}

#[test]
fn the_higher_orders_take_a_fraction_of_the_impacts() {
    assert!(tau_ch("closed form, higher orders", "40 impacts") < 1e-13);
    assert!(tau_ch("closed form, Eq. 75", "40 impacts") > 1e-5);
    assert!(tau_ch("closed form, Eq. 75", "160 impacts") < 1e-12);
    assert!(tau_ch("velocity threshold", "1e-12") > 1e-12);
}

#[test]
fn solvers_follow_their_tolerance_where_each_flight_has_its_own_units() {
    for solver in ["tsit45", "bdf", "tr-bdf2", "esdirk34"] {
        let rows = family(&format!("{solver}, rescaled"));
        assert_eq!(rows.len(), 10);
        let (coarse, fine) = (rows[0], rows[9]);
        assert!(fine.tau_ch_error.unwrap() < 1e-4 * coarse.tau_ch_error.unwrap(), "{solver}");
        assert!(fine.impact_40_error.unwrap() < 1e-4 * coarse.impact_40_error.unwrap(), "{solver}");
        assert!(fine.rhs > coarse.rhs, "{solver}");
    }
    for row in family("tsit45, one clock, old step") {
        assert!(row.tau_ch_error.is_none() && row.outcome.contains("fell through"), "{row:?}");
    }
}

#[test]
fn what_the_enclosure_proves_gets_narrower_with_its_digits() {
    let widths: Vec<f64> = family("enclosure, proven").iter().map(|row| row.tau_ch_error.unwrap()).collect();
    assert!(widths.windows(2).all(|two| two[1] < two[0]) && widths[7] < 1e-15, "{widths:?}");
}

/// Everything but the seconds is the same in every run.
#[test]
fn only_the_seconds_change() {
    let request = Scope { percents: vec![(50.0, 80)], patience: 0.0, ..Scope::default() };
    let timeless =
        |rows: &[WorkRow]| -> Vec<WorkRow> { rows.iter().map(|row| WorkRow { seconds: 0.0, ..row.clone() }).collect() };
    assert_eq!(timeless(&measure(&request, || ()).unwrap()), timeless(small()));
}

#[test]
fn every_chart_is_drawn_from_the_file_with_and_without_peers() {
    let recorded = concat!(env!("CARGO_MANIFEST_DIR"), "/data/record/peers/work_precision.csv");
    let recorded = std::fs::read_to_string(recorded).unwrap();
    for peers in [Vec::new(), read(&recorded).unwrap()] {
        let files = files(&[small(), &peers].concat()).unwrap();
        for chart in &CHARTS {
            let table = Table::from_reader(chart.table, files[chart.table].as_bytes()).unwrap();
            let svg = (chart.draw)(&table).unwrap();
            assert!(svg.starts_with("<svg"), "{}", chart.name);
            let shows_peers = svg.contains("heyoka.py (peer)");
            assert_eq!(shows_peers, !peers.is_empty() && chart.name == "work_impact_40.svg", "{}", chart.name);
        }
    }
    assert!(read("share,epsilon\n50 %,0.1\n").is_err());
}

/// The charts that are kept are those of the tables beside them.
#[test]
fn the_recorded_charts_are_drawn_from_the_recorded_tables() {
    let record = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("data/record");
    for (folder, charts) in [
        ("work_precision", &CHARTS[..]),
        ("atlas", &atlas::CHARTS),
        ("plan", &plan_map::CHARTS),
        ("remaining_time", &remaining_time::CHARTS),
        ("diagnose", &diagnose::CHARTS),
    ] {
        let kept = |name: &str| std::fs::read_to_string(record.join(folder).join(name)).ok();
        let mut seen = 0;
        for chart in charts {
            if let Some(svg) = kept(chart.name) {
                let csv =
                    kept(chart.table).unwrap_or_else(|| panic!("{folder}/{} is not beside its chart", chart.table));
                let table = Table::from_reader(chart.table, csv.as_bytes()).unwrap();
                assert_eq!(
                    (chart.draw)(&table).unwrap(),
                    svg,
                    "data/record/{folder}/{} is of something else",
                    chart.name
                );
                seen += 1;
            }
        }
        assert!(seen > 0, "{folder}");
    }
}

#[test]
fn charts_are_drawn_again_from_their_tables_alone() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let redraw = |flags: &[&str]| {
        let arguments = [&["chart", "--redraw", "--out", out], flags].concat();
        Command::new(env!("CARGO_BIN_EXE_chattercheck")).args(arguments).output().unwrap()
    };
    let told = redraw(&["--only", "plan"]);
    assert_eq!(told.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&told.stderr).contains("plan_map.csv"));
    let record = concat!(env!("CARGO_MANIFEST_DIR"), "/data/record/plan/plan_map.");
    std::fs::copy(format!("{record}csv"), folder.path().join("plan_map.csv")).unwrap();
    assert_eq!(redraw(&["--only", "plan"]).status.code(), Some(0));
    let drawn = std::fs::read(folder.path().join("plan_map.svg")).unwrap();
    assert_eq!(drawn, std::fs::read(format!("{record}svg")).unwrap());
    assert_eq!(redraw(&["--peers", "x.csv"]).status.code(), Some(2), "peers are measured, and would be ignored");
}

#[test]
fn what_the_command_refuses() {
    let folder = tempfile::tempdir().unwrap();
    let chart = |flags: &[&str]| {
        let output = Command::new(env!("CARGO_BIN_EXE_chattercheck")).arg("chart").args(flags).output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!((output.status.code(), message.lines().count()), (Some(2), 1), "{message}");
        message
    };
    let out = folder.path().join("out");
    let out = out.to_str().unwrap();
    assert!(chart(&["--only", "atlas"]).contains("--out"));
    assert!(chart(&["--out", out, "--only", "maps"]).contains("maps"));
    assert!(chart(&["--out", out, "--peers", "/nowhere/peers.csv"]).contains("/nowhere/peers.csv"));
    let peers = folder.path().join("peers.csv");
    let head = "share,epsilon,family,setting,impacts,rhs,seconds,tau_ch_error,impact_40_error,outcome\n";
    for (rows, said) in [
        ("", "there are no rows"),
        ("50 %,0.01,x,y,,,-1,,,\n", "line 2: seconds = -1 is outside the allowed range: a finite number above 0"),
        ("50 %,0.01,x,y,,,1,,,\n50 %,-1,x,y,,,1,,,\n", "line 3: epsilon = -1"),
        ("50 %,0.01,x,y,,,1,NaN,,\n", "tau_ch_error = NaN"),
        ("77 %,0.01,x,y,,,1,,,\n", "share = 77 % is outside the allowed range: 50 %, 90 % or 99.9 %"),
    ] {
        std::fs::write(&peers, format!("{head}{rows}")).unwrap();
        let told = chart(&["--out", out, "--peers", peers.to_str().unwrap()]);
        assert!(told.contains(said), "{rows}: {told}");
    }
    let beside = chart(&["--out", out, "--only", "plan", "--peers", peers.to_str().unwrap()]);
    assert!(beside.contains("peers are drawn in the work-precision charts"), "{beside}");
    assert!(!folder.path().join("out").exists(), "nothing is written");
}
