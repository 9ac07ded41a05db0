//! How a process ended, in words.

use rustix::process::WaitIdStatus;

/// Whether it says that all is well.
pub fn is_success(status: &WaitIdStatus) -> bool {
    status.exit_status() == Some(0)
}

/// In words.
pub fn told(status: &WaitIdStatus) -> String {
    match (status.exit_status(), status.terminating_signal()) {
        (Some(code), _) => format!("exit status {code}"),
        (None, Some(signal)) => format!("signal {signal}{}", name(signal)),
        (None, None) => "an unknown end".to_owned(),
    }
}

/// The name of a signal that programs end by.
fn name(signal: i32) -> &'static str {
    match signal {
        2 => " (SIGINT)",
        4 => " (SIGILL, illegal instruction)",
        6 => " (SIGABRT, abort)",
        8 => " (SIGFPE, arithmetic)",
        9 => " (SIGKILL, killed from outside; often out of memory)",
        11 => " (SIGSEGV, memory fault)",
        13 => " (SIGPIPE)",
        15 => " (SIGTERM)",
        _ => "",
    }
}
