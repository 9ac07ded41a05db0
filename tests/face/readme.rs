//! The README: short, its two commands first, and the verdict that it shows is from the run that is kept.

use super::pages::read;

/// A README of one success; the rest is in the guide.
const MOST_BYTES: usize = 8192;

#[test]
fn the_readme_is_short_and_begins_with_the_two_commands() {
    let readme = read("README.md");
    assert!(readme.len() <= MOST_BYTES, "{} bytes, {MOST_BYTES} allowed: move something to the guide", readme.len());
    let verify = readme.find("$ cargo run --release -- verify\n").unwrap();
    let test = readme.find("$ cargo test --workspace\n").unwrap();
    assert!(verify < test && test < 400);
}

#[test]
fn the_verdict_shown_is_from_the_run_that_is_kept() {
    let (readme, run) = (read("README.md"), read("data/record/verify.md"));
    let (_, from) = readme.split_once("<!-- verify:begin").unwrap();
    let (shown, _) = from.split_once("<!-- verify:end").unwrap();
    let shown: Vec<&str> = shown.lines().skip(1).filter(|line| !line.starts_with("```")).collect();
    assert!((10..=25).contains(&shown.len()), "{} lines", shown.len());
    for line in &shown {
        assert!(run.lines().any(|kept| kept == *line), "data/record/verify.md lacks: {line}");
    }
    assert!(shown.iter().any(|line| line.starts_with("PASS")));
}

#[test]
fn every_chapter_is_in_the_guide_and_reached_from_the_readme() {
    let (readme, guide) = (read("README.md"), read("src/guide/mod.rs"));
    for entry in std::fs::read_dir(super::pages::root().join("src/guide")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap();
        if name != "mod" {
            assert!(guide.contains(&format!("]({name})")), "src/guide/mod.rs does not introduce {name}");
            assert!(
                guide.contains(&format!("[{name}]: crate::guide::{name}\n")),
                "src/guide/mod.rs does not link {name}"
            );
            assert!(readme.contains(&format!("(src/guide/{name}.md)")), "the README does not lead to {name}");
        }
    }
}
