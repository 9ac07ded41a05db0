//! What an engineer sees first: the summary of a response and its drawing; and that both show what the data say.

use std::path::Path;

use assert_cmd::Command;
use roxmltree::{Document, Node};
use serde_json::Value;

const SCENES: [&str; 3] = ["earthquake", "one_sine", "paper_fig_9"];

fn run(arguments: &str) -> (Option<i32>, String, String) {
    let output = Command::cargo_bin("chattercheck").unwrap().args(arguments.split_whitespace()).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn json(scene: &str) -> Value {
    let (code, out, err) = run(&format!("response data/scenes/{scene}.toml --format json"));
    assert_eq!(code, Some(0), "{err}");
    serde_json::from_str(&out).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

#[test]
fn the_summary_is_that_of_the_data() {
    for scene in SCENES {
        let document = json(scene);
        let (summary, p) = (&document["summary"], number(&document["frequency_parameter"]));
        let bouts = document["bouts"].as_array().unwrap();
        let impacts: u64 = bouts.iter().map(|bout| bout["impacts"].as_u64().unwrap()).sum();
        assert_eq!(
            (summary["impacts"].as_u64(), summary["times_of_rocking"].as_u64()),
            (Some(impacts), Some(bouts.len() as u64))
        );
        let near = |one: &Value, other: f64| {
            assert!((number(one) - other).abs() <= 1e-12 * other.abs(), "{scene}: {one} {other}")
        };
        near(&summary["begins_to_rock"], number(&bouts[0]["from"]) / p);
        let largest = &summary["largest_rotation"];
        near(&largest["degrees"], number(&document["peak"]["theta"]));
        near(&largest["share_of_alpha"], number(&document["peak"]["phi"]).abs());
        near(&largest["seconds"], number(&document["peak"]["tau"]) / p);
        let rests = summary["rests"].as_array().unwrap();
        assert_eq!(rests.len(), document["rests"].as_array().unwrap().len());
        for (one, other) in rests.iter().zip(document["rests"].as_array().unwrap()) {
            near(&one["from"], number(&other["from"]) / p);
            near(&one["to"], number(&other["to"]) / p);
        }
        // In words, in seconds and degrees before tau.
        let (_, text, _) = run(&format!("response data/scenes/{scene}.toml --format text"));
        for words in [
            format!(
                "at {:.4} s; on its base it takes {:.4} g",
                number(&summary["begins_to_rock"]),
                number(&summary["threshold"])
            ),
            format!("{:.1} % of the way", 100.0 * number(&largest["share_of_alpha"])),
            format!("degrees, at {:.4} s", number(&largest["seconds"])),
            format!("{impacts} resolved, in {} time", bouts.len()),
            "at rest, from".to_owned(),
        ] {
            let at = text.find(&words).unwrap_or_else(|| panic!("{scene}: no {words} in {text}"));
            assert!(at < text.find("tau").unwrap(), "{scene}: {words} after tau");
        }
        // Where the history is printed it is told beside it.
        let (_, csv, told) = run(&format!("response data/scenes/{scene}.toml"));
        assert!(csv.starts_with("tau,t,") && told.lines().filter(|line| text.contains(line)).count() >= 10, "{told}");
    }
}

fn attribute(node: Node, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

fn drawn(scene: &str, options: &str, folder: &Path) -> String {
    let file = folder.join("drawn.svg");
    let (code, out, err) = run(&format!("response data/scenes/{scene}.toml --svg {} {options}", file.display()));
    assert_eq!(code, Some(0), "{err}");
    assert!(out.contains("begins to rock") && err.is_empty(), "the summary, and no thousand rows: {out}{err}");
    std::fs::read_to_string(file).unwrap()
}

#[test]
fn the_drawing_shows_the_rests_and_the_rotation() {
    let folder = tempfile::tempdir().unwrap();
    for scene in SCENES {
        let svg = drawn(scene, "", folder.path());
        let tree = Document::parse(&svg).unwrap();
        let nodes = |name: &'static str| tree.descendants().filter(move |node| node.has_tag_name(name));
        let document = json(scene);
        // Each rest is shaded twice, behind the ground and behind the rotation, as long as it lasts; and once more in the legend.
        let rests: Vec<f64> = document["rests"]
            .as_array()
            .unwrap()
            .iter()
            .map(|rest| number(&rest["to"]) - number(&rest["from"]))
            .collect();
        let shades: Vec<f64> = nodes("rect")
            .filter(|rect| rect.attribute("fill") == Some("#DFE9F2"))
            .map(|rect| attribute(rect, "width"))
            .collect();
        assert_eq!(shades.len(), 2 * rests.len() + 1, "{scene}");
        let (total, wide): (f64, f64) = (rests.iter().sum(), shades[..rests.len()].iter().sum());
        for (width, rest) in shades.iter().zip(rests.iter().chain(&rests)) {
            assert!((width / wide - rest / total).abs() < 0.2 / wide * rests.len() as f64, "{scene}: {width} {rest}");
        }
        // The line of the rotation goes as far to either side as the history.
        let (_, csv, _) = run(&format!("response data/scenes/{scene}.toml --steps 2000"));
        let turned: Vec<f64> = csv.lines().skip(1).map(|row| row.split(',').nth(3).unwrap().parse().unwrap()).collect();
        let lines: Vec<Vec<f64>> = nodes("polyline")
            .filter(|line| line.attribute("stroke") == Some("#D55E00"))
            .map(|line| {
                line.attribute("points")
                    .unwrap()
                    .split(' ')
                    .map(|place| place.split(',').nth(1).unwrap().parse().unwrap())
                    .collect()
            })
            .collect();
        let line = &lines[0];
        let extremes =
            |of: &[f64]| (of.iter().copied().fold(f64::NAN, f64::min), of.iter().copied().fold(f64::NAN, f64::max));
        let ((left, right), (top, bottom), base) = (extremes(&turned), extremes(line), line[0]);
        let scale = (bottom - top) / (right - left);
        assert!(((base - top) - scale * right).abs() < 0.3, "{scene}: {base} {top} {scale} {right}");
        let words: Vec<&str> = nodes("text").filter_map(|text| text.text()).collect();
        for word in
            ["time (s)", "ground (g)", "rotation (degrees)", "θ/α", "at rest", "impacts", "time left until rest (s)"]
        {
            assert_eq!(words.iter().filter(|other| **other == word).count(), 1, "{scene}: {word} in {words:?}");
        }
    }
    // A part of it is drawn too.
    let part = drawn("earthquake", "--from 4s --to 8s", folder.path());
    assert!(Document::parse(&part).is_ok() && part != drawn("earthquake", "", folder.path()));
}

#[test]
fn a_block_that_does_not_rock_or_falls_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let still = drawn("found/below_the_threshold", "", folder.path());
    assert!(still.contains("The block does not rock.") && !still.contains("magnified"));
    let falls = drawn("found/lies_on_its_side", "", folder.path());
    assert!(falls.contains("it overturns"));
}

#[test]
fn the_page_needs_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let (svg, html) = (folder.path().join("a.svg"), folder.path().join("a.html"));
    let (code, _, err) =
        run(&format!("response data/scenes/one_sine.toml --svg {} --html {}", svg.display(), html.display()));
    assert_eq!(code, Some(0), "{err}");
    let (svg, html) = (std::fs::read_to_string(svg).unwrap(), std::fs::read_to_string(html).unwrap());
    assert!(html.contains(&svg), "the page has the drawing");
    let elsewhere = html.matches("//").count() - html.matches("http://www.w3.org/2000/svg").count();
    assert_eq!(elsewhere, 0, "no address");
    for words in ["default-src 'none'", "begins to rock", "Times of rocking", "complete", "width=device-width"] {
        assert!(html.contains(words), "{words}");
    }
    // The same again, byte for byte, on stdout.
    let (_, again, told) = run("response data/scenes/one_sine.toml --html -");
    assert!(again == html && told.contains("begins to rock"));
}

#[test]
fn files_that_cannot_be_written_and_options_that_are_not_used_are_refused() {
    let scene = "response data/scenes/one_sine.toml";
    for (arguments, words) in [
        (format!("{scene} --svg /no/such/folder/a.svg"), vec!["/no/such/folder/a.svg"]),
        (format!("{scene} --svg a.svg --html a.svg"), vec!["html = a.svg", "--svg"]),
        (format!("{scene} --svg data/scenes/one_sine.toml"), vec!["svg", "another file than the scene"]),
        (
            "response data/scenes/earthquake.toml --svg data/scenes/shaking.AT2".to_owned(),
            vec!["the record of the scene"],
        ),
        (format!("{scene} --svg - --format json"), vec!["format = json", "--svg"]),
        (format!("{scene} --format text --from 1"), vec!["from = 1", "--format csv, --svg or --html"]),
        (format!("{scene} --svg a.svg --steps 7"), vec!["steps = 7", "--format csv"]),
        (format!("{scene} --svg a.svg --impacts 7"), vec!["impacts = 7", "--format json"]),
        (format!("{scene} --until -1s"), vec!["--until", "-1s", "2.5s"]),
        (format!("{scene} --from 99s"), vec!["from = 99s", "end of the response"]),
    ] {
        let (code, out, err) = run(&arguments);
        assert_eq!((code, out.as_str(), err.lines().count()), (Some(2), "", 1), "{arguments}: {err}");
        assert!(words.iter().all(|word| err.contains(word)), "{arguments}: {err}");
    }
    assert!(!Path::new("a.svg").exists());
}

/// A time in seconds is the same time in tau.
#[test]
fn a_time_may_be_in_seconds() {
    let p = number(&json("one_sine")["frequency_parameter"]);
    let (_, seconds, _) = run("response data/scenes/one_sine.toml --until 0.5s --format json");
    let (_, tau, _) = run(&format!("response data/scenes/one_sine.toml --until {:?} --format json", 0.5 * p));
    assert_eq!(seconds, tau);
    assert_eq!(serde_json::from_str::<Value>(&seconds).unwrap()["summary"]["end"], 0.5);
    let (_, criterion, _) = run("criterion data/scenes/one_sine.toml --until 0.5s --format json");
    assert_eq!(criterion, run(&format!("criterion data/scenes/one_sine.toml --until {:?} --format json", 0.5 * p)).1);
}
