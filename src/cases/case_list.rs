//! Lists of cases as data: those that are built in, and those of users.

use std::{collections::HashMap, ops::Range};

use contract::{Case, Invalid};
use serde::Deserialize;
use toml::Spanned;

use super::{
    case_file::{self, CaseFields},
    toml_error::{self, Allowed, is_control, printable},
};

/// A case of a list.
#[derive(Debug, Clone, PartialEq)]
pub struct Listed {
    /// Unique in its list.
    pub name: String,
    /// Why it is in the list; may be empty.
    pub why: String,
    /// The case.
    pub case: Case,
    /// The line of the list that its name is in; the first is 1.
    pub line: usize,
}

/// What is wrong with a list, and in which line.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct ListError(String);

/// What is allowed for the fields of a list, besides those of a case.
const OF_A_LIST: [Allowed; 3] = [
    ("case", "tables that start with [[case]]"),
    ("name", "a name in quotes that no other case has"),
    ("why", "a text in quotes"),
];

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    case: Vec<Spanned<Entry>>,
}

/// As [`CaseFields`], with a name; and with the places of all of them, for errors.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    name: Option<Spanned<String>>,
    why: Option<String>,
    a: Option<Spanned<f64>>,
    epsilon: Option<Spanned<f64>>,
    omega: Option<Spanned<f64>>,
    eta: Option<Spanned<f64>>,
    alpha: Option<Spanned<f64>>,
    normalisation: Option<Spanned<String>>,
    impacts: Option<Spanned<usize>>,
    until: Option<Spanned<f64>>,
}

/// Reads a list.
///
/// # Errors
/// When the text is not a list, a value is not allowed, or a name comes twice: the line, the field, the value as it was typed, what is allowed.
pub fn read(text: &str) -> Result<Vec<Listed>, ListError> {
    let allowed: Vec<Allowed> = OF_A_LIST.into_iter().chain(case_file::ALLOWED).collect();
    let file: File = toml_error::read(text, &allowed).map_err(ListError)?;
    let mut lines: HashMap<String, usize> = HashMap::new();
    let mut cases = Vec::with_capacity(file.case.len());
    for entry in file.case {
        let listed = Source { text, at: entry.span() }.listed(entry.get_ref())?;
        if let Some(first) = lines.insert(listed.name.clone(), listed.line) {
            let Listed { name, line, .. } = listed;
            return Err(ListError(format!("line {line}: name = {name:?} is that of the case in line {first}")));
        }
        cases.push(listed);
    }
    Ok(cases)
}

/// An entry of the text.
struct Source<'a> {
    text: &'a str,
    at: Range<usize>,
}

impl Source<'_> {
    fn line(&self, span: &Range<usize>) -> usize {
        self.text.get(..span.start).map_or(0, |before| before.matches('\n').count()) + 1
    }

    fn missing(&self, field: &str) -> ListError {
        ListError(format!("line {}: {field} is missing in this case", self.line(&self.at)))
    }

    fn listed(&self, entry: &Entry) -> Result<Listed, ListError> {
        let Some(name) = &entry.name else { return Err(self.missing("name")) };
        if name.get_ref().is_empty() || name.get_ref().chars().any(is_control) {
            let allowed = "a name of one line that is not empty";
            return Err(self.refused(entry, &Invalid::new("name", name.get_ref(), allowed)));
        }
        let value = |given: &Option<Spanned<f64>>| given.as_ref().map(|given| *given.get_ref());
        let Some(omega) = value(&entry.omega) else { return Err(self.missing("omega")) };
        let Some(eta) = value(&entry.eta) else { return Err(self.missing("eta")) };
        let fields = CaseFields {
            a: value(&entry.a),
            epsilon: value(&entry.epsilon),
            omega,
            eta,
            alpha: value(&entry.alpha),
            normalisation: entry.normalisation.as_ref().map(|given| given.get_ref().clone()),
            impacts: entry.impacts.as_ref().map(|given| *given.get_ref()),
            until: value(&entry.until),
        };
        let case = fields.case().map_err(|invalid| self.refused(entry, &invalid))?;
        let why = entry.why.clone().unwrap_or_default();
        Ok(Listed { name: name.get_ref().clone(), why, case, line: self.line(&name.span()) })
    }

    /// A value that is refused: the line, the field, what was typed, what is allowed.
    fn refused(&self, entry: &Entry, invalid: &Invalid) -> ListError {
        let span = entry.span_of(invalid.field);
        let typed = span.as_ref().and_then(|span| self.text.get(span.clone())).map(printable);
        let invalid = Invalid { value: typed.unwrap_or_else(|| invalid.value.clone()), ..invalid.clone() };
        ListError(format!("line {}: {invalid}", self.line(span.as_ref().unwrap_or(&self.at))))
    }
}

impl Entry {
    /// Where the value of a field stands.
    fn span_of(&self, field: &str) -> Option<Range<usize>> {
        match field {
            "name" => self.name.as_ref().map(Spanned::span),
            "normalisation" => self.normalisation.as_ref().map(Spanned::span),
            "impacts" => self.impacts.as_ref().map(Spanned::span),
            "a" => self.a.as_ref().map(Spanned::span),
            "epsilon" => self.epsilon.as_ref().map(Spanned::span),
            "omega" => self.omega.as_ref().map(Spanned::span),
            "eta" => self.eta.as_ref().map(Spanned::span),
            "alpha" => self.alpha.as_ref().map(Spanned::span),
            "until" => self.until.as_ref().map(Spanned::span),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str) -> String {
        read(text).unwrap_err().to_string()
    }

    const CASE: &str = "[[case]]\nname = \"x\"\na = 1.03\nomega = 2.0\neta = 0.5\n";

    #[test]
    fn several_cases_of_one_file_are_read() {
        let text = format!(
            "# mine\n{CASE}\n[[case]]\nname = \"y\"\nwhy = \"deep\"\nepsilon = 1e-9\nomega = 2\neta = 0.9\nalpha = 0.1\nnormalisation = \"slender\"\nimpacts = 7\nuntil = 0.5\n"
        );
        let cases = read(&text).unwrap();
        let names: Vec<_> = cases.iter().map(|listed| (listed.name.as_str(), listed.line)).collect();
        assert_eq!(names, [("x", 3), ("y", 9)]);
        assert_eq!((cases[1].case.epsilon(), cases[1].case.max_impacts(), cases[1].why.as_str()), (1e-9, 7, "deep"));
        assert_eq!(read("").unwrap(), []);
    }

    /// The line, the field, the value as typed, what is allowed.
    #[test]
    fn what_is_wrong_is_named_with_its_line() {
        for (wrong, right, told_of) in [
            ("eta = 1.50", "eta = 0.5", "line 5: eta = 1.50 is outside the allowed range: "),
            ("omega = 0e0", "omega = 2.0", "line 4: omega = 0e0 is outside the allowed range: "),
            ("eta = 0.5\nalpha = 4", "eta = 0.5", "line 6: alpha = 4 is outside the allowed range: "),
            ("eta = 0.5\nimpacts = 0", "eta = 0.5", "line 6: impacts = 0 is outside the allowed range: "),
            ("eta = 0.5\nepsilon = 1", "eta = 0.5", "line 6: epsilon = 1 is outside the allowed range: one of a and"),
            ("eta = 0.5\nfrequency = 1", "eta = 0.5", "line 6: frequency is not known here"),
            ("eta = \"high\"", "eta = 0.5", "line 5: eta: allowed is a number, 0 < eta < 1, in `eta = \"high\"`"),
            ("# no name", "name = \"x\"", "line 1: name is missing in this case"),
            ("name = \"\"", "name = \"x\"", "line 2: name = \"\" is outside the allowed range: "),
            ("name = \"a\\nb\"", "name = \"x\"", "line 2: name = \"a\\nb\" is outside the allowed range: "),
            ("# no eta", "eta = 0.5", "line 1: eta is missing in this case"),
            ("# no a", "a = 1.03", "line 1: a = (missing) is outside the allowed range: one of a and epsilon"),
            (
                "eta = 0.5\nalpha = 0.1\nnormalisation = \"slendr\"",
                "eta = 0.5",
                "line 7: normalisation = \"slendr\" is",
            ),
        ] {
            let told = told(&CASE.replace(right, wrong));
            assert!(told.starts_with(told_of) && told.lines().count() == 1, "{wrong}: {told}");
        }
        let second = told(&format!("{CASE}\n{}", CASE.replace("0.5", "1")));
        assert!(second.starts_with("line 11: eta = 1 is outside"), "{second}");
        assert_eq!(told(&CASE.repeat(2)), "line 7: name = \"x\" is that of the case in line 2");
        assert!(told("[[cases]]\n").starts_with("line 1: cases is not known here (perhaps case)"));
    }
}
