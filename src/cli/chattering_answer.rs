//! What `chattering-time` answers.

use serde::Serialize;

use super::motion_facts::Facts;

#[derive(Serialize)]
pub(super) struct Answer {
    #[serde(flatten)]
    pub asked: Facts,
    /// Whether the amplitude exceeds the threshold at all.
    pub rocks: bool,
    /// `null` if it does not rock, or the list of impacts is too short to tell, or nothing is known of `tau_ch`.
    pub complete: Option<bool>,
    pub tau_ch: Option<f64>,
    /// `null` beside a `tau_ch` too where nothing is known of it.
    pub uncertainty: Option<f64>,
    /// Proven bounds, as decimals rounded outward; only of the enclosure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lower: Option<String>,
    /// See `lower`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub upper: Option<String>,
    /// `tau_ch` in seconds after rocking began; only of a scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
    /// `tau_ch/(T/2)`.
    pub half_period_fraction: Option<f64>,
    pub impacts: usize,
    pub oracle: String,
    pub method: Option<&'static str>,
    pub ending: String,
}

impl Answer {
    /// Whether there is a chattering time of which its own oracle does not know how far it is off.
    pub fn is_unsure(&self) -> bool {
        self.tau_ch.is_some() && !self.uncertainty.is_some_and(f64::is_finite)
    }
}

/// The answer in a line or two.
pub(super) fn text(answer: &Answer) -> String {
    if !answer.rocks {
        return "does not rock: the ground acceleration does not exceed the threshold while it lasts (rocks: false, tau_ch: null)".to_owned();
    }
    if let (Some(lower), Some(upper)) = (&answer.lower, &answer.upper) {
        return format!("proven: complete, {lower}\n      <= tau_ch <= {upper}, by {}", answer.oracle);
    }
    if let (Some(time), true) = (answer.tau_ch, answer.is_unsure()) {
        return format!(
            "tau_ch is not known: {} comes to {time:?}, and by its own account may be off by any amount",
            answer.oracle
        );
    }
    // Only a sinusoid has a half period.
    let fraction = answer.half_period_fraction.map_or(String::new(), |fraction| format!(" = {fraction:?} T/2"));
    match (answer.tau_ch, answer.uncertainty) {
        (Some(time), Some(uncertainty)) => format!(
            "tau_ch = {time:?} ± {uncertainty:.1e}{fraction}{}, complete, by {} from {} impacts, {}",
            answer.seconds.map_or(String::new(), |seconds| format!(" = {seconds:?} s")),
            answer.oracle,
            answer.impacts,
            answer.method.unwrap_or_default()
        ),
        _ => format!("no chattering time: {} after {} impacts, by {}", answer.ending, answer.impacts, answer.oracle),
    }
}
