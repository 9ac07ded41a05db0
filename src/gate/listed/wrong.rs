//! What can be wrong with an impact of a list.

use std::fmt;

use contract::Impact;

/// An impact of a list that is wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrong {
    /// Its number, from 1.
    pub n: usize,
    /// Its time as given; where the velocity is wrong, that.
    pub given: f64,
    /// What is wrong.
    pub what: What,
}

/// What is wrong with an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum What {
    /// Its time is before this, that of the one before it.
    Falls(f64),
    /// The block never rocks.
    NeverRocks,
    /// The block came to rest at this time.
    AfterRest(f64),
    /// The block overturned before.
    AfterOverturning,
    /// There are not so many impacts up to this time.
    TooMany,
    /// It is really a later one: so many were missed.
    Missed(usize),
    /// It is the one of this number again.
    Repeated(usize),
    /// There is no such impact; the one after it in the list stands where this one should.
    Extra,
    /// It is too early or too late: the proven one.
    Off(Impact),
    /// Its velocity should be this.
    Velocity(f64),
    /// Its velocity is to the other side.
    Side,
}

impl Wrong {
    /// The kind, in a word or two.
    pub fn kind(&self) -> &'static str {
        match self.what {
            What::Falls(_) => "time-falls",
            What::NeverRocks => "never-rocks",
            What::AfterRest(_) => "after-rest",
            What::AfterOverturning => "after-overturning",
            What::TooMany => "too-many",
            What::Missed(_) => "missed",
            What::Repeated(_) => "repeated",
            What::Extra => "extra",
            What::Off(proven) if self.given < proven.time => "early",
            What::Off(_) => "late",
            What::Velocity(_) => "velocity",
            What::Side => "side",
        }
    }
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { n, given, what } = *self;
        match what {
            What::Falls(before) => write!(f, "its time {given} is before {before}, that of the one before it"),
            What::NeverRocks => f.write_str("the block never rocks: the ground does not reach the threshold"),
            What::AfterRest(rest) => write!(f, "at {given} the block has come to rest: it did at {rest}"),
            What::AfterOverturning => write!(f, "at {given} the block has overturned"),
            What::TooMany => write!(f, "there are only {} impacts up to {given}", n - 1),
            What::Missed(1) => write!(f, "{given} is the time of impact {}: impact {n} is missing", n + 1),
            What::Missed(missed) => {
                write!(f, "{given} is the time of impact {}: impacts {n} to {} are missing", n + missed, n + missed - 1)
            }
            What::Repeated(of) => write!(f, "{given} is the time of impact {of} again"),
            What::Extra => {
                write!(f, "there is no impact at {given}; the next one in the list stands where this one should")
            }
            What::Off(proven) => {
                let (off, way) = ((given - proven.time).abs(), if given < proven.time { "early" } else { "late" });
                let (time, share) = (proven.time, 100.0 * off / proven.interval);
                write!(f, "{given}, and proven is {time}: {off:.2e} too {way}, {share:.2} % of the interval before it")
            }
            What::Velocity(proven) => {
                write!(f, "its velocity is {given}, and proven is {proven} just after the impact")
            }
            What::Side => {
                write!(f, "its velocity {given} is to the other side than it should be after those before it")
            }
        }
    }
}
