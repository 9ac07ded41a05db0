//! The answer to a case, and all the ways in which it can be wrong.

use std::{
    io::Write,
    process::{Command, Stdio, abort, exit},
    thread::sleep,
    time::Duration,
};

use serde_json::Value;

use crate::{
    Fake, flood, hang, print,
    reply::{columns, history, list, right},
    start::become_shell,
};

/// The case over which some break: it has this restitution.
const BAD: f64 = 0.25;

/// Answers one case.
pub fn answer(fake: &Fake, case: &Value) {
    print(&line(fake, case));
}

/// Answers many cases.
pub fn answer_all(fake: &Fake, cases: &[Value]) {
    let mut lines: Vec<Vec<u8>> = cases
        .iter()
        .map(|case| match fake.how.as_str() {
            "batch-only" => {
                let mut moved = columns(case);
                moved.velocity[1] *= 1.0 + f64::EPSILON;
                history(case, &moved, "limit-reached", "").into_bytes()
            }
            _ => line(fake, case),
        })
        .collect();
    match fake.how.as_str() {
        "batch-any-order" => lines.reverse(),
        "batch-twice" => lines.insert(1, lines[0].clone()),
        "batch-one-missing" => drop(lines.pop()),
        "batch-last-twice" => lines.push(lines.last().unwrap().clone()),
        _ => {}
    }
    print(&lines.concat());
}

/// The line that answers a case.
fn line(fake: &Fake, case: &Value) -> Vec<u8> {
    let seq = &case["seq"];
    let is_bad = case["eta"].as_f64() == Some(BAD);
    let mut moved = columns(case);
    let text = match fake.how.as_str() {
        "silent" => hang(),
        "garbage" => "step 1 of 100\n".to_owned(),
        "empty-line" => "\n".to_owned(),
        "half-line" => {
            print(&right(case).as_bytes()[..40]);
            hang();
        }
        "half-line-then-end" => {
            print(&right(case).as_bytes()[..40]);
            exit(0);
        }
        "cut-line" => format!("{}\n", &right(case)[..40]),
        "long-line" => format!("{}\n", "7".repeat(1 << 20)),
        "gigabyte-line" => {
            for _ in 0..16_384 {
                print(&[b'7'; 1 << 16]);
            }
            "\n".to_owned()
        }
        "ten-million-impacts" => format!("{{\"seq\":{seq},\"history\":{{\"time\":[{}0]}}}}\n", "1,".repeat(10_000_000)),
        "flood" => flood(),
        "broken-utf8" => {
            return [format!("{{\"seq\":{seq},\"decline\":{{\"reason\":\"zu gro").as_bytes(), b"\xdf\"}}\n"].concat();
        }
        "wrong-seq" => "{\"seq\":12345,\"decline\":{\"reason\":\"lost count\"}}\n".to_owned(),
        "no-seq" => right(case).replace(&format!("\"seq\":{seq},"), ""),
        "two-answers" => right(case).repeat(2),
        "answers-again-and-again" => right(case).repeat(1_000),
        "two-in-one" => right(case).replace("\"ns\"", "\"decline\":{\"reason\":\"unsure\"},\"ns\""),
        "none-in-one" => format!("{{\"seq\":{seq}}}\n"),
        "two-objects" => right(case).trim().repeat(2) + "\n",
        "unknown-field" => right(case).replace("\"velocity\"", "\"speed\""),
        "own-field" => right(case).replace("\"ns\"", "\"x-steps\":12,\"ns\""),
        "field-twice" => right(case).replace("\"ns\"", "\"ns\":1,\"ns\""),
        "no-velocity" => format!("{{\"seq\":{seq},\"history\":{{\"time\":[],\"ending\":\"never-rocks\"}}}}\n"),
        "wrong-kind" => right(case).replace("\"limit-reached\"", "17"),
        "text-for-number" => right(case).replace("\"ns\":1500", "\"ns\":\"fast\""),
        "bare-nan" => right(case).replace("\"ns\":1500", "\"ns\":NaN"),
        "too-large" => right(case).replace("\"ns\":1500", "\"ns\":1e999"),
        "quoted-nan" => right(case).replacen("\"time\":[", "\"time\":[\"nan\",", 1).replacen(
            &format!(",{:?}]", moved.time.last().unwrap()),
            "]",
            1,
        ),
        "unequal-columns" => {
            moved.velocity.pop();
            history(case, &moved, "limit-reached", "")
        }
        "too-many-impacts" => {
            let mut more = case.clone();
            more["impacts"] = (case["impacts"].as_u64().unwrap() + 1).into();
            right(&more)
        }
        "unknown-ending" => history(case, &moved, "sleeping", ""),
        "claim-not-announced" => history(case, &moved, "limit-reached", ",\"claim\":{\"time\":1e-9}"),
        "claims" => {
            let claim = format!(
                ",\"tau_ch\":2.5,\"claim\":{{\"time\":{},\"interval\":1e-12,\"tau_ch\":1e-8}}",
                list(&moved.interval)
            );
            history(case, &moved, "at-rest", &claim)
        }
        "claims-negative" => history(case, &moved, "limit-reached", ",\"claim\":{\"time\":-1e-9}"),
        "claims-nan" => history(case, &moved, "limit-reached", ",\"claim\":{\"time\":\"nan\"}"),
        "claims-short" => history(case, &moved, "limit-reached", ",\"claim\":{\"time\":[1e-9]}"),
        "no-interval" => {
            let text = right(case);
            let (front, back) = text.split_once("\"interval\":").unwrap();
            front.to_owned() + back.split_once("],").unwrap().1
        }
        "hexadecimal" => right(case).replacen(&format!("{:?}", moved.time[0]), "\"0x1.0p-1\"", 1),
        "falling-times" => {
            moved.time.swap(0, 1);
            history(case, &moved, "limit-reached", "")
        }
        "negative-interval" => {
            moved.interval[1] *= -1.0;
            history(case, &moved, "limit-reached", "")
        }
        // As those print who have doubles only, and null for what is not there.
        "whole-numbers" => right(case).replace(&format!("\"seq\":{seq}"), &format!("\"seq\":{seq}.0")),
        "nulls" => right(case).replace("\"ns\":1500", "\"decline\":null,\"error\":null,\"ns\":null"),
        "carriage-returns" => right(case).replace('\n', "\r\n"),
        "declines" => {
            format!(
                "{{\"seq\":{seq},\"decline\":{{\"reason\":\"eta too large\",\"why\":\"eta = {}\"}}}}\n",
                case["eta"]
            )
        }
        "errors" => format!("{{\"seq\":{seq},\"error\":{{\"message\":\"no root in step 17\"}}}}\n"),
        "errors-without-seq" => "{\"error\":{\"message\":\"no root in step 17\"}}\n".to_owned(),
        "ends" => exit(0),
        "exits" => {
            eprintln!("assertion failed: phi > 0");
            exit(3);
        }
        "aborts" => abort(),
        "crashes-on-bad" | "batch-crashes-on-bad" if is_bad => exit(3),
        "hangs-on-bad" if is_bad => hang(),
        "crashes-once" | "another-after-restart" if fake.for_the_first_time() => exit(3),
        "closes-output" => become_shell("exec >&-; sleep 60"),
        "leaves-a-child" => {
            // It holds the pipes, and outlives its parent.
            let child = Command::new("sleep").arg("60").stdin(Stdio::null()).spawn().unwrap();
            eprintln!("child {}", child.id());
            exit(3);
        }
        "floods-stderr" => {
            for _ in 0..160 {
                std::io::stderr().write_all(&[b'w'; 1 << 16]).unwrap();
            }
            eprintln!("the end");
            right(case)
        }
        "slow" => {
            sleep(Duration::from_millis(5));
            right(case)
        }
        _ => right(case),
    };
    text.into_bytes()
}
