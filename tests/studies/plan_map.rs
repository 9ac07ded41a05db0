//! The map of how much model a scene needs.

use chattercheck::studies::{
    chart::Table,
    plan_map::{self, CHARTS},
};

/// The map reaches every method that it has a name for, and each where it belongs.
#[test]
fn the_map_shows_how_much_model_is_needed() {
    let rows = plan_map::rows().unwrap();
    let of = |method: &str| rows.iter().filter(|row| row.method == method).collect::<Vec<_>>();
    assert!(of("nothing").iter().all(|row| row.share <= 0.0) && !of("nothing").is_empty());
    assert!(of("critical-amplitude").iter().all(|row| row.share > 1.0) && !of("critical-amplitude").is_empty());
    for method in ["closed-form", "closed-form/corrected", "taylor"] {
        assert!(of(method).len() > 20, "{method}: {}", of(method).len());
    }
    // The stockier the block and the more digits, the more model.
    let mean = |method: &str| of(method).iter().map(|row| row.alpha.ln()).sum::<f64>() / of(method).len() as f64;
    assert!(mean("closed-form") < mean("closed-form/corrected") && mean("closed-form/corrected") < mean("taylor"));
    for row in &rows {
        assert!(row.uncertainty.is_none_or(|off| off <= row.tolerance), "{row:?}");
    }
    let mut csv = csv::Writer::from_writer(Vec::new());
    rows.iter().for_each(|row| csv.serialize(row).unwrap());
    let table = Table::from_reader(CHARTS[0].table, csv.into_inner().unwrap().as_slice()).unwrap();
    let svg = plan_map::draw(&table).unwrap();
    assert!(svg.contains("corrected"));
}
