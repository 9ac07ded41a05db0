//! Long work, which ends at Ctrl-C.

use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc::{self, RecvTimeoutError},
    },
    thread,
    time::Duration,
};

use chattercheck::gate::progress::Progress;
use contract::{
    Body, Bout, Case, Closure, Decline, FlightSolver, Followed, History, Model, Motion, Oracle, conformance::Times,
};
use pyo3::{exceptions::PyRuntimeError, prelude::*};

/// How often it is looked whether the user wants to stop.
const TICK: Duration = Duration::from_millis(20);

/// Tells long work that its answer is not wanted any more.
#[derive(Debug, Clone, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Whether it is not.
    pub fn is_raised(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    fn check(&self) -> Result<(), Decline> {
        if self.is_raised() { Err(Decline::Unsupported { what: "what is not wanted any more" }) } else { Ok(()) }
    }
}

impl Progress for Stop {
    fn done(&self, _: bool) {}

    fn is_interrupted(&self) -> bool {
        self.is_raised()
    }
}

/// Does the work on a thread of its own, without the interpreter's lock, while signals are looked for; at one that raises, `stop` is raised, and the work is left
/// to end by itself.
///
/// # Errors
/// What the handler of a signal raises; when the work panicked.
pub fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    stop: &Stop,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (send, mut receive) = mpsc::channel();
    thread::spawn(move || {
        // Nobody may be waiting any more.
        let _ = send.send(work());
    });
    loop {
        let answer;
        (receive, answer) = py.detach(move || {
            let answer = receive.recv_timeout(TICK);
            (receive, answer)
        });
        match answer {
            Ok(answer) => return Ok(answer),
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err("chattercheck broke; this is a fault of it, please report it"));
            }
            Err(RecvTimeoutError::Timeout) => {
                py.check_signals().inspect_err(|_| stop.0.store(true, Ordering::Relaxed))?
            }
        }
    }
}

/// An oracle that declines once it is not wanted any more.
pub struct Stoppable {
    /// The oracle.
    pub oracle: Box<dyn Oracle>,
    /// Who tells it.
    pub stop: Stop,
}

impl Oracle for Stoppable {
    fn name(&self) -> &str {
        self.oracle.name()
    }

    fn model(&self) -> Model {
        self.oracle.model()
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        self.stop.check()?;
        self.oracle.history(case)
    }

    fn times(&self) -> Times {
        self.oracle.times()
    }

    fn coarser(&self) -> Option<Box<dyn Oracle>> {
        self.oracle.coarser()
    }

    fn flights(&self, case: &Case) -> Result<Box<dyn FlightSolver>, Decline> {
        self.stop.check()?;
        self.oracle.flights(case)
    }

    fn flights_on(&self, body: &Body, motion: &Motion) -> Result<Box<dyn FlightSolver>, Decline> {
        self.stop.check()?;
        self.oracle.flights_on(body, motion)
    }

    fn closure_on(&self, body: &Body, motion: &Motion) -> Result<Box<dyn Closure>, Decline> {
        self.stop.check()?;
        self.oracle.closure_on(body, motion)
    }

    fn bouts_on(&self, body: &Body, motion: &Motion, asked: &Followed) -> Result<Vec<Bout>, Decline> {
        self.stop.check()?;
        self.oracle.bouts_on(body, motion, asked)
    }
}
