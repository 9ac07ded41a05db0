//! The oracles are independent: none depends on another, and none on anything that is not on its list.
//!
//! Shared code would make two methods agree on the same mistake. The contract crate carries words only: it is `no_std`, which keeps `sqrt`
//! and `sin` out of it, and depends on nothing.

use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
    process::Command,
};

use serde_json::Value;

use super::paths::Paths;

/// What each crate under `oracles/` may depend on, at run time and at build time. To use something new, add it here with a reason.
const ALLOWED: &[(&str, &[&str])] = &[
    ("contract", &[]),
    // registers of an instruction set, found at run time and of the baseline; threads
    ("closed_form", &["contract", "pulp", "rayon", "wide"]),
    // diffsol is the generic solver that this oracle is about
    ("ode", &["contract", "diffsol"]),
    // arithmetic with the digits of two doubles
    ("asymptotic", &["contract", "twofloat"]),
    ("taylor", &["contract"]),
    ("accumulation", &["contract"]),
    // arithmetic with many digits, rounded in the direction asked for; another library than that of `printed`
    ("enclosure", &["contract", "dashu-float", "dashu-int"]),
    // an engine of somebody else: the lines of the protocol, pipes that don't block, groups of processes; no method at all
    ("process", &["contract", "rustix", "serde", "serde_json"]),
    // arithmetic with many digits
    ("printed", &["contract", "astro-float"]),
];

/// The file that says how much tests run, as the tests of an oracle name it.
const EFFORT: [&str; 2] = ["#[path=\"../../../../tests/effort/mod.rs\"]", "#[path=\"../../../tests/effort/mod.rs\"]"];

fn metadata() -> Value {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--no-deps", "--offline"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The packages under `oracles/`, by name, with their dependencies (normal, build and development) by kind.
fn oracle_crates() -> Vec<(String, Vec<(String, String)>)> {
    let metadata = metadata();
    let packages = metadata["packages"].as_array().unwrap();
    let in_oracles = packages.iter().filter(|package| {
        let manifest = Path::new(package["manifest_path"].as_str().unwrap());
        manifest.parent().and_then(Path::parent).is_some_and(|folder| folder.ends_with("oracles"))
    });
    in_oracles
        .map(|package| {
            let dependencies = package["dependencies"].as_array().unwrap().iter();
            let named = dependencies.map(|dependency| {
                let kind = dependency["kind"].as_str().unwrap_or("normal");
                (dependency["name"].as_str().unwrap().to_owned(), kind.to_owned())
            });
            (package["name"].as_str().unwrap().to_owned(), named.collect())
        })
        .collect()
}

#[test]
fn every_folder_under_oracles_is_a_crate_with_an_entry() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("oracles");
    let folders: BTreeSet<String> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    let crates: BTreeSet<String> = oracle_crates().into_iter().map(|(name, _)| name).collect();
    let listed: BTreeSet<String> = ALLOWED.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(folders, crates);
    assert_eq!(crates, listed);
}

#[test]
fn no_oracle_depends_on_another_or_on_anything_off_its_list() {
    for (name, dependencies) in oracle_crates() {
        let allowed = ALLOWED.iter().find(|(listed, _)| *listed == name).unwrap().1;
        for (dependency, kind) in dependencies {
            if kind == "dev" {
                // Tests of an oracle may use test crates, but not another oracle as their truth.
                let is_oracle = ALLOWED.iter().any(|(other, _)| *other == dependency && dependency != "contract");
                assert!(!is_oracle, "{name} tests itself against the oracle {dependency}");
            } else {
                assert!(
                    allowed.contains(&dependency.as_str()),
                    "{name} depends on {dependency}, off its list {allowed:?}"
                );
            }
        }
    }
}

#[test]
fn every_oracle_is_built_from_its_own_folder_and_by_no_script() {
    for package in metadata()["packages"].as_array().unwrap() {
        let manifest = Path::new(package["manifest_path"].as_str().unwrap()).parent().unwrap();
        if !manifest.parent().is_some_and(|folder| folder.ends_with("oracles")) {
            continue;
        }
        for target in package["targets"].as_array().unwrap() {
            let source = Path::new(target["src_path"].as_str().unwrap());
            assert!(source.starts_with(manifest), "{} is built from {}", package["name"], source.display());
            let kinds = target["kind"].as_array().unwrap();
            assert!(!kinds.iter().any(|kind| kind == "custom-build"), "{} has a build script", package["name"]);
        }
    }
}

#[test]
fn no_oracle_takes_in_source_from_outside_its_folder() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("oracles");
    let mut files = vec![root];
    let mut seen = 0;
    while let Some(path) = files.pop() {
        if path.is_dir() {
            assert!(!path.is_symlink(), "{} is a link", path.display());
            files.extend(std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            assert!(!path.is_symlink(), "{} is a link", path.display());
            let text = std::fs::read_to_string(&path).unwrap();
            let text: String = text.chars().filter(|character| !character.is_whitespace()).collect();
            // The tests of all crates read in one file how much they run; it holds nothing of any method.
            let is_test = path.components().any(|part| part.as_os_str() == "tests" || part.as_os_str() == "tests.rs");
            let text = if is_test { EFFORT.iter().fold(text, |text, way| text.replace(way, "")) } else { text };
            for way_in in
                ["#[path", "path=\"", "cfg_attr(all", "include!", "include_str!", "include_bytes!", "env!(\"OUT_DIR"]
            {
                assert!(!text.contains(way_in), "{} uses {way_in}", path.display());
            }
            seen += 1;
        }
    }
    assert!(seen >= 15, "only {seen} source files found");
}

#[test]
fn the_contract_has_no_mathematics() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("oracles/contract/src");
    let lib = std::fs::read_to_string(folder.join("lib.rs")).unwrap();
    assert!(lib.contains("#![no_std]"), "the contract crate must stay no_std");
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        assert!(path.is_file(), "{} is a folder, which this test does not look into", path.display());
        let text = std::fs::read_to_string(path).unwrap();
        let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
        let code: String = code.flat_map(str::chars).filter(|character| !character.is_whitespace()).collect();
        for function in ["externcratestd", "libm", "sqrt(", "sin(", "cos(", "exp(", "powi(", "powf(", "f64::math"] {
            assert!(!code.contains(function), "the contract crate calls {function}");
        }
    }
}

/// The paths in the files of `src`, but for the files of tests.
fn sources() -> Vec<(PathBuf, Paths)> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
    let mut sources = Vec::new();
    while let Some(folder) = folders.pop() {
        for path in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") && !path.ends_with("tests.rs") {
                let paths = Paths::of_file(&path);
                sources.push((path, paths));
            }
        }
    }
    sources
}

/// Whether a path begins at the crate of an oracle.
fn is_of_an_oracle(path: &[String]) -> bool {
    ALLOWED.iter().any(|(name, _)| *name != "contract" && path.first().is_some_and(|first| first == name))
}

#[test]
fn only_the_panel_the_studies_and_the_tests_name_the_oracles() {
    // The studies are about single methods. Everything else meets a method through its row of the panel, and an engine of somebody else through the
    // manifest.
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let may_name = [source.join("panel.rs"), source.join("panel"), source.join("studies"), source.join("engines")];
    let mut by_those = 0;
    for (file, paths) in sources() {
        let named = paths.found.iter().filter(|path| is_of_an_oracle(path));
        if may_name.iter().any(|place| file.starts_with(place)) {
            by_those += named.count();
        } else {
            assert_eq!(named.collect::<Vec<_>>(), Vec::<&Vec<String>>::new(), "{}", file.display());
        }
    }
    assert!(by_those >= 7, "only {by_those} paths into an oracle were found");
}

#[test]
fn nothing_of_an_oracle_is_handed_on() {
    for (file, paths) in sources() {
        let handed_on: Vec<_> = paths.re_exported.iter().filter(|path| is_of_an_oracle(path)).collect();
        assert!(handed_on.is_empty(), "{} hands on {handed_on:?}", file.display());
    }
}
