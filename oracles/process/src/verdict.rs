//! The ways in which an engine breaks, each with a name and with what to do about it.

use std::fmt;

use contract::Decline;

/// Declares the verdicts: what is meant, the name in reports, and the advice to somebody who has never read the protocol.
macro_rules! verdicts {
    ($($(#[$meaning:meta])* $verdict:ident: $name:literal, $advice:literal;)*) => {
        /// A way in which an engine breaks. It says nothing about the physics.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Verdict {
            $($(#[$meaning])* $verdict,)*
        }

        impl Verdict {
            /// Every verdict.
            pub const ALL: &[Self] = &[$(Self::$verdict),*];

            /// The name that reports use.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$verdict => $name,)*
                }
            }

            /// What to do about it.
            pub fn advice(self) -> &'static str {
                match self {
                    $(Self::$verdict => $advice,)*
                }
            }
        }
    };
}

verdicts! {
    /// What is to be run is not described well.
    BadSetting: "bad setting", "Correct this setting of the engine";
    /// There is no such program.
    NoSuchProgram: "no such program", "Check the first word of `run` (and the interpreter that a script names in its first line), install the program, or give its full path";
    /// The directory to run in is missing.
    NoSuchDirectory: "no such directory", "Check `directory`; it is relative to the file that names the engine";
    /// The system refused to start the program.
    CannotStart: "cannot be started", "Make the file executable (chmod +x), or put the interpreter in front of it in `run`";
    /// The command that tells its version failed.
    NoVersion: "no version", "Run the command of `version` by hand; it has to print the version and to end";
    /// It is another version than the manifest wants.
    AnotherVersion: "another version", "Install the version that `version` asks for, or change its pattern";
    /// It did not answer the start in time.
    NoAnswerAtStart: "no answer at the start", "The engine has to answer the first line that it reads with one line. Flush standard output after every line; if it only needs longer, raise `start-timeout`";
    /// It ended before it answered the start.
    EndedAtStart: "ended at the start", "Run the same command by hand; the end of its error output tells why it stopped";
    /// It speaks another version of the protocol.
    WrongVersion: "wrong version", "Answer the start with \"version\": 1";
    /// The echo came back with other digits.
    EchoNotExact: "echo not bit for bit", "The engine loses digits when it reads or prints numbers. Print 17 significant digits (%.17g in C, repr in Python), keep the sign of -0.0, and read numbers as doubles";
    /// It does not solve the model that is asked for.
    ModelNotOffered: "model not offered", "Set `model` to one that the engine solves, or add it to \"models\" in its answer to the start";
    /// It measures the amplitude by something else.
    NormalisationNotOffered: "normalisation not offered", "Set `normalisation` to one that the engine uses, or add it to \"normalisations\" in its answer to the start";
    /// It does not know the motion of the ground.
    GroundNotOffered: "ground not offered", "Every case here has a sinusoidal ground motion: add \"sine\" to \"ground\" in the answer to the start";
    /// It answered the start otherwise than before.
    AnotherEngine: "another engine after a restart", "All processes of one engine have to give the same name, version and abilities";
    /// A line is no JSON.
    Garbage: "garbage on standard output", "Standard output is for answers only, one JSON object a line: print everything else to standard error";
    /// A line is not whole.
    HalfLine: "half a line", "End every answer with a newline and flush standard output after it";
    /// Not a number outside of quotes.
    BareNan: "NaN outside of quotes", "JSON has no NaN and no infinity: write \"nan\", \"inf\" or \"-inf\", with the quotes";
    /// A number that is too large for a double.
    NumberTooLarge: "number too large", "Write numbers that a double can hold, or \"inf\", with the quotes";
    /// A line is longer than any answer to the question.
    LineTooLong: "line too long", "Send no more impacts than \"impacts\" asks for, one answer a line";
    /// Output without end and without a newline.
    Flood: "flood without a newline", "The engine prints without end: look for a loop that does not stop; end every answer with a newline";
    /// A line is not UTF-8.
    BrokenUtf8: "broken UTF-8", "Print UTF-8 only: no binary output, and no text in another encoding";
    /// A field that the protocol does not have.
    UnknownField: "unknown field", "Correct the name, or start it with x- if it is an addition of your own";
    /// A field given twice.
    FieldTwice: "field given twice", "Give every field once";
    /// A field is missing.
    MissingField: "missing field", "Add this field to the answer";
    /// A field holds something else than it should.
    WrongKind: "field of the wrong kind", "Give this field the kind of value that is named";
    /// An answer to a question that nobody asked.
    WrongSeq: "wrong seq", "Copy \"seq\" from the question into its answer";
    /// A second answer to the same question.
    TwoAnswers: "two answers", "Answer every question once";
    /// The columns of a history are not equally long.
    UnequalColumns: "columns of different lengths", "Give \"time\", \"velocity\" and, if it is there, \"interval\" one number for every impact";
    /// More impacts than were asked for.
    TooManyImpacts: "more impacts than asked", "Stop after as many impacts as \"impacts\" asks for, with the ending \"limit-reached\"";
    /// An ending that the protocol does not have.
    UnknownEnding: "unknown ending", "Use one of never-rocks, at-rest, incomplete, overturned, limit-reached, lost";
    /// A claim that is no error.
    BadClaim: "claim that is no error", "A claimed error is zero or positive, one number for all impacts or one for each";
    /// A claim from an engine that said it claims nothing.
    ClaimNotAnnounced: "claim not announced", "Answer the start with \"claims\": true, or leave \"claim\" out";
    /// The engine says that it failed.
    ReportedError: "error reported by the engine", "The message is the engine's own: look there";
    /// No answer in time, twice.
    TimedOut: "timed out", "If the engine only needs longer, raise `case-timeout`; otherwise look for a loop that does not stop, an answer that is not flushed, or a question that is not read";
    /// It crashed, twice.
    Crashed: "crashed", "Run this case by hand; the end of the engine's error output tells where it stopped";
    /// It ended without an answer, and without an error status, twice.
    EndedMidCase: "ended without an answer", "The engine has to go on reading questions until its input ends: put a loop around it";
    /// It closed its standard output and lives on.
    ClosedOutput: "standard output closed", "Keep standard output open until the input ends";
    /// It closed its standard input and lives on.
    ClosedInput: "standard input closed", "Keep reading standard input, a line at a time, until it ends";
    /// It was restarted too often.
    RestartsExhausted: "restarts exhausted", "Mend what made it break before, or raise `restarts`; the cases after that were not asked";
    /// Asked alone it answers otherwise than in a batch.
    DiffersAlone: "answers differ alone", "A case has to have the same answer in any company: look for state that is kept from one case to the next, or set \"max_batch\" to 1";
    /// It did not end when it was told to.
    DoesNotStop: "does not stop", "End when \"cmd\" is \"stop\" or the input ends; it was killed";
}

impl Verdict {
    /// Whether it may be chance: the case is asked once more, alone, of a new process.
    pub(crate) fn may_be_chance(self) -> bool {
        use Verdict::{ClosedInput, ClosedOutput, Crashed, EndedMidCase, HalfLine, TimedOut};
        matches!(self, TimedOut | Crashed | EndedMidCase | ClosedOutput | ClosedInput | HalfLine)
    }

    /// Whether one whole line came that means nothing, so that the engine can be asked on.
    pub(crate) fn is_of_a_whole_line(self) -> bool {
        use Verdict::{BareNan, BrokenUtf8, FieldTwice, MissingField, NumberTooLarge, UnknownField, WrongKind};
        matches!(self, BareNan | BrokenUtf8 | FieldTwice | MissingField | NumberTooLarge | UnknownField | WrongKind)
    }
}

/// How one engine broke.
#[derive(Debug, Clone, PartialEq)]
pub struct Breakdown {
    /// In which way.
    pub verdict: Verdict,
    /// What happened, with the numbers, in one line.
    pub happened: String,
    /// The end of its error output, where that may tell more.
    pub stderr: String,
}

impl Breakdown {
    pub(crate) fn new(verdict: Verdict, happened: impl Into<String>) -> Self {
        Self { verdict, happened: happened.into(), stderr: String::new() }
    }

    pub(crate) fn with_stderr(self, stderr: String) -> Self {
        Self { stderr, ..self }
    }

    /// The last line of the error output that is not empty.
    fn last_words(&self) -> Option<&str> {
        self.stderr.lines().map(str::trim).rfind(|line| !line.is_empty())
    }
}

impl From<Breakdown> for Decline {
    fn from(broke: Breakdown) -> Self {
        let last =
            broke.last_words().map(|words| format!("; its error output ends with {words:?}")).unwrap_or_default();
        Self::NoAnswer {
            breakdown: broke.verdict.name(),
            happened: broke.happened + &last,
            advice: format!("{}.", broke.verdict.advice()),
        }
    }
}

impl fmt::Display for Breakdown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Decline::from(self.clone()).fmt(f)
    }
}

impl std::error::Error for Breakdown {}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nobody can tell two ways of breaking apart that have one name.
    #[test]
    fn names_are_unique() {
        for (at, verdict) in Verdict::ALL.iter().enumerate() {
            assert!(Verdict::ALL.iter().skip(at + 1).all(|other| other.name() != verdict.name()), "{verdict:?}");
        }
    }

    /// The line for people has the name, what happened, the last words, and what to do.
    #[test]
    fn a_breakdown_is_told_in_one_line() {
        let broke = Breakdown::new(Verdict::Crashed, "exit status 3").with_stderr("first\nlast words\n\n".to_owned());
        let told = broke.to_string();
        assert!(
            told.starts_with("crashed: exit status 3; its error output ends with \"last words\". Run this"),
            "{told}"
        );
        assert!(!told.contains('\n'));
    }
}
