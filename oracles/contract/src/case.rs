use crate::Invalid;

/// One dimensionless problem. Its fields can only hold allowed values.
///
/// Each number *is* the double that is stored: truths are computed for its exact value, not for the decimal that was typed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Case {
    epsilon: f64,
    omega: f64,
    eta: f64,
    slenderness: Option<Slenderness>,
    max_impacts: usize,
    horizon: Horizon,
}

/// How slender the block is, for the models that need it, and what the amplitude is measured against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slenderness {
    alpha: f64,
    normalisation: Normalisation,
}

/// What the dimensionless amplitude `a` is a multiple of. The largest modelling error there is comes from mistaking one for the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Normalisation {
    /// `ü_g = a g tan(α) sin(ωτ + ψ)`: rocking starts at exactly `a = 1` (Eq. 1). Models may be compared under this one.
    Threshold,
    /// `ü_g = a g α sin(ωτ + ψ)`: the slender approximation of Eq. 5. Rocking starts at `a = tan(α)/α`.
    Slender,
}

/// How far a history is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Horizon {
    /// To half a period of the excitation, `T/2 = π/ω`: chattering that is not complete by then is incomplete.
    HalfPeriod,
    /// To the dimensionless time `τ` given, past `T/2` if the block still rocks there.
    Until(f64),
}

impl Slenderness {
    /// A block with slenderness angle `alpha` in radians, whose excitation amplitude is normalised as named.
    ///
    /// # Errors
    /// When `alpha` is not inside [1e-100, π/2). Where its square is no number any more, methods would lose digits without a sign of it.
    pub fn new(alpha: f64, normalisation: Normalisation) -> Result<Self, Invalid> {
        let inside = (1e-100..core::f64::consts::FRAC_PI_2).contains(&alpha);
        let alpha = Invalid::unless(inside, "alpha", alpha, "1e-100 <= alpha < pi/2 (radians)")?;
        Ok(Self { alpha, normalisation })
    }

    /// The slenderness angle `α = atan(b/h)` in radians.
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// What the amplitude is a multiple of.
    pub fn normalisation(&self) -> Normalisation {
        self.normalisation
    }
}

impl Case {
    /// How many impacts a history lists unless told otherwise.
    pub const DEFAULT_IMPACTS: usize = 60;
    /// How many impacts a history may be asked to list.
    pub const MOST_IMPACTS: usize = 1_000_000;

    /// A case given by `epsilon = a - 1`, the distance to the threshold, without the rounding of `a` (Eq. 14).
    ///
    /// # Errors
    /// When `epsilon` is not inside [-1, 1e9], `omega` is not positive, `eta` is not inside (0, 1), or any is not finite.
    pub fn from_epsilon(epsilon: f64, omega: f64, eta: f64) -> Result<Self, Invalid> {
        let epsilon = Invalid::unless((-1.0..=1e9).contains(&epsilon), "epsilon", epsilon, "-1 <= epsilon <= 1e9")?;
        let omega = Invalid::unless(omega > 0.0, "omega", omega, "omega > 0 and finite")?;
        let eta = Invalid::unless(eta > 0.0 && eta < 1.0, "eta", eta, "0 < eta < 1")?;
        Ok(Self {
            epsilon,
            omega,
            eta,
            slenderness: None,
            max_impacts: Self::DEFAULT_IMPACTS,
            horizon: Horizon::HalfPeriod,
        })
    }

    /// A case given by the amplitude `a`. `a - 1` is exact for every double from 1/2 up, so nothing is lost.
    ///
    /// # Errors
    /// As [`Case::from_epsilon`], with `a` inside [0, 1e9].
    pub fn from_amplitude(a: f64, omega: f64, eta: f64) -> Result<Self, Invalid> {
        let a = Invalid::unless((0.0..=1e9).contains(&a), "a", a, "0 <= a <= 1e9")?;
        Self::from_epsilon(a - 1.0, omega, eta)
    }

    /// The same case for a block of this slenderness.
    #[must_use]
    pub fn with_slenderness(self, slenderness: Slenderness) -> Self {
        Self { slenderness: Some(slenderness), ..self }
    }

    /// The same case, listing `max_impacts` impacts at the most.
    ///
    /// # Errors
    /// When `max_impacts` is 0 or above [`Case::MOST_IMPACTS`].
    pub fn with_max_impacts(self, max_impacts: usize) -> Result<Self, Invalid> {
        if max_impacts == 0 || max_impacts > Self::MOST_IMPACTS {
            return Err(Invalid::new("impacts", max_impacts, "1 <= impacts <= 1000000"));
        }
        Ok(Self { max_impacts, ..self })
    }

    /// The same case, followed as far as `horizon`.
    ///
    /// # Errors
    /// When the horizon is a time that is not positive and finite.
    pub fn with_horizon(self, horizon: Horizon) -> Result<Self, Invalid> {
        if let Horizon::Until(tau) = horizon {
            Invalid::unless(tau > 0.0, "until", tau, "until > 0 and finite")?;
        }
        Ok(Self { horizon, ..self })
    }

    /// `ε = a - 1`: how far the amplitude is above the threshold of Eq. 1 (or of Eq. 5, see [`Normalisation`]).
    pub fn epsilon(&self) -> f64 {
        self.epsilon
    }

    /// The amplitude `a = 1 + ε`, rounded where `ε` has more digits than a double near 1 can hold.
    pub fn amplitude(&self) -> f64 {
        1.0 + self.epsilon
    }

    /// The frequency ratio `ω = ω_g/p`.
    pub fn omega(&self) -> f64 {
        self.omega
    }

    /// The coefficient of restitution `η` of Eq. 13.
    pub fn eta(&self) -> f64 {
        self.eta
    }

    /// The block's slenderness, where the case has one.
    pub fn slenderness(&self) -> Option<Slenderness> {
        self.slenderness
    }

    /// How many impacts a history lists at the most.
    pub fn max_impacts(&self) -> usize {
        self.max_impacts
    }

    /// How far the history is followed.
    pub fn horizon(&self) -> Horizon {
        self.horizon
    }
}
