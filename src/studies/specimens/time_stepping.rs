use contract::Case;

use super::{Conclusion, Landing, Response, Run, SAMPLES, Specimen, half_period};

/// The time stepping of Moreau and Jean for the one degree of freedom of the block, with a fixed step `h`: the rotation is looked at in the middle
/// of each step. Away from the base, the velocity changes by the acceleration there. Where the middle is at the base or beyond, the reaction is
/// anything from that of one edge to that of the other (`Sgn(0) = [-1, 1]` in Eq. 4): if that can hold the block, it stays; if not, it goes over
/// with the velocity of Eq. 13, or is lifted if it had none. No impact time is looked for, so none can be lost at an accumulation point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoreauJean {
    /// The step, in `τ`, at the most: half a period is cut into whole ones.
    pub step: f64,
}

/// The velocity, in steps, that the scheme can't tell from rest: a step changes the velocity by up to `2 h`, and so the place at which it finds an
/// impact adds as much to it, while an impact takes away `1 - η` of it. A block that should rest can rattle with `2 h/(1 - η)` for ever.
fn rattle(case: &Case) -> f64 {
    2.0 / (1.0 - case.eta())
}

/// The block in the middle of the run.
struct State {
    tau: f64,
    rotation: f64,
    velocity: f64,
    /// The sign of the flight.
    sign: f64,
}

impl MoreauJean {
    /// A step of length `h`; whether the block went over to the other side.
    fn step(case: &Case, psi: f64, h: f64, state: &mut State) -> bool {
        let middle = state.rotation + 0.5 * h * state.velocity;
        let excitation = case.amplitude() * (case.omega() * (state.tau + 0.5 * h) + psi).sin();
        let without_base = state.velocity + h * (middle - excitation);
        let is_over = state.sign * middle <= 0.0;
        let is_held = is_over && without_base.abs() <= h;
        let goes_over = is_over && !is_held && state.velocity != 0.0;
        if is_held {
            state.velocity = 0.0;
        } else if goes_over {
            state.sign = -state.sign;
            state.velocity *= case.eta();
        } else {
            if is_over {
                state.sign = without_base.signum();
            }
            state.velocity = without_base - h * state.sign;
        }
        // The middle of the step was reached with the old velocity, its end is with the new one.
        state.rotation = middle + 0.5 * h * state.velocity;
        state.tau += h;
        goes_over
    }
}

impl Specimen for MoreauJean {
    fn family(&self) -> &'static str {
        "Moreau-Jean"
    }

    fn setting(&self) -> String {
        format!("step {:e}", self.step)
    }

    fn run(&self, case: &Case) -> Option<Run> {
        let half_period = half_period(case);
        // Whole steps between the times at which the response is looked at.
        let between = (half_period / SAMPLES as f64 / self.step).ceil().max(1.0);
        let h = half_period / SAMPLES as f64 / between;
        let (psi, rattle) = ((1.0 / case.amplitude()).asin(), rattle(case) * h);
        let mut state = State { tau: 0.0, rotation: 0.0, velocity: 0.0, sign: -1.0 };
        let (mut impacts, mut response) = (Vec::new(), Vec::with_capacity(SAMPLES));
        let (mut last, mut moved) = (0.0, 0.0);
        for sample in 0..2 * SAMPLES {
            for _ in 0..between as usize {
                let (before, rotation, velocity) = (state.tau, state.rotation, state.velocity);
                if Self::step(case, psi, h, &mut state) && sample < SAMPLES && moved >= before {
                    let time = (before - rotation / velocity).clamp(before, state.tau);
                    impacts.push(Landing { time, interval: time - last, velocity: state.velocity });
                    last = time;
                }
                if sample < SAMPLES && state.velocity.abs() > rattle {
                    moved = state.tau;
                }
            }
            if sample >= SAMPLES {
                response.push(state.rotation);
            }
        }
        let rests = moved < half_period - h;
        let conclusion = if rests { Conclusion::Rests(moved) } else { Conclusion::Rocks };
        let evaluations = Some((2.0 * SAMPLES as f64 * between) as u64);
        Some(Run { impacts, conclusion, response: Some(Response(response)), evaluations })
    }
}
