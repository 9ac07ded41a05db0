//! When the ground first pushes a block that rests, and how long it does: never past the first such time, by steps that bounds on the motion allow.

use contract::{Decline, Motion};

use super::ground::{Piece, pieces};

/// How rocking begins.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start<'a> {
    /// When.
    pub time: f64,
    /// The sign of `f`.
    pub sign: f64,
    /// Whether `|f|` is 1 there; otherwise it jumps past it.
    pub crosses: bool,
    /// The piece that it begins in.
    pub piece: Piece<'a>,
}

/// More than any motion takes that the contract allows, but for one that touches the threshold again and again.
const MOST_STEPS: usize = 20_000_000;

/// The first time from `from` to `until` at which `|f|` reaches 1.
pub(super) fn next_start(motion: &Motion, from: f64, until: f64) -> Result<Option<Start<'_>>, Decline> {
    let mut steps = 0;
    for piece in pieces(motion, from) {
        let mut time = piece.from.max(from);
        let end = piece.to.min(until);
        let (value, _) = piece.at(time);
        if time < end && value.abs() > 1.0 + piece.unsure {
            return Ok(Some(Start { time, sign: value.signum(), crosses: false, piece }));
        }
        while time < end {
            let (value, slope) = piece.at(time);
            let sign = value.signum();
            if value.abs() >= 1.0 - piece.unsure && slope * sign > 0.0 {
                return Ok(Some(Start { time, sign, crosses: true, piece }));
            }
            let free = [sign, -sign].map(|sign| stays(1.0 - sign * value, -sign * slope, piece.curvature));
            time = forward(time, free[0].min(free[1]));
            steps += 1;
            if steps > MOST_STEPS {
                return Err(Decline::NotConvergent {
                    why: format!("the ground stays next to the threshold at tau = {time}"),
                });
            }
        }
        if piece.to >= until {
            break;
        }
    }
    Ok(None)
}

/// From when on `|f|` is below 1 again, in the piece of the start; its end if that comes first.
pub(super) fn push_ends(start: &Start) -> f64 {
    let Start { piece, sign, .. } = start;
    let (_, slope) = piece.at(start.time);
    // From the threshold itself at first only the slope tells.
    let mut time = start.time + if start.crosses { first_step(sign * slope, piece) } else { 0.0 };
    for _ in 0..MOST_STEPS {
        if time >= piece.to {
            return piece.to;
        }
        let (value, slope) = piece.at(time);
        let margin = sign * value - 1.0;
        if margin <= piece.unsure && sign * slope < 0.0 {
            break;
        }
        time = forward(time, stays(margin, sign * slope, piece.curvature));
    }
    time
}

fn first_step(slope: f64, piece: &Piece) -> f64 {
    if piece.curvature > 0.0 { slope / piece.curvature } else { f64::INFINITY }
}

/// How long a margin stays positive at least that changes at a rate, itself changing at no more than `curvature`: until `margin + rate s - curvature s²/2` is 0.
fn stays(margin: f64, rate: f64, curvature: f64) -> f64 {
    let margin = margin.max(0.0);
    let root = (rate * rate + 2.0 * curvature * margin).sqrt();
    if rate < 0.0 {
        2.0 * margin / (root - rate)
    } else if curvature > 0.0 {
        (rate + root) / curvature
    } else {
        f64::INFINITY
    }
}

/// Later by a step, by one ulp at least.
fn forward(time: f64, step: f64) -> f64 {
    (time + step).max(time.next_up())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_push_begins_and_ends_where_the_sine_says() {
        for (a, mirrored) in [(1.02, 1.0), (1.0 + 1e-9, 1.0), (3.0, -1.0)] {
            let motion = Motion::one_sine(a * mirrored, 2.0).unwrap();
            let start = next_start(&motion, 0.0, 10.0).unwrap().unwrap();
            let angle = (1.0 / a).asin();
            let off = 1e-15 / (1.0 - 1.0 / (a * a)).sqrt();
            assert!((start.time - 0.5 * angle).abs() < off && start.sign == mirrored && start.crosses, "{start:?}");
            assert!((push_ends(&start) - 0.5 * (std::f64::consts::PI - angle)).abs() < off, "{a}");
            let second = next_start(&motion, push_ends(&start), 10.0).unwrap().unwrap();
            assert!((second.time - 0.5 * (std::f64::consts::PI + angle)).abs() < off && second.sign == -mirrored);
            assert!(next_start(&motion, 0.0, start.time - off).unwrap().is_none());
        }
        assert!(next_start(&Motion::one_sine(0.999_999_9, 2.0).unwrap(), 0.0, f64::INFINITY).unwrap().is_none());
    }

    #[test]
    fn jumps_and_samples_above_the_threshold_are_starts() {
        let cosine = Motion::one_cosine(-1.2, 3.0).unwrap();
        let start = next_start(&cosine, 0.0, 1.0).unwrap().unwrap();
        assert!(start.time == 0.0 && start.sign == -1.0 && !start.crosses);
        let record = Motion::record(0.5, 1.0, vec![0.0, 0.5, 1.5, 0.0, 0.0]).unwrap();
        let start = next_start(&record, 0.0, 9.0).unwrap().unwrap();
        assert!((start.time - 0.75).abs() < 1e-15 && start.crosses && start.piece.from == 0.5, "{start:?}");
        assert_eq!(push_ends(&start), 1.0);
    }
}
