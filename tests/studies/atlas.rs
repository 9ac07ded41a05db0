//! What the atlas says of each way of handling the accumulation point, on a few cases.

use std::sync::OnceLock;

use chattercheck::studies::{
    atlas::{AtlasRow, CHARTS, Scope, Tables, methods},
    chart::Table,
};

const DISTANCES: [f64; 5] = [0.5, 1e-3, -1e-3, -0.1, -0.5];

fn small() -> &'static Tables {
    static TABLES: OnceLock<Tables> = OnceLock::new();
    let request = Scope { omega: 2.0, etas: vec![0.92], distances: DISTANCES.to_vec() };
    TABLES.get_or_init(|| Tables::measure(&request, || ()).unwrap())
}

fn row(family: &str, setting: &str, to_go: f64) -> &'static AtlasRow {
    let mut rows = small().atlas.iter().filter(|row| row.family == family && row.setting == setting);
    rows.find(|row| row.to_go == to_go).unwrap_or_else(|| panic!("{family} {setting} at {to_go}"))
}

#[test]
fn every_method_is_asked_every_case_once() {
    assert_eq!(small().atlas.len(), methods().len() * DISTANCES.len());
    for row in &small().atlas {
        assert_eq!(row.truth, if row.to_go > 0.0 { "rests" } else { "rocks" }, "{row:?}");
        assert_eq!(row.failure == "none", row.how.is_empty(), "{row:?}");
        assert!(row.verdict.is_some() || row.failure != "none", "{row:?}");
    }
}

#[test]
fn the_exact_oracles_judge_rightly_from_both_sides() {
    for (oracle, tau_ch, response) in [("closed-form", 1e-13, 1e-11), ("ode/linear/tsit45", 1e-9, 1e-8)] {
        for to_go in DISTANCES {
            let row = row("oracle", oracle, to_go);
            assert_eq!((row.failure, row.verdict), ("none", Some(row.truth)), "{row:?}");
            assert!(row.error.unwrap() < if to_go > 0.0 { tau_ch } else { response }, "{row:?}");
            assert!(to_go < 0.0 || row.shortest.unwrap() < 1e-29, "{row:?}");
        }
    }
}

#[test]
fn a_velocity_threshold_trades_its_error_for_its_verdict() {
    let error = |exponent: i32| row("velocity threshold", &format!("1e-{exponent}"), 0.5).error.unwrap();
    for exponent in 3..12 {
        let gain = error(exponent) / error(exponent + 1);
        assert!((8.0..13.0).contains(&gain), "a tenth of the threshold, a tenth of the error: {gain} at 1e-{exponent}");
    }
    // Fig. 11: a block is put to rest that rocks on, and after T/2 goes another way.
    for (setting, to_go, least) in [("1e-1", -0.5, 0.1), ("1e-2", -0.1, 0.05)] {
        let stopped = row("velocity threshold", setting, to_go);
        assert_eq!((stopped.verdict, stopped.failure), (Some("rests"), "silent"));
        assert!(stopped.response_error.unwrap() > least, "{stopped:?}");
    }
    assert_eq!(row("velocity threshold", "1e-12", -1e-3).failure, "none");
}

#[test]
fn one_interval_below_a_threshold_stops_earlier_than_two() {
    for (to_go, setting) in [(0.5, "1e-2"), (0.5, "1e-4"), (1e-3, "1e-4")] {
        let [one, two] = ["interval threshold", "threshold of two intervals"].map(|rule| row(rule, setting, to_go));
        assert!(one.resolved < two.resolved && one.error > two.error, "{one:?} {two:?}");
    }
}

#[test]
fn the_ad_hoc_scheme_hangs_where_its_formulas_are_on_the_wrong_side() {
    // Eq. 65 is later than the true chattering time at half the way; Eq. 76 is below the true critical amplitude.
    for to_go in [0.5, 1e-3] {
        let row = row("ad hoc (Eqs 65 and 76)", "", to_go);
        assert_eq!(row.failure, "hang", "{row:?}");
    }
    assert_eq!(row("ad hoc (Eqs 65 and 76)", "", -0.5).failure, "none");
}

#[test]
fn on_one_clock_the_end_is_never_found() {
    for rtol in ["rtol 1e-6", "rtol 1e-9", "rtol 1e-12"] {
        for restart in ["one clock, state zero", "one clock, state lifted", "one clock, old step kept"] {
            let row = row(restart, rtol, 0.5);
            assert!(row.verdict != Some("rests") && row.failure != "none", "{row:?}");
        }
    }
    let fell = row("one clock, old step kept", "rtol 1e-12", 0.5);
    assert_eq!((fell.failure, fell.how.as_str()), ("silent", "falls through the base without an event"));
    assert!(fell.resolved < 5);
    let lifted = row("one clock, state lifted", "rtol 1e-12", 1e-3);
    assert_eq!((lifted.verdict, lifted.failure), (Some("rocks"), "silent"));
}

#[test]
fn equation_6_in_absolute_time_loses_its_digits() {
    let row = row("Eq. 6 in absolute time", "", 0.5);
    assert!(row.verdict.is_none() && (100..200).contains(&row.resolved), "{row:?}");
}

#[test]
fn time_stepping_always_answers_and_gets_better_with_its_step() {
    let rows = |to_go| ["step 1e-3", "step 1e-4", "step 1e-6"].map(|step| row("Moreau-Jean", step, to_go));
    for rows in [rows(0.5), rows(-0.5)] {
        let errors = rows.map(|row| row.error.unwrap());
        assert!(errors[2] < 0.1 * errors[0] && errors[2] < errors[1], "{errors:?}");
    }
}

#[test]
fn the_series_decline_above_the_critical_amplitude() {
    for series in ["asymptotic/paper", "asymptotic/order-16", "asymptotic/resummed"] {
        assert_eq!(row("oracle", series, -1e-3).failure, "loud");
    }
    assert!(row("oracle", "asymptotic/resummed", 0.5).error.unwrap() < 1e-12);
}

#[test]
fn the_sequence_is_lost_on_one_clock_and_kept_in_units_of_each_flight() {
    let worst = |method: &str| {
        let rows = small().depth.iter().filter(|row| row.method == method && row.share == "50 %");
        rows.filter_map(|row| row.error).fold(0.0, f64::max)
    };
    assert!(worst("closed-form") < 1e-14 && worst("ode/linear/tsit45") < 1e-9);
    for lost in ["one clock, state zero rtol 1e-12", "one clock, state lifted rtol 1e-12", "Moreau-Jean step 1e-6"] {
        assert!(worst(lost) > 0.1, "{lost}: {}", worst(lost));
    }
}

#[test]
fn every_chart_is_drawn_from_its_file() {
    let files = small().files().unwrap();
    for chart in &CHARTS {
        let table = Table::from_reader(chart.table, files[chart.table].as_bytes()).unwrap();
        assert!((chart.draw)(&table).unwrap().starts_with("<svg"), "{}", chart.name);
        let header = files[chart.table].lines().next().unwrap();
        let empty = Table::from_reader(chart.table, header.as_bytes()).unwrap();
        assert!((chart.draw)(&empty).is_err(), "{}", chart.name);
    }
    assert_eq!(files["atlas.md"].lines().count(), methods().len() + 2);
}
