//! The whole responses of a verification run.

use std::path::Path;

use chattercheck::{
    cases::shaking::Question,
    gate::{
        partition::{Partition, cost_of_response},
        progress::Progress,
        responses::{self, Failure, Report, Responder, Selection},
    },
    panel,
    responders::{self, Stepped, Told},
};
use clap::Args;
use contract::{Invalid, Oracle};

use super::{
    files::{make_folder, write_new, write_numbered},
    numbers::count,
    output::note,
};

#[derive(Args)]
pub(super) struct Responses {
    #[arg(
        long,
        value_name = "N",
        allow_negative_numbers = true,
        value_parser = count::<0, { Selection::MOST }>,
        help = format!(
            "How many whole responses, by the oracles that follow them, against a plain follower: two of three on sinusoids, the others on random motions [default: {}, 0 if none does, and where engines are given]",
            Selection::DEFAULT
        )
    )]
    responses: Option<usize>,
}

/// What is to be run: the methods of these oracles, and the responses.
pub(super) struct Chosen {
    /// How many of all parts.
    asked: usize,
    methods: Vec<Stepped>,
    told: Vec<Told>,
    questions: Vec<(String, Question)>,
}

impl Responses {
    /// # Errors
    /// When there are too many, or none of the oracles follows whole responses and some were asked for.
    /// Where they are not `usual`, none are run unless asked for: with engines, which follow none, and where only chosen cases are run.
    pub fn chosen(
        &self,
        panel: &[&dyn Oracle],
        usual: bool,
        seed: u64,
        partition: Partition,
    ) -> Result<Chosen, Invalid> {
        let named = |name: &str| panel.iter().any(|oracle| oracle.name() == name);
        let methods: Vec<Stepped> =
            responders::all().into_iter().filter(|method| named(method.oracle.name())).collect();
        let usual = if methods.is_empty() || !usual { 0 } else { Selection::DEFAULT };
        let responses = self.responses.unwrap_or(usual);
        if responses > Selection::MOST {
            return Err(Invalid::new("responses", responses, "at most 1000000"));
        }
        if responses > 0 && methods.is_empty() {
            let allowed = "0, as none of the oracles asked (--oracles) follows whole responses";
            return Err(Invalid::new("responses", responses, allowed));
        }
        let all = responses::questions(&Selection { responses, seed });
        let costs: Vec<f64> = all.iter().map(|(_, question)| cost_of_response(question)).collect();
        // One of a method speaks for the others of it, which differ in how many terms they sum.
        let of_same = |one: &dyn Oracle| {
            let method = |name: &str| panel::method(name).map(|method| method.name);
            panel.iter().any(|oracle| method(oracle.name()) == method(one.name()))
        };
        let told = responders::told(of_same);
        Ok(Chosen { asked: responses, methods, told, questions: partition.of(all, &costs) })
    }
}

impl Chosen {
    /// How many there are in all parts.
    pub fn asked(&self) -> usize {
        self.asked
    }

    /// The names of the methods that are asked for them; none where none are run.
    pub fn responders(&self) -> Vec<String> {
        if self.asked == 0 {
            return Vec::new();
        }
        self.methods().iter().map(|method| method.name().to_owned()).collect()
    }

    pub fn len(&self) -> usize {
        self.questions.len()
    }

    /// Runs them; `None` where there are none. How many seconds each took is the last.
    pub fn run(&self, progress: &impl Progress) -> (Option<Report>, Vec<Failure>, Vec<f64>) {
        if self.questions.is_empty() {
            return (None, Vec::new(), Vec::new());
        }
        let (report, failures, seconds) = responses::timed(&self.methods(), &self.questions, progress);
        (Some(report), failures, seconds)
    }

    fn methods(&self) -> Vec<&dyn Responder> {
        let stepped = self.methods.iter().map(|method| method as &dyn Responder);
        stepped.chain(self.told.iter().map(|told| told as &dyn Responder)).collect()
    }

    /// Shrinks the first finding of a few failures, and writes each as a scene.
    ///
    /// # Errors
    /// When a file can't be written.
    pub fn write_scenes(
        &self,
        seed: u64,
        failures: &[Failure],
        folder: &Path,
        part: &str,
        watch: &impl Progress,
    ) -> anyhow::Result<()> {
        for failure in failures.iter().take(MOST_SCENES) {
            let Some(first) = failure.findings.first() else { continue };
            let (question, finding) = if watch.is_interrupted() {
                (failure.question.clone(), first.clone())
            } else {
                responses::shrink(&self.methods(), &failure.question, first)
            };
            make_folder("replays", folder)?;
            let text = |path: &Path| responses::scene_text(failure, seed, &question, &finding, path);
            let path = write_numbered(folder, &format!("response-seed-{seed}{part}"), |path| Ok(text(path)))?;
            if let Some(samples) = responses::samples_text(&question) {
                write_new(&responses::samples_path(&path), &samples)?;
            }
            note(format_args!("shrunk {}: {finding}\n  a scene that shows it: {}", failure.name, path.display()));
        }
        Ok(())
    }
}

/// How many failures are shrunk.
const MOST_SCENES: usize = 5;
