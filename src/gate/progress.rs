//! Who watches a run while it goes on, and may end it early.

/// Told of every case that is done, from any thread.
pub trait Progress: Sync {
    /// A case is done, and whether something was wrong with it.
    fn done(&self, is_wrong: bool);

    /// Whether the cases that are left are to be left out. The report then says that it is partial.
    fn is_interrupted(&self) -> bool;
}

/// Nobody watches.
impl Progress for () {
    fn done(&self, _: bool) {}

    fn is_interrupted(&self) -> bool {
        false
    }
}
