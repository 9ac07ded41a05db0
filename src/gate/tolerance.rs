//! The one table of what is allowed beyond the oracles' own claims, every number with its reason.
//!
//! Two oracles that solve the same model have to agree to within the sum of what they claim: slack is zero, but for what
//! rounding the parameters does to the case. Both follow the conditioning of the case, so no entry has to be made for cases near the critical
//! amplitude.

use serde::Serialize;

/// An allowance, and why it is needed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Tolerance {
    /// What it applies to.
    pub applies_to: &'static str,
    /// The number.
    pub value: f64,
    /// What the number is.
    pub meaning: &'static str,
    /// Why it is not smaller.
    pub reason: &'static str,
}

/// Pairs that solve the same model, every observable.
pub const SAME_MODEL: Tolerance = Tolerance {
    applies_to: "same model, every observable",
    value: 0.0,
    meaning: "slack on top of the sum of the two claims and of the conditioning",
    reason: "Claims are made to be relied on: a pair that needs slack has a claim that is wrong.",
};

/// Every pair, every observable.
pub const BACKWARD: Tolerance = Tolerance {
    applies_to: "every pair, every observable",
    value: 1.0,
    meaning: "multiple of what rounding epsilon, omega and eta by 2^-53 of themselves does to the observable of this case",
    reason: "A method that works in doubles rounds its own parameters, once each; what that does is computed with the derivatives \
             of every impact (see conditioning.rs), and grows without bound towards a_cr.",
};

/// Pairs across models, every observable.
pub const ACROSS_MODELS: Tolerance = Tolerance {
    applies_to: "linear against nonlinear, every observable",
    value: 1.0,
    meaning: "multiple of the model gap, on top of the sum of the two claims",
    reason: "The models differ by up to alpha^2 (1/2 + a) in gravitational stiffness; the gap is what that does to this case, \
             computed with the linear oracle (see model_gap.rs). It falls as alpha^2.",
};

/// The sum of intervals against the time.
pub const TIME_IS_SUM: Tolerance = Tolerance {
    applies_to: "one oracle: time against the sum of its intervals",
    value: contract::conformance::TIME_IS_SUM,
    meaning: "units in the last place of the time, on top of the claim for the interval",
    reason: "Two times and their difference are rounded, and a method may add intervals in plain doubles.",
};

/// How the interval ratios approach `η²`.
pub const RATIO_LAW: Tolerance = Tolerance {
    applies_to: "one oracle: interval ratio against eta^2 and its first-order rate",
    value: 3.0,
    meaning: "multiple of x^2, x the relative change of the forcing over two flights, on top of the claims",
    reason: "Eq. 73 is the limit; the first-order term in the interval is known, what is left is of second order with a \
             coefficient that stayed below 1.2 over all cases of the default run.",
};

/// Where [`RATIO_LAW`] is applied.
pub const RATIO_REGIME: Tolerance = Tolerance {
    applies_to: "one oracle: interval ratio, where the law is applied",
    value: 0.02,
    meaning: "largest x",
    reason: "Earlier flights are not yet in the regime of Eq. 73.",
};

/// The order in `α` of the difference between the models.
pub const ALPHA_LADDER: Tolerance = Tolerance {
    applies_to: "ladder of slenderness: order of the nonlinear-linear difference of tau_ch",
    value: 0.01,
    meaning: "distance of the observed order from 2",
    reason: "The next term is of order alpha^4; between the two lowest rungs (0.05 and 0.025) it makes the order 2.0011 to 2.0013.",
};

/// The order in `ε` of the error of the series.
pub const EPSILON_LADDER: Tolerance = Tolerance {
    applies_to: "ladder of epsilon: order of the relative error of the series' tau_ch",
    value: 0.005,
    meaning: "distance of the observed order from 1",
    reason: "The next term is of order epsilon^2; between the two lowest rungs (1e-5 and 1e-6) it makes the order 0.9994 to 1.0000.",
};

/// Below which an interval a list may end earlier than that of another oracle.
pub const RESOLUTION: Tolerance = Tolerance {
    applies_to: "length of the list when the chattering is complete",
    value: 1e-100,
    meaning: "interval below which an oracle may stop resolving impacts",
    reason: "Methods differ in the smallest number that they can hold; nothing physical is left at this depth.",
};

/// How much of a pair's comparisons may be so wide that they compare nothing.
pub const VACUOUS: Tolerance = Tolerance {
    applies_to: "a pair over the whole run",
    value: 0.75,
    meaning: "largest share of impacts, and of chattering times, at which an allowance exceeds half of the value",
    reason: "The series claims little near a_cr, where most of the deep impacts are (63 % of its impacts); an oracle that claims \
             nothing anywhere must not pass.",
};

/// How much of its allowance a pair has to come near to, somewhere.
pub const USED: Tolerance = Tolerance {
    applies_to: "a pair over a whole run of 100 cases or more",
    value: 0.01,
    meaning: "smallest share of the allowance that the worst figure of every observable has to use",
    reason: "Claims and gaps that nothing ever comes near to are too wide to find anything; the worst figures of every pair use \
             3 % or more.",
};

/// How much larger than its true error an oracle may claim that it is.
pub const CALIBRATION: Tolerance = Tolerance {
    applies_to: "one oracle over a run, judged by the enclosure",
    value: 100.0,
    meaning: "largest median of the claim in multiples of the true error, of any observable",
    reason: "A claim that is too small is a failure of its case; one that is far too large hides what it should find.",
};

/// How far the claims of an oracle may move against its true errors before somebody has to look.
pub const RECALIBRATION: Tolerance = Tolerance {
    applies_to: "one oracle over a run in which 200 cases or more are judged",
    value: 1.5,
    meaning: "largest factor, up or down, between the median of the claim in multiples of the true error and what is on record",
    reason: "Claims that are halved or doubled find less or hide more, and no single case shows it. From seed to seed the medians vary by \
             factors of up to 1.3 from what is on record (data/record/calibration.csv).",
};

/// How many of the cases that it is asked the judge has to judge.
pub const JUDGED: Tolerance = Tolerance {
    applies_to: "the judge over a run",
    value: 0.95,
    meaning: "smallest share of the cases in the sample of which every history is judged",
    reason: "It may be undecided next to a_cr or a grazing impact; a judge that says nothing proves nothing.",
};

/// In how many whole responses it may be too close to call what happens.
pub const RESPONSES_TOO_CLOSE: Tolerance = Tolerance {
    applies_to: "whole responses of a run",
    value: 0.25,
    meaning: "largest share of the responses in which it is too close to call what happens from some time on",
    reason: "A response that is followed over many bouts may come arbitrarily near to a bifurcation; 5 of the 200 of the default run do.",
};

/// How many whole responses a method may decline.
pub const RESPONSES_DECLINED: Tolerance = Tolerance {
    applies_to: "one method over the whole responses of a run",
    value: 0.05,
    meaning: "largest share of the responses that its model can be asked which it declines",
    reason: "Responses are made for the methods that follow them: a decline is a rare corner, not a way out.",
};

/// How much of its allowance a method has to come near to in whole responses.
pub const RESPONSES_USED: Tolerance = Tolerance {
    applies_to: "one method over the whole responses of a run",
    value: 1e-3,
    meaning: "smallest share of the allowance that the worst impact has to use",
    reason: "What is allowed follows from how far the problem itself moves; a method of which no impact comes near could be wrong unseen.",
};

/// How many whole responses a run needs before it has to reach everything.
pub const RESPONSES_WHOLE: Tolerance = Tolerance {
    applies_to: "whole responses of a run",
    value: 200.0,
    meaning: "fewest responses of which every kind has to be met, and the three shares above are judged",
    reason: "Of the 200 of the default run, four or more are of every kind.",
};

/// Every entry.
pub const TABLE: [&Tolerance; 18] = [
    &SAME_MODEL,
    &BACKWARD,
    &ACROSS_MODELS,
    &TIME_IS_SUM,
    &RATIO_LAW,
    &RATIO_REGIME,
    &ALPHA_LADDER,
    &EPSILON_LADDER,
    &RESOLUTION,
    &VACUOUS,
    &USED,
    &CALIBRATION,
    &RECALIBRATION,
    &JUDGED,
    &RESPONSES_TOO_CLOSE,
    &RESPONSES_DECLINED,
    &RESPONSES_USED,
    &RESPONSES_WHOLE,
];
