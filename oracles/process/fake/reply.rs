//! The right answer to a case: right by the protocol, that is.

use serde_json::Value;

/// The columns of a history.
#[derive(Clone)]
pub struct Columns {
    /// The times.
    pub time: Vec<f64>,
    /// The intervals.
    pub interval: Vec<f64>,
    /// The velocities.
    pub velocity: Vec<f64>,
}

/// A geometric series of as many impacts as asked for.
pub fn columns(case: &Value) -> Columns {
    let number = |name: &str| case[name].as_f64().unwrap();
    let impacts = usize::try_from(case["impacts"].as_u64().unwrap()).unwrap();
    let ratio = number("eta") * number("eta");
    let mut columns = Columns { time: Vec::new(), interval: Vec::new(), velocity: Vec::new() };
    let (mut time, mut interval, mut sign) = (0.0, 0.5 + number("epsilon") / number("omega"), 1.0);
    for _ in 0..impacts {
        time += interval;
        columns.time.push(time);
        columns.interval.push(interval);
        columns.velocity.push(sign * interval / 3.0);
        interval *= ratio;
        sign = -sign;
    }
    columns
}

/// A list as JSON.
pub fn list(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
    format!("[{}]", values.join(","))
}

/// The line of a history, with more fields of the history behind.
pub fn history(case: &Value, columns: &Columns, ending: &str, more: &str) -> String {
    let [time, interval, velocity] = [&columns.time, &columns.interval, &columns.velocity].map(|column| list(column));
    format!(
        "{{\"seq\":{},\"history\":{{\"time\":{time},\"interval\":{interval},\"velocity\":{velocity},\"ending\":\"{ending}\"{more}}},\"ns\":1500}}\n",
        case["seq"]
    )
}

/// The right answer.
pub fn right(case: &Value) -> String {
    history(case, &columns(case), "limit-reached", "")
}
