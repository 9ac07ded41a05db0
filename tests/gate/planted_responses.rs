//! Mistakes planted in whole responses, each of which the gate has to notice and call by its name: in the flights, in what the loop of events makes of
//! them, and in the table that is printed.

use std::f64::consts::PI;

use chattercheck::{
    cases::shaking::{Question, Shaking},
    gate::{
        judge::Judges,
        outcome::Outcomes,
        report::{self, Report},
        responses::{self, BoutEnding, Finding, Law, Responder, What, Whole, Wrong},
        run::{self, Selection},
        verdict::Verdict,
    },
    motion::{response::Termination, scene::Scene},
    panel::{self, Settings},
    responders::Stepped,
};
use contract::{Arrival, Case, Decline, Departure, FlightSolver, Ground, History, Model, Oracle};

/// An oracle whose flights have a mistake.
struct Mistaken {
    oracle: Box<dyn Oracle>,
    flaw: Flaw,
}

#[derive(Clone, Copy)]
enum Flaw {
    /// That the block overturns is concluded as if the ground never stopped.
    GroundNeverStops,
    /// The ground goes on after its end.
    GoesOn,
    /// On still ground the block rebounds as fast as it landed.
    ElasticAfterwards,
    /// Rest is called while the block may still be thrown.
    RestsTooSoon,
    /// Every flight lasts too long, by this share.
    Late(f64),
}

struct MistakenFlights {
    solver: Box<dyn FlightSolver>,
    flaw: Flaw,
    eta: f64,
}

impl Oracle for Mistaken {
    fn name(&self) -> &str {
        self.oracle.name()
    }

    fn model(&self) -> Model {
        self.oracle.model()
    }

    fn history(&self, case: &Case) -> Result<History, Decline> {
        self.oracle.history(case)
    }

    fn flights(&self, case: &Case) -> Result<Box<dyn FlightSolver>, Decline> {
        Ok(Box::new(MistakenFlights { solver: self.oracle.flights(case)?, flaw: self.flaw, eta: case.eta() }))
    }
}

impl MistakenFlights {
    fn departure(&self, departure: &Departure) -> Departure {
        match self.flaw {
            Flaw::GoesOn => Departure { ground: Ground::Shaking, ..*departure },
            _ => *departure,
        }
    }
}

impl FlightSolver for MistakenFlights {
    fn fly(&self, departure: &Departure, horizon: f64) -> Arrival {
        let arrival = self.solver.fly(&self.departure(departure), horizon);
        match (self.flaw, arrival) {
            (Flaw::GroundNeverStops, Arrival::Aloft { .. }) => match self.solver.fly(departure, 50.0) {
                Arrival::Overturned { .. } => Arrival::Overturned { after: horizon },
                _ => arrival,
            },
            (Flaw::ElasticAfterwards, Arrival::Impact { interval, speed }) if departure.ground == Ground::Still => {
                Arrival::Impact { interval, speed: speed / self.eta }
            }
            (Flaw::Late(share), Arrival::Impact { interval, speed }) => {
                Arrival::Impact { interval: interval * (1.0 + share), speed }
            }
            _ => arrival,
        }
    }

    fn motion(&self, departure: &Departure, s: f64) -> (f64, f64) {
        self.solver.motion(&self.departure(departure), s)
    }

    fn rests(&self, departure: &Departure) -> bool {
        match self.flaw {
            Flaw::RestsTooSoon => departure.velocity < 0.05,
            _ => self.solver.rests(&self.departure(departure)),
        }
    }
}

/// A method that is asked another question than it is held against, or whose answer is spoilt.
struct Spoilt {
    inner: Stepped,
    ask: fn(Shaking) -> Shaking,
    spoil: fn(&mut Whole, &Shaking),
}

impl Responder for Spoilt {
    fn name(&self) -> &str {
        self.inner.name()
    }

    fn model(&self) -> Model {
        self.inner.model()
    }

    fn accuracy(&self) -> f64 {
        self.inner.accuracy()
    }

    /// Motions that are no sinusoids are asked and answered as they are.
    fn respond(&self, question: &Question, rows: usize) -> Option<Whole> {
        let Question::Sinusoid(shaking) = question else { return self.inner.respond(question, rows) };
        let mut whole = self.inner.respond(&Question::Sinusoid((self.ask)(*shaking)), rows)?;
        (self.spoil)(&mut whole, shaking);
        Some(whole)
    }
}

fn stepped(oracle: Box<dyn Oracle>) -> Stepped {
    Stepped { oracle, name: "mistaken".to_owned(), model: Model::Linear, accuracy: 1e-13, table: true, wavelets: true }
}

fn closed_form() -> Box<dyn Oracle> {
    panel::one("closed-form", &Settings::default(), "linear").unwrap()
}

fn mistaken(flaw: Flaw) -> Stepped {
    stepped(Box::new(Mistaken { oracle: closed_form(), flaw }))
}

fn same(shaking: Shaking) -> Shaking {
    shaking
}

fn nothing(_: &mut Whole, _: &Shaking) {}

fn asked(ask: fn(Shaking) -> Shaking) -> Spoilt {
    Spoilt { inner: stepped(closed_form()), ask, spoil: nothing }
}

fn spoilt(spoil: fn(&mut Whole, &Shaking)) -> Spoilt {
    Spoilt { inner: stepped(closed_form()), ask: same, spoil }
}

/// The responses in which mistakes are looked for.
fn questions() -> Vec<(String, Question)> {
    responses::questions(&responses::Selection { responses: 225, seed: 1 })
}

/// Whether this is found of a method in one of them.
fn found(responder: &dyn Responder, is: impl Fn(&Wrong) -> bool) -> bool {
    questions().iter().any(|(_, question)| {
        let findings = responses::examine(&[responder], question).findings;
        assert!(findings.iter().all(|finding| finding.method == "mistaken"), "{findings:?}");
        findings.iter().any(|finding| is(&finding.wrong))
    })
}

fn breaks(law: Law) -> impl Fn(&Wrong) -> bool {
    move |wrong| matches!(wrong, Wrong::Breaks(broken, _) if *broken == law)
}

fn differs(what: What) -> impl Fn(&Wrong) -> bool {
    move |wrong| matches!(wrong, Wrong::Differs(difference) if difference.what == what)
}

fn anything(_: &Wrong) -> bool {
    true
}

/// Without a mistake nothing is found: what is found below is the mistake. With one the run is red.
#[test]
fn the_method_without_a_mistake_is_green() {
    assert!(!found(&asked(same), anything));
    let (report, failures) = responses::run(&[&asked(same)], &questions(), &());
    assert!(report.verdict() == Verdict::Pass && failures.is_empty());
    let (report, failures) = responses::run(&[&mistaken(Flaw::Late(1e-9))], &questions(), &());
    assert!(
        report.verdict() == Verdict::Fail
            && !failures.is_empty()
            && report.tally.methods["mistaken"].wrong == failures.len()
    );
}

/// A block that comes back (it hits the base at τ = 4.53479041) is not said to overturn because the ground would have thrown it over had it gone on.
#[test]
fn overturning_that_forgets_the_end_of_the_shaking_is_found() {
    let quarter = Shaking {
        case: Case::from_amplitude(1.9, 1.0, 0.9).unwrap(),
        phase: Some(0.0),
        lasts: Some(0.5 * PI),
        until: f64::INFINITY,
    };
    let method = mistaken(Flaw::GroundNeverStops);
    let quarter = Question::Sinusoid(quarter);
    let findings = responses::examine(&[&method], &quarter).findings;
    let false_overturning = |finding: &Finding| match &finding.wrong {
        Wrong::Differs(difference) => {
            matches!(difference.what, What::NoImpact) && (difference.time - 4.534_790_41).abs() < 1e-8
                || matches!(difference.what, What::Ending(BoutEnding::Overturned, BoutEnding::Rest))
        }
        Wrong::Breaks(..) | Wrong::Changes(..) => false,
    };
    assert!(matches!(&findings[..], [finding] if false_overturning(finding)), "{findings:?}");
    let right = asked(same);
    assert!(responses::examine(&[&right], &quarter).findings.is_empty());
    assert!(found(&method, anything));
}

#[test]
fn mistakes_of_flights_are_found() {
    assert!(found(&mistaken(Flaw::GoesOn), anything));
    assert!(found(&mistaken(Flaw::ElasticAfterwards), differs(What::ImpactSpeed)));
    assert!(found(&mistaken(Flaw::Late(1e-9)), differs(What::ImpactTime)));
    assert!(found(&mistaken(Flaw::RestsTooSoon), anything));
}

/// What is allowed follows from what the two methods are worth, 1e-13 and 2e-12: flights that are off by a few times as much don't pass.
#[test]
fn flights_that_are_off_by_a_few_times_what_is_claimed_are_found() {
    for share in [1e-11, -1e-11] {
        assert!(found(&mistaken(Flaw::Late(share)), differs(What::ImpactTime)), "{share}");
    }
}

#[test]
fn another_motion_of_the_ground_is_found() {
    let ignored = asked(|shaking| Shaking { lasts: None, until: shaking.until.min(60.0), ..shaking });
    assert!(found(&ignored, anything));
    let late =
        asked(|shaking| Shaking { lasts: shaking.lasts.map(|lasts| lasts + PI / shaking.case.omega()), ..shaking });
    assert!(found(&late, anything));
    let hardly_late = asked(|shaking| Shaking { lasts: shaking.lasts.map(|lasts| lasts * (1.0 + 1e-9)), ..shaking });
    assert!(found(&hardly_late, anything));
    let mirrored = asked(|shaking| Shaking { phase: shaking.phase.map(|phase| phase + PI), ..shaking });
    assert!(found(&mirrored, anything));
    let shifted = asked(|shaking| Shaking { phase: shaking.phase.map(|phase| phase + 1e-10), ..shaking });
    assert!(found(&shifted, differs(What::Begin)));
    let bouncy = asked(|shaking| {
        let case =
            Case::from_amplitude(shaking.case.amplitude(), shaking.case.omega(), shaking.case.eta() * (1.0 - 1e-9));
        Shaking { case: case.unwrap(), ..shaking }
    });
    assert!(found(&bouncy, breaks(Law::Restitution)));
}

#[test]
fn mistakes_of_the_loop_of_events_are_found() {
    // The sign of every lobe but the first.
    let sides = spoilt(|whole, _| whole.bouts.iter_mut().skip(1).for_each(|bout| bout.side = -bout.side));
    assert!(found(&sides, differs(What::Side)));
    // However late: only the last bout of five and more.
    let last = spoilt(|whole, _| {
        if let Some(bout) = whole.bouts.get_mut(4..).and_then(<[_]>::last_mut) {
            bout.side = -bout.side;
        }
    });
    assert!(found(&last, differs(What::Side)));
    // A rest that lasts for a bout too long: the bout is gone.
    let slept = spoilt(|whole, _| {
        if whole.bouts.len() > 2 {
            let gone = whole.bouts.remove(1);
            whole.rests.retain(|(from, _)| *from != gone.end);
            whole.rests.iter_mut().for_each(|rest| {
                if rest.1 == gone.begin {
                    rest.1 = whole.bouts[1].begin
                }
            });
        }
    });
    assert!(found(&slept, breaks(Law::Threshold)));
    // And without the law: nothing but the list of bouts.
    let shorter = spoilt(|whole, _| {
        if whole.bouts.len() > 1 && whole.rests.len() >= whole.bouts.len() {
            whole.bouts.pop();
        }
    });
    assert!(found(&shorter, breaks(Law::Tiling)));
    let closed_wrong = spoilt(|whole, _| {
        for k in 0..whole.bouts.len() {
            let end = whole.bouts[k].end;
            let later = end + 1e-8 * (end - whole.bouts[k].begin);
            if whole.bouts[k].outcome == BoutEnding::Rest {
                whole.rests.iter_mut().for_each(|rest| {
                    if rest.0 == end {
                        rest.0 = later
                    }
                });
                whole.bouts[k].end = later;
            }
        }
        whole.end = whole.bouts.last().map_or(whole.end, |bout| whole.end.max(bout.end));
    });
    assert!(found(&closed_wrong, differs(What::RestTime)));
    let unsure = spoilt(|whole, _| whole.bouts.iter_mut().for_each(|bout| bout.uncertainty = 1e4));
    assert!(found(&unsure, differs(What::Unsure)));
    let lost_impact = spoilt(|whole, _| {
        whole.bouts.iter_mut().filter(|bout| bout.outcome == BoutEnding::Overturned).for_each(|bout| {
            bout.impacts.pop();
        });
    });
    assert!(found(&lost_impact, differs(What::NoImpact)));
    let high = spoilt(|whole, _| {
        for bout in &mut whole.bouts {
            bout.peak = bout.peak.map(|peak| peak * (1.0 + 1e-7));
        }
    });
    assert!(found(&high, differs(What::Peak)));
    let early = spoilt(|whole, _| whole.end *= 0.5);
    assert!(found(&early, anything));
}

#[test]
fn mistakes_in_the_table_are_found() {
    // The ground acceleration of the threshold below it.
    let weak = spoilt(|whole, shaking| {
        let a = shaking.case.amplitude();
        whole.rows.iter_mut().filter(|_| a < 1.0).for_each(|row| row.ground /= a);
    });
    assert!(found(&weak, breaks(Law::Ground)));
    let going_on = spoilt(|whole, shaking| {
        for row in &mut whole.rows {
            row.ground =
                shaking.case.amplitude() * (shaking.case.omega() * row.time + shaking.phase.unwrap_or(0.0)).sin();
        }
    });
    assert!(found(&going_on, breaks(Law::Ground)));
    // Of the two rows of an impact, the second a rounding later; or earlier.
    let later = spoilt(|whole, _| shift_after_impacts(whole, f64::EPSILON));
    assert!(found(&later, breaks(Law::OneTime)));
    let earlier = spoilt(|whole, _| shift_after_impacts(whole, -f64::EPSILON));
    assert!(found(&earlier, breaks(Law::Order)));
    let still = spoilt(|whole, _| whole.rows.iter_mut().for_each(|row| row.velocity *= 1.0 + 1e-8));
    assert!(found(&still, differs(What::Velocity)));
    let tilted = spoilt(|whole, _| whole.rows.iter_mut().for_each(|row| row.rotation *= 1.0 + 1e-8));
    assert!(found(&tilted, differs(What::Rotation)));
    let asleep = spoilt(|whole, _| {
        whole.rows.iter_mut().for_each(|row| row.state = responses::State::Rest);
    });
    assert!(found(&asleep, breaks(Law::AtRest)));
    let fallen = spoilt(|whole, _| {
        let rocking = |row: &&mut responses::Row| row.state == responses::State::Rocking;
        whole.rows.iter_mut().filter(rocking).for_each(|row| row.state = responses::State::Overturned);
    });
    assert!(found(&fallen, differs(What::State)));
}

/// Moves the second of the two rows of each impact.
fn shift_after_impacts(whole: &mut Whole, share: f64) {
    for k in 1..whole.rows.len() {
        let (one, two) = (whole.rows[k - 1], whole.rows[k]);
        if one.rotation == 0.0 && two.rotation == 0.0 && one.velocity * two.velocity != 0.0 && one.time == two.time {
            whole.rows[k].time *= 1.0 + share;
        }
    }
}

/// Where all methods differ in the same way, what they share is suspect, or the follower.
#[test]
fn methods_that_agree_against_the_follower_are_said_to() {
    let other =
        |name: &str| Spoilt { inner: Stepped { name: name.to_owned(), ..stepped(closed_form()) }, ..asked(late) };
    fn late(shaking: Shaking) -> Shaking {
        Shaking { lasts: shaking.lasts.map(|lasts| 1.1 * lasts), ..shaking }
    }
    let (one, two) = (other("one"), other("two"));
    let request = responses::Selection { responses: 20, seed: 1 };
    let (_, failures) = responses::run(&[&one, &two], &responses::questions(&request), &());
    assert!(!failures.is_empty());
    for finding in failures.iter().flat_map(|failure| &failure.findings) {
        assert_eq!(finding.agreeing, [if finding.method == "one" { "two" } else { "one" }]);
        assert!(finding.to_string().contains("suspect"), "{finding}");
    }
}

/// What was found is made small, still disagrees in the same way, and can be run by itself as a scene.
#[test]
fn what_disagrees_is_shrunk_to_a_scene() {
    let method = asked(|shaking| Shaking { lasts: shaking.lasts.map(|lasts| 1.1 * lasts), ..shaking });
    let request = responses::Selection { responses: 40, seed: 1 };
    let (_, failures) = responses::run(&[&method], &responses::questions(&request), &());
    let failure = &failures[0];
    let (question, finding) = responses::shrink(&[&method], &failure.question, &failure.findings[0]);
    assert!(finding.wrong.resembles(&failure.findings[0].wrong));
    let again = responses::examine(&[&method], &question).findings;
    assert!(again.contains(&finding), "{again:?}");
    let digits = |question: &Question| format!("{question:?}").len();
    assert!(digits(&question) + 30 < digits(&failure.question), "{question:?} from {:?}", failure.question);
    let text = responses::scene_text(failure, 1, &question, &finding, std::path::Path::new("scene.toml"));
    let Question::Sinusoid(shaking) = question else { panic!("{question:?}") };
    let scene = Scene::parse(&text).unwrap();
    let asked = scene.response(Some(shaking.until).filter(|until| until.is_finite()), Termination::Exact).unwrap();
    assert_eq!(
        (asked.case.amplitude(), asked.case.omega(), asked.phase),
        (shaking.case.amplitude(), shaking.case.omega(), shaking.phase)
    );
    // The end of the shaking goes through cycles and seconds; it is what is wrong here.
    let (end, wanted) = (asked.lasts.unwrap(), shaking.lasts.unwrap());
    assert!((end / wanted - 1.0).abs() < 1e-14, "{end} for {wanted}");
}

/// A whole response that is wrong turns the run red, in the text, in the JSON and in JUnit; one case or response is not that of another.
#[test]
fn a_wrong_response_is_in_every_report() {
    let panel = panel::select("closed-form,taylor").unwrap();
    let panel: Vec<&dyn Oracle> = panel.iter().map(AsRef::as_ref).collect();
    let cases = [run::cases(&Selection { cases: 0, seed: 1 }, panel[0]).swap_remove(0)];
    let judges = Judges { oracles: Vec::new(), every: 1, closing: None };
    let green = || Report::new(&run::run(&panel, &judges, &cases, 1, None, &()), &panel::roles());
    assert!(green().passes());
    let (all_well, _) = responses::run(&[&asked(same)], &questions()[..20], &());
    assert!(green().with_responses(Some(all_well)).passes());
    let (wrong, failures) = responses::run(&[&mistaken(Flaw::Late(1e-9))], &questions()[..20], &());
    let names: Vec<&str> = failures.iter().map(|failure| failure.name.as_str()).collect();
    let report = green().with_responses(Some(wrong));
    assert!(!report.passes() && !names.is_empty());
    let text = report::text(&report);
    assert!(
        text.starts_with("FAIL") && text.contains(&format!("{} of 20 whole responses failed", names.len())),
        "{text}"
    );
    assert!(text.contains(&format!("FAILED {}", names[0])) && text.contains("time of an impact"), "{text}");
    let json = serde_json::to_value(&report).unwrap();
    assert_eq!(json["verdict"], "fail");
    let in_json: Vec<&str> = json["responses"]["failures"]
        .as_array()
        .unwrap()
        .iter()
        .map(|failed| failed["name"].as_str().unwrap())
        .collect();
    assert_eq!(in_json, names);
    let junit = super::audit::junit_cases(&report::junit(&report, &cases, &Outcomes::default()).unwrap());
    let failed: Vec<&str> =
        junit.iter().filter(|(_, failed)| failed.is_some()).map(|(name, _)| name.as_str()).collect();
    assert_eq!(failed, names);
    // The case, twenty responses, and the two of the runs as a whole.
    assert_eq!(junit.len(), 1 + 20 + 2);
}
