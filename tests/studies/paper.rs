//! The paper again: its figures are drawn from their tables and say what their captions say, and its claims are all measured.

use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
    sync::OnceLock,
};

use assert_cmd::Command;
use chattercheck::studies::{
    chart::Table,
    paper::{self, FIGURES},
};

fn paper_command(out: &Path) -> std::process::Output {
    Command::cargo_bin("chattercheck").unwrap().args(["paper", "--out"]).arg(out).output().unwrap()
}

/// The text of a table that the run wrote.
fn csv_of(figure: &str) -> String {
    std::fs::read_to_string(run().1.join(format!("{figure}.csv"))).unwrap()
}

fn table(figure: &str) -> Table {
    Table::from_reader(figure, csv_of(figure).as_bytes()).unwrap()
}

fn numbers(table: &Table, column: &str) -> Vec<f64> {
    table.numbers(column).unwrap().into_iter().flatten().collect()
}

#[test]
fn every_claim_is_measured_and_every_measurement_is_of_a_claim() {
    let claims = paper::claims().unwrap();
    let ids: BTreeSet<&str> = claims.iter().map(|claim| claim.id.as_str()).collect();
    let measured = paper::measured();
    assert_eq!(ids, measured.iter().copied().collect());
    assert_eq!((claims.len(), measured.len()), (ids.len(), ids.len()), "each once");
    assert!(ids.len() >= 25);
    for claim in &claims {
        assert!(claim.holds <= claim.within && claim.holds >= 0.0, "{}", claim.id);
        for text in [&claim.place, &claim.statement, &claim.measured, &claim.truth] {
            assert!(text.len() > 3 && !text.contains('\n'), "{}", claim.id);
        }
    }
}

fn committed() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/paper")
}

/// One run of the command, for all tests that need one.
fn run() -> &'static (tempfile::TempDir, PathBuf, BTreeSet<String>) {
    static RUN: OnceLock<(tempfile::TempDir, PathBuf, BTreeSet<String>)> = OnceLock::new();
    RUN.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("new/out");
        let output = paper_command(&out);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let listed = String::from_utf8(output.stdout).unwrap().lines().map(str::to_owned).collect();
        (folder, out, listed)
    })
}

#[test]
fn the_committed_table_is_what_a_run_gives() {
    let (_, out, _) = run();
    for name in ["claims.md", "summary.md"] {
        let made = std::fs::read_to_string(out.join(name)).unwrap();
        let committed = std::fs::read_to_string(committed().join(name)).unwrap();
        for (committed, made) in committed.lines().zip(made.lines()) {
            assert_eq!(committed, made, "data/paper/{name} is to be that of `chattercheck paper --out DIR`");
        }
        assert_eq!(committed.lines().count(), made.lines().count(), "{name}");
    }
}

/// What is known to be wrong in the paper, and what to be right, whatever decides it.
#[test]
fn the_verdicts_are_those_that_are_known() {
    let (_, out, _) = run();
    let claims = Table::read(out.join("claims.csv")).unwrap();
    assert_eq!(claims.len(), paper::claims().unwrap().len());
    let verdict = |id: &str| claims.filter("id", id).unwrap().texts("verdict").unwrap()[0].to_owned();
    for id in ["eq-31-third", "eq-41", "eq-51-c3", "step-3", "eq-65-second", "eq-5-slender"] {
        assert!(verdict(id).starts_with("does not hold"), "{id}");
    }
    for id in ["eq-31-first", "eq-34-fifth", "eq-62-one-root", "eq-65-first", "eq-68", "a-cr", "fig-7"] {
        assert_eq!(verdict(id), "holds", "{id}");
    }
}

#[test]
fn every_chart_is_committed() {
    let there: BTreeSet<_> = std::fs::read_dir(committed().join("figures"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let charts = FIGURES.iter().flat_map(|one| one.charts).map(|(name, _)| (*name).to_owned());
    assert_eq!(there, charts.chain(FIGURES.iter().map(|one| format!("{}.csv", one.name))).collect());
}

/// Whether two fields of a table are the same to more digits than another machine's sine could change.
fn are_alike(one: &str, other: &str) -> bool {
    match (one.parse::<f64>(), other.parse::<f64>()) {
        (Ok(one), Ok(other)) => (one - other).abs() <= 1e-12 + 1e-7 * one.abs(),
        _ => one == other,
    }
}

#[test]
fn the_committed_figures_are_those_of_a_run() {
    for figure in &FIGURES {
        let committed = |name: &str| std::fs::read_to_string(committed().join("figures").join(name)).unwrap();
        let (kept, made) = (committed(&format!("{}.csv", figure.name)), csv_of(figure.name));
        let fields = |text: &str| {
            text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>()).collect::<Vec<_>>()
        };
        let (kept_rows, made) = (fields(&kept), fields(&made));
        assert_eq!(kept_rows.len(), made.len(), "{}", figure.name);
        for (kept, made) in kept_rows.iter().zip(&made) {
            let is_same = kept.len() == made.len() && kept.iter().zip(made).all(|(kept, made)| are_alike(kept, made));
            assert!(
                is_same,
                "{}.csv of data/paper/figures is to be that of `chattercheck paper --out DIR`: {kept:?}, now {made:?}",
                figure.name
            );
        }
        let table = Table::from_reader(figure.name, kept.as_bytes()).unwrap();
        for (name, draw) in figure.charts {
            assert_eq!(
                draw(&table).unwrap(),
                committed(name),
                "data/paper/figures/{name} is drawn from something else"
            );
        }
    }
}

#[test]
fn every_chart_is_drawn_from_its_table() {
    for figure in &FIGURES {
        let csv = csv_of(figure.name);
        let table = Table::from_reader(figure.name, csv.as_bytes()).unwrap();
        let header = Table::from_reader(figure.name, csv.lines().next().unwrap().as_bytes()).unwrap();
        assert!(csv.len() < 500_000, "{} is large", figure.name);
        for (name, draw) in figure.charts {
            assert!(draw(&table).unwrap().starts_with("<svg"), "{name}");
            assert!(draw(&header).is_err(), "{name} is drawn from something else");
        }
    }
}

/// Figs 3, 5, 6 and 7 against what is known of them by other ways.
#[test]
fn the_tables_say_what_is_known() {
    for (figure, limit) in [("fig_3a", 0.8464), ("fig_3b", 0.7396)] {
        let ratios = numbers(&table(figure), "ratio");
        assert!((ratios[0] - limit).abs() > 0.5 && (ratios[60] / limit - 1.0).abs() < 1e-3 && ratios.len() == 121);
    }
    let fig_5 = table("fig_5");
    let exact = fig_5.filter("method", "semi-analytical (Eq. 75)").unwrap();
    let (a, share) = (numbers(&exact, "a"), numbers(&exact, "half_period_fraction"));
    assert!((a.last().unwrap() - 1.038_015_538_7).abs() < 1e-10 && (share.last().unwrap() - 1.0).abs() < 2e-3);
    assert!(share.windows(2).all(|two| two[0] < two[1]));
    let near = a.iter().position(|a| *a > 1.03).unwrap();
    assert!(share[near - 1] < 0.7168 && share[near] > 0.7168);
    let fig_6 = table("fig_6");
    let fits = numbers(&fig_6, "a_cr").into_iter().zip(numbers(&fig_6, "eq76"));
    let worst = fits.fold(0.0_f64, |worst, (a_cr, fit)| worst.max((a_cr - fit).abs()));
    assert!((0.011..0.012).contains(&worst), "its caption says 0.012: {worst}");
    let fig_7 = table("fig_7");
    let a_cr = numbers(&fig_7, "a_cr");
    assert!((a_cr[0] - 1.03302).abs() < 1e-5 && (a_cr.last().unwrap() - 1.03836).abs() < 1e-5);
    let seventh = (a_cr.last().unwrap() - a_cr[0]) / (a_cr.last().unwrap() - 1.0);
    assert!((seventh * 7.0 - 1.0).abs() < 0.05, "its caption says a seventh: {seventh}");
}

#[test]
fn the_excitation_is_at_the_threshold_where_it_is_marked() {
    let table = table("fig_4");
    let (tau, excitation) = (numbers(&table, "tau"), numbers(&table, "ground_acceleration"));
    assert!((tau.last().unwrap() - tau[0] - 2.5 * std::f64::consts::PI).abs() < 1e-12, "2.5 T");
    for (number, threshold) in [("1", 1.0), ("2", -1.0)] {
        let marked = numbers(&table.filter("initiation", number).unwrap(), "ground_acceleration");
        assert!(marked.len() == 1 && (marked[0] - threshold).abs() < 1e-12);
    }
    assert!(excitation.iter().all(|value| value.abs() <= 1.03));
}

/// Figs 2 and 9 to 11: the response comes to rest, or does not, as the captions say.
#[test]
fn the_responses_are_those_of_the_captions() {
    let fig_2 = table("fig_2");
    let rest = numbers(&fig_2.filter("part", "rest").unwrap(), "tau")[0];
    assert!((rest - 1.125_947_676_933_812).abs() < 1e-12, "{rest}");
    let impacts = numbers(&fig_2.filter("part", "impacts c").unwrap(), "tau");
    assert!(impacts.len() == 4 && impacts.windows(2).all(|two| two[0] < two[1]) && impacts[3] < rest);
    // When a line last leaves the base, and when it ends.
    let end = |figure: &str, part: &str, scheme: &str| {
        let rows = table(figure).filter("part", part).unwrap().filter("scheme", scheme).unwrap();
        let (tau, phi) = (numbers(&rows, "tau"), numbers(&rows, "phi"));
        assert!(tau.windows(2).all(|two| two[0] <= two[1]) && tau.len() > 100, "{figure} {part}");
        let last = phi.iter().rposition(|phi| phi.abs() > 0.0).unwrap();
        (tau[last], *tau.last().unwrap())
    };
    let fine = "VelTol/(pα) = 5×10⁻¹⁰";
    for (figure, scheme, rests_at) in [
        ("fig_9", "chattering threshold", Some(1.1045)),
        ("fig_10", "chattering threshold", Some(1.1045)),
        ("fig_10", fine, Some(1.126)),
        ("fig_11", fine, None),
    ] {
        let (moves_until, ends) = end(figure, "insert", scheme);
        match rests_at {
            Some(time) => assert!((moves_until - time).abs() < 5e-3 && moves_until < ends, "{figure}: {moves_until}"),
            None => assert!(moves_until > ends - 1e-2, "{figure}: {moves_until}"),
        }
    }
}

#[test]
fn the_command_writes_every_file_and_says_which() {
    let (_, out, listed) = run();
    let there: BTreeSet<String> =
        std::fs::read_dir(out).unwrap().map(|entry| entry.unwrap().path().display().to_string()).collect();
    assert_eq!(*listed, there);
    for figure in &FIGURES {
        assert!(out.join(format!("{}.csv", figure.name)).exists());
        assert!(figure.charts.iter().all(|(name, _)| out.join(name).exists()));
    }
}

#[test]
fn where_nothing_can_be_written_nothing_is() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, "mine").unwrap();
    for out in [file.clone(), file.join("below"), "/proc/chattercheck".into()] {
        let output = paper_command(&out);
        assert_eq!(output.status.code(), Some(2));
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(message.contains(&format!("out = {}", out.display())) && message.lines().count() == 1, "{message}");
    }
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "mine");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}
