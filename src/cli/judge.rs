use std::{
    fs::File,
    io::{self, Read},
    path::{Path, PathBuf},
};

use anyhow::{Context as _, anyhow, bail};
use chattercheck::{
    cases::toml_error::printable,
    gate::listed::{self, Judged, Listed, Written},
    measure::asking::{Reply, ask},
    panel,
    studies::chart::csv_in_words,
};
use clap::Args;
use contract::{Case, Horizon, Invalid, Model};
use serde::Serialize;

use super::{
    Status,
    case_facts::CaseFacts,
    case_flags::CaseFlags,
    numbers::number,
    output::{Format, note},
};

/// A list of impact times from anywhere, held against proven bounds: what is right, to how many digits, and where it goes wrong first
///
/// The file is CSV with a head: column time (or tau), in units of 1/p, counted from initiation, where the ground acceleration reaches the threshold; and, if there is one, velocity, phi' just after the impact, with or without its sign. Other columns are not
/// looked at, and a first row at time 0 is initiation. What `chattercheck simulate` prints is such a file. The slender block (Eq. 4) is the truth, and with --alpha the block as it is (Eq. 2).
///
/// Exit status: 0 all that can be judged is right; 1 something is wrong; 3 nothing can be judged.
#[derive(Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    case: CaseFlags,
    /// The list; - is stdin
    file: PathBuf,
    /// What a right impact may be off by: its time in shares of the interval before it, its velocity in shares of itself, besides what its last digit leaves open
    #[arg(long, value_name = "T", default_value_t = 1e-3, allow_hyphen_values = true, value_parser = number)]
    tolerance: f64,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Serialize)]
struct Answer {
    #[serde(flatten)]
    case: CaseFacts,
    judge: String,
    /// How many impacts the list has.
    impacts: usize,
    /// How many are right, from the first on.
    right_impacts: usize,
    /// `null` if nothing is wrong.
    first_wrong: Option<FirstWrong>,
    /// What would explain it.
    hint: Option<String>,
    /// The fewest right digits of a time, an interval and a velocity among the right impacts.
    digits: Option<f64>,
    interval_digits: Option<f64>,
    velocity_digits: Option<f64>,
    /// Impacts too near to each other for the digits that were written; impacts of a later rocking; impacts that nothing is proven of.
    unresolved: usize,
    later: usize,
    unproven: usize,
    ending: String,
    /// When the block really comes to rest, if it does.
    tau_ch: Option<f64>,
    uncertainty: Option<f64>,
}

#[derive(Serialize)]
struct FirstWrong {
    impact: usize,
    kind: &'static str,
    says: String,
}

pub(super) fn run(arguments: &Arguments) -> anyhow::Result<Status> {
    let case = arguments.case.case(Case::DEFAULT_IMPACTS)?;
    if !(1e-12..=0.25).contains(&arguments.tolerance) {
        return Err(Invalid::new("tolerance", arguments.tolerance, "1e-12 to 0.25 (of an interval)").into());
    }
    if let Some(scene) = arguments.case.scene()?
        && scene.question()?.request.is_some()
    {
        bail!(
            "phase or duration (of the scene) is not used by judge, which is for a motion that passes the threshold and goes on"
        );
    }
    let model = arguments.case.model().map_or(Ok(panel::model_of(&case)), panel::model_named)?;
    if let Some(alpha) = arguments.case.alpha().filter(|_| model == Model::Linear) {
        bail!("alpha = {alpha} is not used by the linear model; only with --model nonlinear");
    }
    let list = read(&arguments.file)?;
    let judges = panel::judges();
    let judge = judges.iter().find(|judge| judge.model() == model).ok_or_else(|| anyhow!("no judge of this model"))?;
    let case = listed::case_for(&case, &list)?;
    // A case goes on past half a period as a scene may not.
    if let (Some(scene), Horizon::Until(last)) = (&arguments.case.scene, case.horizon()) {
        bail!("time = {last} is past half a period, where judge does not know the motion of {}", scene.display());
    }
    let proven = match ask(judge.as_ref(), &case).reply {
        Reply::Observed(observed) => observed,
        Reply::Declined(decline) | Reply::Broke(decline) => bail!("{} declines: {decline}", judge.name()),
        Reply::Panicked(message) => bail!("{} broke: {message}", judge.name()),
    };
    let judged = listed::judge(&case, &proven, &list, arguments.tolerance);
    arguments.format.print(&answer(judge.name(), &case, &judged), |answer| text(answer, arguments.tolerance))?;
    Ok(match (&judged.first_wrong, judged.right) {
        (Some(_), _) => Status::Disagreed,
        (None, 0) => Status::Failed,
        (None, _) => Status::Well,
    })
}

fn answer(judge: &str, case: &Case, judged: &Judged) -> Answer {
    Answer {
        case: CaseFacts::of(case),
        judge: judge.to_owned(),
        impacts: judged.impacts,
        right_impacts: judged.right,
        first_wrong: judged.first_wrong.as_ref().map(|wrong| FirstWrong {
            impact: wrong.n,
            kind: wrong.kind(),
            says: wrong.to_string(),
        }),
        hint: judged.hint.map(|hint| hint.to_string()),
        digits: judged.digits.time,
        interval_digits: judged.digits.interval,
        velocity_digits: judged.digits.velocity,
        unresolved: judged.unresolved,
        later: judged.later,
        unproven: judged.unproven,
        ending: judged.ending.to_string(),
        tau_ch: judged.rest.map(|rest| rest.value),
        uncertainty: judged.rest.map(|rest| rest.uncertainty),
    }
}

fn text(answer: &Answer, within: f64) -> String {
    let Answer { impacts, right_impacts: right, .. } = answer;
    let mut lines = vec![match &answer.first_wrong {
        Some(wrong) => format!("WRONG at impact {}: {}", wrong.impact, wrong.says),
        None if *right == 0 => "NOTHING CAN BE JUDGED".to_owned(),
        None if right == impacts => format!("RIGHT: all {impacts} impacts, within {within} of an interval"),
        None => {
            format!("RIGHT, as far as it can be judged: {right} of {impacts} impacts, within {within} of an interval")
        }
    }];
    lines.extend(answer.hint.as_ref().map(|hint| format!("as if {hint}")));
    if *right > 0 {
        let of = |name: &str, digits: Option<f64>| digits.map(|digits| format!("{name} to {digits:.1} digits"));
        let digits = [
            of("times", answer.digits),
            of("intervals", answer.interval_digits),
            of("velocities", answer.velocity_digits),
        ];
        let digits = digits.into_iter().flatten().collect::<Vec<_>>().join(", ");
        lines.push(format!("right: impact{} 1 to {right}: {digits}", if *right == 1 { "" } else { "s" }));
    }
    for (count, why) in [
        (answer.unresolved, "are too near to each other for the digits that are written"),
        (answer.later, "are of a later rocking, after the block had come to rest, and are not judged"),
        (answer.unproven, "are beyond what is proven"),
    ] {
        lines.extend((count > 0).then(|| format!("{count} more {why}")));
    }
    let rest = answer.tau_ch.zip(answer.uncertainty);
    lines.push(match rest {
        Some((rest, off)) => format!("proven by {}: {}, at {rest} ± {off:.1e}", answer.judge, answer.ending),
        None => format!("proven by {}: {}", answer.judge, answer.ending),
    });
    lines.join("\n")
}

/// The list in a file.
fn read(path: &Path) -> anyhow::Result<Vec<Listed>> {
    let shown = path.display();
    let file: Box<dyn Read> = if path == Path::new("-") {
        Box::new(io::stdin().lock())
    } else {
        Box::new(File::open(path).with_context(|| format!("cannot read {shown}"))?)
    };
    let mut csv = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(file);
    let head = csv.headers().map_err(|error| unread(path, &error))?.clone();
    let column = |names: &[&str]| -> anyhow::Result<Option<usize>> {
        let mut found = head.iter().enumerate().filter(|(_, name)| names.contains(name));
        match (found.next(), found.next()) {
            (Some(_), Some((_, second))) => {
                bail!("{shown}: column = {second} is there twice; allowed is one of {}", names.join(", "))
            }
            (first, _) => Ok(first.map(|(place, _)| place)),
        }
    };
    let time = column(&["time", "tau"])?.ok_or_else(|| {
        let columns = head.iter().collect::<Vec<_>>().join(", ");
        // One column with several words in it has another separator.
        let other = [';', '\t'].into_iter().find(|separator| columns.contains(*separator));
        if let Some(separator) = other {
            return anyhow!("{shown}: columns are separated by commas, not by {separator:?}");
        }
        anyhow!("{shown}: columns = {columns} are outside the allowed: time (or tau), and velocity if there is one")
    })?;
    let velocity = column(&["velocity"])?;
    let mut list = Vec::new();
    for record in csv.records() {
        let record = record.map_err(|error| unread(path, &error))?;
        let line = record.position().map_or(0, csv::Position::line);
        let of = |name: &str, place: usize| -> anyhow::Result<Written> {
            let text = record.get(place).unwrap_or_default();
            let value = number(text).ok().filter(|value| value.is_finite());
            let value = value.ok_or_else(|| {
                anyhow!(
                    "{shown}, line {line}: {name} = {text} is outside the allowed range: a finite number, as in 0.36"
                )
            })?;
            Ok(Written::new(text, value))
        };
        let time = of("time", time)?;
        if time.value < 0.0 {
            bail!("{shown}, line {line}: time = {} is outside the allowed range: 0 or more", time.value);
        }
        let velocity = velocity.map(|place| of("velocity", place)).transpose()?;
        // Initiation is no impact.
        if !(list.is_empty() && time.value == 0.0) {
            list.push(Listed { time, velocity });
        }
        if list.len() > Case::MOST_IMPACTS {
            bail!("{shown}: impacts = more than {} are outside the allowed range: 1 to {0}", Case::MOST_IMPACTS);
        }
    }
    if list.is_empty() {
        bail!("{shown}: impacts = 0 is outside the allowed range: 1 to {}", Case::MOST_IMPACTS);
    }
    let ignored: Vec<&str> = head.iter().filter(|name| !["time", "tau", "velocity"].contains(name)).collect();
    if !ignored.is_empty() {
        note(format_args!("{shown}: not looked at: {}", printable(&ignored.join(", "))));
    }
    Ok(list)
}

/// What is wrong with a file as CSV.
fn unread(path: &Path, error: &csv::Error) -> anyhow::Error {
    anyhow!("cannot read {}: {}", path.display(), csv_in_words(error))
}
