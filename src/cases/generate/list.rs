//! The curated cases in `data/cases`.

use contract::{Case, Invalid};
use serde::Deserialize;

use crate::cases::case_file::{CaseFields, one_line};

/// A case of a list.
#[derive(Debug, Clone, PartialEq)]
pub struct Listed {
    /// Unique in its list.
    pub name: String,
    /// Why it is in the list.
    pub why: String,
    /// The case.
    pub case: Case,
}

/// Why a list can't be read.
#[derive(Debug, thiserror::Error)]
pub enum LoadError {
    /// It is not TOML of the right form.
    #[error("not a list of cases: {0}")]
    Form(String),
    /// A case has unknown keys, or lacks one.
    #[error("case {name}: {wrong}")]
    Entry {
        /// The name of the case.
        name: String,
        /// What is wrong with it.
        wrong: String,
    },
    /// A value of a case is not allowed.
    #[error("case {name}: {invalid}")]
    Value {
        /// The name of the case.
        name: String,
        /// What is wrong with it.
        invalid: Invalid,
    },
    /// Two cases have the same name.
    #[error("name = {0} is outside the allowed range: a name that no other case has")]
    Twice(String),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    case: Vec<toml::Table>,
}

/// Reads a list.
///
/// # Errors
/// When the text is not a list, a value is not allowed, or a name comes twice.
pub fn read(text: &str) -> Result<Vec<Listed>, LoadError> {
    let file: File = toml::from_str(text).map_err(|error| LoadError::Form(one_line(&error, text)))?;
    let mut cases: Vec<Listed> = Vec::with_capacity(file.case.len());
    for mut entry in file.case {
        let mut text = |key: &str| match entry.remove(key) {
            Some(toml::Value::String(text)) => Ok(text),
            _ => Err(LoadError::Form(format!("a case needs the string `{key}`"))),
        };
        let (name, why) = (text("name")?, text("why")?);
        // What is left must be a case and nothing else; flattening it into one struct would let unknown keys pass.
        let fields: CaseFields =
            entry.try_into().map_err(|error| LoadError::Entry { name: name.clone(), wrong: one_line(&error, "") })?;
        if cases.iter().any(|listed| listed.name == name) {
            return Err(LoadError::Twice(name));
        }
        let case = fields.case().map_err(|invalid| LoadError::Value { name: name.clone(), invalid })?;
        cases.push(Listed { name, why, case });
    }
    Ok(cases)
}

/// The lists that are built in. A test makes sure that they can be read.
pub fn shipped() -> Vec<Listed> {
    [include_str!("../../../data/cases/paper.toml"), include_str!("../../../data/cases/found.toml")]
        .into_iter()
        .flat_map(|text| read(text).unwrap_or_default())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shipped_lists_can_be_read_and_no_name_comes_twice() {
        let paper = read(include_str!("../../../data/cases/paper.toml")).expect("paper.toml");
        let found = read(include_str!("../../../data/cases/found.toml")).expect("found.toml");
        assert!(paper.len() >= 10 && !found.is_empty());
        let mut names: Vec<_> = shipped().into_iter().map(|listed| listed.name).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!((names.len(), count), (count, paper.len() + found.len()));
    }

    #[test]
    fn what_is_wrong_with_a_list_is_named() {
        let one = |body: &str| read(&format!("[[case]]\nname = \"x\"\nwhy = \"y\"\n{body}")).unwrap_err().to_string();
        assert!(one("a = 1.03\nomega = 2.0\neta = 1.5").contains("eta = 1.5"));
        assert!(one("a = 1.03\nomega = 2.0\neta = 0.5\nfrequency = 2").contains("frequency"));
        assert!(one("omega = 2.0\neta = 0.5").contains("one of a and epsilon"));
        let case = "[[case]]\nname = \"x\"\nwhy = \"y\"\na = 1.03\nomega = 2.0\neta = 0.5\n";
        assert!(read(&case.repeat(2)).unwrap_err().to_string().contains("no other case has"));
    }
}
