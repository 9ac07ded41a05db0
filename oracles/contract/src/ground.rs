use alloc::{format, sync::Arc, vec, vec::Vec};
use core::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::{Invalid, Normalisation, Slenderness};

/// A motion of the ground as data: its acceleration `f(τ)` in multiples of that which starts the rocking of the block, so that the thresholds are `±1`. It starts
/// at `τ = 0` and is nothing before and after its time. Each oracle evaluates it itself.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// Sums of sinusoids, a stretch of time each, one after another.
    Sinusoids(Vec<Stretch>),
    /// A wavelet of Ricker.
    Ricker(Ricker),
    /// Samples, and straight lines between them.
    Record(Record),
}

/// A stretch of time in which the ground moves as a sum of sinusoids.
#[derive(Debug, Clone, PartialEq)]
pub struct Stretch {
    /// When it ends, `τ`, where the next one begins; infinite only for the last.
    pub until: f64,
    /// What is added up; nothing stands for ground at rest.
    pub terms: Vec<Sinusoid>,
}

/// `a sin(ωτ + phase)`, with `τ` from the start of the motion, whichever stretch it is in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinusoid {
    /// `a`, of either sign.
    pub amplitude: f64,
    /// `ω >= 0`.
    pub omega: f64,
    /// In radians.
    pub phase: f64,
}

/// `a (1 - y²) exp(-y²/2)` with `y = ω(τ - center)/√2`, or `a/1.3801 (y³ - 3y) exp(-y²/2)` with `y = ω(τ - center)/√3`; over twice the center.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ricker {
    /// `a`: the peak.
    pub amplitude: f64,
    /// `ω`.
    pub omega: f64,
    /// The time of its middle.
    pub center: f64,
    /// Which of the two.
    pub antisymmetric: bool,
}

/// Sample `k` is at `k dt`, as an exact product; linear in between, nothing before the first and after the last.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// The step, `τ`.
    pub dt: f64,
    /// What the samples are multiplied with.
    pub scale: f64,
    /// The samples; shared, as a record is long and asked often.
    pub samples: Arc<[f64]>,
}

/// The block that a motion of the ground is followed with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    eta: f64,
    alpha: Option<f64>,
}

impl Body {
    /// A block of this restitution, and of this slenderness for the nonlinear model.
    ///
    /// # Errors
    /// As [`Case::from_epsilon`](crate::Case::from_epsilon) and [`Slenderness::new`].
    pub fn new(eta: f64, alpha: Option<f64>) -> Result<Self, Invalid> {
        let eta = Invalid::unless(eta > 0.0 && eta < 1.0, "eta", eta, "0 < eta < 1")?;
        let alpha = alpha.map(|alpha| Slenderness::new(alpha, Normalisation::Threshold).map(|of| of.alpha()));
        Ok(Self { eta, alpha: alpha.transpose()? })
    }

    /// The coefficient of restitution `η` of Eq. 13.
    pub fn eta(&self) -> f64 {
        self.eta
    }

    /// The slenderness angle `α` in radians, where it is known.
    pub fn alpha(&self) -> Option<f64> {
        self.alpha
    }
}

/// The peak of `(y³ - 3y) exp(-y²/2)`, as it is rounded where the wavelet is defined.
pub const RICKER_ANTISYMMETRIC_PEAK: f64 = 1.3801;

impl Motion {
    /// The largest amplitude, and how far a record may be scaled.
    pub const MOST: f64 = 1e6;
    /// No motion that ends lasts for more cycles of its fastest part.
    pub const MOST_CYCLES: f64 = 1e4;
    /// As many terms or stretches as anybody writes down.
    const MOST_TERMS: usize = 1000;
    /// As many samples as a record may have.
    pub const MOST_SAMPLES: usize = 10_000_000;

    /// One period of `a sin(ωτ)`.
    ///
    /// # Errors
    /// When the amplitude or the frequency is out of its range.
    pub fn one_sine(amplitude: f64, omega: f64) -> Result<Self, Invalid> {
        Self::pulse(omega, TAU, vec![Sinusoid { amplitude, omega, phase: 0.0 }])
    }

    /// One period of `a cos(ωτ)`, which starts and ends with a jump.
    ///
    /// # Errors
    /// When the amplitude or the frequency is out of its range.
    pub fn one_cosine(amplitude: f64, omega: f64) -> Result<Self, Invalid> {
        Self::pulse(omega, TAU, vec![Sinusoid { amplitude, omega, phase: FRAC_PI_2 }])
    }

    /// `-a/(2γ) [sin(ωx/γ) cos(ωx + ν) + γ sin(ωx + ν)(1 + cos(ωx/γ))]` with `x = τ - πγ/ω`, over `2πγ/ω`: the pulse of Mavroeidis and Papageorgiou (2003), as a
    /// sum of three sinusoids.
    ///
    /// # Errors
    /// When a parameter is out of its range.
    pub fn mavroeidis_papageorgiou(amplitude: f64, omega: f64, gamma: f64, nu: f64) -> Result<Self, Invalid> {
        let gamma = Invalid::unless((1e-3..=1e3).contains(&gamma), "gamma", gamma, "1e-3 to 1e3")?;
        let nu = Invalid::unless(nu.abs() <= 1e3, "nu", nu, "-1000 to 1000 (radians)")?;
        // With A = ωx/γ and B = ωx + ν: (1 + γ)/2 sin(A + B) + (1 - γ)/2 sin(A - B) + γ sin B.
        let (carrier, envelope) = (nu - PI * gamma, -PI);
        let part = -amplitude / (2.0 * gamma);
        let term = |share: f64, omega: f64, phase: f64| {
            // sin(-ωτ + φ) = -sin(ωτ - φ)
            if omega < 0.0 {
                Sinusoid { amplitude: -share * part, omega: -omega, phase: -phase }
            } else {
                Sinusoid { amplitude: share * part, omega, phase }
            }
        };
        let terms = [
            term(0.5 * (1.0 + gamma), omega * (1.0 / gamma + 1.0), envelope + carrier),
            term(0.5 * (1.0 - gamma), omega * (1.0 / gamma - 1.0), envelope - carrier),
            term(gamma, omega, carrier),
        ];
        Self::pulse(omega, TAU * gamma, terms.into_iter().filter(|term| term.amplitude != 0.0).collect())
    }

    fn pulse(omega: f64, phase: f64, terms: Vec<Sinusoid>) -> Result<Self, Invalid> {
        let omega = Invalid::unless((1e-9..=1e9).contains(&omega), "omega", omega, "1e-9 to 1e9")?;
        Self::sinusoids(vec![Stretch { until: phase / omega, terms }])
    }

    /// Sums of sinusoids, one stretch after another.
    ///
    /// # Errors
    /// When there is none, one does not end after the one before, or a term is out of its range.
    pub fn sinusoids(stretches: Vec<Stretch>) -> Result<Self, Invalid> {
        let terms: usize = stretches.iter().map(|stretch| stretch.terms.len()).sum();
        if stretches.is_empty() || stretches.len() + terms > Self::MOST_TERMS {
            let given = format!("{} stretches of {terms}", stretches.len());
            return Err(Invalid::new("sinusoids", given, "1 to 1000 stretches and terms together"));
        }
        let mut before = 0.0;
        let last = stretches.len() - 1;
        for (place, Stretch { until, terms }) in stretches.iter().enumerate() {
            if !(*until > before && (until.is_finite() || place == last)) {
                let allowed = "above 0, each after the one before, and finite but for the last";
                return Err(Invalid::new("duration", format!("{until:?}"), allowed));
            }
            before = *until;
            for Sinusoid { amplitude, omega, phase } in terms {
                Invalid::unless(amplitude.abs() <= Self::MOST, "amplitude", *amplitude, "-1e6 to 1e6 thresholds")?;
                Invalid::unless((0.0..=1e9).contains(omega), "omega", *omega, "0 to 1e9")?;
                if until.is_finite() {
                    Self::check_cycles("duration", *until, *omega)?;
                }
                Invalid::unless(phase.abs() <= 1e5, "phase", *phase, "-1e5 to 1e5 (radians)")?;
            }
        }
        Ok(Self::Sinusoids(stretches))
    }

    /// A wavelet of Ricker.
    ///
    /// # Errors
    /// When a parameter is out of its range.
    pub fn ricker(ricker: Ricker) -> Result<Self, Invalid> {
        let Ricker { amplitude, omega, center, .. } = ricker;
        Invalid::unless(amplitude.abs() <= Self::MOST, "amplitude", amplitude, "-1e6 to 1e6 thresholds")?;
        Invalid::unless((1e-9..=1e9).contains(&omega), "omega", omega, "1e-9 to 1e9")?;
        Invalid::unless(center > 0.0 && center <= 1e9, "center", center, "above 0, up to 1e9 (in τ)")?;
        Self::check_cycles("center", center, 2.0 * omega)?;
        Ok(Self::Ricker(ricker))
    }

    fn check_cycles(field: &'static str, time: f64, omega: f64) -> Result<(), Invalid> {
        let allowed = "up to 10000 cycles of the fastest part of the motion (in τ)";
        Invalid::unless(time * omega <= TAU * Self::MOST_CYCLES, field, time, allowed).map(|_| ())
    }

    /// Samples `dt` apart, each times `scale`.
    ///
    /// # Errors
    /// When there are fewer than two, one is not finite, or the step or the scale is out of its range.
    pub fn record(dt: f64, scale: f64, samples: Vec<f64>) -> Result<Self, Invalid> {
        Invalid::unless((1e-9..=1e9).contains(&dt), "dt", dt, "1e-9 to 1e9 (in τ)")?;
        Invalid::unless(scale.abs() <= Self::MOST, "scale", scale, "-1e6 to 1e6")?;
        if !(2..=Self::MOST_SAMPLES).contains(&samples.len()) {
            return Err(Invalid::new("samples", samples.len(), "2 to 10000000"));
        }
        let fits = |sample: &f64| (sample * scale).abs() <= Self::MOST;
        if let Some(sample) = samples.iter().find(|sample| !fits(sample)) {
            return Err(Invalid::new("sample", format!("{sample:?}"), "finite, up to 1e6 thresholds"));
        }
        Ok(Self::Record(Record { dt, scale, samples: samples.into() }))
    }

    /// When it ends, `τ`; infinite if it does not.
    pub fn duration(&self) -> f64 {
        match self {
            Self::Sinusoids(stretches) => stretches.last().map_or(0.0, |last| last.until),
            Self::Ricker(Ricker { center, .. }) => 2.0 * center,
            Self::Record(record) => record.dt * (record.samples.len().saturating_sub(1)) as f64,
        }
    }

    /// The same motion, `factor` times as strong.
    ///
    /// # Errors
    /// When that is out of range.
    pub fn scaled(&self, factor: f64) -> Result<Self, Invalid> {
        match self {
            Self::Sinusoids(stretches) => {
                let scaled = |term: &Sinusoid| Sinusoid { amplitude: term.amplitude * factor, ..*term };
                let stretch = |of: &Stretch| Stretch { until: of.until, terms: of.terms.iter().map(scaled).collect() };
                Self::sinusoids(stretches.iter().map(stretch).collect())
            }
            Self::Ricker(of) => Self::ricker(Ricker { amplitude: of.amplitude * factor, ..*of }),
            Self::Record(of) => {
                let scale = of.scale * factor;
                Invalid::unless(scale.abs() <= Self::MOST, "scale", scale, "-1e6 to 1e6")?;
                Ok(Self::Record(Record { scale, ..of.clone() }))
            }
        }
    }
}
