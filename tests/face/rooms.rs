//! The rooms of the harness: who may import whom, and no circles between files.
//!
//! A reader who opens a room sees what it is made of; one who changes a room knows who can be hurt.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

use super::paths::Paths;

/// What each room of `src` may import. Those that are handed in (the panel, roles, methods) are not imported.
const MAY_IMPORT: &[(&str, &[&str])] = &[
    ("measure", &[]),
    // Files that say whether they are whole.
    ("stored", &[]),
    ("cases", &["measure"]),
    ("gate", &["cases", "measure", "stored"]),
    ("motion", &["cases", "measure"]),
    // The one table of the methods, and what they are good for.
    ("panel", &["gate", "measure", "motion"]),
    // Which method of the panel a scene needs.
    ("plan", &["measure", "motion", "panel"]),
    // Simulators of somebody else, as oracles beside the panel.
    ("engines", &["cases", "gate", "measure"]),
    // The gate in one call, for other crates.
    ("verify", &["faults", "gate", "measure", "panel"]),
    ("responders", &["cases", "gate", "measure", "motion", "panel"]),
    // The gate's own test plants faults in the panel.
    ("faults", &["cases", "gate", "measure", "panel"]),
    ("studies", &["cases", "faults", "gate", "measure", "motion", "panel", "plan", "responders"]),
    // Maps: points of cases and scenes, a table, and its drawing.
    ("sweep", &["cases", "measure", "motion", "panel", "stored", "studies"]),
    // A report as one HTML file.
    ("page", &["cases", "gate", "measure"]),
    // The Python package: a crate of its own, which takes the harness from outside.
    ("python", &[]),
    ("guide", &[]),
];

/// The modules of a crate, by path, each with the modules that it imports.
struct Modules {
    imports: BTreeMap<String, BTreeSet<String>>,
}

impl Modules {
    fn of(source: &Path) -> Self {
        let mut files: BTreeMap<String, PathBuf> = BTreeMap::new();
        let mut folders = vec![source.to_path_buf()];
        while let Some(folder) = folders.pop() {
            for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|extension| extension == "rs") {
                    let place = path.strip_prefix(source).unwrap().with_extension("");
                    let mut parts: Vec<&str> = place.iter().map(|part| part.to_str().unwrap()).collect();
                    parts.pop_if(|last| ["mod", "lib", "main"].contains(last));
                    // Tests may use what they like.
                    if parts.last() != Some(&"tests") {
                        files.insert(parts.join("::"), path);
                    }
                }
            }
        }
        let imports = files.iter().map(|(module, path)| {
            let paths = Paths::of_file(path);
            let named = paths.found.iter().filter_map(|path| {
                let full = absolute(module, path)?;
                let known = (1..=full.len()).rev().map(|length| full[..length].join("::"));
                known.into_iter().find(|name| files.contains_key(name))
            });
            (module.clone(), named.filter(|name| name != module).collect())
        });
        Self { imports: imports.collect() }
    }

    /// Files that import each other in a circle. The file of a folder stands above those in it: it names them, and they may name it.
    fn circle(&self) -> Option<Vec<&str>> {
        let is_above = |one: &str, other: &str| other.starts_with(&format!("{one}::"));
        let mut left: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        for (module, imports) in &self.imports {
            let beside = imports.iter().map(String::as_str);
            let beside = beside.filter(|other| !is_above(module, other) && !is_above(other, module));
            left.insert(module, beside.collect());
        }
        while let Some(leaf) = left.iter().find(|(_, imports)| imports.is_empty()).map(|(module, _)| *module) {
            left.remove(leaf);
            left.values_mut().for_each(|imports| {
                imports.remove(leaf);
            });
        }
        // Each of those that are left imports another of them.
        let mut walk = vec![*left.keys().next()?];
        loop {
            let next = *left[walk.last().unwrap()].iter().find(|other| left.contains_key(*other)).unwrap();
            if let Some(start) = walk.iter().position(|module| *module == next) {
                return Some(walk[start..].to_vec());
            }
            walk.push(next);
        }
    }
}

/// A path as it is seen from the root of the crate; none for one into another crate.
fn absolute(module: &str, path: &[String]) -> Option<Vec<String>> {
    let here = || module.split("::").filter(|part| !part.is_empty()).map(str::to_owned);
    let (first, mut rest) = path.split_first()?;
    let mut full: Vec<String> = match first.as_str() {
        "crate" => Vec::new(),
        "self" => here().collect(),
        "super" => {
            let mut above: Vec<String> = here().collect();
            above.pop();
            while let Some(("super", more)) = rest.split_first().map(|(part, more)| (part.as_str(), more)) {
                above.pop();
                rest = more;
            }
            above
        }
        _ => return None,
    };
    full.extend(rest.iter().cloned());
    Some(full)
}

#[test]
fn every_room_imports_only_what_it_may() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let modules = Modules::of(&source);
    let room = |module: &str| module.split("::").next().unwrap().to_owned();
    let mut crossings = 0;
    for (module, imports) in modules.imports.iter().filter(|(module, _)| !module.is_empty() && room(module) != "cli") {
        let from = room(module);
        let allowed = MAY_IMPORT.iter().find(|(name, _)| *name == from);
        let (_, allowed) = allowed.unwrap_or_else(|| panic!("{from} is a room without a row in MAY_IMPORT"));
        for to in imports.iter().map(|other| room(other)).filter(|to| *to != from) {
            assert!(allowed.contains(&to.as_str()), "{module} imports {to}, which {from} may not");
            crossings += 1;
        }
    }
    assert!(crossings >= 100, "only {crossings} imports between rooms were found");
}

#[test]
fn files_do_not_import_each_other_in_circles() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let oracles = fs::read_dir(root.join("oracles")).unwrap().map(|entry| entry.unwrap().path());
    for source in oracles.map(|oracle| oracle.join("src")).chain([root.join("src")]).filter(|source| source.is_dir()) {
        let circle = Modules::of(&source).circle().map(|files| files.join(" -> "));
        assert_eq!(circle, None, "{}", source.display());
    }
}

#[test]
fn a_circle_and_every_way_to_import_are_found() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    };
    write("lib.rs", "mod gate; mod motion;");
    write("motion.rs", "pub struct Scene;");
    write("gate/mod.rs", "mod a; mod b; mod c; mod d; mod e;");
    write("gate/a.rs", "use crate::{motion::Scene as Other};");
    write("gate/b.rs", "fn f() -> super::super::motion::Scene { loop {} }");
    write("gate/c.rs", "use super::d; #[cfg(test)] mod tests { use crate::motion; }");
    write("gate/d.rs", "use super::a;");
    write("gate/e.rs", "fn f() { assert!([g(crate::motion::Scene::new())].is_empty()) }");
    let modules = Modules::of(folder.path());
    let imports = |module: &str| modules.imports[module].iter().map(String::as_str).collect::<Vec<_>>();
    assert_eq!(imports("gate::a"), ["motion"]);
    assert_eq!(imports("gate::b"), ["motion"]);
    assert_eq!(imports("gate::c"), ["gate::d"]);
    assert_eq!(imports("gate::e"), ["motion"]);
    assert_eq!(modules.circle(), None);
    write("gate/d.rs", "use super::c::Thing;");
    assert_eq!(Modules::of(folder.path()).circle(), Some(vec!["gate::c", "gate::d"]));
}
