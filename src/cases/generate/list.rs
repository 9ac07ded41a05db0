//! The curated cases in `data/cases`.

use crate::cases::case_list::{Listed, read};

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
    fn the_shipped_lists_can_be_read_each_case_says_why_and_no_name_comes_twice() {
        let paper = read(include_str!("../../../data/cases/paper.toml")).expect("paper.toml");
        let found = read(include_str!("../../../data/cases/found.toml")).expect("found.toml");
        assert!(paper.len() >= 10 && !found.is_empty());
        assert!(paper.iter().chain(&found).all(|listed| !listed.why.is_empty()));
        let mut names: Vec<_> = shipped().into_iter().map(|listed| listed.name).collect();
        let count = names.len();
        names.sort();
        names.dedup();
        assert_eq!((names.len(), count), (count, paper.len() + found.len()));
    }
}
