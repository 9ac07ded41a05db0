//! A process in a group of its own, whose three pipes never block: one wait serves them all, and every wait has an end.

use std::{
    io::{ErrorKind, Read, Write},
    os::{fd::AsFd, unix::process::CommandExt},
    process::{ChildStderr, ChildStdin, ChildStdout, Command, Stdio},
    time::{Duration, Instant},
};

use rustix::{
    event::{PollFd, PollFlags, Timespec, poll},
    io::ioctl_fionbio,
    process::{Pid, Signal, WaitId, WaitIdOptions, WaitIdStatus, kill_process_group, waitid},
};

use crate::{
    launch::Launch,
    lines::{Cut, Lines},
    tail::Tail,
    verdict::{Breakdown, Verdict},
};

/// How much is read at once.
const PIECE: usize = 64 * 1024;

/// How long a wait lasts before it is seen whether the process still lives: something else may hold its pipes open.
const TICK: Duration = Duration::from_millis(50);

/// What was heard.
#[derive(Debug)]
pub enum Heard {
    /// A line, one too long, or one without end.
    Cut(Cut),
    /// The output has ended, or the process has.
    End,
    /// The time is over.
    Late,
}

/// A running process.
#[derive(Debug)]
pub struct Child {
    process: std::process::Child,
    group: Pid,
    input: Option<ChildStdin>,
    output: Option<ChildStdout>,
    errors: Option<ChildStderr>,
    outbox: Vec<u8>,
    sent: usize,
    /// Whether it closed its input.
    pub deaf: bool,
    lines: Lines,
    tail: Tail,
    piece: Vec<u8>,
    reaped: bool,
}

impl Child {
    /// Starts the process.
    pub fn start(launch: &Launch) -> Result<Self, Breakdown> {
        let (program, arguments) =
            launch.run.split_first().ok_or_else(|| Breakdown::new(Verdict::BadSetting, "`run` is empty"))?;
        if !launch.directory.is_dir() {
            return Err(Breakdown::new(Verdict::NoSuchDirectory, format!("{}", launch.directory.display())));
        }
        let started = Command::new(program)
            .args(arguments)
            .current_dir(&launch.directory)
            .envs(&launch.environment)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .process_group(0)
            .spawn();
        let mut process = started.map_err(|error| {
            let verdict =
                if error.kind() == ErrorKind::NotFound { Verdict::NoSuchProgram } else { Verdict::CannotStart };
            Breakdown::new(verdict, format!("{program:?}: {error}"))
        })?;
        let mut child = Self {
            group: Pid::from_child(&process),
            input: process.stdin.take(),
            output: process.stdout.take(),
            errors: process.stderr.take(),
            process,
            outbox: Vec::new(),
            sent: 0,
            deaf: false,
            lines: Lines::default(),
            tail: Tail::default(),
            piece: vec![0; PIECE],
            reaped: false,
        };
        child.never_block().map_err(|error| {
            child.kill();
            Breakdown::new(Verdict::CannotStart, format!("its pipes: {error}"))
        })?;
        Ok(child)
    }

    fn never_block(&self) -> rustix::io::Result<()> {
        self.input.as_ref().map_or(Ok(()), |pipe| ioctl_fionbio(pipe, true))?;
        self.output.as_ref().map_or(Ok(()), |pipe| ioctl_fionbio(pipe, true))?;
        self.errors.as_ref().map_or(Ok(()), |pipe| ioctl_fionbio(pipe, true))
    }

    /// Puts a message into the outbox; it goes out while the answer is waited for.
    pub fn say(&mut self, message: &str) {
        if !self.deaf {
            self.outbox.extend_from_slice(message.as_bytes());
        }
    }

    /// Ends its input.
    pub fn close(&mut self) {
        self.input = None;
    }

    /// Waits for the next line of at most `limit` bytes, until the deadline.
    pub fn hear(&mut self, limit: usize, deadline: Instant) -> Heard {
        loop {
            if let Some(cut) = self.lines.next(limit) {
                return Heard::Cut(cut);
            }
            if self.output.is_none() {
                return Heard::End;
            }
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Heard::Late;
            }
            // Dead, and nothing more in the pipe: whoever else holds it is not the engine.
            if !self.turn(left.min(TICK)) && self.exited().is_some() && !self.turn(Duration::ZERO) {
                self.output = None;
            }
        }
    }

    /// What has come of a line whose end has not.
    pub fn lines(&self) -> &Lines {
        &self.lines
    }

    /// The end of the error output.
    pub fn stderr(&self, most: usize) -> String {
        self.tail.text(most)
    }

    /// Waits until a pipe is ready and serves it; whether one was.
    fn turn(&mut self, wait: Duration) -> bool {
        let wants_to_say = self.sent < self.outbox.len();
        let ready = {
            // Also with nothing to say: a pipe that nobody reads any more is told as an error.
            let room = if wants_to_say { PollFlags::OUT } else { PollFlags::empty() };
            let input = self.input.as_ref().map(|pipe| (pipe.as_fd(), room));
            let output = self.output.as_ref().map(|pipe| (pipe.as_fd(), PollFlags::IN));
            let errors = self.errors.as_ref().map(|pipe| (pipe.as_fd(), PollFlags::IN));
            let pipes = [input, output, errors];
            let mut watched: Vec<PollFd<'_>> =
                pipes.iter().flatten().map(|(pipe, flags)| PollFd::from_borrowed_fd(*pipe, *flags)).collect();
            let wait = Timespec {
                tv_sec: i64::try_from(wait.as_secs()).unwrap_or(i64::MAX),
                tv_nsec: wait.subsec_nanos().into(),
            };
            if !poll(&mut watched, Some(&wait)).is_ok_and(|ready| ready > 0) {
                return false;
            }
            let mut events = watched.iter().map(PollFd::revents);
            pipes.map(|pipe| pipe.and_then(|_| events.next()).unwrap_or(PollFlags::empty()))
        };
        let [input, output, errors] = ready;
        if input.intersects(PollFlags::ERR | PollFlags::HUP | PollFlags::NVAL) {
            self.deafen();
        } else if input.contains(PollFlags::OUT) {
            self.send();
        }
        let [output, errors] = [output, errors].map(|events| !events.is_empty());
        if output && let Some(read) = take(&mut self.output, &mut self.piece) {
            self.lines.add(self.piece.get(..read).unwrap_or_default());
        }
        if errors && let Some(read) = take(&mut self.errors, &mut self.piece) {
            self.tail.add(self.piece.get(..read).unwrap_or_default());
        }
        true
    }

    /// Writes as much as the pipe takes.
    fn send(&mut self) {
        let Some(input) = &mut self.input else { return };
        match input.write(self.outbox.get(self.sent..).unwrap_or_default()) {
            Ok(written) => self.sent += written,
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => {}
            Err(_) => self.deafen(),
        }
        if self.sent == self.outbox.len() {
            self.outbox.clear();
            self.sent = 0;
        }
    }

    /// It does not read any more. It may still answer what it has read.
    fn deafen(&mut self) {
        self.deaf = true;
        self.input = None;
        self.sent = self.outbox.len();
    }

    /// How it ended, if it has. It is left as it is, so that its number is not given to another process.
    fn exited(&self) -> Option<WaitIdStatus> {
        let how = WaitIdOptions::EXITED | WaitIdOptions::NOHANG | WaitIdOptions::NOWAIT;
        if self.reaped { None } else { waitid(WaitId::Pid(self.group), how).ok().flatten() }
    }

    /// How it ended, waited for until the deadline. Its error output is read meanwhile, and what it still prints is dropped.
    pub fn ended(&mut self, deadline: Instant) -> Option<WaitIdStatus> {
        loop {
            let status = self.exited();
            let left = deadline.saturating_duration_since(Instant::now());
            if status.is_some() || left.is_zero() {
                // What it said before it ended is in the pipes: as much as a pipe holds, and not what others may add for ever.
                for _ in 0..32 {
                    if !self.turn(Duration::ZERO) {
                        break;
                    }
                }
                return status;
            }
            self.turn(left.min(Duration::from_millis(2)));
            self.lines = Lines::default();
        }
    }

    /// Sends what is in the outbox, ends the input, and waits for the end of the process; then kills what is left of its group.
    pub fn finish(&mut self, deadline: Instant) -> Option<WaitIdStatus> {
        while self.sent < self.outbox.len() && Instant::now() < deadline && self.exited().is_none() {
            self.turn(Duration::from_millis(2));
            self.lines = Lines::default();
        }
        self.input = None;
        let status = self.ended(deadline);
        self.kill();
        status
    }

    /// Kills the whole group, and takes leave of the process.
    pub fn kill(&mut self) {
        if self.reaped {
            return;
        }
        // The process is not reaped yet, so that the number of the group can't belong to others. One that is gone is as good.
        let _ = kill_process_group(self.group, Signal::KILL);
        let _ = self.process.wait();
        self.reaped = true;
    }
}

impl Drop for Child {
    fn drop(&mut self) {
        self.kill();
    }
}

/// Reads a piece; `None` if there was nothing. At its end the pipe is dropped.
fn take<R: Read>(pipe: &mut Option<R>, piece: &mut [u8]) -> Option<usize> {
    let read = pipe.as_mut()?.read(piece);
    match read {
        Ok(read) if read > 0 => Some(read),
        Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => None,
        _ => {
            *pipe = None;
            None
        }
    }
}
