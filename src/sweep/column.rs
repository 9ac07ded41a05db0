//! What is wanted of each point, as columns of the table.
//!
//! No number stands there without what may be wrong with it, and no field is empty without a word that says why: each quantity brings its uncertainty, and
//! every table has an `ending`.

use contract::Estimate;

/// A column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Column {
    /// The chattering time `τ_ch`; of a scene that of the first rocking.
    TauCh,
    /// How far `tau_ch` may be off, absolute.
    Uncertainty,
    /// How the first rocking of a scene ends: why there is no `tau_ch` if there is none.
    TauChEnding,
    /// The largest rotation as a share of `α`, without its sign.
    LargestRotation,
    /// How far that may be off.
    LargestRotationUncertainty,
    /// How many impacts are resolved.
    Impacts,
    /// How often a block of a scene rocks, from rest to rest.
    Bouts,
    /// When a block of a scene comes to rest for good, in seconds since the start of the motion.
    RestTime,
    /// How far that may be off, in seconds.
    RestTimeUncertainty,
    /// How it ends, or why that is not known.
    Ending,
}

impl Column {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::TauCh,
        Self::Uncertainty,
        Self::TauChEnding,
        Self::LargestRotation,
        Self::LargestRotationUncertainty,
        Self::Impacts,
        Self::Bouts,
        Self::RestTime,
        Self::RestTimeUncertainty,
        Self::Ending,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::TauCh => "tau_ch",
            Self::Uncertainty => "uncertainty",
            Self::TauChEnding => "tau_ch_ending",
            Self::LargestRotation => "largest_rotation",
            Self::LargestRotationUncertainty => "largest_rotation_uncertainty",
            Self::Impacts => "impacts",
            Self::Bouts => "bouts",
            Self::RestTime => "rest_time",
            Self::RestTimeUncertainty => "rest_time_uncertainty",
            Self::Ending => "ending",
        }
    }

    /// What it is, with its unit, for a drawing; `None` of a word.
    pub fn label(self) -> Option<&'static str> {
        Some(match self {
            Self::TauCh => "chattering time τ_{ch}, in 1/p",
            Self::Uncertainty => "uncertainty of τ_{ch}, in 1/p",
            Self::LargestRotation => "largest rotation (share of α)",
            Self::LargestRotationUncertainty => "uncertainty of the largest rotation (share of α)",
            Self::Impacts => "impacts that are resolved",
            Self::Bouts => "times of rocking",
            Self::RestTime => "at rest from (s)",
            Self::RestTimeUncertainty => "uncertainty of the time of rest (s)",
            Self::TauChEnding | Self::Ending => return None,
        })
    }

    /// Whether only a scene has it.
    pub fn is_of_scenes(self) -> bool {
        matches!(self, Self::TauChEnding | Self::Bouts | Self::RestTime | Self::RestTimeUncertainty)
    }

    /// Those that stand beside it.
    fn beside(self, of_scene: bool) -> &'static [Self] {
        match self {
            Self::TauCh if of_scene => &[Self::Uncertainty, Self::TauChEnding],
            Self::TauCh => &[Self::Uncertainty],
            Self::LargestRotation => &[Self::LargestRotationUncertainty],
            Self::RestTime => &[Self::RestTimeUncertainty],
            _ => &[],
        }
    }

    /// The columns of the table where these are wanted: with those beside them that are not among them, right after, and how it ends.
    pub fn with_companions(wanted: &[Self], of_scene: bool) -> Vec<Self> {
        let is_new = |column: &Self| !wanted.contains(column);
        let mut all = Vec::new();
        for column in wanted {
            all.push(*column);
            all.extend(column.beside(of_scene).iter().copied().filter(is_new));
        }
        all.extend([Self::Ending].into_iter().filter(is_new));
        all
    }
}

/// All words for how a point ends, those first that are commonest where a number is missing.
pub(super) const NAMES_OF_ENDINGS: [&str; 13] = [
    "incomplete",
    "overturned",
    "never-rocks",
    "lying",
    "rocking",
    "not-known",
    "unsure",
    "declined",
    "refused",
    "lost",
    "too-many-impacts",
    "limit-reached",
    "at-rest",
];

/// What was found at a point; what was not found out, or does not exist, is `None`, and `ending` says why.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Findings {
    /// The chattering time, and how far it may be off.
    pub tau_ch: Option<Estimate>,
    /// How the first rocking of a scene ends.
    pub tau_ch_ending: &'static str,
    /// The largest rotation, and how far it may be off.
    pub largest_rotation: Option<Estimate>,
    /// How many impacts are resolved.
    pub impacts: Option<usize>,
    /// How often it rocks.
    pub bouts: Option<usize>,
    /// When it comes to rest for good, and how far that may be off.
    pub rest_time: Option<Estimate>,
    /// How it ends.
    pub ending: &'static str,
}

impl Findings {
    /// What is known of a point of which nothing is found.
    pub fn nothing(ending: &'static str) -> Self {
        Self { tau_ch_ending: ending, ending, ..Self::default() }
    }

    /// Writes a column as a field of a CSV.
    pub fn write(&self, column: Column, row: &mut String) {
        use super::value::write_number;
        let value = |of: Option<Estimate>| of.map_or(f64::NAN, |estimate| estimate.value);
        let uncertainty = |of: Option<Estimate>| of.map_or(f64::NAN, |estimate| estimate.uncertainty);
        let count = |of: Option<usize>| of.map_or(String::new(), |count| count.to_string());
        match column {
            Column::TauCh => write_number(row, value(self.tau_ch)),
            Column::Uncertainty => write_number(row, uncertainty(self.tau_ch)),
            Column::TauChEnding => row.push_str(self.tau_ch_ending),
            Column::LargestRotation => write_number(row, value(self.largest_rotation)),
            Column::LargestRotationUncertainty => write_number(row, uncertainty(self.largest_rotation)),
            Column::Impacts => *row += &count(self.impacts),
            Column::Bouts => *row += &count(self.bouts),
            Column::RestTime => write_number(row, value(self.rest_time)),
            Column::RestTimeUncertainty => write_number(row, uncertainty(self.rest_time)),
            Column::Ending => row.push_str(self.ending),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(wanted: &[Column], of_scene: bool) -> String {
        Column::with_companions(wanted, of_scene).iter().map(|column| column.name()).collect::<Vec<_>>().join(",")
    }

    #[test]
    fn no_number_comes_without_its_uncertainty_and_nothing_comes_twice() {
        use Column::{Ending, Impacts, LargestRotation, TauCh, Uncertainty};
        assert_eq!(names(&[TauCh, Uncertainty, Ending], false), "tau_ch,uncertainty,ending");
        assert_eq!(names(&[Ending, TauCh], false), "ending,tau_ch,uncertainty");
        assert_eq!(names(&[TauCh], true), "tau_ch,uncertainty,tau_ch_ending,ending");
        assert_eq!(
            names(&[LargestRotation, Impacts], false),
            "largest_rotation,largest_rotation_uncertainty,impacts,ending"
        );
    }
}
