//! A suite that is being filled: test cases one by one as long as there is room, sums for the rest.

use std::collections::{BTreeMap, HashSet};

use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite, XmlString};

use super::{
    room::{self, Room, Shown},
    skipped, unsuccessful,
};

/// What became of a test case.
pub(super) enum Told {
    Passed,
    /// Of what kind, and why.
    Skipped(&'static str, String),
    /// The message, and the whole text.
    Unsuccessful(NonSuccessKind, String, String),
}

/// A suite that is being filled.
pub(super) struct Suite {
    suite: TestSuite,
    seconds: f64,
    names: HashSet<(String, String)>,
    sums: BTreeMap<String, Sums>,
}

/// What of one class is not listed.
#[derive(Default)]
struct Sums {
    passed: usize,
    seconds: f64,
    skipped: BTreeMap<String, usize>,
    failed: usize,
    broke: usize,
}

impl Suite {
    pub(super) fn new(name: impl Into<XmlString>) -> Self {
        Self { suite: TestSuite::new(name), seconds: 0.0, names: HashSet::new(), sums: BTreeMap::new() }
    }

    /// Adds a test case that took so long, if that is known.
    pub(super) fn add(&mut self, class: &str, name: &str, seconds: Option<f64>, told: Told, room: &mut Room) {
        self.seconds += seconds.unwrap_or(0.0);
        let name = room::name(name);
        let status = match told {
            Told::Passed if room.lists_all => TestCaseStatus::success(),
            Told::Passed => {
                let sums = self.sums(class);
                sums.passed += 1;
                sums.seconds += seconds.unwrap_or(0.0);
                return;
            }
            Told::Skipped(kind, why) if room.lists_all => skipped(kind, &room::line(&why)),
            Told::Skipped(_, why) => {
                *self.sums(class).skipped.entry(room::line(&why)).or_default() += 1;
                return;
            }
            Told::Unsuccessful(kind, message, text) => {
                let (message, text) = (room::line(&message), room::text(&text));
                match (room.take(&name, &message, &text), kind) {
                    (Shown::Whole, _) => unsuccessful(kind, &message, &text),
                    (Shown::Line, _) => unsuccessful(kind, &message, &message),
                    (Shown::Counted, NonSuccessKind::Failure) => return self.sums(class).failed += 1,
                    (Shown::Counted, NonSuccessKind::Error) => return self.sums(class).broke += 1,
                }
            }
        };
        self.put(class, &name, seconds, status);
    }

    fn sums(&mut self, class: &str) -> &mut Sums {
        self.sums.entry(class.to_owned()).or_default()
    }

    /// Puts a test case under a name that is its own.
    fn put(&mut self, class: &str, name: &str, seconds: Option<f64>, status: TestCaseStatus) {
        let names = std::iter::once(name.to_owned()).chain((2..).map(|n| format!("{name} ({n})")));
        let mut free = names.filter(|name| self.names.insert((class.to_owned(), name.clone())));
        let mut case = TestCase::new(free.next().unwrap_or_default(), status);
        case.set_classname(class);
        // To the microsecond, where the attribute of the crate stops at the millisecond: a case takes less.
        case.extra.extend(seconds.map(|seconds| ("time".into(), format!("{seconds:.6}").into())));
        self.suite.add_test_case(case);
    }

    /// The suite, with the sums.
    pub(super) fn end(mut self) -> TestSuite {
        for (class, sums) in std::mem::take(&mut self.sums) {
            let Sums { passed, seconds, skipped: reasons, failed, broke } = sums;
            if passed > 0 {
                self.put(&class, &format!("{passed} more that passed"), Some(seconds), TestCaseStatus::success());
            }
            let count: usize = reasons.values().sum();
            if count > 0 {
                let mut reasons: Vec<(&String, &usize)> = reasons.iter().collect();
                reasons.sort_by(|(_, one), (_, two)| two.cmp(one));
                let shown = reasons.iter().take(REASONS).map(|(why, count)| format!("{count} {why}"));
                let why = shown.collect::<Vec<_>>().join("; ");
                self.put(&class, &format!("{count} more that were skipped"), None, skipped("summed up", &why));
            }
            for (count, kind, what) in
                [(failed, NonSuccessKind::Failure, "failed"), (broke, NonSuccessKind::Error, "broke an engine")]
            {
                if count > 0 {
                    let text = format!("{count} more cases {what}; the report in JSON has all of them");
                    self.put(&class, &format!("{count} more that {what}"), None, unsuccessful(kind, &text, &text));
                }
            }
        }
        self.suite.extra.insert("time".into(), format!("{:.6}", self.seconds).into());
        self.suite
    }
}

/// How many reasons of what was skipped are given where it is summed up.
const REASONS: usize = 20;
