//! How much the tests run: `CHATTERCHECK_EFFORT=quick` (the default) for every change, `full` for a release.
//!
//! One place decides, and every test that runs less when quick says so on stderr (shown with `--nocapture`, or when it fails).
#![allow(dead_code)] // Each test binary uses a part.

/// How much is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// Enough to notice every planted fault, in minutes.
    Quick,
    /// Everything.
    Full,
}

/// What the environment asks for. Anything but the two words is a mistake, not a default.
pub fn effort() -> Effort {
    match std::env::var("CHATTERCHECK_EFFORT").as_deref() {
        Err(_) | Ok("quick") => Effort::Quick,
        Ok("full") => Effort::Full,
        Ok(other) => panic!("CHATTERCHECK_EFFORT = {other:?}: quick or full"),
    }
}

/// `quick` or `full`, whichever is asked for; `what` is logged with the choice.
pub fn pick<T: std::fmt::Debug>(what: &str, quick: T, full: T) -> T {
    let effort = effort();
    let chosen = match effort {
        Effort::Quick => quick,
        Effort::Full => full,
    };
    eprintln!("{effort:?}: {what} = {chosen:?}");
    chosen
}
