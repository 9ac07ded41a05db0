//! What linearisation costs on motions that are no case: both responses, compared.

use assert_cmd::Command;
use chattercheck::{
    motion::scene::Scene,
    plan::{MotionPlan, Parted},
};
use contract::Model;

fn scene(slenderness: f64, ground: &str) -> Scene {
    let block = format!("[block]\nradius = 1\nslenderness = {slenderness:?}\nrestitution = 0.8\n");
    Scene::parse(&format!("{block}[ground]\n{ground}\n")).unwrap()
}

const PULSE: &str = "pulse = \"one-sine\"\namplitude = { over-threshold = 1.04 }\nfrequency = { omega = 2 }";
const WAVELET: &str =
    "pulse = \"ricker\"\namplitude = { over-threshold = 1.1 }\nfrequency = { omega = 4 }\ncenter = { tau = 2 }";

/// Under the same multiple of the threshold the models differ by a multiple of the square of the slenderness, so the slender block is good enough down from
/// where that meets the tolerance.
#[test]
fn what_linearisation_costs_falls_as_the_square_of_the_slenderness() {
    for ground in [PULSE, WAVELET] {
        let plans = [0.1, 0.05, 0.025].map(|alpha| MotionPlan::new(&scene(alpha, ground)).unwrap());
        for plan in &plans {
            assert!(!plan.bouts.is_empty() && plan.parted.is_none(), "{ground}");
            assert_eq!((plan.linear.response.bouts.len(), plan.bouts.len()), (plan.bouts.len(), plan.bouts.len()));
            // By each model what its own response says.
            for (compared, bout) in plan.bouts.iter().zip(&plan.nonlinear.response.bouts) {
                assert_eq!((compared.from, compared.nonlinear), (bout.begin(), bout.end()));
            }
        }
        let errors = plans.each_ref().map(|plan| plan.error().unwrap());
        let turns = plans.each_ref().map(|plan| plan.rotation.unwrap());
        for falls in [errors, turns] {
            for pair in falls.windows(2) {
                assert!((3.7..4.3).contains(&(pair[0] / pair[1])), "{ground}: {falls:?}");
            }
        }
        let [plan, ..] = plans;
        assert_eq!((plan.needs(2.0 * errors[0]), plan.needs(0.5 * errors[0])), (Model::Linear, Model::Nonlinear));
        assert!(plan.uncertainty() < 1e-3 * errors[0]);
    }
}

/// Where one model gets over what the other does not, it is another response, at any tolerance.
#[test]
fn responses_that_part_need_the_block_as_it_is() {
    // A stocky block overturns where the slender one just does not, or the other way round.
    let plan = MotionPlan::new(&scene(0.6, &PULSE.replace("1.04", "1.238"))).unwrap();
    let overturns = [&plan.linear, &plan.nonlinear]
        .map(|of| of.response.bouts.last().is_some_and(|bout| bout.ending() == "overturned"));
    assert_ne!(overturns[0], overturns[1]);
    assert!(matches!(plan.parted, Some(Parted::Differ(_))) && plan.error().is_none());
    assert_eq!(plan.needs(0.5), Model::Nonlinear);
}

/// By the command line: a record, its errors, and what was not asked.
#[test]
fn a_record_is_planned() {
    let run = |arguments: &[&str]| {
        let output = Command::cargo_bin("chattercheck").unwrap().args(arguments).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let json: serde_json::Value =
        serde_json::from_str(&run(&["plan", "data/scenes/earthquake.toml", "--format", "json"])).unwrap();
    assert_eq!(json["chosen"], "taylor");
    let rows = json["candidates"].as_array().unwrap();
    let of = |method: &str| rows.iter().find(|row| row["method"] == method).unwrap();
    assert_eq!((&of("closed-form")["verdict"], &of("taylor")["verdict"]), (&"refused".into(), &"chosen".into()));
    assert!(of("closed-form")["flights"].as_u64().unwrap() > 100);
    assert!(of("asymptotic/paper")["why"].as_str().unwrap().contains("motions of the ground"));
    assert_eq!(of("ode/nonlinear/tsit45")["verdict"], "not needed");
    let off = json["largest_rotation"]["error"].as_f64().unwrap();
    assert!((1e-4..0.1).contains(&off), "{off}");
    let text = run(&["plan", "data/scenes/earthquake.toml"]);
    assert!(text.contains("answer: by taylor") && text.contains("of alpha"), "{text}");
}

/// Where the scene asks for the linear model, its answer is one of that model: how far the block as it is differs is told beside it.
#[test]
fn the_linear_model_is_planned_as_it_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    let block = "[block]\nradius = 1\nslenderness = 0.2\nrestitution = 0.8\n";
    std::fs::write(&path, format!("{block}[ground]\n{PULSE}\n[ask]\nmodel = \"linear\"\n")).unwrap();
    let run = |arguments: &[&str]| {
        let output =
            Command::cargo_bin("chattercheck").unwrap().arg("plan").arg(&path).args(arguments).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let json: serde_json::Value = serde_json::from_str(&run(&["--format", "json"])).unwrap();
    assert_eq!((&json["model"], &json["chosen"]), (&"linear".into(), &"closed-form".into()));
    assert_eq!(json["meets_tolerance"], true);
    let text = run(&[]);
    assert!(text.contains("refused: the linear model is asked for"), "{text}");
    let answer = text.lines().last().unwrap();
    assert!(answer.starts_with("answer: by closed-form, as asked, of the linear model that the scene asks for; the block as it is differs by "), "{answer}");
}
