//! What an engine says, as it stands in the line.

use std::fmt;

use contract::Case;
use serde::{Deserialize, Deserializer, de};

use crate::{
    number::{Number, Whole},
    object::object,
};

object! {
    /// The answer to the start.
    Hello {
        /// The version of the protocol that the engine has chosen.
        version: Whole,
        /// Who it is.
        engine: Name,
        /// The models that it solves.
        models: Vec<String>,
        /// What its amplitude may be a multiple of.
        normalisations: Vec<String>,
        /// The motions of the ground that it knows.
        ground: Vec<String>,
        /// Whether it claims errors.
        claims: bool,
        /// How many cases may be asked at once.
        max_batch: Whole,
        /// The doubles that it was sent.
        echo: Vec<Number>,
        /// Instead of all that: why it can't start.
        error: Failure,
    }
}

object! {
    /// Who an engine is.
    Name {
        /// Its name.
        name: String,
        /// Its version.
        version: String,
        /// The language that it is written in.
        language: String,
    }
}

object! {
    /// The answer to a case.
    Reply {
        /// The number of the question.
        seq: Whole,
        /// The impacts.
        history: Columns,
        /// A refusal.
        decline: Refusal,
        /// A failure.
        error: Failure,
        /// How long the engine took, in nanoseconds, as it says.
        ns: Number,
    }
}

object! {
    /// A history.
    Columns {
        /// The times of the impacts.
        time: Column,
        /// The intervals before them.
        interval: Column,
        /// The velocities after them.
        velocity: Column,
        /// Why the list ended.
        ending: String,
        /// The chattering time.
        tau_ch: Number,
        /// The errors claimed.
        claim: Claim,
    }
}

object! {
    /// The errors that an engine claims.
    Claim {
        /// Of the times, absolute.
        time: Errors,
        /// Of the intervals, relative.
        interval: Errors,
        /// Of the velocities, relative.
        velocity: Errors,
        /// Of the chattering time, absolute.
        tau_ch: Number,
    }
}

object! {
    /// Why an engine refuses a case.
    Refusal {
        /// In a word or two, without numbers.
        reason: String,
        /// With the numbers.
        why: String,
    }
}

object! {
    /// How an engine failed.
    Failure {
        /// In its words.
        message: String,
    }
}

/// A column of numbers. However many there are, no more are kept than a case can ask for.
#[derive(Debug, Default)]
pub struct Column {
    /// The numbers.
    pub values: Vec<f64>,
    /// How many there were.
    pub count: usize,
}

/// What is claimed of a column: one number for all, or one each.
#[derive(Debug)]
pub enum Errors {
    /// For all.
    Same(f64),
    /// One each.
    Each(Column),
}

struct Numbers;

impl<'de> de::Visitor<'de> for Numbers {
    type Value = Column;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of numbers")
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, mut items: A) -> Result<Column, A::Error> {
        let mut column = Column::default();
        while let Some(Number(value)) = items.next_element()? {
            if column.count < Case::MOST_IMPACTS {
                column.values.push(value);
            }
            column.count += 1;
        }
        Ok(column)
    }
}

impl<'de> Deserialize<'de> for Column {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(Numbers)
    }
}

struct NumberOrNumbers;

impl<'de> de::Visitor<'de> for NumberOrNumbers {
    type Value = Errors;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, or a list of numbers")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Errors, E> {
        Ok(Errors::Same(value))
    }

    #[allow(clippy::cast_precision_loss)] // An integer of JSON stands for the nearest double, as a decimal does.
    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Errors, E> {
        Ok(Errors::Same(value as f64))
    }

    #[allow(clippy::cast_precision_loss)]
    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Errors, E> {
        Ok(Errors::Same(value as f64))
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Errors, E> {
        Number::deserialize(de::value::StrDeserializer::new(text)).map(|number| Errors::Same(number.0))
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, items: A) -> Result<Errors, A::Error> {
        Numbers.visit_seq(items).map(Errors::Each)
    }
}

impl<'de> Deserialize<'de> for Errors {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberOrNumbers)
    }
}
