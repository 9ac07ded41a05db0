//! A response as a drawing: the ground and the rotation one above the other, and the impacts before a rest magnified; in seconds, g and degrees.

use contract::Motion;

use super::chart::{Axis, Draw, Error, Mark, Point, Right, Series, Shade, Strip, Strips};
use crate::motion::{
    response::{Bout, BoutEnd, Response, Sample, Shaken, Window},
    scene::{Account, Scene},
};

/// In how many parts a motion that is no record is drawn.
const PARTS: u32 = 6000;
/// How many decades of the time that is left until rest are magnified.
const DECADES: f64 = 5.0;

/// What is drawn.
pub struct Drawn<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The response to it.
    pub response: &'a Response,
    /// What happens in it.
    pub account: &'a Account,
    /// The part of it that is drawn.
    pub window: Window,
    /// The rows of that part.
    pub samples: &'a [Sample],
    /// The restitution.
    pub eta: f64,
}

impl Drawn<'_> {
    /// The drawing as SVG, in light or dark colours as its reader likes.
    ///
    /// # Errors
    /// When the response has no end, or no length.
    pub fn svg(&self) -> Result<String, Error> {
        let title = if self.scene.title.is_empty() { "Response of a block" } else { &self.scene.title };
        let told = self.account.told();
        let said = |wanted| told.iter().find(|(name, _)| *name == wanted).map_or("", |(_, what)| what.as_str());
        let caption = match self.account.largest_rotation {
            None => "The block does not rock.".to_owned(),
            Some(_) => {
                format!("Largest rotation {}. To overturning: {}.", said("largest rotation"), said("to overturning"))
            }
        };
        let strips = [Some(self.ground()), Some(self.rotation()), self.magnified()];
        Strips { title: title.to_owned(), caption, strips: strips.into_iter().flatten().collect() }.svg()
    }

    fn seconds(&self, tau: f64) -> f64 {
        tau / self.scene.block.frequency_parameter()
    }

    fn time(&self) -> Axis {
        Axis::linear("time (s)").with_range(self.seconds(self.window.from), self.seconds(self.window.to))
    }

    fn rests(&self) -> Vec<Shade> {
        self.account.rests.iter().map(|rest| Shade::Across("at rest", rest.from, rest.to)).collect()
    }

    fn ground(&self) -> Strip {
        const PUSHES: &str = "ground strong enough to start it rocking";
        let threshold = self.account.threshold;
        let Window { from, to, .. } = self.window;
        let even = || (0..=PARTS).map(|part| from + (to - from) * (f64::from(part) / f64::from(PARTS)));
        let times: Vec<f64> = match &self.response.ground {
            Shaken::Motion(motion) => match &**motion {
                // Between its samples are straight lines,
                Motion::Record(record) => {
                    // and nothing after the last.
                    let samples = (0..record.samples.len()).map(|k| k as f64 * record.dt);
                    let samples = samples.chain([motion.duration().next_up()]);
                    let inside = samples.filter(|tau| from < *tau && *tau < to);
                    [from].into_iter().chain(inside).chain([to]).collect()
                }
                _ => even().collect(),
            },
            Shaken::Sinusoid(_) => even().collect(),
        };
        let point = |tau: &f64| Point { x: self.seconds(*tau), y: Some(threshold * self.response.acceleration(*tau)) };
        let line = Series::new("ground acceleration", times.iter().map(point).collect()).with_draw(Draw::Line);
        let level = |of: f64| Mark::level(of * threshold, "");
        let beyond = [Shade::Up(PUSHES, threshold, f64::MAX), Shade::Up(PUSHES, -f64::MAX, -threshold)];
        Strip {
            title: String::new(),
            height: 170.0,
            x: self.time(),
            y: Axis::linear("ground (g)"),
            right: Some(Right { label: "over threshold".to_owned(), unit: threshold }),
            series: vec![line],
            shades: self.rests().into_iter().chain(beyond).collect(),
            marks: vec![level(1.0), level(-1.0)],
            strokes: ("", Vec::new()),
        }
    }

    fn rotation(&self) -> Strip {
        let alpha = self.account.alpha;
        let point = |sample: &Sample| Point { x: self.seconds(sample.tau), y: Some(alpha * sample.phi) };
        let line = Series::new("rotation", self.samples.iter().map(point).collect()).with_draw(Draw::Line);
        let impacts = self.response.bouts.iter().flat_map(Bout::impact_times);
        // The corner, where the block comes near it.
        let is_near = self.account.largest_rotation.is_some_and(|largest| largest.share_of_alpha > 0.5);
        let corners = [-alpha, alpha].into_iter().filter(|_| is_near);
        Strip {
            title: String::new(),
            height: 220.0,
            x: self.time(),
            y: Axis::linear("rotation (degrees)"),
            right: Some(Right { label: "θ/α".to_owned(), unit: alpha }),
            series: vec![line.with_slot(1)],
            shades: self.rests(),
            marks: corners.map(|corner| Mark::level(corner, "")).collect(),
            strokes: ("impacts", impacts.map(|tau| self.seconds(tau)).collect()),
        }
    }

    /// The impacts before the rest that the longest rocking ends with: how they come ever faster, against the time that is left.
    fn magnified(&self) -> Option<Strip> {
        let complete = self.response.bouts.iter().filter(|bout| matches!(bout.outcome, BoutEnd::Complete { .. }));
        let bout = complete.max_by(|one, other| one.duration.total_cmp(&other.duration))?;
        let (rest, mut left) = (bout.end(), 0.0);
        let impacts: Vec<(f64, f64)> = bout.impact_list(self.eta).map(|(time, interval, _)| (time, interval)).collect();
        // Added up from the end: differences of times have few digits there.
        let mut points: Vec<(f64, f64)> = Vec::new();
        let mut later: Option<f64> = None;
        for (time, interval) in impacts.into_iter().rev() {
            left += later.unwrap_or(rest - time).max(0.0);
            later = Some(interval);
            points.push((self.seconds(left), self.seconds(interval)));
        }
        points.reverse();
        let most = points.first()?.0;
        points.retain(|(left, interval)| *left > most / 10_f64.powf(DECADES) && *interval > 0.0);
        let decades = |left: f64| -left.log10();
        let (from, to) = (decades(most), decades(points.last()?.0));
        if points.len() < 3 || to - from < 0.1 {
            return None;
        }
        let ticks = (from.ceil() as i32..=to.floor() as i32).map(|decade| (f64::from(decade), power(-decade)));
        let point = |(left, interval): &(f64, f64)| Point { x: decades(*left), y: Some(*interval) };
        let series = Series::new("impacts", points.iter().map(point).collect()).with_slot(1);
        Some(Strip {
            title: format!("Chattering magnified: the impacts before the rest at {:.4} s", self.seconds(rest)),
            height: 190.0,
            x: Axis::linear("time left until rest (s)").with_range(from - 0.1, to + 0.1).with_ticks(ticks.collect()),
            y: Axis::log("since the last impact (s)"),
            right: None,
            series: vec![series],
            shades: Vec::new(),
            marks: Vec::new(),
            strokes: ("", Vec::new()),
        })
    }
}

/// A power of ten, as it is read best.
fn power(exponent: i32) -> String {
    if (-3..=3).contains(&exponent) { format!("{}", 10_f64.powi(exponent)) } else { format!("10^{{{exponent}}}") }
}
