//! A manifest says what it means, and what is wrong with it is said with its line.

use super::*;

fn read(text: &str) -> Result<Manifest, String> {
    Manifest::parse(Path::new("engines.toml"), text).map_err(|error| error.to_string())
}

/// What is said about an engine with these lines after the first three.
fn told(lines: &str) -> String {
    read(&format!("[[engine]]\nname = \"mine\"\nmodel = \"linear\"\n{lines}")).unwrap_err()
}

#[test]
fn everything_can_be_said() {
    let text = r#"
[[engine]]
name = "mine"
run = ["sh", "-c", "true"]
directory = "src"
environment = { OMP_NUM_THREADS = "1" }
version = { command = ["sh", "--version"], pattern = "GNU *" }
start-timeout = 30
case-timeout = 0.5
grace = 1
processes = 2
restarts = 3
model = "nonlinear"
normalisation = "slender"
may-decline = 0.25
tolerance = { time = 1e-9, interval = 1e-8, reason = "my root finder" }
known = [
    { class = "interval", where = { eta = [0.97, 1.0], impact = [40, 1000] }, reason = "steps are too long", link = "https://example.org/1" },
    { class = "timed out", reason = "slow", within = 5 },
    { class = "sign-alternates", reason = "sign of zero" },
]

[[engine]]
name = "other"
run = ["sh"]
model = "linear"
"#;
    let manifest = read(text).unwrap();
    let [mine, other] = manifest.engines.as_slice() else { panic!("{manifest:?}") };
    let launch = &mine.launch;
    assert_eq!((launch.name.as_str(), launch.run.len(), launch.directory.as_path()), ("mine", 3, Path::new("src")));
    assert_eq!(launch.environment["OMP_NUM_THREADS"], "1");
    assert_eq!(
        [launch.start_timeout, launch.case_timeout, launch.grace].map(|time| time.as_secs_f64()),
        [30.0, 0.5, 1.0]
    );
    assert_eq!((launch.processes, launch.restarts), (2, 3));
    assert_eq!((launch.model, launch.normalisation), (Model::Nonlinear, Normalisation::Slender));
    assert_eq!(launch.tolerance, Tolerance { time: 1e-9, interval: 1e-8, velocity: 0.0, tau_ch: 0.0 });
    assert_eq!(
        (mine.reason.as_str(), mine.may_decline, mine.pattern.as_deref()),
        ("my root finder", 0.25, Some("GNU *"))
    );
    let classes: Vec<String> = mine.known.iter().map(ToString::to_string).collect();
    assert_eq!(
        classes,
        [
            "mine: interval, eta 0.97 to 1, impact 40 to 1000",
            "mine: timed out",
            "mine: the sign of the velocity alternates (Eq. 70)"
        ]
    );
    assert_eq!(mine.known[0].entry, "engines.toml, line 18");
    assert_eq!(mine.known.iter().map(|known| known.within).collect::<Vec<_>>(), [WITHIN, 5, WITHIN]);
    assert_eq!(other.launch.tolerance, Tolerance::default());
    assert_eq!((other.launch.directory.as_path(), other.may_decline), (Path::new("."), MAY_DECLINE));
    assert_eq!(manifest.engine("other").unwrap(), other);
    let unknown = manifest.engine("mien").unwrap_err().to_string();
    assert_eq!(unknown, "engines.toml: there is no engine \"mien\" in it; there are mine, other");
}

#[test]
fn what_is_wrong_is_said_with_its_line() {
    for (lines, expected) in [
        ("run = \"python3 mine.py\"", "line 4: run: allowed is a list of texts: the program first"),
        ("run = [\"sh\"]\ncase_timeout = 5", "line 5: case_timeout is not known here (perhaps case-timeout)"),
        ("run = [\"sh\"]\nrun = [\"sh\"]", "line 5: run is given twice"),
        ("run = []", "line 4: run = [] is outside the allowed range"),
        ("run = [\"pyhton3\", \"mine.py\"]", "line 4: run: there is no program \"pyhton3\" in the folders of PATH"),
        ("run = [\"./engine\"]", "line 4: run: there is no program engine: "),
        ("run = [\"src/lib.rs\"]", "line 4: run: "),
        ("run = [\"src/engines\"]", "line 4: run: src/engines is no file"),
        ("run = [\"sh\"]\ndirectory = \"nowhere\"", "line 5: directory: nowhere is no folder"),
        ("run = [\"sh\"]\nstart-timeout = -1", "line 5: -1 is no time in seconds"),
        ("run = [\"sh\"]\n\ncase-timeout = 0", "line 6: case-timeout = 0 s is outside"),
        ("run = [\"sh\"]\nprocesses = 1000", "line 5: processes = 1000 is outside"),
        ("run = [\"sh\"]\nmay-decline = 2.0", "line 5: may-decline: allowed is a share"),
        ("run = [\"sh\"]\ntolerance = { time = 1e-9 }", "line 5: tolerance: it needs a reason"),
        ("run = [\"sh\"]\ntolerance = { time = -1.0, reason = \"r\" }", "line 5: tolerance.time = -1.0 is outside"),
        (
            "run = [\"sh\"]\ntolerance = { tau_ch = 1.0, reason = \"r\" }",
            "line 5: tau_ch is not known here (perhaps tau-ch)",
        ),
        ("run = [\"sh\"]\nversion = { command = [\"pyhton3\"] }", "line 5: version: there is no program \"pyhton3\""),
        (
            "run = [\"sh\"]\nknown = [{ class = \"speed\", reason = \"r\" }]",
            "line 5: class: allowed is interval, velocity",
        ),
        ("run = [\"sh\"]\nknown = [{ class = \"interval\", reason = \" \" }]", "line 5: known: it needs a reason"),
        (
            "run = [\"sh\"]\nknown = [{ class = \"interval\", where = { eta = [1.0, 0.9] }, reason = \"r\" }]",
            "line 5: where: allowed is a range",
        ),
        ("run = [\"sh\"]\nknown = [\n{ class = \"interval\" }]", "line 6: known: it needs a reason"),
        (
            "run = [\"sh\"]\nknown = [\n{ class = \"interval\", reason = \"r\" },\n{ class = \"interval\", reason = \"q\" }]",
            "line 7: known: the same class",
        ),
        (
            "run = [\"sh\"]\nknown = [{ class = \"interval\", within = 0, reason = \"r\" }]",
            "line 5: within: allowed is",
        ),
        (
            "run = [\"sh\"]\nknown = [{ class = \"interval\", where = { impact = [1.5, 4] }, reason = \"r\" }]",
            "line 5: where: impact is a range of whole numbers",
        ),
        (
            "run = [\"sh\"]\nknown = [{ class = \"interval\", where = { eta = [1.5, 2.0] }, reason = \"r\" }]",
            "line 5: where: no case has eta from 1.5 to 2",
        ),
        ("", "line 1: run is missing in [engine]; allowed is a list of texts"),
    ] {
        let told = told(lines);
        assert!(told.starts_with(&format!("engines.toml: {expected}")), "{told}");
        assert!(!told.contains('\n'), "{told}");
    }
}

#[test]
fn names_are_unique_and_plain() {
    let engine = |name: &str| format!("[[engine]]\nname = \"{name}\"\nmodel = \"linear\"\nrun = [\"sh\"]\n");
    let twice = read(&(engine("mine") + &engine("other") + &engine("mine"))).unwrap_err();
    assert_eq!(twice, "engines.toml: line 10: name: \"mine\" is the name of an engine above already");
    for name in ["", "a b", "a,b", "../a", &"a".repeat(61)] {
        assert!(read(&engine(name)).unwrap_err().contains("line 2: name: allowed are"), "{name}");
    }
}

#[test]
fn no_manifest_is_no_manifest() {
    assert!(read("").unwrap_err().contains("there is no engine in it"));
    assert!(read("[[engines]]\n").unwrap_err().contains("line 1: engines is not known here (perhaps engine)"));
    assert!(Manifest::read(Path::new("no/such/file.toml")).unwrap_err().to_string().contains("cannot be read"));
    assert!(Manifest::read(Path::new("src")).unwrap_err().to_string().contains("cannot be read"));
}
