//! The snippets for CIs of others: they are YAML, their parts fit together, and the commands in them are those of this program.

use std::{fs, path::Path};

use assert_cmd::Command;
use yaml_rust2::{Yaml, YamlLoader};

use super::pages::{read, root};

fn yaml(file: &str) -> Yaml {
    let documents = YamlLoader::load_from_str(&read(&format!("data/ci/{file}"))).unwrap();
    let [document] = documents.as_slice() else { panic!("{file}: {} documents", documents.len()) };
    document.clone()
}

fn text(value: &Yaml) -> &str {
    value.as_str().unwrap_or_else(|| panic!("{value:?} is no text"))
}

fn list(value: &Yaml) -> &[Yaml] {
    value.as_vec().unwrap_or_else(|| panic!("{value:?} is no list"))
}

/// The lines of a script that run this program, with the variables of a CI as they are in the second of four jobs.
fn commands(script: &str) -> Vec<String> {
    let second = |line: &str| {
        line.replace("${{ matrix.part }}", "2").replace("$CI_NODE_INDEX", "2").replace("$CI_NODE_TOTAL", "4")
    };
    script.lines().map(str::trim).filter(|line| line.starts_with("chattercheck ")).map(second).collect()
}

/// Whether the program understands a command: where nothing is to be read, that is what it says.
fn assert_understood(command: &str) {
    let folder = tempfile::tempdir().unwrap();
    let words = command.split_whitespace().skip(1);
    let output =
        Command::new(env!("CARGO_BIN_EXE_chattercheck")).args(words).current_dir(folder.path()).output().unwrap();
    let told = String::from_utf8(output.stderr).unwrap();
    let is_read = ["engines.toml", "parts"].iter().any(|file| told.contains(file)) && told.contains("No such file");
    assert!(output.status.code() == Some(2) && is_read, "{command}: {told}");
}

/// A step does one thing, and in a composite action says in which shell.
fn scripts_of_steps<'a>(steps: &'a Yaml, is_composite: bool) -> Vec<&'a str> {
    let of_step = |step: &'a Yaml| {
        assert!(step["uses"].is_badvalue() != step["run"].is_badvalue(), "{step:?}");
        if let Some(action) = step["uses"].as_str() {
            assert!(
                action.starts_with("./") || action.split_once('@').is_some_and(|(_, version)| version.starts_with('v'))
            );
        }
        assert!(!is_composite || step["run"].is_badvalue() || text(&step["shell"]) == "bash", "{step:?}");
        step["run"].as_str()
    };
    list(steps).iter().filter_map(of_step).collect()
}

#[test]
fn the_workflow_for_github_fits_together() {
    let workflow = yaml("github-workflow.yml");
    assert!(!workflow["on"].is_badvalue() && !workflow["name"].is_badvalue());
    let jobs = workflow["jobs"].as_hash().unwrap();
    let names: Vec<&str> = jobs.keys().map(text).collect();
    let mut all = Vec::new();
    for (name, job) in jobs {
        assert!(text(&job["runs-on"]).starts_with("ubuntu-"), "{name:?}");
        assert!(job["needs"].as_str().is_none_or(|needs| names.contains(&needs)), "{name:?}");
        all.extend(scripts_of_steps(&job["steps"], false).into_iter().flat_map(commands));
    }
    assert_eq!(all.len(), 2);
    all.iter().for_each(|command| assert_understood(command));
    // As many parts as are said to be; the whole waits for them, red or not, and takes what they leave.
    let part = &workflow["jobs"]["part"];
    let parts: Vec<i64> = list(&part["strategy"]["matrix"]["part"]).iter().map(|part| part.as_i64().unwrap()).collect();
    assert_eq!(parts, (1..=parts.len() as i64).collect::<Vec<_>>());
    assert!(all[0].contains(&format!("--partition 2/{} --out parts", parts.len())) && all[1].contains("merge parts"));
    assert_eq!(part["strategy"]["fail-fast"].as_bool(), Some(false));
    let whole = &workflow["jobs"]["whole"];
    assert_eq!((text(&whole["needs"]), text(&whole["if"])), ("part", "${{ !cancelled() }}"));
    let with = |job: &Yaml, action: &str| {
        let step =
            list(&job["steps"]).iter().find(|step| step["uses"].as_str().is_some_and(|uses| uses.starts_with(action)));
        step.unwrap()["with"].clone()
    };
    let (up, down) = (with(part, "actions/upload-artifact"), with(whole, "actions/download-artifact"));
    assert_eq!((text(&up["name"]), text(&up["path"])), ("part-${{ matrix.part }}", "parts"));
    assert_eq!((text(&down["pattern"]), text(&down["path"])), ("part-*", "parts"));
    // Both jobs have the program by the action beside this file.
    for job in [part, whole] {
        assert!(list(&job["steps"]).iter().any(|step| step["uses"].as_str() == Some("./.github/actions/chattercheck")));
    }
}

#[test]
fn the_composite_action_fits_together() {
    let action = yaml("action.yml");
    assert_eq!(text(&action["runs"]["using"]), "composite");
    let scripts = scripts_of_steps(&action["runs"]["steps"], true);
    let source = read("data/ci/action.yml");
    for (input, declared) in action["inputs"].as_hash().unwrap() {
        assert!(!text(&declared["description"]).is_empty());
        assert!(source.contains(&format!("inputs.{} }}}}", text(input))), "{input:?} is not used");
    }
    assert!(scripts.iter().any(|script| script.contains("cargo install --locked --git")));
    assert!(text(&action["inputs"]["revision"]["default"]).ends_with(env!("CARGO_PKG_VERSION")));
}

#[test]
fn the_jobs_for_gitlab_fit_together() {
    let file = yaml("gitlab-ci.yml");
    let stages: Vec<&str> = list(&file["stages"]).iter().map(text).collect();
    let jobs: Vec<(&str, &Yaml)> = file.as_hash().unwrap().iter().map(|(name, job)| (text(name), job)).collect();
    let jobs: Vec<_> = jobs.into_iter().filter(|(name, _)| !["stages", "variables"].contains(name)).collect();
    assert_eq!(jobs.len(), 2);
    let mut all = Vec::new();
    for (name, job) in jobs {
        assert!(stages.contains(&text(&job["stage"])), "{name}");
        // GitLab starts a shell in the image, which has the program as its entry point.
        assert_eq!(list(&job["image"]["entrypoint"]).iter().map(text).collect::<Vec<_>>(), [""], "{name}");
        assert_eq!(text(&job["artifacts"]["when"]), "always", "{name}");
        all.extend(list(&job["script"]).iter().flat_map(|line| commands(text(line))));
    }
    assert_eq!(all.len(), 2);
    all.iter().for_each(|command| assert_understood(command));
    assert_eq!(file["part"]["parallel"].as_i64(), Some(4));
    let junit = text(&file["whole"]["artifacts"]["reports"]["junit"]);
    assert!(all[1].contains(&format!("--junit {junit}")), "{}", all[1]);
    assert!(list(&file["part"]["artifacts"]["paths"]).iter().any(|path| path.as_str() == Some("parts")));
}

#[test]
fn the_container_recipe_builds_this_program() {
    let recipe = read("data/ci/Containerfile");
    let instructions = ["FROM", "WORKDIR", "COPY", "RUN", "USER", "ENTRYPOINT", "CMD"];
    let lines: Vec<&str> = recipe.lines().filter(|line| !line.is_empty() && !line.starts_with('#')).collect();
    assert!(lines.iter().all(|line| instructions.contains(&line.split(' ').next().unwrap())), "{lines:?}");
    // The toolchain is one that the program builds with, and what is built is what is copied.
    let needed = read("Cargo.toml");
    let needed = needed.lines().find_map(|line| line.strip_prefix("rust-version = ")).unwrap().trim_matches('"');
    assert!(lines[0].contains(&format!("rust:{needed}")), "{}", lines[0]);
    assert!(recipe.contains("--bin chattercheck") && recipe.contains("/source/target/release/chattercheck"));
    let shown = recipe.lines().filter_map(|line| line.split_once(" chattercheck verify").map(|(_, rest)| rest));
    let shown: Vec<String> = shown.map(|rest| format!("chattercheck verify{rest}")).collect();
    assert_eq!(shown.len(), 1);
    assert_understood(&shown[0]);
}

/// What is at hand in `data/ci` is what the guide tells of.
#[test]
fn the_guide_tells_of_every_snippet() {
    let guide = read("src/guide/parts.md");
    for entry in fs::read_dir(Path::new(root()).join("data/ci")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(guide.contains(&format!("data/ci/{name}")), "{name}");
    }
}
