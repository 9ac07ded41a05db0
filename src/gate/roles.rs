//! What the gate has to be told of the oracles that it is given: it knows them through the contract only.

/// Who is what in a panel.
#[derive(Clone, Copy)]
pub struct Roles<'a> {
    /// The name of the series whose error has to fall with `ε`.
    pub series: &'a str,
    /// The largest share of the cases of a run that the oracle of this name may decline.
    pub may_decline: &'a (dyn Fn(&str) -> f64 + Sync),
}
