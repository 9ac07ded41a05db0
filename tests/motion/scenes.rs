//! Scenes: physical units, and what is wrong with a file, said on its line.

use approx::assert_relative_eq;
use assert_cmd::Command;
use chattercheck::{
    motion::scene::{AnswerError, Answers, Scene, schema},
    panel,
};
use contract::Normalisation;
use serde_json::Value;

const BLOCK: &str = "[block]\nhalf_width = 0.2\nhalf_height = 1.1\nrestitution = 0.9\n";
const GROUND: &str = "[ground]\namplitude = { g = 0.19 }\nfrequency = { hz = 1.5 }\n";

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap()
}

fn answers(scene: &Scene) -> Result<Answers, AnswerError> {
    scene.answers(panel::stepper_of(scene.ask.model).as_ref())
}

fn error(text: &str) -> String {
    Scene::parse(text).unwrap_err().to_string()
}

#[test]
fn a_block_in_metres_and_a_motion_in_hertz_become_a_case() {
    let scene = scene(&format!("{BLOCK}{GROUND}"));
    let case = scene.case().unwrap();
    // R² = b² + h², tan α = b/h, p² = 3g/4R.
    let radius = (0.2_f64 * 0.2 + 1.1 * 1.1).sqrt();
    let p = (0.75 * 9.81 / radius).sqrt();
    assert_relative_eq!(case.amplitude(), 0.19 * 1.1 / 0.2, max_relative = 1e-15);
    assert_relative_eq!(case.omega(), std::f64::consts::TAU * 1.5 / p, max_relative = 1e-15);
    assert_eq!(case.eta(), 0.9);
    let slenderness = case.slenderness().unwrap();
    assert_relative_eq!(slenderness.alpha().tan(), 0.2 / 1.1, max_relative = 1e-15);
    assert_eq!(slenderness.normalisation(), Normalisation::Threshold);
}

/// The same scene said in other words.
#[test]
fn every_way_to_say_it_means_the_same() {
    let one = scene(&format!("{BLOCK}{GROUND}")).case().unwrap();
    let alpha = 0.2_f64.atan2(1.1);
    let radius = 0.2_f64.hypot(1.1);
    let p = (0.75 * 9.81 / radius).sqrt();
    let by_radius = format!("[block]\nradius = {radius:?}\nslenderness = {alpha:?}\nrestitution = 0.9\n");
    for amplitude in [
        "{ g = 0.19 }".to_owned(),
        format!("{{ m-per-s2 = {:?} }}", 0.19 * 9.81),
        format!("{{ over-threshold = {:?} }}", 0.19 / alpha.tan()),
    ] {
        for frequency in ["{ hz = 1.5 }".to_owned(), format!("{{ omega = {:?} }}", std::f64::consts::TAU * 1.5 / p)] {
            let other = format!("{by_radius}[ground]\namplitude = {amplitude}\nfrequency = {frequency}\n");
            let other = scene(&other).case().unwrap();
            assert_relative_eq!(one.epsilon(), other.epsilon(), max_relative = 1e-13);
            assert_relative_eq!(one.omega(), other.omega(), max_relative = 1e-14);
        }
    }
    // In another field of gravity `g` is that one.
    let moon = |amplitude: String| {
        let block = by_radius.replace("restitution", "gravity = 1.62\nrestitution");
        scene(&format!("{block}[ground]\namplitude = {amplitude}\nfrequency = {{ hz = 1.5 }}\n")).case().unwrap()
    };
    let threshold = 1.62 * alpha.tan();
    for amplitude in ["{ g = 0.19 }".to_owned(), format!("{{ m-per-s2 = {:?} }}", 0.19 * 1.62)] {
        assert_relative_eq!(moon(amplitude).amplitude(), 0.19 * 1.62 / threshold, max_relative = 1e-14);
    }
    let slender =
        format!("{by_radius}[ground]\namplitude = {{ over-slender-threshold = 1.03 }}\nfrequency = {{ omega = 2 }}\n");
    let slender = scene(&slender).case().unwrap();
    assert_eq!(slender.epsilon(), 1.03 - 1.0);
    assert_eq!(slender.slenderness().unwrap().normalisation(), Normalisation::Slender);
}

#[test]
fn housners_restitution_conserves_angular_momentum() {
    let alpha = 0.3_f64;
    let text = format!("[block]\nradius = 2\nslenderness = {alpha}\nrestitution = \"housner\"\n{GROUND}");
    // Angular momentum about the new corner before and after: I θ' - 2 m R² sin²α θ' = I θ'_after, I = 4/3 m R².
    let expected = (4.0 / 3.0 - 2.0 * alpha.sin().powi(2)) / (4.0 / 3.0);
    assert_relative_eq!(scene(&text).block.restitution, expected, max_relative = 1e-15);
    let stocky = text.replace("0.3", "1.2");
    assert!(error(&stocky).starts_with("line 4: restitution = -0.3"), "{}", error(&stocky));
}

/// `|a sin(ω_g t + phase)|` is below 1 before the initiation, and 1 there, rising; where it is above 1 from the start rocking begins at once.
#[test]
fn rocking_begins_when_the_ground_first_reaches_the_threshold() {
    for phase in [-3.0, -1.0, 0.0, 0.5, 1.6_f64.sin().atan(), 2.0, 3.0, 6.0] {
        let text = format!(
            "{BLOCK}[ground]\namplitude = {{ over-threshold = 1.2 }}\nfrequency = {{ hz = 2 }}\nphase = {phase:?}\n"
        );
        let ground = |time: f64| 1.2 * (std::f64::consts::TAU * 2.0 * time + phase).sin();
        let time = answers(&scene(&text)).unwrap().initiation.unwrap();
        if ground(0.0).abs() > 1.0 {
            assert_eq!(time, 0.0);
            continue;
        }
        assert_relative_eq!(ground(time).abs(), 1.0, max_relative = 1e-12);
        assert!(ground(time + 1e-6).abs() > 1.0, "{phase}: it falls");
        assert!((0..1000).all(|k| ground(time * f64::from(k) / 1000.0).abs() <= 1.0 + 1e-12), "{phase}: not the first");
    }
    let weak = format!("{BLOCK}[ground]\namplitude = {{ over-threshold = 0.99 }}\nfrequency = {{ hz = 2 }}\n");
    assert_eq!(answers(&scene(&weak)).unwrap().initiation, None);
    let short = format!(
        "{BLOCK}[ground]\namplitude = {{ over-threshold = 1.2 }}\nfrequency = {{ hz = 2 }}\nphase = 0.0\nduration = {{ seconds = 0.01 }}\n"
    );
    assert_eq!(answers(&scene(&short)).unwrap().initiation, None, "it ends before the threshold");
}

/// Each thing that is asked is answered, in seconds, and what is not asked is not.
#[test]
fn what_is_asked_is_answered() {
    let ask = |what: &str| {
        let text = format!(
            "{BLOCK}{GROUND}duration = {{ cycles = 3 }}\n[ask]\nwhat = [{what}]\nimpacts = 7\ntolerance = 1e-9\n"
        );
        let scene = scene(&text);
        (answers(&scene).unwrap(), scene)
    };
    let (answers, scene) = ask("\"chattering-time\", \"impact-times\", \"rest-periods\", \"response\"");
    let chattering = answers.chattering_time.unwrap();
    let p = scene.block.frequency_parameter();
    let (code, out, _) = {
        let case = scene.case().unwrap();
        let flags = [
            ("--a", case.amplitude()),
            ("--omega", case.omega()),
            ("--eta", case.eta()),
            ("--alpha", case.slenderness().unwrap().alpha()),
        ];
        let flags: Vec<String> =
            flags.iter().flat_map(|(flag, value)| [(*flag).to_owned(), format!("{value:?}")]).collect();
        let mut arguments = vec!["chattering-time", "--oracle", "enclosure", "--format", "json"];
        arguments.extend(flags.iter().map(String::as_str));
        run(&arguments)
    };
    assert_eq!(code, Some(0));
    let proven: Value = serde_json::from_str(&out).unwrap();
    let proven = proven["tau_ch"].as_f64().unwrap();
    assert!(
        chattering.complete == Some(true) && chattering.meets_tolerance == Some(true) && !chattering.after_the_motion
    );
    let claimed = chattering.relative_uncertainty.unwrap();
    assert!((chattering.seconds.unwrap() * p / proven - 1.0).abs() <= claimed && claimed < 1e-11, "{claimed}");
    let times = answers.impact_times.unwrap();
    assert!(times.len() == 7 && times.windows(2).all(|two| two[0] < two[1]) && times[6] < chattering.seconds.unwrap());
    let rests = answers.rest_periods.unwrap();
    assert_relative_eq!(rests[0].0, chattering.seconds.unwrap(), max_relative = 1e-14);
    assert_eq!((rests.len(), answers.response.unwrap().bouts), (6, 6));
    assert_relative_eq!(rests[5].1, 2.0, max_relative = 1e-12);
    let (answers, _) = ask("\"rest-periods\"");
    assert!(answers.chattering_time.is_none() && answers.impact_times.is_none() && answers.response.is_none());
}

#[test]
fn what_is_wrong_is_said_on_its_line_with_field_value_and_range() {
    let whole = format!("{BLOCK}{GROUND}");
    for (from, to, says) in [
        ("half_height = 1.1", "half_height = 0", "line 3: half_height = 0 is outside the allowed range: 1e-6 to 1e6"),
        ("half_height = 1.1", "half_height = -1.1", "line 3: half_height = -1.1"),
        ("half_height = 1.1", "half_height = 1e308", "line 3: half_height = 1e308"),
        ("half_height = 1.1", "half_height = nan", "line 3: half_height = nan"),
        ("half_height = 1.1", "half_height = inf", "line 3: half_height = inf"),
        (
            "half_height = 1.1\n",
            "",
            "[block] needs width and height (of the whole block), or half_width and half_height",
        ),
        ("half_height = 1.1", "half_height = 1.1\nradius = 2", "[block] needs"),
        (
            "half_height = 1.1",
            "half_height = \"tall\"",
            "line 3: half_height: allowed is a number, 1e-6 to 1e6 (metres), in `half_height = \"tall\"`",
        ),
        (
            "restitution = 0.9",
            "restitution = 1.01",
            "line 4: restitution = 1.01 is outside the allowed range: 0 < restitution < 1",
        ),
        ("restitution = 0.9", "restitution = \"newton\"", "line 4: "),
        ("restitution = 0.9\n", "", "restitution is missing"),
        (
            "restitution = 0.9",
            "restitution = 0.9\ncolour = 1",
            "line 5: colour is not known here; known are width, height, half_width, ",
        ),
        ("{ g = 0.19 }", "{ g = -0.19 }", "line 6: amplitude = { g = -0.19 }"),
        ("{ g = 0.19 }", "{ furlongs = 1 }", "line 6: amplitude: allowed is one of { g = number }, "),
        ("{ g = 0.19 }", "0.19", "line 6: amplitude: "),
        ("{ g = 0.19 }", "{ g = 0.19, over-threshold = 1.02 }", "line 6: amplitude: allowed is one of "),
        ("{ g = 0.19 }", "{}", "line 6: amplitude: allowed is one of "),
        (
            "{ g = 0.19 }",
            "{ g = 1e400 }",
            "line 6: amplitude: the number is too large; allowed is one of { g = number }, { m-per-s2 = number }, { over-threshold = number } or { over-slender-threshold = number }, in `amplitude = { g = 1e400 }`",
        ),
        ("{ hz = 1.5 }", "{ rpm = 90 }", "line 7: frequency: allowed is one of { hz = number } or { omega = number }"),
        ("{ hz = 1.5 }", "{ hz = 1.5 }\nduration = 10", "line 8: duration: "),
        ("{ hz = 1.5 }", "{ hz = 0 }", "line 7: frequency = { hz = 0 } is outside"),
        ("{ hz = 1.5 }", "{ hz = 1.5 }\nduration = { seconds = -1 }", "line 8: duration = { seconds = -1 } is outside"),
        ("{ hz = 1.5 }", "{ hz = 1.5 }\nduration = { cycles = 1e8 }", "line 8: duration = { cycles = 1e8 } is outside"),
        ("{ hz = 1.5 }", "{ hz = 1.5 }\nphase = nan", "line 8: phase = nan"),
        ("{ hz = 1.5 }", "{ hz = 1.5 }\n[ask]\nimpacts = 0", "line 9: impacts = 0"),
        ("{ hz = 1.5 }", "{ hz = 1.5 }\n[ask]\ntolerance = 0", "line 9: tolerance = 0 is"),
        (
            "{ hz = 1.5 }",
            "{ hz = 1.5 }\n[ask]\nmodel = \"cubic\"",
            "line 9: model: allowed is \"linear\" or \"nonlinear\", in `model",
        ),
        (
            "[ground]",
            "[grund]",
            "line 5: grund is not known here (perhaps ground); known are title, block, ground, start, ask",
        ),
        ("[ground]", "[ground", "line 5: "),
        ("{ hz = 1.5 }", "{ hz = 1.5 }\n[ask]\nwhat = []", "line 9: what: allowed is a list of at least one of "),
        ("{ hz = 1.5 }", "{ hz = 1.5 }\n[ask]\nwhat = [\"response\", \"response\"]", "line 9: what: allowed is "),
        ("{ hz = 1.5 }", "{ hz = 1.5 }\n[ask]\nwhat = \"response\"", "line 9: what: allowed is a list"),
    ] {
        assert!(whole.contains(from));
        let message = error(&whole.replace(from, to));
        assert!(message.contains(says) && message.lines().count() == 1, "{to}: {message}");
    }
    assert!(error(&" ".repeat(2 << 20)).contains("up to 1 MiB"));
}

fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_chattercheck")).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

#[test]
fn the_scenes_that_come_with_it_can_be_asked() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let path = path.to_str().unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        if Scene::parse_in(&text, folder.as_ref()).unwrap().sine().is_err() {
            // Not the history of a case.
            let (code, _, err) = run(&["response", path, "--format", "json"]);
            assert_eq!(code, Some(0), "{path}: {err}");
            count += 1;
            continue;
        }
        let (code, out, err) = run(&["chattering-time", "--scene", path, "--format", "json"]);
        assert_eq!(code, Some(0), "{path}: {err}");
        let answer: Value = serde_json::from_str(&out).unwrap();
        let scene = scene(&text);
        let seconds = answer["tau_ch"].as_f64().unwrap() / scene.block.frequency_parameter();
        assert_relative_eq!(answer["seconds"].as_f64().unwrap(), seconds, max_relative = 1e-15);
        // Whatever answers it, it is right to the tolerance of the scene, on the equation that the scene asks for.
        let model = scene.case().unwrap().slenderness().map_or("closed-form", |_| "taylor");
        let (_, exact, _) = run(&["chattering-time", "--scene", path, "--oracle", model, "--format", "json"]);
        let exact: Value = serde_json::from_str(&exact).unwrap();
        let (found, exact) = (answer["tau_ch"].as_f64().unwrap(), exact["tau_ch"].as_f64().unwrap());
        assert!((found / exact - 1.0).abs() <= scene.ask.tolerance, "{path}: {found} {exact}");
        assert!(answer["uncertainty"].as_f64().unwrap() <= scene.ask.tolerance * found);
        let (_, out, _) = run(&["scene", path, "--format", "json"]);
        let answer: Value = serde_json::from_str(&out).unwrap();
        assert_eq!(answer["rocks"], true);
        count += 1;
    }
    assert!(count >= 2);
}

#[test]
fn a_scene_that_is_not_there_or_together_with_flags_is_refused() {
    for arguments in [
        vec!["chattering-time", "--scene", "no-such-file.toml"],
        vec!["chattering-time", "--scene", "x.toml", "--a", "1.03"],
        vec!["chattering-time", "--a", "1.03", "--omega", "2"],
        vec!["scene"],
    ] {
        let (code, out, err) = run(&arguments);
        assert_eq!((code, out.as_str(), err.lines().count()), (Some(2), "", 1), "{arguments:?}: {err}");
    }
}

#[test]
fn the_published_schema_is_that_of_the_program() {
    let published = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/data/scenes/schema.json")).unwrap();
    assert_eq!(published, schema().unwrap(), "put the output of `chattercheck scene --schema` there");
}
