//! A rocking block that chatters, as an engine for chattercheck: reads questions, one JSON object a line, and prints answers.
//!
//! Between impacts phi'' = phi - side - f(tau), with side the sign of phi and f = cos(omega tau) + r sin(omega tau) the acceleration of the ground
//! over that which starts the rocking, r = sqrt(a^2 - 1). At an impact, phi = 0, the velocity is multiplied by eta. Replace what is yours.

use std::io::{self, BufRead, Write};

/// cosh or sinh (sign = 1), cos or sin (sign = -1) from the power x^n on, divided by x^n: 1/n! + sign x^2/(n+2)! + ...
fn series(n: u32, x: f64, sign: f64) -> f64 {
    let mut term = 1.0 / f64::from((1..=n).product::<u32>());
    let (mut total, mut k) = (term, f64::from(n));
    while term.abs() > 1e-17 * total.abs() {
        k += 2.0;
        term *= sign * x * x / (k * (k - 1.0));
        total += term;
    }
    total
}

/// side + f; 1 - cos is written as 2 sin^2, so that nothing is lost next to the start.
fn pull(side: f64, r: f64, phase: f64) -> f64 {
    let (sin, cos) = (phase / 2.0).sin_cos();
    r * phase.sin() + if side > 0.0 { 2.0 * cos * cos } else { -2.0 * sin * sin }
}

struct Flight {
    side: f64,
    v: f64,
    omega: f64,
    r: f64,
    phase: f64,
}

impl Flight {
    /// phi/s and phi' a time s after the impact. No term is the small difference of large ones, so that short flights are as right as long ones.
    fn at(&self, s: f64) -> (f64, f64) {
        let Self { side, v, omega, r, phase } = *self;
        let (w2, g, (sin, cos)) = (omega * omega, pull(side, r, phase), phase.sin_cos());
        let h: [f64; 5] = std::array::from_fn(|n| series(n as u32, s, 1.0));
        let b: [f64; 5] = std::array::from_fn(|n| h[n] + w2 * series(n as u32, omega * s, -1.0));
        let f = (cos + r * sin) * s.powi(3) * w2 / (1.0 + w2);
        let slope = (r * cos - sin) * s * s * omega / (1.0 + w2);
        let phi = v * h[1] - g * s * h[2] + f * b[4] - slope * b[3];
        (phi, v * h[0] - g * s * h[1] + f * b[3] - slope * b[2])
    }

    /// The first root of phi up to the time `end`, and phi' there: a scan for the change of sign, then Newton's method kept inside of the bracket.
    fn landing(&self, end: f64) -> Option<(f64, f64)> {
        let g = pull(self.side, self.r, self.phase);
        let step = if self.v * g > 0.0 { (self.v / g / 2.0).min(end / 64.0) } else { end / 64.0 };
        let (mut low, mut high) = (0.0, step);
        while self.side * self.at(high).0 > 0.0 {
            if high >= end {
                return None;
            }
            (low, high) = (high, (high + step.max(high / 16.0)).min(end));
        }
        let (mut s, mut speed) = (high, 0.0);
        for _ in 0..200 {
            let phi;
            (phi, speed) = self.at(s);
            if self.side * phi > 0.0 { low = s } else { high = s }
            let mut new = s - phi * s / speed;
            if !(low < new && new < high) {
                new = (low + high) / 2.0;
            }
            if (new - s).abs() <= 2e-16 * s {
                break;
            }
            s = new;
        }
        Some((s, speed))
    }
}

/// The history of a case as JSON; `until` is none for half a period of the ground.
fn chatter(epsilon: f64, omega: f64, eta: f64, impacts: usize, until: Option<f64>) -> String {
    let (r, end) = ((epsilon * (2.0 + epsilon)).sqrt(), until.unwrap_or(std::f64::consts::PI / omega));
    let mut flight = Flight { side: -1.0, v: 0.0, omega, r, phase: 0.0 };
    let (mut time, mut interval, mut velocity, mut now) = (Vec::new(), Vec::new(), Vec::new(), 0.0);
    let mut ending = "never-rocks";
    while epsilon > 0.0 {
        let Some((s, speed)) = flight.landing(end - now).filter(|(s, _)| now + s < end) else {
            ending = if until.is_some() { "limit-reached" } else { "incomplete" };
            break;
        };
        now += s;
        flight = Flight { side: -flight.side, v: eta * speed, phase: omega * now, ..flight };
        let before = interval.last().copied().unwrap_or(0.0);
        time.push(now);
        interval.push(s);
        velocity.push(flight.v);
        if flight.v.abs() < 1e-250 || time.len() == impacts {
            // The intervals that are left are a geometric series; if the pull hardly changes while they last, the block comes to rest.
            let left = (before + s) * eta * eta / (1.0 - eta * eta);
            let change = omega * left * (r * (omega * now).cos() - (omega * now).sin()).abs();
            let weakest = pull(1.0, r, omega * now).min(-pull(-1.0, r, omega * now));
            ending = if change < 0.1 * weakest { "at-rest" } else { "limit-reached" };
            break;
        }
    }
    // `{:?}` prints the shortest decimal that is read back as the same double.
    format!("{{\"time\":{time:?},\"interval\":{interval:?},\"velocity\":{velocity:?},\"ending\":\"{ending}\"}}")
}

/// The text behind "name": in a question, up to what ends it. Questions have no spaces, and every name once.
fn field<'a>(question: &'a str, name: &str) -> &'a str {
    let rest = question.split_once(&format!("\"{name}\":")).map_or("", |(_, rest)| rest);
    match rest.strip_prefix('[') {
        Some(list) => list.split(']').next().unwrap_or(""),
        None => rest.split([',', '}']).next().unwrap_or(""),
    }
}

fn answer(question: &str) -> String {
    let number = |name| field(question, name).parse::<f64>().ok();
    if field(question, "cmd") == "\"start\"" {
        // The numbers are read and printed again, which shows that no digit is lost.
        let echo: Vec<f64> = field(question, "echo").split(',').filter_map(|text| text.parse().ok()).collect();
        return format!(
            r#"{{"version":1,"engine":{{"name":"my Rust engine","version":"1","language":"Rust"}},"models":["linear"],"normalisations":["threshold"],"ground":["sine"],"echo":{echo:?}}}"#
        );
    }
    let (seq, until) = (field(question, "seq"), number("until"));
    match (number("epsilon"), number("omega"), number("eta"), number("impacts")) {
        (Some(epsilon), Some(omega), Some(eta), Some(impacts))
            if field(question, "model") == "\"linear\"" && until.unwrap_or(0.0) * omega <= 10.0 =>
        {
            format!(r#"{{"seq":{seq},"history":{}}}"#, chatter(epsilon, omega, eta, impacts as usize, until))
        }
        _ => format!(r#"{{"seq":{seq},"decline":{{"reason":"not the linear block in little more than half a period"}}}}"#),
    }
}

fn main() -> io::Result<()> {
    for line in io::stdin().lock().lines() {
        let question = line?;
        if field(&question, "cmd") == "\"stop\"" {
            break;
        }
        println!("{}", answer(&question));
        // Flushed, or the gate waits for ever for an answer that stays in a buffer.
        io::stdout().flush()?;
    }
    Ok(())
}
