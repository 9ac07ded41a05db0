//! The excitation, without the cancellation where it balances gravity.
//!
//! With `sin ψ = 1/a` (Eq. 12), `f = a sin(ωτ + ψ) = cos 2θ + q sin 2θ`, where `θ = ωτ/2` and `q = a cos ψ = sqrt(ε(2 + ε))`. Hence
//! `1 - f = 2 sin θ (sin θ - q cos θ)` and `1 + f = 2 cos θ (cos θ + q sin θ)`: products of small numbers where they are small.

use crate::{
    directed::Directed,
    functions::sin_cos,
    ground::{Ground, Window},
    interval::Interval,
    pull::{Bend, Pull, Side, Wave},
};

/// The constants of an excitation.
pub struct Excitation<F> {
    /// `ω`.
    pub omega: Interval<F>,
    omega_squared: Interval<F>,
    /// `a ω²`.
    bend: Interval<F>,
    /// `q = sqrt(ε(2 + ε))`.
    quadrature: Interval<F>,
    /// `a = 1 + ε`.
    pub amplitude: Interval<F>,
    /// Every pull that there can be.
    any: Pull<f64>,
}

/// Where in its period the excitation is: the sine and the cosine of `θ = ωτ/2`.
#[derive(Clone)]
pub struct HalfPhase<F> {
    sine: Interval<F>,
    cosine: Interval<F>,
}

impl<F: Directed> Excitation<F> {
    /// The excitation whose amplitude is `1 + epsilon` times the threshold.
    pub fn new(epsilon: &Interval<F>, omega: f64) -> Self {
        let two = Interval::exactly(2.0);
        let amplitude = epsilon + &Interval::exactly(1.0);
        let (bound, rate) = (amplitude.convert::<f64>(), Interval::<f64>::exactly(omega));
        let value = Interval::within(bound.magnitude());
        let slope = &rate * &value;
        let wave = Wave { omega_squared: rate.squared(), value: value.clone(), slope: slope.clone() };
        let any = Pull { value: &Interval::exactly(1.0) + &value, slope, bend: Bend::Waves(vec![wave]) };
        let omega = Interval::exactly(omega);
        let omega_squared = omega.squared();
        let bend = &amplitude * &omega_squared;
        Self { omega, omega_squared, bend, quadrature: (epsilon * &(epsilon + &two)).root(), amplitude, any }
    }

    /// Between which multiples of the time that is left to the end of the half period the pull is until then, on the side on which it vanishes there; `None` for the
    /// other side, and where it does not fall all the way.
    ///
    /// With `σ = ω s` the pull is `1 - cos σ + q sin σ`; over `σ` it lies between `q (1 - σ²/6) + σ/2 - σ³/24`, which is least at one end, and `q + σ/2`.
    pub fn fall_to_half_period(&self, left: &Interval<F>, side: Side) -> Option<Interval<F>> {
        let angle = &self.omega * left;
        let falls = Interval::exactly(1.5);
        if side == Side::Minus || !angle.is_below(&falls) {
            return None;
        }
        let q = &self.quadrature;
        let (square, half) = (angle.squared(), &angle * &Interval::exactly(0.5));
        let lost = &(&square / &Interval::exactly(6.0)) * &(q + &(&angle * &Interval::exactly(0.25)));
        let most = q + &half;
        Some(&self.omega * &q.or(&most).or(&(&most - &lost)))
    }

    /// The same with other digits.
    pub fn convert<G: Directed>(&self) -> Excitation<G> {
        Excitation {
            omega: self.omega.convert(),
            omega_squared: self.omega_squared.convert(),
            bend: self.bend.convert(),
            quadrature: self.quadrature.convert(),
            amplitude: self.amplitude.convert(),
            any: self.any.clone(),
        }
    }
}

impl<F: Directed> Ground<F> for Excitation<F> {
    type Moment = HalfPhase<F>;

    /// Turning the phase keeps what is small accurate, at a cost in width that is at most `exp(θ)` in all.
    fn later(&self, phase: &HalfPhase<F>, interval: &Interval<F>) -> HalfPhase<F> {
        let half_turn = &(&self.omega * interval) * &Interval::exactly(0.5);
        let (sine, cosine) = sin_cos(&half_turn);
        let unit = Interval::within(1.0);
        HalfPhase {
            sine: (&(&phase.sine * &cosine) + &(&phase.cosine * &sine)).and(&unit),
            cosine: (&(&phase.cosine * &cosine) - &(&phase.sine * &sine)).and(&unit),
        }
    }

    fn pull(&self, phase: &HalfPhase<F>, side: Side) -> Pull<F> {
        let HalfPhase { sine: s, cosine: c } = phase;
        let two = Interval::exactly(2.0);
        let q = &self.quadrature;
        let value = match side {
            Side::Minus => &(&two * s) * &(s - &(q * c)),
            Side::Plus => &(&two * c) * &(c + &(q * s)),
        };
        // f' = ω (q cos 2θ - sin 2θ)
        let rate = &self.omega * &(&(q * &(&c.squared() - &s.squared())) - &(&two * &(s * c)));
        let slope = side.of(&rate);
        let wave = Wave {
            omega_squared: self.omega_squared.clone(),
            value: &value - &Interval::exactly(1.0),
            slope: slope.clone(),
        };
        Pull { value, slope, bend: Bend::Waves(vec![wave]) }
    }

    /// Every pull of any moment.
    fn any_pull(&self, _: &HalfPhase<F>, _: Side, _: f64) -> Pull<f64> {
        self.any.clone()
    }

    fn change(&self, _: &HalfPhase<F>) -> Option<(Interval<F>, HalfPhase<F>)> {
        None
    }

    fn window(&self, _: &HalfPhase<F>, _: Side, pull: &Pull<F>, length: &Interval<F>) -> Option<Window<F>> {
        // b' changes by at most a ω² in a unit of time.
        Some(Window::bent(pull, &self.bend, length))
    }

    fn amplitude(&self) -> &Interval<F> {
        &self.amplitude
    }
}

impl<F: Directed> HalfPhase<F> {
    /// At initiation.
    pub fn start() -> Self {
        Self { sine: Interval::zero(), cosine: Interval::exactly(1.0) }
    }

    /// The same with other digits.
    pub fn convert<G: Directed>(&self) -> HalfPhase<G> {
        HalfPhase { sine: self.sine.convert(), cosine: self.cosine.convert() }
    }
}
