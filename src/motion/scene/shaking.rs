//! A ground motion that is no sinusoid: a pulse by its name, a sum of sinusoids, or a record, in multiples of the threshold and in `τ`.

use std::{
    ops::Range,
    path::{Path, PathBuf},
    sync::Arc,
};

use contract::{Invalid, Model, Motion, Ricker, Sinusoid, Stretch};
use toml::Spanned;

use super::{
    Block, ROUNDING, SceneError, Text,
    file::{Amplitude, Duration, Frequency, GroundFields, PulseName, RecordFields, SineFields, Time},
};
use crate::motion::record::{self, Asked, Step, Units};

/// How far apart samples may be.
const STEPS: &str = "1e-9 to 1e9 (in tau, times time_scale)";

/// A motion of the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaking {
    /// What it is, for people: the name of the pulse, `a sum of sinusoids`, `a record`.
    pub name: &'static str,
    /// The motion, in multiples of the acceleration at which the block begins to rock, over `τ`.
    pub motion: Arc<Motion>,
    /// By how much it may be off by rounding, relative.
    pub rounding: f64,
    /// The model whose threshold it was measured with, `g α` of the linear one, where an amplitude is written over the slender threshold.
    pub over_slender: Option<Model>,
    /// The file of a record.
    pub file: Option<PathBuf>,
    /// What a reader of its file should know.
    pub notes: Vec<String>,
}

impl Shaking {
    /// A record under this block, by its samples in these units: a time `dt` apart, in `τ`, and each times `scale`.
    ///
    /// # Errors
    /// As [`Motion::record`].
    pub fn of_samples(
        block: &Block,
        units: Units,
        (dt, scale): (f64, f64),
        samples: Vec<f64>,
    ) -> Result<Self, Invalid> {
        let unit = in_thresholds(units, block);
        let motion = Arc::new(Motion::record(dt, scale * unit, samples)?);
        let rounding = if unit == 1.0 { 0.0 } else { ROUNDING };
        Ok(Self { name: "a record", motion, rounding, over_slender: None, file: None, notes: Vec::new() })
    }
}

/// One of these units, in multiples of the acceleration at which the block begins to rock.
fn in_thresholds(units: Units, block: &Block) -> f64 {
    let threshold = block.gravity * block.slenderness.tan();
    match units {
        Units::G => block.gravity / threshold,
        Units::MetresPerSecondSquared => 1.0 / threshold,
        Units::CentimetresPerSecondSquared => 0.01 / threshold,
        Units::Threshold => 1.0,
    }
}

/// What is known when the ground is read.
pub(super) struct Reader<'a> {
    pub block: &'a Block,
    pub model: Model,
    pub text: &'a Text<'a>,
    /// Where the scene is.
    pub folder: &'a Path,
}

impl Reader<'_> {
    /// The motion of a `[ground]` that is no sinusoid; `None` of one that is.
    ///
    /// # Errors
    /// When a field is missing, not used, or not allowed.
    pub fn shaking(&self, fields: &GroundFields) -> Result<Option<Shaking>, SceneError> {
        let GroundFields { pulse, sinusoids, record, .. } = fields;
        match (pulse, sinusoids, record) {
            (None, None, None) => Ok(None),
            (Some(pulse), None, None) => self.pulse(pulse, fields).map(Some),
            (None, Some(sinusoids), None) => self.sum(sinusoids, fields).map(Some),
            (None, None, Some(record)) => self.record(record, fields).map(Some),
            _ => Err(SceneError("[ground] is one of pulse, sinusoids or record, not more than one".to_owned())),
        }
    }

    fn pulse(&self, pulse: &Spanned<PulseName>, fields: &GroundFields) -> Result<Shaking, SceneError> {
        let name = *pulse.get_ref();
        let is_ricker = matches!(name, PulseName::Ricker | PulseName::RickerAntisymmetric);
        let is_mp = name == PulseName::MavroeidisPapageorgiou;
        let by = name.name();
        refuse_unused(
            self.text,
            by,
            [
                ("center", fields.center.as_ref().map(Spanned::span).filter(|_| !is_ricker)),
                ("gamma", fields.gamma.as_ref().map(Spanned::span).filter(|_| !is_mp)),
                ("phase", fields.phase.as_ref().map(Spanned::span).filter(|_| !is_mp)),
                ("duration", fields.duration.as_ref().map(Spanned::span)),
            ],
        )?;
        let needed = |field: &str| SceneError(format!("[ground] with pulse = \"{by}\" needs {field}"));
        let amplitude = fields.amplitude.as_ref().ok_or_else(|| needed("amplitude"))?;
        let (amplitude, rounding) = self.amplitude(amplitude)?;
        let omega = self.omega(fields.frequency.as_ref().ok_or_else(|| needed("frequency"))?)?;
        let number = |field: &'static str, value: &Option<Spanned<f64>>| match value {
            Some(value) => self.text.number(field, value, |value| value.abs() <= 1e3, "-1000 to 1000"),
            None => Err(needed(field)),
        };
        let motion = match name {
            PulseName::OneSine => Motion::one_sine(amplitude, omega),
            PulseName::OneCosine => Motion::one_cosine(amplitude, omega),
            PulseName::Ricker | PulseName::RickerAntisymmetric => {
                let center = self.time("center", fields.center.as_ref().ok_or_else(|| needed("center"))?)?;
                let antisymmetric = name == PulseName::RickerAntisymmetric;
                Motion::ricker(Ricker { amplitude, omega, center, antisymmetric })
            }
            PulseName::MavroeidisPapageorgiou => {
                let gamma = number("gamma", &fields.gamma)?;
                let nu = fields.phase.as_ref().map_or(Ok(0.0), |_| number("phase", &fields.phase))?;
                Motion::mavroeidis_papageorgiou(amplitude, omega, gamma, nu)
            }
        };
        let motion = motion.map_err(|invalid| self.refused(&invalid, fields, pulse.span()))?;
        let over_slender = self.over_slender(fields.amplitude.iter());
        Ok(Shaking { name: by, motion: Arc::new(motion), rounding, over_slender, file: None, notes: Vec::new() })
    }

    /// Where a motion refuses a parameter: the line of its field as it is typed, and else that of the pulse.
    fn refused(&self, invalid: &Invalid, fields: &GroundFields, pulse: Range<usize>) -> SceneError {
        let span = match invalid.field {
            "gamma" => fields.gamma.as_ref().map(Spanned::span),
            "nu" => fields.phase.as_ref().map(Spanned::span),
            "center" => fields.center.as_ref().map(Spanned::span),
            "omega" | "duration" => fields.frequency.as_ref().map(Spanned::span),
            "amplitude" => fields.amplitude.as_ref().map(Spanned::span),
            _ => None,
        };
        self.text.error(&span.unwrap_or(pulse), invalid)
    }

    fn sum(&self, sinusoids: &Spanned<Vec<SineFields>>, fields: &GroundFields) -> Result<Shaking, SceneError> {
        const BY: &str = "a sum of sinusoids";
        refuse_unused(
            self.text,
            BY,
            [
                ("amplitude", fields.amplitude.as_ref().map(Spanned::span)),
                ("frequency", fields.frequency.as_ref().map(Spanned::span)),
                ("phase", fields.phase.as_ref().map(Spanned::span)),
                ("center", fields.center.as_ref().map(Spanned::span)),
                ("gamma", fields.gamma.as_ref().map(Spanned::span)),
            ],
        )?;
        let mut rounding: f64 = 0.0;
        let mut terms = Vec::new();
        for SineFields { amplitude, frequency, phase } in sinusoids.get_ref() {
            let (amplitude, off) = self.amplitude(amplitude)?;
            let phase = phase.as_ref().map_or(Ok(0.0), |phase| {
                self.text.number("phase", phase, |phase| phase.abs() <= 1e3, "-1000 to 1000 (radians)")
            })?;
            terms.push(Sinusoid { amplitude, omega: self.omega(frequency)?, phase });
            rounding = rounding.max(off);
        }
        if terms.is_empty() {
            return Err(self.text.error(&sinusoids.span(), "sinusoids: allowed is one at least"));
        }
        let until = match &fields.duration {
            None => f64::INFINITY,
            Some(duration) => {
                let p = self.block.frequency_parameter();
                let (tau, typed) = match *duration.get_ref() {
                    Duration::Seconds(seconds) => (seconds * p, seconds),
                    Duration::Tau(tau) => (tau, tau),
                    Duration::Cycles(_) => {
                        let said = "duration: of several sinusoids it is { seconds = number } or { tau = number }";
                        return Err(self.text.error(&duration.span(), said));
                    }
                };
                self.text.check(
                    "duration",
                    typed,
                    &duration.span(),
                    |_| tau > 0.0 && tau <= 1e9,
                    "above 0, up to 1e9 (in τ)",
                )?;
                tau
            }
        };
        let motion = Motion::sinusoids(vec![Stretch { until, terms }]);
        let motion = motion.map_err(|invalid| self.text.error(&sinusoids.span(), invalid))?;
        let over_slender = self.over_slender(sinusoids.get_ref().iter().map(|fields| &fields.amplitude));
        Ok(Shaking { name: BY, motion: Arc::new(motion), rounding, over_slender, file: None, notes: Vec::new() })
    }

    fn record(&self, record: &RecordFields, fields: &GroundFields) -> Result<Shaking, SceneError> {
        refuse_unused(
            self.text,
            "a record",
            [
                ("amplitude", fields.amplitude.as_ref().map(Spanned::span)),
                ("frequency", fields.frequency.as_ref().map(Spanned::span)),
                ("phase", fields.phase.as_ref().map(Spanned::span)),
                ("center", fields.center.as_ref().map(Spanned::span)),
                ("gamma", fields.gamma.as_ref().map(Spanned::span)),
                ("duration", fields.duration.as_ref().map(Spanned::span)),
            ],
        )?;
        let p = self.block.frequency_parameter();
        let number = |field, value: &Option<Spanned<f64>>, least: f64, allowed| {
            value.as_ref().map_or(Ok(1.0), |value| {
                self.text.number(field, value, |value| value.abs() <= 1e6 && value >= least, allowed)
            })
        };
        let scale = number("scale", &record.scale, -1e6, "-1e6 to 1e6")?;
        let direction = record.direction.as_ref().map_or(Ok(1.0), |direction| match *direction.get_ref() {
            one @ (1 | -1) => Ok(one as f64),
            other => Err(self
                .text
                .error(&direction.span(), Invalid::new("direction", other, "1, or -1 for the other way round"))),
        })?;
        let time_scale = number("time_scale", &record.time_scale, 1e-6, "1e-6 to 1e6")?;
        let units = record.units.as_ref().map(|units| self.units(units)).transpose()?;
        let column = record.column.as_ref().map(|column| self.column(column)).transpose()?;
        let is_step = |tau: f64| (1e-9..=1e9).contains(&(tau * time_scale));
        let (step, in_tau) = match &record.dt {
            None => (Step::OfFile, None),
            Some(dt) => {
                let (value, tau) = match *dt.get_ref() {
                    Time::Seconds(seconds) => (seconds, seconds * p),
                    Time::Tau(tau) => (tau, tau),
                };
                self.text.check("dt", value, &dt.span(), |_| is_step(tau), STEPS)?;
                match *dt.get_ref() {
                    Time::Seconds(seconds) => (Step::Seconds(seconds), None),
                    Time::Tau(tau) => (Step::Elsewhere, Some(tau)),
                }
            }
        };
        let path = self.folder.join(record.file.get_ref());
        let at_file = |said: String| self.text.error(&record.file.span(), said);
        let read = record::read_file(&path, &Asked { units, step, column });
        let mut read = read.map_err(|error| at_file(error.to_string()))?;
        let (dt, units) = (read.dt, read.units);
        let in_file = |line: Option<usize>, said: String| {
            let line = line.map_or(String::new(), |line| format!(" line {line}:"));
            at_file(format!("{}:{line} {said}", path.display()))
        };
        let unit = in_thresholds(units, self.block);
        let of_file = dt.map(|seconds| seconds * p);
        if let (Some(tau), Some(of_file), Some(field)) = (in_tau, of_file, &record.dt)
            && (tau - of_file).abs() > 1e-6 * of_file
        {
            let said = format!(
                "dt = {tau} tau, and the file says {of_file} tau; expected is the same, or none in the scene (time_scale stretches times)"
            );
            return Err(self.text.error(&field.span(), said));
        }
        let dt = in_tau.or(of_file).map(|dt| dt * time_scale);
        let dt =
            dt.ok_or_else(|| at_file("dt: the file does not say it: { seconds = .. } or { tau = .. }".to_owned()))?;
        if let Some(seconds) = read.dt.filter(|seconds| in_tau.is_none() && !is_step(seconds * p)) {
            return Err(in_file(read.dt_line, Invalid::new("dt", format!("{seconds:?} s"), STEPS).to_string()));
        }
        let factor = direction * scale * unit;
        if let Some(sample) = read.samples.iter().copied().find(|sample| (sample * factor).abs() > Motion::MOST) {
            let (line, typed) = record::line_of_sample(&path, &read, sample).unzip();
            let typed = typed.unwrap_or_else(|| format!("{sample:?}"));
            let times = Some(direction * scale).filter(|factor| *factor != 1.0);
            let times = times.map_or(String::new(), |factor| format!(", times {factor},"));
            let said = format!(
                "the sample {typed} ({units}){times} is {:e} thresholds of this block; allowed is up to 1e6",
                sample * factor
            );
            return Err(in_file(line, said));
        }
        let (samples, notes) = (std::mem::take(&mut read.samples), std::mem::take(&mut read.notes));
        let shaking = Shaking::of_samples(self.block, units, (dt, direction * scale), samples);
        let shaking = shaking.map_err(|invalid| at_file(invalid.to_string()))?;
        Ok(Shaking { file: Some(path), notes, ..shaking })
    }

    fn over_slender<'b>(&self, mut amplitudes: impl Iterator<Item = &'b Spanned<Amplitude>>) -> Option<Model> {
        let is_slender =
            |amplitude: &Spanned<Amplitude>| matches!(amplitude.get_ref(), Amplitude::OverSlenderThreshold(_));
        amplitudes.any(is_slender).then_some(self.model)
    }

    /// In multiples of the threshold, and by how much that may be off, relative.
    fn amplitude(&self, amplitude: &Spanned<Amplitude>) -> Result<(f64, f64), SceneError> {
        Ok(self.block.over_own_threshold(self.text.amplitude(amplitude)?, self.model))
    }

    fn omega(&self, frequency: &Spanned<Frequency>) -> Result<f64, SceneError> {
        Ok(self.block.omega(self.text.frequency(frequency)?))
    }

    fn time(&self, field: &'static str, time: &Spanned<Time>) -> Result<f64, SceneError> {
        let (Time::Seconds(value) | Time::Tau(value)) = *time.get_ref();
        self.text.check(field, value, &time.span(), |value| value > 0.0 && value <= 1e9, "above 0, up to 1e9")?;
        Ok(match *time.get_ref() {
            Time::Seconds(seconds) => seconds * self.block.frequency_parameter(),
            Time::Tau(tau) => tau,
        })
    }

    fn units(&self, units: &Spanned<String>) -> Result<Units, SceneError> {
        Units::named(units.get_ref()).map_err(|invalid| self.text.error(&units.span(), invalid))
    }

    fn column(&self, column: &Spanned<i64>) -> Result<usize, SceneError> {
        let number = usize::try_from(*column.get_ref()).ok().filter(|number| (1..=1000).contains(number));
        number.ok_or_else(|| {
            self.text.error(&column.span(), Invalid::new("column", column.get_ref(), "1 to 1000, the first being 1"))
        })
    }
}

impl PulseName {
    fn name(self) -> &'static str {
        match self {
            Self::OneSine => "one-sine",
            Self::OneCosine => "one-cosine",
            Self::Ricker => "ricker",
            Self::RickerAntisymmetric => "ricker-antisymmetric",
            Self::MavroeidisPapageorgiou => "mavroeidis-papageorgiou",
        }
    }
}

/// Refuses the first field that is given where it is not used.
pub(super) fn refuse_unused<const N: usize>(
    text: &Text<'_>,
    by: &str,
    fields: [(&str, Option<Range<usize>>); N],
) -> Result<(), SceneError> {
    match fields.into_iter().find_map(|(field, span)| Some((field, span?))) {
        Some((field, span)) => Err(text.error(&span, format!("{field} is not used by {by}"))),
        None => Ok(()),
    }
}
