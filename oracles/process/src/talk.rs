//! The talk with one process.

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use contract::{Case, Model};

use crate::{
    answer::{Answer, Outcome},
    child::{Child, Heard},
    exit,
    launch::Launch,
    lines::Cut,
    question::{Asked, ECHO, Question, VERSIONS},
    reading::read,
    record::{Direction, Recorder},
    reply::{Hello, Reply},
    verdict::{Breakdown, Verdict},
    welcome::Welcome,
};

/// How long a process may take to end after it has closed its output.
const LAST_BREATH: Duration = Duration::from_millis(300);

/// How much of the error output a breakdown carries.
const STDERR: usize = 4 * 1024;

/// How long a line may be, whatever is asked.
const LONGEST_LINE: usize = 96 << 20;

/// How much of a line is for everything but the impacts.
const LINE_BESIDES: usize = 64 << 10;

/// How much of a line is for an impact: six columns, all claims among them, in hexadecimal.
const LINE_PER_IMPACT: usize = 200;

/// A talk with one process that was started and has shown that it can be asked.
pub struct Talk {
    child: Child,
    recorder: Recorder,
    launch: Arc<Launch>,
    welcome: Welcome,
    /// The number of the next question.
    next: u64,
    /// What was asked last, and whether an answer to it came again.
    before: Vec<(Case, bool)>,
}

/// What came of a question.
pub struct Replies {
    /// The answers, in the order of the cases.
    pub answers: Vec<Option<Answer>>,
    /// Cases of the question before that were answered again.
    pub again: Vec<Case>,
    /// How the talk broke. It can't go on then.
    pub broke: Option<Breakdown>,
}

impl Talk {
    /// Starts a process and shakes hands.
    ///
    /// # Errors
    /// How it broke; nothing of it is left then.
    pub fn start(launch: &Arc<Launch>, recorder: Recorder) -> Result<Self, Breakdown> {
        let mut child = Child::start(launch)?;
        let start = Question::Start { versions: VERSIONS, echo: ECHO };
        say(&mut child, &recorder, &start)?;
        let deadline = Instant::now() + launch.start_timeout;
        let welcome = listen(&mut child, &recorder, LINE_BESIDES, deadline)
            .map_err(|broke| at_the_start(broke, launch.start_timeout))
            .and_then(|line| Welcome::of(read::<Hello>(&line)?, launch))
            .map_err(|broke| broke.with_stderr(child.stderr(STDERR)))?;
        Ok(Self { child, recorder, launch: Arc::clone(launch), welcome, next: 1, before: Vec::new() })
    }

    /// What the engine said of itself.
    pub fn welcome(&self) -> &Welcome {
        &self.welcome
    }

    /// The end of its error output.
    pub fn stderr(&self) -> String {
        self.child.stderr(usize::MAX)
    }

    /// Asks these cases of this model: one, or a batch.
    pub fn ask(&mut self, cases: &[Case], model: Model) -> Replies {
        let mut replies = Replies { answers: cases.iter().map(|_| None).collect(), again: Vec::new(), broke: None };
        let began = Instant::now();
        if let Err(broke) = self.answer_all(cases, model, &mut replies) {
            let broke = broke.with_stderr(self.child.stderr(STDERR));
            match replies.answers.as_mut_slice() {
                // A whole line that can't be understood was the answer; the engine waits for the next question.
                [only @ None] if broke.verdict.is_of_a_whole_line() => {
                    *only = Some(Answer::without(Outcome::Broke(broke)));
                }
                _ => replies.broke = Some(broke),
            }
        }
        let shares = u32::try_from(cases.len()).unwrap_or(u32::MAX).max(1);
        for answer in replies.answers.iter_mut().flatten() {
            answer.elapsed = began.elapsed() / shares;
        }
        self.before = cases.iter().map(|case| (*case, false)).collect();
        replies
    }

    fn answer_all(&mut self, cases: &[Case], model: Model, replies: &mut Replies) -> Result<(), Breakdown> {
        let first = self.next;
        let otherwise = self.launch.normalisation;
        let asked: Vec<Asked> =
            (first..).zip(cases).map(|(seq, case)| Asked::new(seq, case, model, otherwise)).collect();
        self.next += u64::try_from(cases.len()).unwrap_or(u64::MAX);
        let question = match asked.as_slice() {
            [only] => Question::Case(only),
            many => Question::Cases { cases: many },
        };
        say(&mut self.child, &self.recorder, &question)?;
        let most = cases.iter().map(Case::max_impacts).max().unwrap_or(0);
        let limit = (LINE_BESIDES + LINE_PER_IMPACT * most).min(LONGEST_LINE);
        let patience = self.launch.case_timeout * u32::try_from(cases.len()).unwrap_or(u32::MAX);
        let deadline = Instant::now() + patience;
        while replies.answers.iter().any(Option::is_none) {
            let line = listen(&mut self.child, &self.recorder, limit, deadline)
                .map_err(|broke| in_time(broke, patience, cases.len()))?;
            self.take(read(&line)?, first, cases, replies)?;
        }
        Ok(())
    }

    /// Puts a reply where it belongs.
    fn take(&mut self, reply: Reply, first: u64, cases: &[Case], replies: &mut Replies) -> Result<(), Breakdown> {
        let seq = match (reply.seq.map(|seq| seq.0), cases.len()) {
            (Some(seq), _) => seq,
            // Who failed may not know what it was asked; there is only one thing that it can mean.
            (None, 1) if reply.error.is_some() => first,
            (None, _) => return Err(Breakdown::new(Verdict::MissingField, "the answer has no \"seq\"")),
        };
        let place = |from: u64| seq.checked_sub(from).and_then(|place| usize::try_from(place).ok());
        if let Some((case, slot)) = place(first).and_then(|at| cases.get(at).zip(replies.answers.get_mut(at))) {
            *slot = Some(match slot {
                None => Answer::of(reply, case, &self.launch.tolerance, self.welcome.claims),
                Some(_) => Answer::broke(Verdict::TwoAnswers, format!("seq {seq} was answered twice")),
            });
            return Ok(());
        }
        let earlier = first.saturating_sub(u64::try_from(self.before.len()).unwrap_or(u64::MAX));
        match place(earlier).and_then(|at| self.before.get_mut(at)) {
            Some((case, again)) if !*again => {
                *again = true;
                replies.again.push(*case);
                Ok(())
            }
            Some(_) => Err(Breakdown::new(Verdict::TwoAnswers, format!("seq {seq} was answered again and again"))),
            None => {
                let last = self.next.saturating_sub(1);
                let asked = if first == last { format!("{first}") } else { format!("{first} to {last}") };
                Err(Breakdown::new(Verdict::WrongSeq, format!("the answer has seq {seq}, the question had {asked}")))
            }
        }
    }

    /// Says good-bye, and waits for the end.
    pub fn stop(mut self) -> Option<Breakdown> {
        let _ = say(&mut self.child, &self.recorder, &Question::Stop);
        let grace = self.launch.grace;
        match self.child.finish(Instant::now() + grace) {
            Some(_) => None,
            None => Some(
                Breakdown::new(Verdict::DoesNotStop, format!("it was still there {} s later", grace.as_secs_f64()))
                    .with_stderr(self.child.stderr(STDERR)),
            ),
        }
    }
}

fn say(child: &mut Child, recorder: &Recorder, question: &Question<'_>) -> Result<(), Breakdown> {
    let line = question.line().map_err(|error| Breakdown::new(Verdict::BadSetting, error.to_string()))?;
    recorder.keep(Direction::To, line.as_bytes());
    child.say(&line);
    Ok(())
}

/// The next line.
fn listen(child: &mut Child, recorder: &Recorder, limit: usize, deadline: Instant) -> Result<Vec<u8>, Breakdown> {
    let heard = child.hear(limit, deadline);
    if let Heard::Cut(Cut::Line(line)) = heard {
        recorder.keep(Direction::From, &line);
        return Ok(line);
    }
    let unfinished = child.lines().unfinished();
    if unfinished > 0 {
        let rest = child.lines().rest();
        recorder.keep(Direction::From, rest.get(..rest.len().min(LINE_BESIDES)).unwrap_or_default());
    }
    let half = format!("{unfinished} bytes came, and no newline");
    let (verdict, happened) = match heard {
        Heard::Cut(Cut::TooLong(length)) => {
            (Verdict::LineTooLong, format!("{length} bytes, where an answer has {limit} at the most"))
        }
        Heard::Cut(_) => (Verdict::Flood, half),
        Heard::Late if child.lines().overflows() => (Verdict::Flood, half),
        Heard::Late if unfinished > 0 => (Verdict::HalfLine, half),
        Heard::Late if child.deaf => {
            (Verdict::ClosedInput, "no answer, and the engine does not read any more".to_owned())
        }
        Heard::Late => (Verdict::TimedOut, "no answer".to_owned()),
        Heard::End => match child.ended(Instant::now() + LAST_BREATH) {
            Some(status) if !exit::is_success(&status) => (Verdict::Crashed, exit::told(&status)),
            Some(_) if unfinished > 0 => (Verdict::HalfLine, format!("{half}; then the engine ended")),
            Some(status) => (Verdict::EndedMidCase, exit::told(&status)),
            None => (Verdict::ClosedOutput, "no answer, and the engine is still running".to_owned()),
        },
    };
    Err(Breakdown::new(verdict, happened))
}

/// What it means when it happens before the engine has said anything.
fn at_the_start(broke: Breakdown, patience: Duration) -> Breakdown {
    match broke.verdict {
        Verdict::TimedOut => {
            Breakdown::new(Verdict::NoAnswerAtStart, format!("nothing in {} s", patience.as_secs_f64()))
        }
        Verdict::Crashed | Verdict::EndedMidCase => Breakdown { verdict: Verdict::EndedAtStart, ..broke },
        _ => broke,
    }
}

/// Says how long was waited.
fn in_time(broke: Breakdown, patience: Duration, cases: usize) -> Breakdown {
    match broke.verdict {
        Verdict::TimedOut => {
            let of = if cases == 1 { String::new() } else { format!(" to some of {cases} cases") };
            Breakdown { happened: format!("no answer{of} in {} s", patience.as_secs_f64()), ..broke }
        }
        _ => broke,
    }
}
