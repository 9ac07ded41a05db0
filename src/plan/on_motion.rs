//! Which model a motion of the ground needs that is no case: there no formula predicts what linearisation costs, so the two responses are compared.

use contract::Model;

use crate::{
    motion::{
        response::{Bout, Peak, Response, Termination},
        scene::{AnswerError, Scene},
    },
    panel,
};

/// The responses of a scene by both models, and what they differ by.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionPlan {
    /// By Eq. 4.
    pub linear: Followed,
    /// By Eq. 2.
    pub nonlinear: Followed,
    /// The times of rocking that both have, in order, up to where they part.
    pub bouts: Vec<Compared>,
    /// Why they are not compared to the end; `None` if they are.
    pub parted: Option<Parted>,
    /// By how much the largest rotation of the linear model is off, relative; `None` if the block never rocks.
    pub rotation: Option<f64>,
}

/// A response, and by what.
#[derive(Debug, Clone, PartialEq)]
pub struct Followed {
    /// Whose flights.
    pub oracle: String,
    /// How many flights were followed.
    pub flights: usize,
    /// The largest rotation.
    pub peak: Option<Peak>,
    /// What happens.
    pub response: Response,
}

/// A time of rocking by both models.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compared {
    /// When it begins, `τ`.
    pub from: f64,
    /// When it ends by the linear model.
    pub linear: f64,
    /// When it ends by the nonlinear one.
    pub nonlinear: f64,
    /// How it ends by both.
    pub ending: &'static str,
    /// What linearisation is off by, relative to how long it lasts.
    pub error: f64,
    /// What is uncertain of that, relative.
    pub uncertainty: f64,
}

/// Why two responses are not compared any further.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Parted {
    /// One of them goes another way than the other in the rocking that begins then, `τ`.
    Differ(f64),
    /// It is not known how that rocking goes, even by one model.
    Unknown(f64),
}

impl MotionPlan {
    /// Follows the scene by both models.
    ///
    /// # Errors
    /// When a number is out of its range, or a method declines.
    pub fn new(scene: &Scene) -> Result<Self, AnswerError> {
        let [linear, nonlinear] = [Model::Linear, Model::Nonlinear].map(|model| Followed::new(scene, model));
        let (linear, nonlinear) = (linear?, nonlinear?);
        let (bouts, parted) = compare(&linear.response.bouts, &nonlinear.response.bouts);
        let sizes = linear.peak.zip(nonlinear.peak);
        let rotation = sizes.map(|(one, other)| (one.rotation.abs() / other.rotation.abs() - 1.0).abs());
        Ok(Self { linear, nonlinear, bouts, parted, rotation })
    }

    /// The largest error of the linear model, in when the block rests and how far it turns; `None` where the responses part, so that it is another response.
    pub fn error(&self) -> Option<f64> {
        let of_bouts = self.bouts.iter().map(|bout| bout.error);
        self.parted.is_none().then(|| of_bouts.chain(self.rotation).fold(0.0, f64::max))
    }

    /// The largest of what is uncertain of that.
    pub fn uncertainty(&self) -> f64 {
        self.bouts.iter().map(|bout| bout.uncertainty).fold(0.0, f64::max)
    }

    /// The model that is good enough for this tolerance: the slender block, where its error and what is uncertain of it are no more.
    pub fn needs(&self, tolerance: f64) -> Model {
        let meets = self.error().is_some_and(|error| error + self.uncertainty() <= tolerance);
        if meets { Model::Linear } else { Model::Nonlinear }
    }
}

impl MotionPlan {
    /// The model whose answer it is: the linear one where that is asked for, and else the one that is needed.
    pub fn chosen(&self, asked: Model, tolerance: f64) -> Model {
        if asked == Model::Linear { asked } else { self.needs(tolerance) }
    }

    /// The response by a model.
    pub fn by(&self, model: Model) -> &Followed {
        if model == Model::Linear { &self.linear } else { &self.nonlinear }
    }

    /// The error of a model, relative; `None` where the responses part. Of the block as it is it is 0.
    pub fn error_of(&self, model: Model) -> Option<f64> {
        if model == Model::Linear { self.error() } else { Some(0.0) }
    }

    /// Whether the answer of the chosen model is as accurate as asked.
    pub fn meets(&self, asked: Model, tolerance: f64) -> bool {
        match (asked, self.needs(tolerance)) {
            // Of the equation that is asked for it is no error that it is not the block's own.
            (Model::Linear, _) => self.linear.uncertainty() <= tolerance,
            (Model::Nonlinear, Model::Linear) => true,
            (Model::Nonlinear, Model::Nonlinear) => self.nonlinear.uncertainty() <= tolerance,
        }
    }
}

impl Followed {
    /// The largest of what is uncertain of its ends, relative to how long each time of rocking lasts.
    pub fn uncertainty(&self) -> f64 {
        let of = |bout: &Bout| bout.uncertainty() / (bout.duration - bout.start);
        self.response.bouts.iter().map(of).fold(0.0, f64::max)
    }

    fn new(scene: &Scene, model: Model) -> Result<Self, AnswerError> {
        let mut scene = scene.clone();
        scene.ask.model = model;
        let request = scene.on_motion(None, Termination::Exact)?;
        let oracle = panel::stepper_on(&request.body, &request.motion);
        let declined = |why| AnswerError::Declined { oracle: oracle.name().to_owned(), why };
        let response = Response::on_motion(oracle.as_ref(), &request).map_err(declined)?;
        let peak = response.peak_on_motion(oracle.as_ref(), &request).map_err(declined)?;
        let flights = response.bouts.iter().map(|bout| bout.flights.len()).sum();
        Ok(Self { oracle: oracle.name().to_owned(), flights, peak, response })
    }
}

/// The times of rocking that both have, and why no more are compared.
fn compare(linear: &[Bout], nonlinear: &[Bout]) -> (Vec<Compared>, Option<Parted>) {
    let mut bouts = Vec::new();
    for k in 0..linear.len().max(nonlinear.len()) {
        let (one, other) = match (linear.get(k), nonlinear.get(k)) {
            (Some(one), Some(other)) => (one, other),
            (Some(only), None) | (None, Some(only)) => return (bouts, Some(Parted::Differ(only.begin()))),
            (None, None) => break,
        };
        let from = one.begin().min(other.begin());
        if one.is_unsure() || other.is_unsure() {
            return (bouts, Some(Parted::Unknown(from)));
        }
        // Both wait for the same push, at a time that is the ground's.
        let same_push = (one.begin() - other.begin()).abs() <= 1e-9 * from.max(1.0);
        if !same_push || one.outcome.name() != other.outcome.name() {
            return (bouts, Some(Parted::Differ(from)));
        }
        let lasts = other.end() - from;
        bouts.push(Compared {
            from,
            linear: one.end(),
            nonlinear: other.end(),
            ending: other.ending(),
            error: (one.end() - other.end()).abs() / lasts,
            uncertainty: (one.uncertainty() + other.uncertainty()) / lasts,
        });
    }
    (bouts, None)
}
