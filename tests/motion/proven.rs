//! The judge on whole responses, by the command line: its bounds contain what another method found to 24 digits.

use assert_cmd::Command;
use serde_json::Value;

fn proven(arguments: &[&str]) -> Value {
    let output = Command::cargo_bin("chattercheck").unwrap().arg("response").args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

const PULSE: &str = r#"
[block]
radius = 1.0
slenderness = 0.1
restitution = 0.6

[ground]
pulse = "one-sine"
amplitude = { over-threshold = 1.02 }
frequency = { omega = 2 }

[ask]
model = "linear"
"#;

/// Of a decimal, the digits up to the 20th, to be compared as text.
fn digits(value: &Value) -> String {
    value.as_str().unwrap().chars().take(19).collect()
}

#[test]
fn the_sine_pulse_is_proven_to_as_many_digits_as_are_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pulse.toml");
    std::fs::write(&path, PULSE).unwrap();
    let arguments = ["--oracle", "enclosure", "--digits", "25", "--format", "json", "--impacts", "3"];
    let answer = proven(&[&[path.to_str().unwrap()][..], &arguments].concat());
    let bouts = answer["bouts"].as_array().unwrap();
    assert_eq!(bouts.len(), 2);
    for (bout, lower, upper, expected) in [
        (&bouts[0], "lower", "upper", "1.15829610235734598"),
        (&bouts[1], "from_lower", "from_upper", "2.25701722911294252"),
        (&bouts[1], "lower", "upper", "2.72909242915224260"),
    ] {
        assert_eq!((digits(&bout[lower]).as_str(), digits(&bout[upper]).as_str()), (expected, expected));
        assert!(bout[lower].as_str().unwrap() <= bout[upper].as_str().unwrap());
    }
    assert!(
        bouts.iter().all(|bout| bout["ending"] == "complete" && bout["impact_times"].as_array().unwrap().len() == 3)
    );
}

/// What other methods say of the earthquake is within what is proven of it.
#[test]
fn the_response_to_a_record_is_within_its_proof() {
    let scene = "data/scenes/earthquake.toml";
    let (proof, found) =
        (proven(&[scene, "--oracle", "enclosure", "--format", "json"]), proven(&[scene, "--format", "json"]));
    let (proof, found) = (proof["bouts"].as_array().unwrap(), found["bouts"].as_array().unwrap());
    assert!(proof.len() == found.len() && proof.len() == 2);
    for (proof, found) in proof.iter().zip(found) {
        assert_eq!(proof["ending"], "complete");
        assert_eq!(proof["ending"], found["ending"]);
        let near =
            |one: &Value, other: &Value, most: f64| (one.as_f64().unwrap() - other.as_f64().unwrap()).abs() <= most;
        assert!(near(&proof["from"], &found["from"], 1e-13));
        let off = found["uncertainty"].as_f64().unwrap() + 1e-14;
        assert!(near(&proof["to"], &found["to"], off), "{proof} {found}");
    }
}
