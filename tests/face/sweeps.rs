//! `sweep`: a table whose bytes are those of its sweep, whatever happens on the way.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use assert_cmd::cargo::CommandCargoExt as _;

const MAP: &str = "[axes]\neta = [0.8, 0.9]\nomega = { log = [0.5, 8, 7] }\na = { linear = [0.99, 1.06, 8] }\n\n[want]\ncolumns = [\"tau_ch\", \"uncertainty\", \"ending\"]\n";
/// So much that it is still at work when it is killed.
const LONG: &str = "[axes]\neta = { linear = [0.9, 0.95, 6] }\nomega = { log = [0.5, 8, 20] }\na = { linear = [1.001, 1.03, 25] }\n[want]\ncolumns = [\"tau_ch\", \"largest_rotation\"]\n";
const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes/one_sine.toml");

struct Place(tempfile::TempDir);

impl Place {
    fn with(sweep: &str) -> Self {
        let place = Self(tempfile::tempdir().unwrap());
        fs::write(place.path("sweep.toml"), sweep).unwrap();
        place
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::cargo_bin("chattercheck").unwrap();
        command.args(["sweep", "sweep.toml"]).args(arguments.split_whitespace()).current_dir(self.0.path());
        command
    }

    /// Status, stdout and stderr.
    fn run(&self, arguments: &str) -> (Option<i32>, String, String) {
        let output = self.command(arguments).output().unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        (output.status.code(), text(output.stdout), text(output.stderr))
    }

    /// The table on stdout.
    fn table(&self, arguments: &str) -> String {
        let (status, out, err) = self.run(&format!("--out - {arguments}"));
        assert_eq!((status, err.as_str()), (Some(0), ""));
        out
    }

    fn files(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

fn rows(table: &str) -> Vec<Vec<&str>> {
    table.lines().skip(1).map(|line| line.split(',').collect()).collect()
}

#[test]
fn every_point_has_a_row_in_the_order_of_the_axes_and_the_values_are_those_of_the_command() {
    let place = Place::with(MAP);
    let table = place.table("");
    let rows = rows(&table);
    assert!(table.starts_with("eta,omega,a,tau_ch,uncertainty,ending\n0.8,0.5,0.99,,,never-rocks\n"));
    assert_eq!(rows.len(), 2 * 7 * 8);
    assert_eq!((&rows[7][..3], &rows[111][..3]), (&["0.8", "0.5", "1.06"][..], &["0.9", "8.0", "1.06"][..]));
    let mut seen = [0; 2];
    for row in rows.iter().step_by(3) {
        let [eta, omega, a, tau, uncertainty, ending] = row[..] else { panic!("{row:?}") };
        let mut command = Command::cargo_bin("chattercheck").unwrap();
        command.args(["chattering-time", "--a", a, "--omega", omega, "--eta", eta, "--format", "json"]);
        let answer: serde_json::Value = serde_json::from_slice(&command.output().unwrap().stdout).unwrap();
        let number = |text: &str| text.parse::<f64>().ok();
        let claimed = number(uncertainty).unwrap_or(0.0) + answer["uncertainty"].as_f64().unwrap_or(0.0);
        match (number(tau), answer["tau_ch"].as_f64()) {
            (Some(here), Some(there)) => assert!((here - there).abs() <= claimed, "{row:?} {answer}"),
            (here, there) => assert_eq!(here, there, "{row:?} {answer}"),
        }
        assert_eq!(ending == "at-rest", answer["complete"] == true, "{row:?} {answer}");
        assert_eq!(tau.is_empty(), uncertainty.is_empty(), "{row:?}");
        seen[usize::from(tau.is_empty())] += 1;
    }
    assert!(seen[0] >= 10 && seen[1] >= 5, "{seen:?}");
}

#[test]
fn neither_threads_nor_parts_change_a_byte() {
    let place = Place::with(MAP);
    let table = place.table("--threads 1");
    assert_eq!(place.table("--threads 3"), table);
    for parts in [2, 5, 200] {
        let of_part = |part| place.table(&format!("--partition {part}/{parts}"));
        assert_eq!((1..=parts).map(of_part).collect::<String>(), table, "{parts} parts");
    }
    let (status, _, err) = place.run("--out table.csv --svg map.svg --partition 1/2");
    assert!(status == Some(2) && err.contains("svg = map.svg") && err.contains("--redraw"), "{err}");
    for part in 1..=2 {
        assert_eq!(place.run(&format!("--out part-{part} --partition {part}/2")).0, Some(0));
    }
    let [first, second] = [1, 2].map(|part| fs::read_to_string(place.path(&format!("part-{part}"))).unwrap());
    fs::write(place.path("table.csv"), first + &second).unwrap();
    assert_eq!(place.run("--out table.csv --svg map.svg --redraw").0, Some(0));
    assert!(fs::read_to_string(place.path("map.svg")).unwrap().starts_with("<svg"));
    assert_eq!(fs::read_to_string(place.path("table.csv")).unwrap(), table);
}

/// Waits until so many bytes of rows are kept.
fn wait_for(rows: &Path, bytes: u64) {
    let start = Instant::now();
    while fs::metadata(rows).map_or(0, |rows| rows.len()) < bytes {
        assert!(start.elapsed() < Duration::from_secs(120), "no rows");
        thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn what_was_killed_goes_on_and_comes_to_the_same_bytes() {
    let place = Place::with(LONG);
    let kept = place.path("table.csv.rows");
    let mut before = 0;
    for _ in 0..2 {
        let mut child = place.command("--out table.csv").stderr(Stdio::null()).spawn().unwrap();
        wait_for(&kept, before + 2000);
        child.kill().unwrap();
        child.wait().unwrap();
        assert_eq!(place.files(), ["sweep.toml", "table.csv.rows", "table.csv.sweep"]);
        before = fs::metadata(&kept).unwrap().len();
    }
    // What is torn, or is no row of this sweep, is done again; what is whole is not.
    let mut torn = fs::read_to_string(&kept).unwrap();
    torn.truncate(torn.len() - 7);
    let whole = torn.lines().count() - 2;
    fs::write(&kept, &torn).unwrap();
    let (status, out, err) = place.run("--out table.csv");
    assert_eq!((status, out.as_str()), (Some(0), ""), "{err}");
    assert!(err.contains(&format!("{whole} of 3000 rows are whole already")), "{err}");
    assert_eq!(place.files(), ["sweep.toml", "table.csv"]);
    let table = fs::read_to_string(place.path("table.csv")).unwrap();
    assert!(table.starts_with(&torn), "what was kept stays");
    let other = place.run("--out other.csv --threads 1");
    assert_eq!(other.0, Some(0));
    assert!(table == fs::read_to_string(place.path("other.csv")).unwrap());
}

#[cfg(unix)]
#[test]
fn what_was_interrupted_says_so_and_two_at_once_do_not_mix() {
    let place = Place::with(LONG);
    let child = place.command("--out table.csv").stderr(Stdio::piped()).spawn().unwrap();
    wait_for(&place.path("table.csv.rows"), 1000);
    let (status, _, err) = place.run("--out table.csv");
    assert!(status == Some(2) && err.contains("table.csv") && err.contains("another run is at work"), "{err}");
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(3) && err.contains("the same command goes on from there"), "{err}");
    let kept = fs::read(place.path("table.csv.rows")).unwrap();
    // Another sweep, or another part of it, does not go on with these rows.
    let (status, _, err) = place.run("--out table.csv --partition 1/2");
    assert!(status == Some(2) && err.contains("another partition: 1/1 there, 1/2 asked"), "{err}");
    fs::write(place.path("sweep.toml"), LONG.replace("0.95", "0.96")).unwrap();
    let (status, _, err) = place.run("--out table.csv");
    assert!(status == Some(2) && err.contains("table.csv.sweep") && err.contains("its file has changed"), "{err}");
    assert_eq!(fs::read(place.path("table.csv.rows")).unwrap(), kept);
    fs::remove_file(place.path("table.csv.sweep")).unwrap();
    let (status, _, err) = place.run("--out table.csv");
    assert!(status == Some(2) && err.contains("without its mark"), "{err}");
}

#[test]
fn a_table_that_is_there_stays() {
    let place = Place::with(MAP);
    fs::write(place.path("table.csv"), "mine").unwrap();
    let (status, _, err) = place.run("--out table.csv");
    assert!(status == Some(2) && err.contains("out = table.csv is there already"), "{err}");
    assert_eq!(fs::read_to_string(place.path("table.csv")).unwrap(), "mine");
    let (status, _, err) = place.run("--out sweep.toml");
    assert!(status == Some(2) && err.contains("sweep.toml is there already"), "{err}");
    assert_eq!(place.files(), ["sweep.toml", "table.csv"]);
}

#[test]
fn random_axes_are_drawn_together_and_again_the_same() {
    let random = |seed: &str| {
        format!(
            "{seed}[axes]\na = {{ random = [1.001, 1.05, 50] }}\nomega = {{ random-log = [0.5, 8, 50] }}\neta = 0.9\n[want]\ncolumns = [\"tau_ch\"]\n"
        )
    };
    let place = Place::with(&random(""));
    let table = place.table("");
    assert_eq!(rows(&table).len(), 50);
    assert_eq!(place.table("--threads 1"), table);
    assert_eq!(Place::with(&random("seed = 1\n")).table(""), table);
    let other = Place::with(&random("seed = 2\n")).table("");
    assert!(rows(&other).iter().zip(rows(&table)).all(|(one, other)| one[0] != other[0] && one[1] != other[1]));
    // hashlib.sha256(b"1/a/0"), its first 53 bits
    let share = 0.049_002_331_200_932_87;
    let first: f64 = rows(&table)[0][0].parse().unwrap();
    assert!((first - (1.001 + 0.049 * share)).abs() < 1e-15, "{first}");
}

#[test]
fn a_scene_is_swept_over_any_of_its_fields() {
    let sweep = format!(
        "scene = {SCENE:?}\n[axes]\nground.amplitude.over-threshold = {{ linear = [0.5, 1.5, 5] }}\nblock.restitution = [0.5, 0.6]\n[want]\ncolumns = [\"tau_ch\", \"rest_time\", \"bouts\"]\n"
    );
    let table = Place::with(&sweep).table("");
    let rows = rows(&table);
    let head = "ground.amplitude.over-threshold,block.restitution,tau_ch,uncertainty,tau_ch_ending,rest_time,rest_time_uncertainty,bouts,ending\n";
    assert!(table.starts_with(head), "{table}");
    assert_eq!((rows.len(), &rows[0][2..]), (10, &["", "", "never-rocks", "", "", "0", "never-rocks"][..]));
    let scene = fs::read_to_string(SCENE).unwrap();
    let place = Place::with(&sweep);
    for row in rows.iter().filter(|row| row[4] == "at-rest") {
        let number = |place: usize| row[place].parse::<f64>().unwrap();
        let text: String = scene
            .lines()
            .map(|line| match line.split(" =").next() {
                Some("amplitude") => format!("amplitude = {{ over-threshold = {} }}\n", row[0]),
                Some("restitution") => format!("restitution = {}\n", row[1]),
                _ => format!("{line}\n"),
            })
            .collect();
        fs::write(place.path("scene.toml"), text).unwrap();
        let mut command = Command::cargo_bin("chattercheck").unwrap();
        command.args(["chattering-time", "--scene", "scene.toml", "--format", "json"]).current_dir(place.0.path());
        let answer: serde_json::Value = serde_json::from_slice(&command.output().unwrap().stdout).unwrap();
        assert!((answer["tau_ch"].as_f64().unwrap() - number(2)).abs() <= 2.0 * number(3), "{row:?} {answer}");
    }
}

/// Everything that can be wrong with a sweep: one line that names the field, what stands there, and what is allowed.
#[test]
fn bad_input_is_one_line_that_names_field_value_and_range() {
    let good = "[axes]\na = 1.01\nomega = 2\neta = [0.8, 0.9]\n[want]\ncolumns = [\"tau_ch\"]\n";
    let replaced = |from: &str, to: &str| {
        assert!(good.contains(from));
        good.replace(from, to)
    };
    let scene = |axes: &str| format!("scene = {SCENE:?}\n[axes]\n{axes}\n[want]\ncolumns = [\"tau_ch\"]\n");
    let rows: &[(String, &[&str])] = &[
        ("x".to_owned(), &["line 1", "not TOML"]),
        (replaced("[want]", "[wanted]"), &["line 5", "wanted is not known here", "axes, want"]),
        (replaced("columns", "column"), &["column is not known here (perhaps columns)"]),
        (replaced("[\"tau_ch\"]", "[]"), &["columns = []", "tau_ch, uncertainty", "at least one"]),
        (replaced("\"tau_ch\"", "\"tau\""), &["columns = \"tau\"", "tau_ch, uncertainty"]),
        (replaced("\"tau_ch\"", "\"tau_ch\", \"tau_ch\""), &["columns = \"tau_ch\"", "each once"]),
        (replaced("\"tau_ch\"", "\"bouts\""), &["columns = \"bouts\"", "tau_ch"]),
        (replaced("a = 1.01\n", ""), &["axes.a is missing", "epsilon"]),
        (replaced("omega = 2\n", ""), &["axes.omega is missing"]),
        (replaced("a = 1.01", "a = 1.01\nepsilon = 0.01"), &["axes.epsilon", "one of a and epsilon"]),
        (replaced("omega", "frequency"), &["axes.frequency is not known here", "omega"]),
        (replaced("a = 1.01", "a = -1"), &["line 2", "axes.a at -1", "a = -1.0", "0 <= a <= 1e9"]),
        (replaced("a = 1.01", "a = nan"), &["line 2", "axes.a = nan", "a number"]),
        (replaced("a = 1.01", "a = []"), &["line 2", "axes.a = []", "a list"]),
        (replaced("a = 1.01", "a = [1.01, 1.01]"), &["axes.a = [1.01, 1.01]", "differ"]),
        (replaced("a = 1.01", "a = \"x\""), &["line 2", "axes.a at x", "a number"]),
        (replaced("0.9]", "1.0]"), &["line 4", "axes.eta at 1", "eta = 1.0", "0 < eta < 1"]),
        (replaced("a = 1.01", "a = { linear = [1, 2] }"), &["axes.a.linear = [1, 2]", "[low, high, how many]"]),
        (replaced("a = 1.01", "a = { linear = [2, 1, 5] }"), &["axes.a.linear = [2, 1, 5]", "low < high"]),
        (replaced("a = 1.01", "a = { linear = [1, 2, 1] }"), &["axes.a.linear", "2 to 1e9"]),
        (replaced("a = 1.01", "a = { linear = [1, 2, 2.5] }"), &["axes.a.linear", "how many"]),
        (replaced("a = 1.01", "a = { log = [0, 2, 5] }"), &["axes.a.log = [0, 2, 5]", "0 < low"]),
        (replaced("a = 1.01", "a = { random = [1, 2, 0] }"), &["axes.a.random", "1 to 1e9"]),
        (replaced("a = 1.01", "a = { logarithmic = [1, 2, 5] }"), &["axes.a", "logarithmic"]),
        (replaced("a = 1.01", "a = { log = [1, 2, 5], linear = [1, 2, 5] }"), &["axes.a", "one of"]),
        (format!("seed = 3\n{good}"), &["line 1", "seed = 3", "random"]),
        (
            format!("seed = -3\n{}", replaced("a = 1.01", "a = { random = [1, 2, 5] }")),
            &["line 1", "seed = -3", "0 to 9223372036854775807"],
        ),
        (
            replaced("a = 1.01", "a = { random = [1, 2, 5] }").replace("omega = 2", "omega = { random = [1, 2, 6] }"),
            &["line 3", "axes.omega with 6 values", "axes.a, 5"],
        ),
        (format!("normalisation = \"slender\"\n{good}"), &["normalisation = slender", "alpha"]),
        (format!("scene = \"none.toml\"\n{good}"), &["none.toml", "cannot read"]),
        (scene("restitution = 0.5"), &["axes.restitution", "block.restitution"]),
        (scene("block.restitution = [0.5, 1.5]"), &["line 3", "axes.block.restitution at 1.5", "restitution = 1.5"]),
        (scene("block.colour = 1"), &["axes.block.colour", "colour is not known here"]),
        (scene("block.restitution.x = 1"), &["axes.block.restitution.x", "not a field"]),
        (
            replaced("a = 1.01", "a = { linear = [1, 2, 1000000000] }")
                .replace("omega = 2", "omega = { linear = [1, 2, 1000000000] }"),
            &["axes", "up to 1e12"],
        ),
    ];
    let mut wrong = Vec::new();
    for (sweep, words) in rows {
        let place = Place::with(sweep);
        let (status, out, err) = place.run("--out table.csv");
        let is_refused = (status, out.as_str(), err.lines().count()) == (Some(2), "", 1);
        if !(is_refused && words.iter().all(|word| err.contains(word)) && place.files() == ["sweep.toml"]) {
            wrong.push(format!("{sweep}\n{words:?}\n{status:?} {err}"));
        }
    }
    let place = Place::with(good);
    for (arguments, words) in [
        ("--out -  --threads 0", &["threads = 0", "1 to 1024"][..]),
        ("--out - --partition 3/2", &["partition = 3/2", "1 <= K <= N"]),
        ("--out none/table.csv", &["cannot write none/table.csv.sweep"]),
        ("--out - --svg map.svg", &["svg = map.svg", "--out"]),
        ("--out t.csv --svg sweep.toml", &["svg = sweep.toml", "another file"]),
        ("--out t.csv --svg map.svg", &["y = none", "two axes"]),
        ("--out t.csv --svg map.svg --x omega", &["x = omega", "two axes"]),
        ("--out t.csv --svg map.svg --column colour", &["none"]),
        ("--out t.csv --x a", &["--svg"]),
        ("--out t.csv --redraw", &["--svg"]),
    ] {
        let (status, out, err) = place.run(arguments);
        let is_refused = (status, out.as_str(), err.lines().count()) == (Some(2), "", 1);
        if !(is_refused && words.iter().all(|word| err.contains(word)) && place.files() == ["sweep.toml"]) {
            wrong.push(format!("{arguments}\n{words:?}\n{status:?} {err}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn a_map_names_its_axes_its_colours_and_why_cells_are_empty() {
    let place = Place::with(&format!("title = \"A < map\"\n{MAP}"));
    let (status, out, err) = place.run("--out table.csv --svg -");
    assert_eq!(status, Some(0), "{err}");
    for text in ["A &lt; map", "η = 0.8", "η = 0.9", "ω", "a", "never-rocks", "incomplete"] {
        assert!(out.contains(&format!(">{text}<")), "{text}");
    }
    assert!(out.contains("chattering time τ") && !out.contains(">overturned<"));
    let redrawn = |more: &str| {
        let (status, out, err) = place.run(&format!("--out table.csv --svg - --redraw {more}"));
        assert_eq!(status, Some(0), "{err}");
        out
    };
    assert_eq!(redrawn(""), out);
    for more in ["--x omega --y a", "--x eta", "--column uncertainty", "--log-colour"] {
        assert_ne!(redrawn(more), out, "{more}");
    }
}
