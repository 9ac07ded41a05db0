use anyhow::{anyhow, bail};
use chattercheck::{
    measure::{excitation::half_period, observables::Observed, sharpest},
    motion::response::{Bout, BoutEnd},
    panel::{self, Method, Proven, Refused, Role},
    plan::{Conclusion, Plan, Question},
};
use clap::Args;
use contract::{Case, Ending, Invalid, Oracle};

use super::{
    Status,
    case_facts::CaseFacts,
    case_flags::CaseFlags,
    chattering_answer::{Answer, text},
    estimate,
    followed::{Followed, follow, goes_on, on_motion},
    motion_facts::Facts,
    numbers::{count, whole},
    oracle_flags::{Asked, OracleFlags},
    output::{Format, note},
    proven_time,
};

/// The chattering time of one case: when the infinite sequence of impacts comes to rest
#[derive(Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    case: CaseFlags,
    #[command(flatten)]
    oracle: OracleFlags,
    /// Close the sum after this many impacts [default: as many as the restitution and the closeness to a_cr need]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = count::<1, { Case::MOST_IMPACTS }>)]
    impacts: Option<usize>,
    /// For enclosure: how many digits are to be proven, 1 to 100 [default: as many as a double holds]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole::<1, 100>)]
    digits: Option<i64>,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let Arguments { case: flags, oracle, digits, .. } = arguments;
    if let Some(answer) = proven_time::of_more_than_a_case(flags, oracle, *digits)? {
        return arguments.print_proven(&answer);
    }
    if let Some((oracle, followed)) = on_motion(flags, oracle, *digits)? {
        return in_scene(arguments, &oracle, &followed);
    }
    let case = flags.case(arguments.impacts.unwrap_or(sharpest::FIRST_IMPACTS))?;
    let oracle = match oracle.asked(flags, &case, *digits).map_err(auto_too)? {
        Asked::Auto(question) => return planned(arguments, *question),
        Asked::Oracle(oracle) => oracle,
    };
    arguments.refuse_impacts(oracle.name())?;
    if let Some(followed) = follow(flags, oracle.as_ref(), None)? {
        return in_scene(arguments, oracle.name(), &followed);
    }
    if let Some(proven) = arguments.oracle.proven(flags, &case, *digits)? {
        if goes_on(proven.history.ending)
            && let Some(answer) = proven_time::of_scene(flags, &arguments.oracle, *digits)?
        {
            return arguments.print_proven(&answer);
        }
        return enclosed(arguments, &proven, &case);
    }
    estimate::impacts(oracle.as_ref(), &case);
    let (case, observed) = arguments.observe(oracle.as_ref(), case)?;
    if let Some(followed) = follow(flags, oracle.as_ref(), Some(observed.history.ending))? {
        return in_scene(arguments, oracle.name(), &followed);
    }
    let mut answer = answer(oracle.name(), &case, &observed);
    answer.seconds = seconds(arguments, &answer)?;
    if answer.is_unsure() {
        answer.ending = "unsure: by its own account tau_ch may be off by any amount".to_owned();
    }
    arguments.format.print(&answer, text)?;
    let has_none = matches!(observed.history.ending, Ending::Lost(_)) || answer.is_unsure();
    Ok(if has_none { Status::Disagreed } else { Status::Well })
}

impl Arguments {
    /// An oracle with a sum of its own has one chattering time, however many impacts are listed.
    fn refuse_impacts(&self, oracle: &str) -> Result<(), Refused> {
        let sums = |method: &Method| method.roles.contains(&Role::OwnSum);
        match self.impacts {
            Some(impacts) if panel::method(oracle).is_some_and(sums) => {
                Err(Refused::unused("impacts", impacts, oracle, |method| !sums(method)))
            }
            _ => Ok(()),
        }
    }

    /// What the judge proves of a scene.
    fn print_proven(&self, answer: &Answer) -> anyhow::Result<Status> {
        self.refuse_impacts_in_scene()?;
        self.format.print(answer, text)?;
        if answer.rocks && answer.complete.is_none() {
            note("undecided with the digits that are tried: too near to where the ending changes, or too many impacts");
        }
        Ok(Status::Well)
    }

    /// In a scene that is more than a case it takes as many as it needs.
    fn refuse_impacts_in_scene(&self) -> Result<(), Invalid> {
        let why = "only for a scene that is no more than a case: here it takes as many as it needs";
        self.impacts.map_or(Ok(()), |impacts| Err(Invalid::new("impacts", impacts, why)))
    }

    /// What the oracle says, with as many impacts as are asked for, or else as many as sharpen the answer and it can do; and the case with so many.
    fn observe(&self, oracle: &dyn Oracle, case: Case) -> anyhow::Result<(Case, Observed)> {
        let observed = match self.impacts {
            Some(_) => oracle.history(&case).map(|history| (case, Observed::new(&case, history))),
            None => sharpest::observe(oracle, &case),
        };
        observed.map_err(|decline| anyhow!("{} declines: {decline}", oracle.name()))
    }
}

/// A tolerance is for `auto` too, which is no method of the panel.
fn auto_too(error: anyhow::Error) -> anyhow::Error {
    match error.downcast() {
        Ok(Refused::Unused { option: "tolerance", value, method, users }) => {
            Refused::Unused { option: "tolerance", value, method, users: format!("{users} or auto") }.into()
        }
        Ok(other) => other.into(),
        Err(error) => error,
    }
}

/// The answer of the cheapest method that meets the tolerance. Its uncertainty is all that is known to be wrong with it, the model included.
fn planned(arguments: &Arguments, question: Question) -> anyhow::Result<Status> {
    // It takes as many impacts as it needs, and asks what happens within half a period.
    let impacts = arguments.impacts.map(|impacts| ("impacts", impacts.to_string()));
    let until = arguments.case.until().map(|until| ("until", until.to_string()));
    if let Some((option, value)) = impacts.or(until) {
        let uses = |method: &Method| option == "until" || !method.roles.contains(&Role::OwnSum);
        return Err(Refused::unused(option, value, "auto", uses).into());
    }
    let found = Plan::new(question).answer();
    if let (None, Some(decline)) = (found.conclusion(), found.declined()) {
        bail!("auto: every method declines, first because {decline}");
    }
    let (outcome, method) = (found.conclusion(), found.method().map_or_else(String::new, |method| method.to_string()));
    let time = found.chattering_time();
    let ending = match outcome {
        None => "no method had an answer",
        Some(Conclusion::NeverRocks) => "never rocks",
        Some(Conclusion::Incomplete) => "incomplete (still rocking at half a period)",
        Some(Conclusion::Rocking) => "still rocking when the response ends",
        Some(Conclusion::Overturned) => "overturned",
        Some(Conclusion::Complete(_)) => "at rest (complete chattering)",
    };
    let mut answer = Answer {
        asked: Facts::Case(CaseFacts::of(&arguments.case.case(question.case.max_impacts())?)),
        rocks: outcome != Some(Conclusion::NeverRocks),
        complete: outcome.filter(|outcome| *outcome != Conclusion::NeverRocks).map(|_| time.is_some()),
        tau_ch: time.map(|time| time.value),
        uncertainty: time.map(|time| time.uncertainty),
        lower: None,
        upper: None,
        seconds: None,
        half_period_fraction: time.map(|time| time.value / half_period(question.case.omega())),
        impacts: found.attempts.last().map_or(0, |attempt| attempt.impacts),
        oracle: method,
        method: time.map(|_| match found.meets {
            true => "the cheapest method that meets the tolerance",
            false => "the best of the methods, none of which is predicted to meet the tolerance",
        }),
        ending: ending.to_owned(),
    };
    answer.seconds = seconds(arguments, &answer)?;
    arguments.format.print(&answer, text)?;
    if time.is_some() && !found.meets {
        note(format_args!(
            "auto: worse than the tolerance of {:.0e} that was asked; no method is predicted to do better",
            question.tolerance
        ));
    }
    Ok(if outcome.is_some() { Status::Well } else { Status::Disagreed })
}

/// The first rocking of a scene that is more than a case.
fn in_scene(arguments: &Arguments, oracle: &str, followed: &Followed) -> anyhow::Result<Status> {
    arguments.refuse_impacts_in_scene()?;
    let bout = followed.first();
    let rests = bout.filter(|bout| matches!(bout.outcome, BoutEnd::Complete { .. }) && !bout.is_unsure());
    let time = rests.map(|bout| bout.duration - bout.start);
    let answer = Answer {
        asked: followed.facts()?,
        rocks: bout.is_some(),
        complete: bout.and_then(|bout| match bout.outcome {
            _ if bout.is_unsure() => None,
            BoutEnd::Complete { .. } => Some(true),
            BoutEnd::Overturned | BoutEnd::Cut => Some(false),
            _ => None,
        }),
        tau_ch: time,
        uncertainty: rests.map(Bout::uncertainty),
        lower: None,
        upper: None,
        seconds: time.map(|time| time / followed.scene.block.frequency_parameter()),
        half_period_fraction: time
            .zip(followed.response.ground.half_period())
            .map(|(time, half_period)| time / half_period),
        impacts: bout.map_or(0, Bout::impacts),
        oracle: oracle.to_owned(),
        method: time.map(|_| "the response of the scene"),
        ending: bout.map_or("never rocks", Bout::ending).to_owned(),
    };
    arguments.format.print(&answer, text)?;
    Ok(if answer.rocks && answer.complete.is_none() { Status::Disagreed } else { Status::Well })
}

/// The answer of the oracle with proven bounds, with all its digits.
fn enclosed(arguments: &Arguments, proven: &Proven, case: &Case) -> anyhow::Result<Status> {
    let observed = Observed::new(case, proven.history.clone());
    let mut answer = answer(&proven.oracle, case, &observed);
    if let Some([lower, upper]) = proven.chattering_time.clone() {
        (answer.lower, answer.upper) = (Some(lower), Some(upper));
        answer.method = Some("proven bounds");
        if proven.wider_than_asked {
            note(format_args!("{}: proven, but wider than asked: it would have taken too long", proven.oracle));
        }
    }
    answer.seconds = seconds(arguments, &answer)?;
    arguments.format.print(&answer, text)?;
    Ok(Status::Well)
}

/// The chattering time of a scene in its own units.
fn seconds(arguments: &Arguments, answer: &Answer) -> anyhow::Result<Option<f64>> {
    let scene = arguments.case.scene()?;
    Ok(scene.zip(answer.tau_ch).map(|(scene, time)| time / scene.block.frequency_parameter()))
}

fn answer(oracle: &str, case: &Case, observed: &Observed) -> Answer {
    let history = &observed.history;
    let time = observed.chattering_time;
    Answer {
        asked: Facts::Case(CaseFacts::of(case)),
        rocks: history.ending != Ending::NeverRocks,
        complete: match history.ending {
            // Of what comes to rest at a time of which nothing is known it is not known whether it comes to rest.
            Ending::AtRest => time.is_none_or(|time| time.uncertainty.is_finite()).then_some(true),
            Ending::Incomplete | Ending::Overturned => Some(false),
            Ending::NeverRocks | Ending::LimitReached(_) | Ending::Lost(_) => None,
        },
        tau_ch: time.map(|time| time.value),
        uncertainty: time.map(|time| time.uncertainty),
        lower: None,
        upper: None,
        seconds: None,
        half_period_fraction: time.map(|time| time.value / half_period(case.omega())),
        impacts: history.impacts.len(),
        oracle: oracle.to_owned(),
        method: time.map(|_| match history.chattering_time {
            Some(_) => "its own sum",
            None => "extrapolation in eta^2 (Eq. 75 to higher orders)",
        }),
        ending: history.ending.to_string(),
    }
}
