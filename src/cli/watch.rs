//! A progress bar on stderr, and SIGINT and SIGTERM, which end a run with a report of what it found.

use std::sync::{
    Arc,
    atomic::{AtomicBool, AtomicUsize, Ordering},
};

use chattercheck::gate::progress::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use signal_hook::{
    consts::{SIGINT, SIGTERM},
    flag,
};

use super::output::note;

/// Counts what is done, and ends at SIGINT or SIGTERM. A second signal ends the program at once.
pub(super) struct Watch {
    bar: ProgressBar,
    failed: AtomicUsize,
    interrupted: Arc<AtomicBool>,
}

impl Watch {
    /// Watches a run of so many cases.
    pub fn start(cases: usize, quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(Some(cases as u64), target);
        let bar = match ProgressStyle::with_template("{bar:40} {pos}/{len} cases, {eta} left{msg}") {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        };
        let interrupted = interruption("would end the run without a report");
        Self { bar, failed: AtomicUsize::new(0), interrupted }
    }

    /// The run is over.
    pub fn end(&self) {
        self.bar.finish_and_clear();
        if self.is_interrupted() {
            note("chattercheck: interrupted; the report says what was found so far");
        }
    }
}

/// A flag that SIGINT and SIGTERM raise; the second of them ends the program at once. `else_what` says what one would do that can't be caught.
pub(super) fn interruption(else_what: &str) -> Arc<AtomicBool> {
    let interrupted = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        // The order matters: the first signal finds the flag down, and raises it.
        let second = flag::register_conditional_shutdown(signal, 128 + signal, Arc::clone(&interrupted));
        if let Err(error) = second.and_then(|_| flag::register(signal, Arc::clone(&interrupted))) {
            note(format_args!("chattercheck: signal {signal} can't be caught, and {else_what}: {error}"));
        }
    }
    interrupted
}

impl Progress for Watch {
    fn done(&self, is_wrong: bool) {
        if is_wrong {
            let failed = self.failed.fetch_add(1, Ordering::Relaxed) + 1;
            self.bar.set_message(format!(", {failed} failed"));
        }
        self.bar.inc(1);
    }

    fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }
}
