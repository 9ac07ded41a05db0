//! What an engine says of itself, once it is known to be usable.

use crate::{
    launch::Launch,
    question::{ECHO, VERSIONS},
    reply::Hello,
    verdict::{Breakdown, Verdict},
    words,
};

/// What an engine says of itself.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Welcome {
    /// The version of the protocol.
    pub protocol: u64,
    /// Its name.
    pub name: String,
    /// Its version.
    pub version: String,
    /// The language that it is written in; empty if it does not say.
    pub language: String,
    /// The models that it solves.
    pub models: Vec<String>,
    /// What its amplitude may be a multiple of.
    pub normalisations: Vec<String>,
    /// The motions of the ground that it knows.
    pub ground: Vec<String>,
    /// Whether it claims errors.
    pub claims: bool,
    /// How many cases may be asked at once.
    pub max_batch: usize,
}

impl Welcome {
    /// What a first answer says, if the engine can be asked what the launch asks.
    ///
    /// # Errors
    /// The first thing that is wrong: the version, then the digits, then what is offered.
    pub fn of(hello: Hello, launch: &Launch) -> Result<Self, Breakdown> {
        if let Some(failure) = hello.error {
            return Err(Breakdown::new(Verdict::ReportedError, failure.message.unwrap_or_default()));
        }
        let protocol = hello.version.ok_or_else(|| missing("version"))?.0;
        if !VERSIONS.contains(&protocol) {
            let happened = format!("it speaks version {protocol} of the protocol, here it is {VERSIONS:?}");
            return Err(Breakdown::new(Verdict::WrongVersion, happened));
        }
        let echo: Vec<f64> = hello.echo.ok_or_else(|| missing("echo"))?.iter().map(|number| number.0).collect();
        check_echo(&echo)?;
        let engine = hello.engine.ok_or_else(|| missing("engine"))?;
        let max_batch = hello.max_batch.map_or(1, |most| most.0);
        if max_batch == 0 {
            return Err(Breakdown::new(Verdict::WrongKind, "\"max_batch\" is 0, it has to be 1 or more"));
        }
        let welcome = Self {
            protocol,
            name: engine.name.ok_or_else(|| missing("engine\".\"name"))?,
            version: engine.version.ok_or_else(|| missing("engine\".\"version"))?,
            language: engine.language.unwrap_or_default(),
            models: hello.models.ok_or_else(|| missing("models"))?,
            normalisations: hello.normalisations.ok_or_else(|| missing("normalisations"))?,
            ground: hello.ground.ok_or_else(|| missing("ground"))?,
            claims: hello.claims.unwrap_or(false),
            max_batch: usize::try_from(max_batch).unwrap_or(usize::MAX),
        };
        offered(Verdict::ModelNotOffered, words::model(launch.model), &welcome.models)?;
        offered(Verdict::NormalisationNotOffered, words::normalisation(launch.normalisation), &welcome.normalisations)?;
        offered(Verdict::GroundNotOffered, "sine", &welcome.ground)?;
        Ok(welcome)
    }
}

fn missing(field: &str) -> Breakdown {
    Breakdown::new(Verdict::MissingField, format!("the answer to the start has no \"{field}\""))
}

fn offered(verdict: Verdict, wanted: &str, offers: &[String]) -> Result<(), Breakdown> {
    if offers.iter().any(|offer| offer == wanted) {
        return Ok(());
    }
    Err(Breakdown::new(verdict, format!("{wanted:?} is asked for, the engine has {offers:?}")))
}

fn check_echo(echo: &[f64]) -> Result<(), Breakdown> {
    let wrong = |happened| Err(Breakdown::new(Verdict::EchoNotExact, happened));
    if echo.len() != ECHO.len() {
        return wrong(format!("{} numbers were sent, {} came back", ECHO.len(), echo.len()));
    }
    match ECHO.iter().zip(echo).find(|(sent, back)| sent.to_bits() != back.to_bits()) {
        Some((sent, back)) => wrong(format!("{sent:?} was sent, {back:?} came back")),
        None => Ok(()),
    }
}
