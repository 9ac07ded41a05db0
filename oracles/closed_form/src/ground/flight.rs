//! One flight in closed form, from its start to anywhere: nothing is handed over where the pull changes, so nothing is lost there, and nothing cancels
//! however short the flight is.

use super::{
    kernels::{of_cosine, of_level, of_line, of_sine},
    pull::Change,
};

/// A flight under a pull that changes now and then.
pub struct Flight {
    /// The rotation away from the base at the start, and the velocity.
    pub start: (f64, f64),
    /// In order; the first is at 0.
    pub changes: Vec<Change>,
}

/// The pull and its slope.
#[derive(Debug, Clone, Copy)]
pub struct Pull {
    pub value: f64,
    pub slope: f64,
}

impl Flight {
    /// The rotation and the velocity a time `s` after the start.
    pub fn at(&self, s: f64) -> (f64, f64) {
        let ((cosh_less_one, sinh), (u, v)) = (of_level(s), self.start);
        let (mut rotation, mut velocity) = (u + u * cosh_less_one + v * sinh, v + v * cosh_less_one + u * sinh);
        for change in self.changes.iter().take_while(|change| change.at < s) {
            let (by, rate) = change.drives(s - change.at);
            rotation -= by;
            velocity -= rate;
        }
        (rotation, velocity)
    }

    /// The pull at `s` and its slope, as before a change at that very time.
    pub fn pull(&self, s: f64) -> Pull {
        let mut pull = Pull { value: 0.0, slope: 0.0 };
        for change in self.changes.iter().take_while(|change| change.at < s || change.at == 0.0) {
            let r = s - change.at;
            pull.value += change.level + change.slope * r;
            pull.slope += change.slope;
            for wave in &change.waves {
                let (sin, cos) = (wave.omega * r).sin_cos();
                let half = (0.5 * wave.omega * r).sin();
                let sine = if wave.omega > 0.0 { sin / wave.omega } else { r };
                pull.value += wave.rate * sine - 2.0 * wave.value * half * half;
                pull.slope += wave.rate * cos - wave.value * wave.omega * sin;
            }
        }
        pull
    }

    /// The last change that is not after `s`, and when the next one is.
    pub fn piece(&self, s: f64) -> Option<(&Change, f64)> {
        let next = self.changes.iter().position(|change| change.at > s).unwrap_or(self.changes.len());
        let end = self.changes.get(next).map_or(f64::INFINITY, |change| change.at);
        Some((self.changes.get(next.checked_sub(1)?)?, end))
    }
}

impl Change {
    /// What it takes from the rotation and the velocity a time `r` later.
    fn drives(&self, r: f64) -> (f64, f64) {
        let (mut rotation, mut velocity) = of_line(r, self.level, self.slope);
        for wave in &self.waves {
            let (sine, cosine) = (of_sine(r, wave.omega), of_cosine(r, wave.omega));
            rotation += wave.rate * sine.0 + wave.value * cosine.0;
            velocity += wave.rate * sine.1 + wave.value * cosine.1;
        }
        (rotation, velocity)
    }
}
