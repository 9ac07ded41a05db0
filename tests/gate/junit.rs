//! The JUnit file, read by another parser than the one that wrote it.

use std::collections::{BTreeMap, BTreeSet};

use chattercheck::gate::{
    outcome::Outcomes,
    report::{self, FailedCase},
};
use roxmltree::{Document, Node};

use super::mixed::{Does, HOSTILE, Mixed, does, mixed};

fn test_cases<'a, 'input>(document: &'a Document<'input>) -> impl Iterator<Item = Node<'a, 'input>> {
    document.descendants().filter(|node| node.has_tag_name("testcase"))
}

/// What became of a test case: the name of its element, what its message says, and what stands inside.
fn status<'a>(case: Node<'a, '_>) -> (&'a str, &'a str, &'a str) {
    let mut elements = case.children().filter(Node::is_element);
    let Some(element) = elements.next() else { return ("", "", "") };
    assert!(elements.next().is_none(), "one status");
    (element.tag_name().name(), element.attribute("message").unwrap(), element.text().unwrap())
}

#[test]
fn every_case_and_what_an_engine_did_with_it_is_a_test_case() {
    let Mixed { report, cases, outcomes } = mixed("mine");
    let xml = report::junit(&report, &cases, &outcomes).unwrap();
    let document = Document::parse(&xml).unwrap();
    let all: Vec<Node> = test_cases(&document).collect();
    // Each once for the panel, once for the engine, and the run as a whole.
    assert_eq!(all.len(), 2 * cases.len() + 1);
    let names: BTreeSet<_> = all.iter().map(|case| (case.attribute("classname"), case.attribute("name"))).collect();
    assert_eq!(names.len(), all.len(), "every name is given once");
    for (place, named) in cases.iter().enumerate() {
        let of = |class: &str, name: &str| {
            let is_it =
                |case: &&Node| case.attribute("classname") == Some(class) && case.attribute("name") == Some(name);
            *all.iter().find(is_it).unwrap_or_else(|| panic!("no {name} in {class}"))
        };
        let panel = of(&format!("chattercheck.{}", named.generator.name()), &named.to_string());
        let engine = of("chattercheck.engine.mine", &format!("{named} by mine"));
        for case in [panel, engine] {
            let seconds: f64 = case.attribute("time").unwrap().parse().unwrap();
            assert!((0.0..60.0).contains(&seconds));
        }
        // The closed form is right; it is the engine that is asked here.
        assert_eq!(status(panel).0, "", "{named}");
        let (element, message, text) = status(engine);
        match does(place) {
            Does::Right => assert_eq!(element, ""),
            Does::Wrong => {
                assert_eq!(element, "failure");
                let finding = "mine is WRONG on velocity, first at impact 1";
                assert!(message.contains(finding) && text.contains(finding), "{message}");
                assert!(text.contains("see it: chattercheck"), "{text}");
            }
            Does::Breaks => {
                assert_eq!((element, message), ("error", "broke: crashed"));
                assert!(text.contains("mine BROKE: crashed: it said </script>"), "{text}");
            }
            Does::Declines => assert_eq!((element, message, text), ("skipped", "declined: on holiday", message)),
            Does::FailsAsKnown => {
                assert_eq!((element, message, text), ("skipped", "known: the step is too long", message));
            }
        }
    }
}

/// Readers believe the counts.
#[test]
fn the_counts_of_a_suite_are_those_of_its_test_cases() {
    let Mixed { report, cases, outcomes } = mixed("mine");
    let xml = report::junit(&report, &cases, &outcomes).unwrap();
    let document = Document::parse(&xml).unwrap();
    let suites: Vec<Node> = document.descendants().filter(|node| node.has_tag_name("testsuite")).collect();
    let names: Vec<_> = suites.iter().map(|suite| suite.attribute("name").unwrap()).collect();
    assert_eq!(names, ["verify", "engine mine", "verify as a whole"]);
    for suite in suites {
        let mut counted: BTreeMap<&str, usize> = BTreeMap::new();
        for case in suite.children().filter(|node| node.has_tag_name("testcase")) {
            *counted.entry("tests").or_default() += 1;
            *counted.entry(status(case).0).or_default() += 1;
        }
        for (attribute, element) in
            [("tests", "tests"), ("failures", "failure"), ("errors", "error"), ("skipped", "skipped")]
        {
            let said: usize = suite.attribute(attribute).unwrap().parse().unwrap();
            assert_eq!(said, counted.get(element).copied().unwrap_or_default(), "{attribute}");
        }
    }
}

/// Whatever an engine is called and says, the file can be read, and says it.
#[test]
fn hostile_names_stay_names() {
    let Mixed { report, cases, outcomes } = mixed(HOSTILE);
    let xml = report::junit(&report, &cases, &outcomes).unwrap();
    let document = Document::parse(&xml).unwrap();
    // All but the bell, which no XML can hold.
    let shown = HOSTILE.replace('\u{7}', "");
    assert!(test_cases(&document).any(|case| case.attribute("name").unwrap().contains(&shown)), "{xml}");
    assert_eq!(document.root_element().tag_name().name(), "testsuites");
}

/// What is listed of many cases of which many failed, and how large the file is: GitLab takes no larger one. More that passed would add nothing.
#[test]
fn a_file_of_many_cases_is_read_by_gitlab() {
    const CASES: usize = 150_000;
    const FAILED: usize = 60_000;
    let as_failed = |n: usize, wrong: FailedCase| FailedCase {
        name: format!("random/{}", n * 2),
        see: vec![HOSTILE.repeat(if n == 0 { 1000 } else { 5 })],
        ..wrong
    };
    let Mixed { mut report, cases, .. } = mixed("mine").many(CASES, FAILED, as_failed);
    report.engines.clear();
    let xml = report::junit(&report, &cases, &Outcomes::default()).unwrap();
    assert!(xml.len() < report::LARGEST_JUNIT, "{} bytes", xml.len());
    let document = Document::parse(&xml).unwrap();
    let count_in = |name: &str| name.split(' ').next().unwrap().parse::<usize>().unwrap();
    let (mut listed, mut whole, mut lines, mut passed, mut more) = (0, 0, 0, 0, 0);
    for case in test_cases(&document) {
        let (name, (element, message, text)) = (case.attribute("name").unwrap(), status(case));
        match element {
            "" if name.ends_with("more that passed") => passed += count_in(name),
            "failure" if name.ends_with("more that failed") => more += count_in(name),
            "failure" => {
                listed += 1;
                whole += usize::from(text.contains("see it"));
                lines += usize::from(text == message);
                assert!(text.len() < 50_000, "{name}");
                assert_eq!(name == "random/0", text.contains("more letters are cut off]"), "{name}");
            }
            _ => assert_eq!(name, "shortfalls"),
        }
    }
    assert_eq!(passed, CASES - FAILED);
    assert_eq!(listed + more, FAILED, "none that failed is left out silently");
    assert_eq!(whole + lines, listed);
    assert!(whole > 1000 && lines > 1000 && more > 1000, "{whole} {lines} {more}");
}
