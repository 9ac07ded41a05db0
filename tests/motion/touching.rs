//! Ground that just touches the threshold: rounding decides whether the block moves there at all, and nothing that follows hangs on it.

use std::path::Path;

use assert_cmd::Command;
use chattercheck::{
    motion::{
        response::{Response, Termination},
        scene::Scene,
    },
    panel::{self, Settings},
};

/// A block with p = 1/s, on a record that reaches the threshold at 0.2 and passes it at 0.6 - 0.3/13.
const SCENE: &str = "[block]\nradius = 7.3575\nslenderness = 0.2\nrestitution = 0.8\n[ground]\nrecord = { file = \"r.txt\", units = \"threshold\", dt = { tau = 0.1 }, scale = SCALE }\n[ask]\nmodel = \"linear\"\n";

fn scene(folder: &Path, scale: &str) -> String {
    std::fs::write(folder.join("r.txt"), "0\n.5\n1.0\n.5\n0\n0\n1.3\n0\n0\n").unwrap();
    SCENE.replace("SCALE", scale)
}

#[test]
fn what_follows_a_touch_is_known() {
    let folder = tempfile::tempdir().unwrap();
    for (name, scale) in [
        ("closed-form", "1.0"),
        ("ode", "1.0"),
        ("taylor", "1.0"),
        ("ode", "-1.0"),
        ("taylor", "0.9999999999999999"),
        ("closed-form", "1.0000000000000013"),
        ("taylor", "1.0000000000000013"),
    ] {
        let scene = Scene::parse_in(&scene(folder.path(), scale), folder.path()).unwrap();
        let request = scene.on_motion(None, Termination::Exact).unwrap();
        let oracle = panel::one(name, &Settings::default(), "linear").unwrap();
        let response = Response::on_motion(oracle.as_ref(), &request).unwrap();
        let bout = response.bouts.last().unwrap();
        assert!((bout.begin() - 0.576_923_076_923_077).abs() < 1e-13, "{name} {scale}: {}", bout.begin());
        assert!(!bout.is_unsure() && bout.uncertainty() < 1e-11, "{name} {scale}: {}", bout.uncertainty());
        // As the enclosure proves it.
        assert!(
            (bout.end() - 0.851_589_096_835_174_7).abs() <= 2.0 * bout.uncertainty() + 1e-14,
            "{name} {scale}: {} +- {}",
            bout.end(),
            bout.uncertainty()
        );
        // The touch itself, if it is one, is told with how little is known of it.
        assert!(response.bouts.len() == 1 || response.bouts[0].end() - response.bouts[0].begin() < 1e-14);
    }
}

/// A plateau at the threshold is no touch: rounding decides whether it pushes for long.
#[test]
fn a_plateau_at_the_threshold_is_not_known() {
    let folder = tempfile::tempdir().unwrap();
    let text = scene(folder.path(), "1.0");
    std::fs::write(folder.path().join("r.txt"), "0\n.5\n1\n1\n1\n0\n1.3\n0\n0\n").unwrap();
    let scene = Scene::parse_in(&text, folder.path()).unwrap();
    let request = scene.on_motion(None, Termination::Exact).unwrap();
    let response = Response::on_motion(panel::stepper_on(&request.body, &request.motion).as_ref(), &request).unwrap();
    assert!(response.bouts.iter().any(|bout| bout.is_unsure()), "{:?}", response.rests());
}

#[test]
fn the_command_answers() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, scene(folder.path(), "1.0")).unwrap();
    for oracle in ["closed-form", "ode", "enclosure", "auto"] {
        let mut command = Command::cargo_bin("chattercheck").unwrap();
        let output = command
            .args(["response", path.to_str().unwrap(), "--oracle", oracle, "--format", "json"])
            .output()
            .unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{oracle}: {said}");
        let document: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let bouts = document["bouts"].as_array().unwrap();
        assert_eq!(bouts.len(), 1, "{oracle}");
        assert!((bouts[0]["from"].as_f64().unwrap() - 0.576_923_076_923_077).abs() < 1e-14, "{oracle}");
        assert!((bouts[0]["to"].as_f64().unwrap() - 0.851_589_096_835_174_7).abs() < 1e-11, "{oracle}");
        assert_eq!(bouts[0]["ending"], "complete", "{oracle}");
        assert!(!said.contains("NOT KNOWN"), "{said}");
    }
}
