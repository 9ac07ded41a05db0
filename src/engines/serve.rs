//! The other side of the talk: an oracle as an engine that speaks the protocol on its standard input and output.

use std::io::{self, BufRead, Write};

use contract::{Case, History, Impact, Model, Oracle};
use process::ending_name;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::cases::case_file::CaseFields;

/// A question, as far as it is looked at.
#[derive(Deserialize)]
struct Question {
    cmd: String,
    #[serde(default)]
    echo: Vec<f64>,
    #[serde(default)]
    cases: Vec<Asked>,
}

/// A case of a question.
#[derive(Deserialize)]
struct Asked {
    seq: u64,
    model: String,
    epsilon: f64,
    omega: f64,
    eta: f64,
    alpha: Option<f64>,
    normalisation: String,
    impacts: usize,
    until: Value,
}

/// Answers every question from `input`, until it ends or says so. `name` is what the engine calls itself.
///
/// # Errors
/// When the input can't be read, is no question, or the answers can't be written.
pub fn serve(name: &str, oracle: &dyn Oracle, input: impl BufRead, mut output: impl Write) -> io::Result<()> {
    for line in input.lines() {
        let line = line?;
        let question: Question = serde_json::from_str(&line)?;
        match question.cmd.as_str() {
            "start" => write(&mut output, &hello(name, oracle, &question.echo))?,
            "case" => write(&mut output, &answer(oracle, &serde_json::from_str(&line)?))?,
            "cases" => question.cases.iter().try_for_each(|case| write(&mut output, &answer(oracle, case)))?,
            _ => return Ok(()),
        }
        output.flush()?;
    }
    Ok(())
}

fn write(output: &mut impl Write, message: &Value) -> io::Result<()> {
    serde_json::to_writer(&mut *output, message)?;
    output.write_all(b"\n")
}

fn word(model: Model) -> &'static str {
    match model {
        Model::Linear => "linear",
        Model::Nonlinear => "nonlinear",
    }
}

fn hello(name: &str, oracle: &dyn Oracle, echo: &[f64]) -> Value {
    json!({
        "version": 1,
        "engine": { "name": name, "version": env!("CARGO_PKG_VERSION"), "language": "Rust" },
        "models": [word(oracle.model())],
        "normalisations": ["threshold", "slender"],
        "ground": ["sine"],
        "claims": true,
        "max_batch": 64,
        "echo": echo,
    })
}

fn answer(oracle: &dyn Oracle, asked: &Asked) -> Value {
    let seq = asked.seq;
    if asked.model != word(oracle.model()) {
        return json!({ "seq": seq, "decline": { "reason": "another model" } });
    }
    let history = match asked.case() {
        Ok(case) => oracle.history(&case),
        Err(why) => return json!({ "seq": seq, "decline": { "reason": "no such case", "why": why } }),
    };
    match history {
        Ok(history) => json!({ "seq": seq, "history": columns(&history) }),
        Err(decline) => json!({ "seq": seq, "decline": { "reason": decline.reason(), "why": decline.to_string() } }),
    }
}

impl Asked {
    /// The case that is meant.
    fn case(&self) -> Result<Case, String> {
        let fields = CaseFields {
            epsilon: Some(self.epsilon),
            omega: self.omega,
            eta: self.eta,
            alpha: self.alpha,
            normalisation: self.alpha.map(|_| self.normalisation.clone()),
            impacts: Some(self.impacts),
            until: self.until.as_f64(),
            ..CaseFields::default()
        };
        fields.case().map_err(|invalid| invalid.to_string())
    }
}

/// A history in the words of the protocol.
#[derive(Serialize)]
struct Columns {
    time: Vec<Value>,
    interval: Vec<Value>,
    velocity: Vec<Value>,
    ending: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    tau_ch: Option<Value>,
    claim: Claim,
}

/// Its claims.
#[derive(Serialize)]
struct Claim {
    time: Vec<Value>,
    interval: Vec<Value>,
    velocity: Vec<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tau_ch: Option<Value>,
}

fn columns(history: &History) -> Columns {
    let column = |of: fn(&Impact) -> f64| history.impacts.iter().map(|impact| number(of(impact))).collect();
    Columns {
        time: column(|impact| impact.time),
        interval: column(|impact| impact.interval),
        velocity: column(|impact| impact.velocity),
        ending: ending_name(history.ending),
        tau_ch: history.chattering_time.map(|time| number(time.value)),
        claim: Claim {
            time: column(|impact| impact.uncertainty.time),
            interval: column(|impact| impact.uncertainty.interval),
            velocity: column(|impact| impact.uncertainty.velocity),
            tau_ch: history.chattering_time.map(|time| number(time.uncertainty)),
        },
    }
}

/// JSON has no word for what is not finite: the protocol's stands in quotes.
fn number(value: f64) -> Value {
    match value {
        _ if value.is_finite() => json!(value),
        _ if value.is_nan() => json!("nan"),
        _ if value > 0.0 => json!("inf"),
        _ => json!("-inf"),
    }
}

#[cfg(test)]
mod tests {
    use contract::{Decline, Ending, Estimate, Uncertainty};

    use super::*;

    struct Odd;

    impl Oracle for Odd {
        fn name(&self) -> &str {
            "odd"
        }

        fn model(&self) -> Model {
            Model::Linear
        }

        fn history(&self, case: &Case) -> Result<History, Decline> {
            if case.eta() > 0.9 {
                return Err(Decline::NotConvergent { why: "eta = 0.95".to_owned() });
            }
            let uncertainty = Uncertainty { time: 0.0, interval: 1e-15, velocity: f64::INFINITY };
            let impact = Impact { time: case.epsilon(), interval: f64::NAN, velocity: -0.0, uncertainty };
            let chattering_time = Some(Estimate { value: 0.5, uncertainty: 0.0 });
            Ok(History { impacts: vec![impact], ending: Ending::AtRest, chattering_time })
        }
    }

    /// What was sent comes back bit for bit, numbers that are none have their words, and what can't be answered is declined.
    #[test]
    fn an_oracle_answers_in_the_words_of_the_protocol() {
        let case = |seq: usize, model: &str, eta: f64| {
            format!(
                r#"{{"cmd":"case","seq":{seq},"model":"{model}","epsilon":5e-324,"omega":2.0,"eta":{eta:?},"alpha":null,"normalisation":"threshold","impacts":3,"until":"half-period"}}"#
            )
        };
        let start = r#"{"cmd":"start","versions":[1],"echo":[0.1,5e-324,1.7976931348623157e308,-0.0]}"#;
        let asked =
            [case(1, "linear", 0.5), case(2, "nonlinear", 0.5), case(3, "linear", 0.95), case(4, "linear", 1.5)];
        let input = format!("{start}\n{}\n{{\"cmd\":\"stop\"}}\nnever read\n", asked.join("\n"));
        let mut output = Vec::new();
        serve("mine", &Odd, input.as_bytes(), &mut output).unwrap();
        let output = String::from_utf8(output).unwrap();
        let lines: Vec<&str> = output.lines().collect();
        assert_eq!(lines.len(), 5, "{output}");
        assert!(lines[0].contains(r#""echo":[0.1,5e-324,1.7976931348623157e+308,-0.0]"#), "{}", lines[0]);
        for part in [r#""time":[5e-324]"#, r#""interval":["nan"]"#, r#""velocity":[-0.0]"#, r#""velocity":["inf"]"#] {
            assert!(lines[1].contains(part), "{part} is not in {}", lines[1]);
        }
        for (line, words) in [(2, "another model"), (3, "eta = 0.95"), (4, "no such case")] {
            assert!(lines[line].contains("decline") && lines[line].contains(words), "{}", lines[line]);
        }
        assert!(serve("mine", &Odd, "Hello\n".as_bytes(), Vec::new()).is_err());
    }
}
