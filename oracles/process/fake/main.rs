//! An engine that speaks the protocol and computes nothing: its impacts are a geometric series. Its first argument says how it misbehaves; a second one
//! is a file by which it remembers that it was started before.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing)] // It exists to break.

mod case;
mod reply;
mod start;

use std::{
    io::{BufRead, Write},
    thread::sleep,
    time::Duration,
};

use serde_json::Value;

/// How it misbehaves.
pub struct Fake {
    how: String,
    mark: Option<String>,
}

impl Fake {
    /// Whether it misbehaves in this way.
    pub fn is(&self, how: &str) -> bool {
        self.how == how
    }

    /// Whether this is asked for the first time, in any process of this engine.
    pub fn for_the_first_time(&self) -> bool {
        let mark = self.mark.as_deref().expect("a file to remember by");
        std::fs::OpenOptions::new().write(true).create_new(true).open(mark).is_ok()
    }
}

/// Prints as it is, and flushes.
pub fn print(text: &[u8]) {
    let mut out = std::io::stdout().lock();
    // Whoever listens may have gone.
    if out.write_all(text).and_then(|()| out.flush()).is_err() {
        std::process::exit(1);
    }
}

/// Does nothing for longer than anybody waits.
pub fn hang() -> ! {
    loop {
        sleep(Duration::from_secs(60));
    }
}

/// Prints without end.
pub fn flood() -> ! {
    loop {
        print(&[b'7'; 1 << 16]);
    }
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let fake = Fake { how: arguments.next().unwrap_or_default(), mark: arguments.next() };
    for line in std::io::stdin().lock().lines() {
        let message: Value = serde_json::from_str(&line.unwrap()).unwrap();
        match message["cmd"].as_str().unwrap() {
            "start" => start::answer(&fake, &message),
            "case" => case::answer(&fake, &message),
            "cases" => case::answer_all(&fake, message["cases"].as_array().unwrap()),
            "stop" if fake.is("ignores-stop") => hang(),
            "stop" => return,
            other => panic!("{other}"),
        }
    }
    if fake.is("ignores-stop") {
        hang();
    }
}
