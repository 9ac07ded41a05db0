//! The parts of a run that are in a folder, and what is wrong with them.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

use anyhow::Context as _;
use chattercheck::{
    gate::partition::{Part, Partition},
    stored::to_line,
};

use super::part_file::read;

/// What is in a folder.
pub(super) struct Parts {
    /// The parts, in order.
    pub parts: Vec<Part>,
    /// Everything that is wrong with them: the file, what is wrong, and what to do.
    pub wrong: Vec<String>,
}

/// All parts in these files, which were found in `folder`.
pub(super) fn all(folder: &Path, files: Vec<PathBuf>) -> Parts {
    let mut wrong = Vec::new();
    let mut read_parts: Vec<(PathBuf, Part)> = Vec::new();
    for path in files {
        match read(&path) {
            Ok(part) => read_parts.push((path, part)),
            Err(error) => wrong.push(format!("{}: {error:#}; delete it and run this part again", path.display())),
        }
    }
    // What most of them are is taken for what is meant.
    let mut kinds: BTreeMap<(String, usize), usize> = BTreeMap::new();
    let kind = |part: &Part| (part.request.hash(), part.partition.parts);
    read_parts.iter().for_each(|(_, part)| *kinds.entry(kind(part)).or_default() += 1);
    let most = kinds.into_iter().max_by_key(|(_, count)| *count).map(|(kind, _)| kind);
    let of_most = read_parts.iter().find(|(_, part)| Some(kind(part)) == most);
    let Some((model_path, model)) = of_most.map(|(path, part)| (path.clone(), part.clone())) else {
        return Parts { parts: Vec::new(), wrong };
    };
    let mut by_number: BTreeMap<usize, (PathBuf, Part)> = BTreeMap::new();
    for (path, part) in read_parts {
        let file = path.display();
        let Partition { part: number, parts } = part.partition;
        if let Some(difference) = difference(&model, &part) {
            let others = model_path.display();
            wrong.push(format!(
                "{file}: it is of another run than {others}: {difference}; keep the parts of one run in a folder"
            ));
        } else if let Some((other, _)) = by_number.get(&number) {
            wrong.push(format!(
                "{file}: it is part {number} of {parts}, and so is {}; delete one of them",
                other.display()
            ));
        } else {
            by_number.insert(number, (path, part));
        }
    }
    wrong.extend(missing(folder, &by_number, model.partition.parts));
    Parts { parts: by_number.into_values().map(|(_, part)| part).collect(), wrong }
}

/// The files in a folder, and in the folders in it, that are called as parts are.
///
/// # Errors
/// When a folder can't be read.
pub(super) fn files(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let entries = |folder: &Path| -> anyhow::Result<Vec<PathBuf>> {
        let failed = || format!("cannot read the folder {}", folder.display());
        let entries = fs::read_dir(folder).with_context(failed)?;
        let mut paths: Vec<PathBuf> =
            entries.map(|entry| Ok(entry?.path())).collect::<Result<_, std::io::Error>>().with_context(failed)?;
        paths.sort();
        Ok(paths)
    };
    let mut all = entries(folder)?;
    let folders: Vec<PathBuf> = all.iter().filter(|path| path.is_dir()).cloned().collect();
    for folder in folders {
        all.extend(entries(&folder)?);
    }
    let is_part = |path: &PathBuf| {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        name.starts_with("part-") && name.ends_with(".jsonl") && path.is_file()
    };
    Ok(all.into_iter().filter(is_part).collect())
}

/// In what another part is not of the same run, if it is not.
fn difference(model: &Part, part: &Part) -> Option<String> {
    if let Some((what, [there, here])) = model.request.difference(&part.request) {
        return Some(format!("{what}: {there} here, {here} there"));
    }
    let (parts, others) = (part.partition.parts, model.partition.parts);
    if parts != others {
        return Some(format!("partition: of {parts} here, of {others} there"));
    }
    // Every part climbs down all ladders: the same numbers to the last bit, unless the oracles are others.
    let ladders = |part: &Part| to_line(&part.run.ladders);
    let differ = ladders(model) != ladders(part);
    differ.then(|| {
        "its oracles answer differently on the ladders: another build, or a machine of another kind".to_owned()
    })
}

/// How many missing parts are named.
const NAMED: usize = 10;

fn missing(folder: &Path, there: &BTreeMap<usize, (PathBuf, Part)>, parts: usize) -> Vec<String> {
    let count = parts - there.len();
    let gaps = (1..=parts).filter(|number| !there.contains_key(number)).take(NAMED);
    let folder = folder.display();
    let mut lines: Vec<String> = gaps
        .map(|part| format!("part {part} of {parts} is missing: run it with the options of the others and --partition {part}/{parts} --out {folder}"))
        .collect();
    if count > NAMED {
        lines.push(format!("and {} more are missing", count - NAMED));
    }
    lines
}
