//! An engine of somebody else: a simulator in any language, run as a process that speaks the protocol, seen by the gate as one more
//! [`Oracle`](contract::Oracle).
//!
//! # The protocol, version 1
//! UTF-8, one JSON object a line, on the engine's standard input and output. Its standard error is read and its end is kept for the report; it is
//! never a verdict. `data/protocol/v1` has a JSON Schema of every message.
//!
//! | direction | message |
//! | --- | --- |
//! | to the engine | `{"cmd":"start","versions":[1],"echo":[0.1,5e-324,1.7976931348623157e+308,-0.0]}` |
//! | from it | `{"version":1,"engine":{"name":…,"version":…,"language":…},"models":["linear"],"normalisations":["threshold"],"ground":["sine"],"claims":false,"max_batch":1,"echo":[…]}` |
//! | to | `{"cmd":"case","seq":7,"model":"linear","epsilon":…,"omega":…,"eta":…,"alpha":null,"normalisation":"threshold","ground":{"sine":{"start":"threshold"}},"impacts":60,"until":"half-period"}` |
//! | to | `{"cmd":"cases","cases":[…]}`, cases without `cmd`, only where `max_batch` is above 1 |
//! | from | `{"seq":7,"history":{"time":[…],"interval":[…],"velocity":[…],"ending":"at-rest","tau_ch":…,"claim":{…}},"ns":…}` |
//! | from | `{"seq":7,"decline":{"reason":…,"why":…}}`, a refusal |
//! | from | `{"seq":7,"error":{"message":…}}`, a failure; the engine stays up |
//! | to | `{"cmd":"stop"}`, then the end of input |
//!
//! - The echo has to come back bit for bit: it unmasks an engine that prints six digits before anything else does.
//! - Numbers are decimals that are read back as the same double, or hexadecimal floats as strings (`"0x1.8p-3"`). `"nan"`, `"inf"` and `"-inf"` are
//!   numbers too: a wrong answer, and not a broken line.
//! - A field that the protocol does not know is an error, so that a slip of the pen is not silently ignored. Names that start with `x-` are free.
//! - `alpha` is null where the model does not look at it. `until` is `"half-period"` or a time `τ`. The phase of the ground is such that at `τ = 0` the
//!   acceleration has just reached the threshold, and grows.
//! - `interval`, `tau_ch`, `claim` and `ns` may be left out. Where there are no intervals they are the differences of the times; each
//!   then carries, besides what is claimed, what the rounding of the two times costs it, `2⁻⁵³ (τ_n + τ_{n-1})/Δτ`, relative.
//! - `claim` has `time` (absolute), `interval`, `velocity` (relative), each a number for all impacts or a column, and `tau_ch` (absolute). For what is
//!   not claimed the user's [`Tolerance`] stands.
//! - The answers to `cases` are a line each, in any order.
//!
//! # When an engine breaks
//! Each way of breaking has a [`Verdict`] with a name of its own. A time-out or a crash ends the whole group of processes; the engine is started anew and
//! the same case is asked alone, and only if that fails too it is a verdict. Nothing hangs and nothing grows: every wait has an end, and every line has a
//! limit that follows from the impacts asked. It needs a Unix system.

mod answer;
mod child;
mod engine;
mod exit;
mod key;
mod launch;
mod lines;
mod number;
mod object;
mod pool;
mod question;
mod reading;
mod record;
mod reply;
mod round;
mod sample;
mod tail;
mod talk;
mod verdict;
mod version;
mod welcome;
mod words;

pub use answer::{Answer, Claimed, Outcome};
pub use engine::Engine;
pub use launch::{Launch, Tolerance};
pub use record::{Direction, Line, Sink};
pub use verdict::{Breakdown, Verdict};
pub use version::version;
pub use welcome::Welcome;
pub use words::ending_name;
