//! The guide, and every other page: its links lead somewhere, its commands are understood, and the answers that it shows are those given.
//! Its Rust examples are run by `cargo test` as documentation.

use std::{collections::BTreeMap, process::Output};

use assert_cmd::Command;

use super::pages::{Page, all, read, root};

/// The targets of the links and images of a page that are files: in brackets, or defined at the foot.
fn links(page: &Page) -> Vec<&str> {
    let inline = page.prose().flat_map(|line| line.split("](").skip(1)).filter_map(|rest| rest.split(')').next());
    let at_foot = page.prose().filter(|line| line.starts_with('[')).filter_map(|line| Some(line.split_once("]: ")?.1));
    inline.chain(at_foot).filter(|target| !target.contains("://") && !target.starts_with('#')).collect()
}

#[test]
fn every_link_leads_somewhere() {
    let mut seen = 0;
    for page in all() {
        for target in links(&page) {
            let file = page.path.parent().unwrap().join(target.split('#').next().unwrap());
            assert!(file.exists(), "{}: no {target}", page.path.display());
            seen += 1;
        }
        for name in page.prose().flat_map(|line| line.split("][").skip(1)).filter_map(|rest| rest.split(']').next()) {
            assert!(page.text.contains(&format!("\n[{name}]: ")), "{}: [{name}] is undefined", page.path.display());
        }
    }
    assert!(seen >= 60, "{seen} links");
}

#[test]
fn every_file_that_a_page_names_exists() {
    let mut seen = 0;
    for page in all().iter().filter(|page| !page.path.ends_with("mutants.md")) {
        for span in page.spans() {
            let is_path = ["src/", "tests/", "oracles/", "benches/", "data/"].iter().any(|room| span.starts_with(room));
            if is_path && !span.contains(char::is_whitespace) {
                assert!(root().join(span).exists(), "{}: no {span}", page.path.display());
                seen += 1;
            }
        }
    }
    assert!(seen >= 40, "{seen} paths");
}

/// The command line of this program in what a page shows or names, without the program's own name.
fn arguments(shown: &str) -> Option<Vec<&str>> {
    let of_cargo = || shown.strip_prefix("cargo run --release -- ");
    Some(shown.strip_prefix("chattercheck ").or_else(of_cargo)?.split_whitespace().collect())
}

fn chattercheck(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_chattercheck")).args(arguments).current_dir(root()).output().unwrap()
}

#[test]
fn every_command_that_a_page_shows_is_understood() {
    let mut help: BTreeMap<String, String> = BTreeMap::new();
    let mut seen = 0;
    for page in all() {
        let shown = page.sessions().into_iter().map(|(command, _)| command);
        for arguments in shown.chain(page.spans()).filter_map(arguments) {
            let command = arguments[0];
            if command == "COMMAND" || command.starts_with("--") {
                continue;
            }
            let help = help.entry(command.to_owned()).or_insert_with(|| {
                let output = chattercheck(&[command, "--help"]);
                assert!(output.status.success(), "{}: there is no command {command}", page.path.display());
                String::from_utf8(output.stdout).unwrap()
            });
            let known = |flag: &str| help.split_whitespace().any(|word| word.trim_end_matches(',') == flag);
            for flag in arguments.iter().filter(|word| word.starts_with("--")) {
                assert!(known(flag), "{}: {command} has no {flag}", page.path.display());
            }
            seen += 1;
        }
    }
    assert!(seen >= 40, "{seen} commands");
    let commands = read("src/guide/commands.md");
    let listed = String::from_utf8(chattercheck(&["--help"]).stdout).unwrap();
    for line in listed.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty()) {
        let command = line.split_whitespace().next().unwrap();
        // Alone, or with what it is given.
        let is_listed = ["`", " "].iter().any(|end| commands.contains(&format!("`{command}{end}")));
        let is_listed = command == "help" || is_listed;
        assert!(is_listed, "src/guide/commands.md lacks {command}");
    }
}

#[test]
fn every_answer_that_the_guide_shows_is_the_one_given() {
    let mut seen = 0;
    for page in all().iter().filter(|page| page.path.starts_with(root().join("src/guide"))) {
        for (command, printed) in page.sessions().into_iter().filter(|(_, printed)| !printed.is_empty()) {
            let Some(arguments) = arguments(command) else { continue };
            let output = chattercheck(&arguments);
            let given = String::from_utf8(output.stdout).unwrap();
            let given: Vec<&str> = given.lines().filter(|line| !line.trim().is_empty()).collect();
            assert_eq!(printed, given, "{}: {command}", page.path.display());
            seen += 1;
        }
    }
    assert!(seen >= 3, "{seen} answers");
}

#[test]
fn every_method_is_described() {
    let methods = read("src/guide/methods.md");
    for oracle in chattercheck::panel::all() {
        let name = oracle.name();
        let tail = name.strip_prefix("ode/linear/").or_else(|| name.strip_prefix("ode/nonlinear/")).unwrap_or(name);
        assert!(methods.contains(&format!("`{tail}`")) || methods.contains(&format!("`{name}`")), "{name}");
    }
}
