//! The answer to the start, and all the ways in which it can be wrong.

use std::{os::unix::process::CommandExt, process::Command};

use serde_json::{Value, json};

use crate::{Fake, flood, hang, print};

/// Answers the start.
pub fn answer(fake: &Fake, start: &Value) {
    let mut hello = json!({
        "version": 1,
        "engine": {"name": "fake", "version": "1.0", "language": "Rust"},
        "models": ["linear", "nonlinear"],
        "normalisations": ["threshold"],
        "ground": ["sine"],
        "claims": fake.how.starts_with("claims"),
        "max_batch": if fake.how.starts_with("batch") { 64 } else { 1 },
        "echo": start["echo"],
    });
    match fake.how.as_str() {
        "start-silent" => hang(),
        "start-ends" => std::process::exit(0),
        "start-crashes" => {
            eprintln!("cannot find libfake.so");
            std::process::exit(3);
        }
        "start-garbage" => print(b"Loading model...\n"),
        "start-half-line" => {
            print(b"{\"version\":1");
            hang();
        }
        "start-flood" => flood(),
        "start-version-2" => hello["version"] = json!(2),
        "start-no-version" => drop(hello.as_object_mut().unwrap().remove("version")),
        "start-error" => hello = json!({"error": {"message": "no licence"}}),
        "start-no-echo" => drop(hello.as_object_mut().unwrap().remove("echo")),
        "start-short-echo" => hello["echo"] = json!([0.1]),
        "start-no-signed-zero" => hello["echo"][3] = json!(0),
        "start-hexadecimal-echo" => {
            hello["echo"] =
                json!(["0x1.999999999999ap-4", "0x0.0000000000001p-1022", "0x1.fffffffffffffp+1023", "-0x0p+0"]);
        }
        "start-no-models" => drop(hello.as_object_mut().unwrap().remove("models")),
        "start-other-model" => hello["models"] = json!(["pendulum"]),
        "start-other-normalisation" => hello["normalisations"] = json!(["g"]),
        "start-other-ground" => hello["ground"] = json!(["white-noise"]),
        "start-unknown-field" => hello["max-batch"] = json!(64),
        "start-own-field" => hello["x-mine"] = json!({"anything": [1]}),
        "start-batch-0" => hello["max_batch"] = json!(0),
        "start-six-digits" => {
            let digits = [0.1, 5e-324, f64::MAX, -0.0].map(six_digits).join(",");
            let text = hello.to_string();
            let (front, back) = text.split_once("\"echo\":[").unwrap();
            let (_, back) = back.split_once(']').unwrap();
            print(format!("{front}\"echo\":[{digits}]{back}\n").as_bytes());
            return;
        }
        "another-after-restart" if !fake.for_the_first_time() => hello["engine"]["version"] = json!("2.0"),
        _ => {}
    }
    print(format!("{hello}\n").as_bytes());
    if fake.is("closes-input") {
        become_shell("exec <&-; sleep 60");
    }
}

/// As `%.6g` prints it.
fn six_digits(value: f64) -> String {
    if value == 0.1 { "0.1".to_owned() } else { format!("{value:.5e}") }
}

/// Goes on as a shell that runs this.
pub fn become_shell(script: &str) -> ! {
    let error = Command::new("sh").args(["-c", script]).exec();
    panic!("{error}");
}
