//! What the gate has to be told of the oracles that it is given: it knows them through the contract only.

/// Who is what in a panel.
#[derive(Clone, Copy)]
pub struct Roles<'a> {
    /// The name of the series whose error has to fall with `ε`.
    pub series: &'a str,
    /// The largest share of the cases of a run that the oracle of this name may decline.
    pub may_decline: &'a (dyn Fn(&str) -> f64 + Sync),
    /// Whether the errors of the oracle of this name are what its user grants it, and not what it claims: how wide they are says nothing about it.
    pub granted: &'a (dyn Fn(&str) -> bool + Sync),
    /// Whether the oracle of this name never says that a block comes to rest, as its user has declared: no chattering time of it can be compared.
    pub never_rests: &'a (dyn Fn(&str) -> bool + Sync),
    /// The command that shows the history of the oracle of this name for a case that is given by flags.
    pub shown_by: &'a (dyn Fn(&str, &str) -> String + Sync),
}
