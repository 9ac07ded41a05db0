//! One scene has one answer, whichever command is asked.

use approx::assert_relative_eq;
use assert_cmd::Command;
use serde_json::Value;

fn run(arguments: &[&str]) -> (i32, String, String) {
    let output = Command::cargo_bin("chattercheck").unwrap().args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

fn json(arguments: &[&str]) -> Value {
    let (status, stdout, stderr) = run(&[arguments, &["--format", "json"]].concat());
    assert_eq!(status, 0, "{arguments:?}: {stderr}");
    serde_json::from_str(&stdout).unwrap()
}

/// A pulse that is over before the block has come to rest, and a motion that goes on in which it never does.
#[test]
fn every_command_tells_the_same_of_a_pulse() {
    let file = "data/scenes/found/one_sine_pulse.toml";
    let scene = json(&["scene", file]);
    let seconds = scene["chattering_time"]["seconds"].as_f64().unwrap();
    for (oracle, tolerance) in [("auto", 1e-6), ("taylor", 1e-12), ("ode", 1e-6)] {
        let answer = json(&["chattering-time", "--scene", file, "--oracle", oracle]);
        assert_eq!(answer["complete"], true, "{oracle}");
        let off = answer["seconds"].as_f64().unwrap() / seconds - 1.0;
        assert!(off.abs() <= tolerance, "{oracle}: {off}");
    }
    let planned = json(&["plan", file]);
    assert!((planned["answer"]["seconds"].as_f64().unwrap() / seconds - 1.0).abs() < 1e-6);
    let p = scene["frequency_parameter"].as_f64().unwrap();
    let response = json(&["response", file]);
    let bout = &response["bouts"][0];
    // But for how JSON is read here these are the same doubles.
    assert_relative_eq!(
        bout["from"].as_f64().unwrap() / p,
        scene["initiation"].as_f64().unwrap(),
        max_relative = 1e-15
    );
    let times = scene["impact_times"].as_array().unwrap();
    assert_eq!(bout["impacts"].as_u64().unwrap() as usize, times.len());
    let listed = json(&["simulate", "--scene", file, "--impacts", "1000"]);
    let listed = listed["impacts"].as_array().unwrap();
    assert_eq!((listed.len(), listed[0]["tau"].as_f64()), (times.len() + 1, bout["from"].as_f64()));
    for (row, time) in listed.iter().skip(1).zip(times) {
        assert_relative_eq!(row["tau"].as_f64().unwrap() / p, time.as_f64().unwrap(), max_relative = 1e-15);
        let (velocity, sign) = (row["velocity"].as_f64().unwrap(), row["sign"].as_f64().unwrap());
        assert!(velocity * sign > 0.0);
    }
    let intervals: f64 = listed.iter().skip(1).map(|row| row["interval"].as_f64().unwrap()).sum();
    assert!(
        (intervals - (listed.last().unwrap()["tau"].as_f64().unwrap() - listed[0]["tau"].as_f64().unwrap())).abs()
            < 1e-12
    );
}

/// A motion that is above the threshold at its start sets the block off at once, in the middle of a lobe: times count from there, and what is claimed is
/// claimed for this motion, not for the one that starts at the threshold.
#[test]
fn every_command_tells_the_same_of_a_motion_that_starts_above_the_threshold() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    let text = "[block]\nradius = 2\nslenderness = 0.2\nrestitution = 0.9\n[ground]\namplitude = { over-threshold = 1.04 }\n\
                frequency = { omega = 2 }\nphase = 1.45\nduration = { cycles = 1 }\n[ask]\nmodel = \"linear\"\ntolerance = 1e-9\n\
                what = [\"chattering-time\", \"rest-periods\"]\n";
    std::fs::write(&path, text).unwrap();
    let file = path.to_str().unwrap();
    let scene = json(&["scene", file]);
    let time = &scene["chattering_time"];
    let (seconds, tau) = (time["seconds"].as_f64().unwrap(), time["tau_ch"].as_f64().unwrap());
    assert_eq!((scene["initiation"].as_f64(), time["complete"].as_bool()), (Some(0.0), Some(true)));
    assert_relative_eq!(scene["rest_periods"][0][0].as_f64().unwrap(), seconds, max_relative = 1e-15);
    let bout = &json(&["response", file, "--model", "linear"])["bouts"][0];
    assert_eq!((bout["from"].as_f64(), bout["to"].as_f64()), (Some(0.0), Some(tau)));
    let claimed = bout["uncertainty"].as_f64().unwrap() / tau;
    assert_relative_eq!(time["relative_uncertainty"].as_f64().unwrap(), claimed, max_relative = 1e-12);
    for oracle in ["closed-form", "ode", "auto"] {
        let answer = json(&["chattering-time", "--scene", file, "--oracle", oracle]);
        assert_relative_eq!(answer["tau_ch"].as_f64().unwrap(), tau, max_relative = 1e-8);
        assert_relative_eq!(answer["seconds"].as_f64().unwrap(), seconds, max_relative = 1e-8);
        let half_period = std::f64::consts::PI / 2.0;
        assert_relative_eq!(answer["half_period_fraction"].as_f64().unwrap(), tau / half_period, max_relative = 1e-8);
    }
}

/// An oracle that only knows cases says so; the judge follows a scene to its chattering time, and lists no impacts of one.
#[test]
fn an_oracle_that_cannot_follow_a_scene_refuses_it() {
    let file = "data/scenes/found/one_sine_pulse.toml";
    for (command, oracle) in [("chattering-time", "printed"), ("simulate", "enclosure")] {
        let (status, stdout, stderr) = run(&[command, "--scene", file, "--oracle", oracle]);
        assert_eq!((status, stdout.as_str(), stderr.lines().count()), (2, "", 1), "{command}: {stderr}");
        assert!(stderr.contains(oracle), "{stderr}");
    }
}

/// A case is answered as ever by an oracle that knows no more: the scene is no more than that.
#[test]
fn a_scene_that_is_a_case_is_answered_as_one() {
    let file = "data/scenes/paper_fig_9.toml";
    let scene = json(&["scene", file])["chattering_time"]["tau_ch"].as_f64().unwrap();
    for oracle in ["closed-form", "enclosure", "auto"] {
        let answer = json(&["chattering-time", "--scene", file, "--oracle", oracle]);
        assert!((answer["tau_ch"].as_f64().unwrap() / scene - 1.0).abs() < 1e-6, "{oracle}");
    }
}

#[test]
fn the_found_scenes_are_answered_right() {
    let ending = |file: &str| json(&["response", &format!("data/scenes/found/{file}.toml")]);
    let back = ending("comes_back");
    assert_eq!((back["bouts"][0]["ending"].as_str(), back["bouts"].as_array().unwrap().len()), (Some("complete"), 1));
    let scene = json(&["scene", "data/scenes/found/comes_back.toml"]);
    let first = scene["impact_times"][0].as_f64().unwrap() * scene["frequency_parameter"].as_f64().unwrap();
    assert!((first - 4.534_790_41).abs() < 1e-8, "{first}");
    let long = ending("hardly_damped");
    assert!((long["bouts"][0]["to"].as_f64().unwrap() - 20_075.896_946_342_1).abs() < 1e-9);
    let falls = ending("lies_on_its_side");
    assert_eq!(falls["bouts"][0]["ending"], "overturned");
    assert_eq!(falls["bouts"][0]["to"], falls["end"]);
    let (_, rows, summary) = run(&["response", "data/scenes/found/lies_on_its_side.toml"]);
    assert!(rows.trim_end().ends_with("lying") && summary.contains("lies on its side"), "{summary}");
    assert_eq!(ending("below_the_threshold")["bouts"].as_array().unwrap().len(), 0);
    let (_, rows, _) = run(&["response", "data/scenes/found/below_the_threshold.toml", "--steps", "10"]);
    for row in rows.lines().skip(1) {
        let cells: Vec<f64> = row.split(',').take(6).map(|cell| cell.parse().unwrap()).collect();
        let omega = ending("below_the_threshold")["omega"].as_f64().unwrap();
        assert!((cells[5] - 0.15 * (omega * cells[0] + 0.4).sin()).abs() < 1e-13, "{row}");
    }
}

/// A ground that touches the threshold exactly pushes nothing, and hides nothing that comes after.
#[test]
fn a_touch_of_the_threshold_is_no_push() {
    for oracle in ["closed-form", "taylor", "ode", "enclosure"] {
        let answer = json(&["response", "data/scenes/found/touches.toml", "--oracle", oracle]);
        let bouts = answer["bouts"].as_array().unwrap();
        let near = |value: &serde_json::Value, right: f64| (value.as_f64().unwrap() - right).abs() < 1e-6;
        // In doubles it hangs on the last digit of a sample whether the block moves there at all, but nothing that follows does.
        assert!(bouts.len() == 1 && bouts[0]["ending"] == "complete", "{oracle}: {answer}");
        assert!(near(&bouts[0]["from"], 0.576_923) && near(&bouts[0]["to"], 0.851_589), "{oracle}: {answer}");
    }
}

/// On other motions than a sinusoid too the first rocking is the same for each command, in seconds and in tau.
#[test]
fn a_pulse_and_a_record_are_answered_as_one() {
    for name in ["one_sine", "earthquake"] {
        let file = &format!("data/scenes/{name}.toml");
        let (response, time) = (json(&["response", file]), json(&["chattering-time", "--scene", file]));
        let (scene, listed) = (json(&["scene", file]), json(&["simulate", "--scene", file, "--impacts", "5"]));
        let p = response["frequency_parameter"].as_f64().unwrap();
        let bout = &response["bouts"][0];
        let lasts = bout["to"].as_f64().unwrap() - bout["from"].as_f64().unwrap();
        let near =
            |value: &Value, expected: f64| assert_relative_eq!(value.as_f64().unwrap(), expected, max_relative = 1e-12);
        near(&time["tau_ch"], lasts);
        near(&time["seconds"], lasts / p);
        near(&scene["chattering_time"]["seconds"], lasts / p);
        near(&scene["initiation"], bout["from"].as_f64().unwrap() / p);
        assert_eq!((&time["complete"], &time["half_period_fraction"]), (&Value::Bool(true), &Value::Null));
        assert_eq!(time["impacts"], bout["impacts"]);
        // What the motion is, dimensionless.
        for fact in ["ground", "strongest", "duration", "samples", "dt"] {
            assert_eq!((&scene[fact], &time[fact]), (&response[fact], &response[fact]), "{fact}");
        }
        let impacts = json(&["response", file, "--impacts", "5"])["bouts"][0]["impact_times"].clone();
        let times: Vec<Value> =
            listed["impacts"].as_array().unwrap().iter().skip(1).map(|row| row["tau"].clone()).collect();
        assert_eq!(Value::Array(times), impacts);
        let (_, said, _) = run(&["chattering-time", "--scene", file]);
        assert!(
            said.starts_with("tau_ch = ") && said.contains(" s, complete, by taylor") && !said.contains("T/2"),
            "{said}"
        );
    }
    // A block that is released has a velocity to begin with, and a side.
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("released.toml");
    let scene = "[block]\nwidth = 0.4\nheight = 2.2\nrestitution = 0.9\n[ground]\namplitude = { g = 0 }\nfrequency = { hz = 1 }\n[start]\nvelocity = 0.1\n";
    std::fs::write(&file, scene).unwrap();
    let released = json(&["simulate", "--scene", file.to_str().unwrap(), "--impacts", "2"]);
    assert_eq!((&released["impacts"][0]["velocity"], &released["impacts"][0]["sign"]), (&0.1.into(), &1.into()));
    let after = released["impacts"][1]["velocity"].as_f64().unwrap();
    assert!((after + 0.09).abs() < 1e-12, "{after}");
}

/// In a scene as of a case, what is listed is claimed, and the claims hold against what is proven.
#[test]
fn impacts_of_a_scene_are_claimed_and_the_claims_hold() {
    for (scene, model, oracle) in [
        ("one_sine", "linear", "closed-form"),
        ("one_sine", "linear", "ode"),
        ("one_sine", "nonlinear", "taylor"),
        ("one_sine", "nonlinear", "ode"),
        ("earthquake", "linear", "closed-form"),
        ("earthquake", "nonlinear", "taylor"),
    ] {
        let file = format!("data/scenes/{scene}.toml");
        let listed = json(&["simulate", "--scene", &file, "--model", model, "--oracle", oracle, "--impacts", "40"]);
        let proof = json(&["response", &file, "--model", model, "--oracle", "enclosure", "--impacts", "40"]);
        let rows = &listed["impacts"].as_array().unwrap()[1..];
        let bout = &proof["bouts"][0];
        assert!(rows.len() >= 20, "{scene} {model} {oracle}: {}", rows.len());
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        let mut before = number(&bout["from"]);
        for (k, row) in rows.iter().enumerate() {
            let (time, velocity) = (number(&bout["impact_times"][k]), number(&bout["impact_velocities"][k]));
            let off = (number(&row["tau"]) - time).abs();
            let claim = number(&row["tau_uncertainty"]);
            assert!(off <= claim && claim < 1e-6, "{scene} {model} {oracle} impact {k}: {off:e} {claim:e}");
            let off = (number(&row["velocity"]) / velocity - 1.0).abs();
            let claim = number(&row["velocity_uncertainty"]);
            assert!(off <= claim && claim < 1e-3, "{scene} {model} {oracle} velocity {k}: {off:e} {claim:e}");
            // The difference of two times has their rounding.
            let off = (number(&row["interval"]) - (time - before)).abs();
            let claim = number(&row["interval_uncertainty"]) * number(&row["interval"]) + 4.0 * f64::EPSILON * time;
            assert!(off <= claim, "{scene} {model} {oracle} interval {k}: {off:e} {claim:e}");
            before = time;
        }
    }
}

/// The judge says of a scene by `chattering-time` what it says by `response`.
#[test]
fn the_chattering_time_of_a_scene_is_proven() {
    for scene in ["one_sine", "earthquake"] {
        let file = format!("data/scenes/{scene}.toml");
        let found = json(&["chattering-time", "--scene", &file, "--oracle", "enclosure", "--digits", "25"]);
        let proof = json(&["response", &file, "--oracle", "enclosure", "--digits", "25"]);
        let bout = &proof["bouts"][0];
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        let lasts = number(&bout["to"]) - number(&bout["from"]);
        assert!((number(&found["tau_ch"]) - lasts).abs() < 1e-14, "{found}");
        let (lower, upper) = (found["lower"].as_str().unwrap(), found["upper"].as_str().unwrap());
        assert!(lower.len() == upper.len() && lower < upper && lower[..23] == upper[..23], "{lower} {upper}");
        let seconds = number(&found["tau_ch"]) / number(&proof["frequency_parameter"]);
        assert!((number(&found["seconds"]) - seconds).abs() < 1e-14);
        let stepped = json(&["chattering-time", "--scene", &file]);
        let off = (number(&stepped["tau_ch"]) - number(&found["tau_ch"])).abs();
        assert!(off <= number(&stepped["uncertainty"]) + 1e-15, "{scene}: {off:e}");
    }
}
