use astro_float::BigFloat;
use contract::{
    Body, Case, Decline, Ending, FlightSolver, History, Horizon, Impact, Invalid, Model, Motion, Oracle, Uncertainty,
};

use crate::arithmetic::{Arithmetic, agreement, double};
use crate::flights::Flights;
use crate::follow::{LongImpact, follow};
use crate::{precision, zeno};

/// Eqs 6-13 in absolute time as they are printed, with more digits than their cancellation takes away.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Printed {
    digits: usize,
}

/// One impact in decimals. Every digit shown is right to a unit of the last one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DecimalImpact {
    /// The dimensionless time `τ_n`.
    pub time: String,
    /// The interval `Δτ_{n-1} = τ_n - τ_{n-1}`.
    pub interval: String,
    /// The velocity `φ'_n(τ_n)` after the impact (Eq. 13).
    pub velocity: String,
}

/// What a double needs, and a few more.
const DIGITS_OF_A_DOUBLE: usize = 20;
/// Bits by which the second of two computations is longer than the first.
const MORE_BITS: usize = 128;
// Two computations that round alike would agree in wrong digits too.
const _: () = assert!(MORE_BITS >= 64);
/// Decimals in which two computations agree that are not shown: one for the measure of agreement itself, one for safety.
const HIDDEN_DIGITS: usize = 2;
/// How many impacts times bits a history is computed for: a few seconds.
const MOST_WORK: usize = 300_000;
/// The depths at which the chattering time is extrapolated, until two of them agree.
const DEPTHS: [usize; 8] = [24, 36, 54, 80, 120, 180, 270, 400];

impl Default for Printed {
    fn default() -> Self {
        Self { digits: 60 }
    }
}

impl Printed {
    /// The method with `digits` significant decimals of the results.
    ///
    /// # Errors
    /// When `digits` is not inside 1..=1000.
    pub fn with_digits(digits: usize) -> Result<Self, Invalid> {
        if !(1..=1000).contains(&digits) {
            return Err(Invalid::new("digits", digits, "1 <= digits <= 1000"));
        }
        Ok(Self { digits })
    }

    /// The impacts of a case, with the digits asked for. Computed twice, the second time with longer numbers: digits in which the two differ
    /// are left out.
    ///
    /// # Errors
    /// As [`Oracle::history`].
    pub fn decimals(&self, case: &Case) -> Result<Vec<DecimalImpact>, Decline> {
        let Some(bits) = bits_for(case, self.digits, case.max_impacts())? else { return Ok(Vec::new()) };
        let short = follow_in(&Arithmetic::new(bits)?, case)?.0;
        let ar = Arithmetic::new(bits + MORE_BITS)?;
        let long = follow_in(&ar, case)?.0;
        short
            .iter()
            .zip(&long)
            .map(|(short, long)| {
                Ok(DecimalImpact {
                    time: self.agreed(&ar, &short.time, &long.time)?,
                    interval: self.agreed(&ar, &short.interval, &long.interval)?,
                    velocity: self.agreed(&ar, &short.velocity, &long.velocity)?,
                })
            })
            .collect()
    }

    /// The chattering time `τ_ch`, extrapolated from the partial sums of the intervals at two depths. Only digits that both agree in are
    /// shown, as many as were asked for if that takes no more than 400 impacts. The limits of the case, on impacts and on time, are not used.
    ///
    /// # Errors
    /// When the block does not rock, does not chatter completely, or the two depths agree in less than 15 digits; else as
    /// [`Oracle::history`].
    pub fn chattering_time_decimal(&self, case: &Case) -> Result<String, Decline> {
        let case = &case.with_horizon(Horizon::HalfPeriod).unwrap_or(*case);
        let mut before: Option<BigFloat> = None;
        let mut best: Option<(usize, String)> = None;
        for depth in DEPTHS {
            let digits = self.digits + HIDDEN_DIGITS + zeno::decimals_lost(case.eta(), depth / 2).ceil() as usize;
            // Deeper than the numbers can go: what there is has to do.
            let Ok(bits) = bits_for(case, digits, depth) else { break };
            let Some(bits) = bits else {
                return Err(Decline::NotConvergent {
                    why: "the block does not rock: there is no chattering time".to_owned(),
                });
            };
            let ar = Arithmetic::new(bits)?;
            let (impacts, ending) = follow(&ar, case, depth);
            match ending {
                Ending::AtRest => {}
                Ending::LimitReached(_) => continue,
                other => return Err(Decline::NotConvergent { why: format!("no chattering time: {other}") }),
            }
            let Some(limit) = zeno::limit(&ar, case, &impacts) else { continue };
            if let Some(before) = before.replace(limit.clone()) {
                let agreed = agreement(&ar, &before, &limit).saturating_sub(HIDDEN_DIGITS);
                let text = decimal(&ar, &limit, agreed.min(self.digits))?;
                if agreed >= self.digits {
                    return Ok(text);
                }
                if best.as_ref().is_none_or(|(digits, _)| *digits < agreed) {
                    best = Some((agreed, text));
                }
            }
        }
        match best {
            Some((15.., text)) => Ok(text),
            Some((digits, _)) => {
                Err(Decline::NotConvergent { why: format!("the chattering time is right to {digits} digits only") })
            }
            None => Err(Decline::NotConvergent {
                why: "two depths of at most 400 impacts from which the chattering is certain to be complete: there are none".to_owned(),
            }),
        }
    }

    fn agreed(&self, ar: &Arithmetic, short: &BigFloat, long: &BigFloat) -> Result<String, Decline> {
        decimal(ar, long, agreement(ar, short, long).saturating_sub(HIDDEN_DIGITS).min(self.digits))
    }
}

fn decimal(ar: &Arithmetic, value: &BigFloat, digits: usize) -> Result<String, Decline> {
    ar.decimal(value, digits).ok_or_else(|| Decline::NotConvergent { why: "a value is not a finite number".to_owned() })
}

/// The bits that a case needs, or `None` when the block does not rock.
fn bits_for(case: &Case, digits: usize, impacts: usize) -> Result<Option<usize>, Decline> {
    if case.epsilon() <= 0.0 { Ok(None) } else { precision::bits(case, digits, impacts).map(Some) }
}

/// The impacts that the case asks for, or a decline where it asks for more than the first half period.
fn follow_in(ar: &Arithmetic, case: &Case) -> Result<(Vec<LongImpact>, Ending), Decline> {
    let (impacts, ending) = follow(ar, case, case.max_impacts());
    // An end of its own, before T/2, is not `Incomplete`.
    if ending == Ending::Incomplete && matches!(case.horizon(), Horizon::Until(_)) {
        return Err(Decline::Unsupported { what: "rocking past half a period" });
    }
    Ok((impacts, ending))
}

impl Oracle for Printed {
    fn name(&self) -> &str {
        "printed"
    }

    fn model(&self) -> Model {
        Model::Linear
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        let Some(bits) = bits_for(case, DIGITS_OF_A_DOUBLE, case.max_impacts())? else {
            return Ok(History { impacts: Vec::new(), ending: Ending::NeverRocks, chattering_time: None });
        };
        if bits.saturating_mul(case.max_impacts()) > MOST_WORK {
            let allowed = "so few that impacts times the bits that they need stay below 300,000: this method is slow";
            return Err(Decline::OutOfRange { field: "impacts", value: case.max_impacts() as f64, allowed });
        }
        let (impacts, ending) = follow_in(&Arithmetic::new(bits)?, case)?;
        Ok(History { impacts: impacts.iter().map(rounded).collect(), ending, chattering_time: None })
    }

    /// Under one sinusoid, or still ground; each flight to the last digit of a double.
    fn flights_on(&self, body: &Body, motion: &Motion) -> Result<Box<dyn FlightSolver>, Decline> {
        Ok(Box::new(Flights::new(body, motion)?))
    }
}

/// The impact in doubles. What it claims is that rounding: one unit in the last place.
fn rounded(impact: &LongImpact) -> Impact {
    let time = double(&impact.time);
    Impact {
        time,
        interval: double(&impact.interval),
        velocity: double(&impact.velocity),
        uncertainty: Uncertainty { time: f64::EPSILON * time, interval: f64::EPSILON, velocity: f64::EPSILON },
    }
}
