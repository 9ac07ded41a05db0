//! The reports against the run, by something that did not write them: what they count is counted again from the answers themselves.

use std::collections::{BTreeMap, BTreeSet};

use chattercheck::{
    cases::generate::Named,
    faults::{
        plant::{Plant, Planted},
        remember::Remembering,
    },
    gate::{
        compare::Agreement,
        examine::{Pairing, examine_and_judge},
        judge::Judges,
        ladder,
        report::{self, Report},
        run::{self, Selection},
    },
    panel,
};
use contract::{Case, Decline, Ending, History, Impact, Model, Oracle};
use quick_xml::events::Event;
use serde_json::Value;

/// What was counted again.
#[derive(Debug, Default)]
struct Recount {
    impacts: usize,
    endings: BTreeMap<&'static str, usize>,
    declines: BTreeMap<(String, String), usize>,
    /// Compared, impacts, disagreements, too close, absent.
    pairs: BTreeMap<[String; 2], [usize; 5]>,
    failed: BTreeSet<String>,
    judged: usize,
}

fn recount(panel: &[&dyn Oracle], judges: &Judges, cases: &[Named]) -> Recount {
    let mut recount = Recount::default();
    for (place, named) in cases.iter().enumerate() {
        let mut answered = 0;
        for oracle in panel {
            match oracle.history(&named.case) {
                Ok(history) => {
                    answered += 1;
                    recount.impacts += history.impacts.len();
                    *recount.endings.entry(ending(history.ending)).or_default() += 1;
                }
                Err(decline) => {
                    let key = (oracle.name().to_owned(), decline.reason().to_owned());
                    *recount.declines.entry(key).or_default() += 1;
                }
            }
        }
        let asked = place % judges.every == 0 || named.to_string().starts_with("list/");
        let examination = examine_and_judge(panel, judges, &named.case, asked && !judges.oracles.is_empty());
        recount.judged += usize::from(answered > 0 && examination.judgements.len() == answered);
        let mut wrong = examination.checked.iter().any(|checked| checked.breach.is_some())
            || examination.judgements.iter().any(|judgement| judgement.refuted.is_some());
        for (one, two, pairing) in &examination.pairs {
            let names = [*one, *two].map(|place| panel[place].name().to_owned());
            let counts = recount.pairs.entry(names).or_default();
            match pairing {
                Pairing::Absent => counts[4] += 1,
                Pairing::Incomparable(_) => {}
                Pairing::Compared(comparison) => {
                    counts[0] += 1;
                    counts[1] += comparison.impacts;
                    counts[2] += usize::from(matches!(comparison.agreement, Agreement::Disagree(_)));
                    counts[3] += usize::from(comparison.agreement == Agreement::TooClose);
                    wrong |= matches!(comparison.agreement, Agreement::Disagree(_));
                }
            }
        }
        if wrong {
            recount.failed.insert(named.to_string());
        }
    }
    recount
}

fn ending(ending: Ending) -> &'static str {
    match ending {
        Ending::NeverRocks => "never-rocks",
        Ending::AtRest => "at-rest",
        Ending::Incomplete => "incomplete",
        Ending::Overturned => "overturned",
        Ending::LimitReached(_) => "limit-reached",
        Ending::Lost(_) => "lost",
    }
}

/// A test case of a JUnit file: its name, and the message of its failure.
pub fn junit_cases(xml: &str) -> Vec<(String, Option<String>)> {
    let mut reader = quick_xml::Reader::from_str(xml);
    let mut cases: Vec<(String, Option<String>)> = Vec::new();
    let attribute = |tag: &quick_xml::events::BytesStart, name: &str| {
        let found = tag.attributes().flatten().find(|attribute| attribute.key.as_ref() == name.as_bytes());
        found.map(|attribute| attribute.normalized_value(quick_xml::XmlVersion::Implicit1_0).unwrap().into_owned())
    };
    loop {
        match reader.read_event().unwrap() {
            Event::Start(tag) | Event::Empty(tag) => match tag.name().as_ref() {
                b"testcase" => cases.push((attribute(&tag, "name").unwrap(), None)),
                b"failure" | b"error" => cases.last_mut().unwrap().1 = Some(attribute(&tag, "message").unwrap()),
                _ => {}
            },
            Event::Eof => return cases,
            _ => {}
        }
    }
}

/// Runs the cases, and holds every report on the run against what is counted again.
fn audit(panel: &[&dyn Oracle], judges: &Judges, cases: &[Named], green: bool) -> Report {
    let ladders = ladder::descend(panel, panel::SERIES).unwrap();
    let run = run::run(panel, judges, cases, 3, Some(ladders), &());
    let report = Report::new(&run, &panel::roles());
    let again = recount(panel, judges, cases);
    let json = serde_json::to_value(&report).unwrap();
    let number = |value: &Value| value.as_u64().unwrap() as usize;

    assert_eq!((number(&json["reach"]["cases"]), &json["seed"]), (cases.len(), &Value::from(3)));
    let names = json["oracles"].as_array().unwrap().iter().map(|name| name.as_str().unwrap().to_owned());
    assert_eq!(names.collect::<Vec<_>>(), panel.iter().map(|oracle| oracle.name()).collect::<Vec<_>>());
    for which in ["handed", "examined"] {
        assert_eq!(number(&json["accounted"][which]["cases"]), cases.len(), "{which}");
    }
    assert_eq!(json["accounted"]["handed"], json["accounted"]["examined"]);
    assert_eq!(number(&json["reach"]["impacts"]), again.impacts, "impacts");
    let endings = json["reach"]["endings"].as_object().unwrap();
    let endings: BTreeMap<&str, usize> =
        endings.iter().map(|(ending, count)| (ending.as_str(), number(count))).collect();
    assert_eq!(endings, again.endings);
    let mut declines = BTreeMap::new();
    for (oracle, reasons) in json["declines"].as_object().unwrap() {
        for (reason, count) in reasons.as_object().unwrap() {
            declines.insert((oracle.clone(), reason.clone()), number(count));
        }
    }
    assert_eq!(declines, again.declines);
    let mut pairs = BTreeMap::new();
    for pair in json["pairs"].as_array().unwrap() {
        let names = [0, 1].map(|place| pair["oracles"][place].as_str().unwrap().to_owned());
        let counts = ["compared", "impacts", "disagreements", "too_close", "absent"].map(|key| number(&pair[key]));
        pairs.insert(names, counts);
    }
    assert_eq!(pairs, again.pairs, "compared, impacts, disagreements, too close, absent");
    assert_eq!(number(&json["judged"]["cases"]), again.judged);
    let failed =
        json["failures"].as_array().unwrap().iter().map(|failure| failure["name"].as_str().unwrap().to_owned());
    assert_eq!(failed.collect::<BTreeSet<_>>(), again.failed);
    let short = json["shortfalls"].as_array().unwrap().len();
    assert_eq!(again.failed.is_empty() && short == 0, green, "{again:?} {:?}", report.shortfalls);
    assert_eq!(json["verdict"], if green { "pass" } else { "fail" });

    let junit = junit_cases(&report::junit(&report, cases, &run.outcomes).unwrap());
    let (whole, each) = junit.split_last().unwrap();
    assert_eq!(each.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>(), names_of(cases));
    let red: BTreeSet<String> =
        each.iter().filter(|(_, failure)| failure.is_some()).map(|(name, _)| name.clone()).collect();
    assert_eq!(red, again.failed, "JUnit");
    assert_eq!((whole.0.as_str(), whole.1.is_some()), ("shortfalls", short > 0));

    let text = report::text(&report);
    let first = text.lines().next().unwrap();
    let told = if green {
        format!("PASS: {} oracles agree on {} cases", panel.len(), cases.len())
    } else {
        format!("FAIL: {} of {} cases failed", again.failed.len(), cases.len())
    };
    assert!(first.starts_with(&told), "{first}");
    assert_eq!(text.matches("PASS").count() + text.matches("FAIL:").count(), 1, "one verdict: {text}");
    assert_eq!(text.matches("SHORTFALL: ").count(), short);
    assert!(text.contains(&format!("impacts      {}", again.impacts)), "{text}");
    assert!(!text.contains("JSON"), "no JSON report was written");
    // Every row of the wide table has the counts of its pair.
    for line in report::full(&report).lines() {
        let Some([compared, impacts, red, close, _]) = pairs
            .iter()
            .find_map(|([one, two], counts)| line.starts_with(&format!("{one} : {two} ")).then_some(counts))
        else {
            continue;
        };
        let words: Vec<&str> = line.split_whitespace().skip(3).collect();
        let shown = [0, 1, 4, 3].map(|column| words[column].parse::<usize>().unwrap());
        assert_eq!(shown, [*compared, *impacts, *red, *close], "{line}");
    }
    report
}

fn names_of(cases: &[Named]) -> Vec<String> {
    cases.iter().map(ToString::to_string).collect()
}

/// Every kind of case, some of them so near to `a_cr` that a coarse method can't tell how they end.
fn cases() -> Vec<Named> {
    let all = run::cases(&Selection { cases: 60, seed: 3 }, panel::stepper().as_ref());
    all.into_iter().step_by(5).collect()
}

fn oracles(list: &str) -> Vec<Remembering> {
    panel::select(list).unwrap().into_iter().map(Remembering::new).collect()
}

fn borrowed(oracles: &[Remembering]) -> Vec<&dyn Oracle> {
    oracles.iter().map(|oracle| oracle as &dyn Oracle).collect()
}

#[test]
fn of_a_green_run() {
    let oracles = oracles("closed-form,ode/linear/tr-bdf2,taylor,asymptotic/paper");
    let judges: Vec<Remembering> = panel::judges().into_iter().map(Remembering::new).collect();
    let judges = Judges { oracles: borrowed(&judges), every: 4, closing: None };
    let report = audit(&borrowed(&oracles), &judges, &cases(), true);
    let close: usize = report.pairs.iter().map(|pair| pair.too_close).sum();
    assert!(
        close > 0 && !report.declines.is_empty() && report.judged.cases > 20,
        "the audit sees something of everything"
    );
}

#[test]
fn of_runs_that_are_red() {
    let oracles = oracles("closed-form,ode/linear/tsit45,asymptotic/paper");
    let honest = borrowed(&oracles);
    for change in [
        (|case, _, history| {
            if case.eta() > 0.9
                && let Some(impact) = history.impacts.get_mut(3)
            {
                impact.velocity *= 1.001;
            }
        }) as fn(&Case, f64, &mut History),
        |_, _, history| history.impacts.iter_mut().for_each(|impact| impact.velocity = -impact.velocity),
    ] {
        let planted = Planted { honest: honest[1], plant: Plant::Answer(change), size: 1.0 };
        let report = audit(
            &[honest[0], &planted, honest[2]],
            &Judges { oracles: Vec::new(), every: 1, closing: None },
            &cases(),
            false,
        );
        assert!(!report.failures.is_empty());
    }
    // Red as a whole only.
    struct Idle;
    impl Oracle for Idle {
        fn name(&self) -> &str {
            "idle"
        }
        fn model(&self) -> Model {
            Model::Linear
        }
        fn history(&self, _: &Case) -> Result<History, Decline> {
            Err(Decline::Unsupported { what: "anything" })
        }
    }
    let report = audit(
        &[honest[0], honest[1], &Idle],
        &Judges { oracles: Vec::new(), every: 1, closing: None },
        &cases(),
        false,
    );
    assert!(report.failures.is_empty() && !report.shortfalls.is_empty());
}

/// Where the judge is wrong, and not those that it refutes, it says so.
#[test]
fn of_a_run_with_a_wrong_judge() {
    let oracles = oracles("closed-form,ode/linear/tsit45");
    let honest = borrowed(&oracles);
    let judge = panel::judges().swap_remove(0);
    let off: fn(&Case, f64, &mut History) = |_, _, history| {
        history.impacts.iter_mut().for_each(|impact: &mut Impact| impact.interval *= 1.0 + 1e-6);
    };
    let wrong = Planted { honest: judge.as_ref(), plant: Plant::Answer(off), size: 1.0 };
    let cases: Vec<Named> = cases().into_iter().take(30).collect();
    let report = audit(&honest, &Judges { oracles: vec![&wrong], every: 1, closing: None }, &cases, false);
    assert!(report.failures.len() > 10);
    for failure in &report.failures {
        assert_eq!(failure.suspect_judges, ["enclosure/linear"], "{failure:?}");
    }
    assert!(report::text(&report).contains("the JUDGE is suspect"));
    // One that is wrong by itself is no reason to suspect it.
    let late = Planted { honest: honest[1], plant: Plant::Answer(off), size: 1.0 };
    let report =
        audit(&[honest[0], &late], &Judges { oracles: vec![judge.as_ref()], every: 1, closing: None }, &cases, false);
    assert!(
        report.failures.iter().all(|failure| failure.suspect_judges.is_empty() && failure.sound == ["closed-form"])
    );
}

/// A case that gets lost between the list and the tally is missed, whichever it is.
#[test]
fn of_cases_that_got_lost() {
    let oracles = oracles("closed-form,asymptotic/paper");
    let (honest, all) = (borrowed(&oracles), cases());
    let judges = Judges { oracles: Vec::new(), every: 1, closing: None };
    for lost in [0, 6, all.len() - 1] {
        let mut left = all.clone();
        left.remove(lost);
        let mut run = run::run(&honest, &judges, &left, 3, None, &());
        run.handed = chattercheck::gate::identity::Identity::of_all(&all);
        let report = Report::new(&run, &panel::roles());
        assert!(
            !report.passes() && report.shortfalls[0].to_string().contains("were examined"),
            "{:?}",
            report.shortfalls
        );
    }
    // The same number, but another case.
    let mut other = all.clone();
    other[6] = other[7].clone();
    let mut run = run::run(&honest, &judges, &other, 3, None, &());
    run.handed = chattercheck::gate::identity::Identity::of_all(&all);
    assert!(!Report::new(&run, &panel::roles()).passes());
}
