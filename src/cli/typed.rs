//! Values in errors as they were typed. What refuses a number has it as a double, which would be printed back in other digits: `1e9` as `1000000000.0`.

use super::numbers::number;

/// `line` with the values of options as they were typed among `words`.
pub(super) fn as_typed(line: String, words: &[String]) -> String {
    options(words).fold(line, |line, (name, typed)| {
        let Ok(value) = number(typed) else { return line };
        let name = name.trim_start_matches('-');
        let printed = [format!("{value:?}"), value.to_string()];
        printed.iter().fold(line, |line, printed| {
            let line = replaced(&line, &format!("{name} = {printed}"), &format!("{name} = {typed}"));
            replaced(&line, &format!("--{name} {printed}"), &format!("--{name} {typed}"))
        })
    })
}

/// The options with their values, written `--name value` or `--name=value`.
fn options(words: &[String]) -> impl Iterator<Item = (&str, &str)> {
    let apart = words.iter().zip(words.iter().skip(1)).map(|(name, value)| (name.as_str(), value.as_str()));
    let joined = words.iter().filter_map(|word| word.split_once('='));
    apart.chain(joined).filter(|(name, _)| name.starts_with("--"))
}

/// `line` with `new` for `old`, where no more digits follow.
fn replaced(line: &str, old: &str, new: &str) -> String {
    let goes_on = |after: &str| after.starts_with(|next: char| next.is_alphanumeric() || next == '.');
    match line.find(old).and_then(|at| Some((line.get(..at)?, line.get(at + old.len()..)?))) {
        Some((before, after)) if !goes_on(after) => format!("{before}{new}{after}"),
        _ => line.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typed(line: &str, words: &[&str]) -> String {
        as_typed(line.to_owned(), &words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>())
    }

    #[test]
    fn a_value_is_shown_as_it_was_typed() {
        assert_eq!(typed("omega = 1000000000.0 is outside", &["--omega", "1e9"]), "omega = 1e9 is outside");
        assert_eq!(typed("a = NaN is outside", &["--a=nan"]), "a = nan is outside");
        assert_eq!(
            typed("eta = 1.0 is outside", &["--eta", "0.99999999999999999"]),
            "eta = 0.99999999999999999 is outside"
        );
        let all =
            typed("no method uses all of --order 3, --rtol 0.0000000001; see", &["--rtol", "1e-10", "--order", "3"]);
        assert_eq!(all, "no method uses all of --order 3, --rtol 1e-10; see");
    }

    #[test]
    fn what_is_not_that_value_is_left_alone() {
        for line in ["omega = 1000000000.05 is", "omega = 2.0 is", "no omega at all"] {
            assert_eq!(typed(line, &["--omega", "1e9", "--eta"]), line);
        }
    }
}
