use crate::kernels::Kernels;
use crate::number::{Number, real};
use crate::paper::even_flight;
use crate::series::Series;

/// The block at an impact, every quantity a power series in `ε`. With `θ = ω τ/ε^(1/2)` and `Φ = ω² φ/ε²`, Eq. 4 reads
/// `Φ'' = (ε/ω²) Φ + (-i - f)/ε`, where `f = cos(ε^(1/2) θ) + (2ε + ε²)^(1/2) sin(ε^(1/2) θ)` for `i_0 = -1` and `a = 1 + ε` (Eq. 14).
#[derive(Debug, Clone)]
pub(crate) struct State<T> {
    /// `θ` so far.
    pub(crate) x: Series<T>,
    /// `dΦ/dθ = ω φ'/ε^(3/2)` just after the impact.
    pub(crate) v: Series<T>,
    /// `g = (1 - f)/ε`, the acceleration of an even flight at its start.
    pub(crate) g: Series<T>,
    /// `h = dg/dθ`.
    pub(crate) h: Series<T>,
}

/// What is the same in all flights.
pub(crate) struct Block<T> {
    /// The coefficient of restitution.
    pub(crate) eta: T,
    /// `1/ω²`.
    pub(crate) q: T,
    /// What `ε` is counted in: 1, or something near its critical value, so that the coefficients stay in the range of a double.
    pub(crate) unit: T,
}

impl<T: Number> Block<T> {
    pub(crate) fn new(omega: f64, eta: f64) -> Self {
        let omega = real::<T>(omega);
        Self { eta: real(eta), q: T::one().over(omega * omega), unit: T::one() }
    }

    /// The same, with `ε` counted in `unit`.
    pub(crate) fn in_units_of(self, unit: f64) -> Self {
        Self { unit: real(unit), ..self }
    }

    /// `ε` times a series.
    fn epsilon_times(&self, series: &Series<T>) -> Series<T> {
        series.shifted().scaled(self.unit)
    }

    /// A duration counted in `θ`; that of an odd flight is one order up.
    fn in_theta(&self, d: &Series<T>, even: bool) -> Series<T> {
        if even { d.clone() } else { self.epsilon_times(d) }
    }

    /// The acceleration `(-i - f)/ε`, times what the duration in `θ` is longer than `d`.
    fn pull(&self, g: &Series<T>, even: bool) -> Series<T> {
        if even { g.clone() } else { self.epsilon_times(g).minus(&Series::constant(real(2.0), g.terms())) }
    }

    /// `f = 1 - ε g`, which is also `dh/dθ`.
    fn forcing(&self, g: &Series<T>) -> Series<T> {
        Series::constant(T::one(), g.terms()).minus(&self.epsilon_times(g))
    }
}

impl<T: Number> State<T> {
    /// At rest when the forcing reaches the threshold: `f = 1`, `df/dθ = ε (2 + ε)^(1/2)`.
    pub(crate) fn initiation(block: &Block<T>, terms: usize) -> Self {
        let zero = || Series::constant(T::zero(), terms);
        let root = Series::root_of_two_plus_epsilon(terms, block.unit);
        Self { x: zero(), v: zero(), g: zero(), h: root.scaled(-T::one()) }
    }

    /// The flight from here to the next impact: its duration, and the state there. Even flights (`i = i_0`) last `D ε^(1/2)/ω` with `D` of
    /// order 1; odd flights, which the forcing pushes back, `d ε^(3/2)/ω` (Eqs 43, 57 and 64).
    pub(crate) fn fly(&self, block: &Block<T>, even: bool) -> (Series<T>, Self) {
        let mut d = Series::constant(self.leading_duration(even), 1);
        let mut after = self.clone();
        for terms in doublings(self.x.terms()) {
            (d, after) = self.newton(block, even, &d, terms);
        }
        (block.in_theta(&d, even), after)
    }

    /// One step of Newton's method from a duration whose terms are known to `terms` of them, at most twice as many; and the state at its end.
    fn newton(&self, block: &Block<T>, even: bool, known: &Series<T>, terms: usize) -> (Series<T>, Self) {
        let d = known.with_terms(terms);
        let (v, g, h) = (self.v.with_terms(terms), self.g.with_terms(terms), self.h.with_terms(terms));
        let f = block.forcing(&g);
        let duration = block.in_theta(&d, even);
        let kernels = Kernels::new(&duration, block.q, block.unit);
        let ([s0, s1, s2], [p2, p3, p4]) = (&kernels.of_state, &kernels.of_forcing);
        let square = duration.times(&duration);
        let pulled = d.times(&block.pull(&g, even));
        let fd = f.times(&duration);
        // Φ/D, the known root at the start divided out, and dΦ/dθ at the end.
        let rotation = v.times(s1).plus(&pulled.times(s2)).plus(&square.times(&h.times(p3).plus(&fd.times(p4))));
        let velocity = v.times(s0).plus(&pulled.times(s1)).plus(&square.times(&h.times(p2).plus(&fd.times(p3))));
        // Those terms that were known stay as they are.
        let mut step = d.times(&rotation).over(&velocity);
        step.0.iter_mut().take(known.terms()).for_each(|term| *term = T::zero());
        // The state belongs to the duration before the step; to the order kept a step changes it in proportion.
        let step_in_theta = block.in_theta(&step, even);
        let [c0, c1, c2] = &kernels.of_phase;
        let g = g.plus(&square.times(&f).times(c2)).plus(&h.times(&duration).times(c1));
        let h = h.times(c0).plus(&fd.times(c1));
        let velocity = velocity.minus(&block.pull(&g, even).times(&step));
        let d = d.minus(&step);
        let after = Self {
            x: self.x.plus(&block.in_theta(&d, even)),
            v: velocity.scaled(block.eta),
            g: g.minus(&h.times(&step_in_theta)),
            h: h.minus(&block.forcing(&g).times(&step_in_theta)),
        };
        (d, after)
    }

    /// The paper's order: the root of the cubic of Eq. 62, or Eq. 64.
    fn leading_duration(&self, even: bool) -> T {
        let (x, v, g, h) = (self.x.leading(), self.v.leading(), self.g.leading(), self.h.leading());
        if !even {
            return v;
        }
        let mut duration: T = real(even_flight::duration(x.rounded(), v.rounded()));
        let [two, three, six, eight, twenty_four] = [2.0, 3.0, 6.0, 8.0, 24.0].map(real);
        // From a double's precision to that of two.
        for _ in 0..2 {
            let cubic = v + duration * (g.over(two) + duration * (h.over(six) + duration.over(twenty_four)));
            let slope = g.over(two) + duration * (h.over(three) + duration.over(eight));
            duration = duration - cubic.over(slope);
        }
        duration
    }
}

/// Numbers of terms from 1, each at most twice the one before, up to `terms`.
fn doublings(terms: usize) -> Vec<usize> {
    let mut counts: Vec<usize> =
        std::iter::successors(Some(terms), |&terms| (terms > 2).then(|| terms.div_ceil(2))).collect();
    counts.reverse();
    counts
}
