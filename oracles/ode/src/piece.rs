//! What happened between the two ends of a step, as far as the values at the two ends can tell.

/// A solver's state at one time: rotation, velocity, acceleration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Knot {
    pub t: f64,
    pub y: f64,
    pub dy: f64,
    pub ddy: f64,
}

impl Knot {
    pub fn is_finite(&self) -> bool {
        (self.t + self.y + self.dy + self.ddy).is_finite()
    }
}

/// The quintic that has the values and the first two derivatives of both ends (Hermite), in Bernstein form.
///
/// Its error falls as the sixth power of the step, so it is no worse than any method here, and better than most dense outputs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece {
    start: f64,
    length: f64,
    bernstein: [f64; 6],
}

impl Piece {
    pub fn between(from: &Knot, to: &Knot) -> Self {
        let h = to.t - from.t;
        let (d0, s0) = (0.2 * h * from.dy, 0.05 * h * h * from.ddy);
        let (d1, s1) = (0.2 * h * to.dy, 0.05 * h * h * to.ddy);
        Self {
            start: from.t,
            length: h,
            bernstein: [from.y, from.y + d0, from.y + 2.0 * d0 + s0, to.y - 2.0 * d1 + s1, to.y - d1, to.y],
        }
    }

    /// How often the Bernstein coefficients change their sign, zeros not counted. By the rule of signs there are that many roots inside
    /// the step, or fewer by an even number: none for 0, one for 1, and doubt for more.
    pub fn sign_changes(&self) -> usize {
        let mut last = 0.0_f64;
        let mut changes = 0;
        for &b in &self.bernstein {
            if b != 0.0 {
                changes += usize::from(last * b.signum() < 0.0);
                last = b.signum();
            }
        }
        changes
    }

    /// Value and derivative at the time `t`, by de Casteljau's scheme.
    pub fn at(&self, t: f64) -> (f64, f64) {
        let x = (t - self.start) / self.length;
        let mid = |p: f64, q: f64| p + (q - p) * x;
        let [a, b, c, d, e, f] = self.bernstein;
        let [a, b, c, d, e] = [mid(a, b), mid(b, c), mid(c, d), mid(d, e), mid(e, f)];
        let [a, b, c, d] = [mid(a, b), mid(b, c), mid(c, d), mid(d, e)];
        let [a, b, c] = [mid(a, b), mid(b, c), mid(c, d)];
        let [a, b] = [mid(a, b), mid(b, c)];
        (mid(a, b), 5.0 * (b - a) / self.length)
    }

    /// The root next to `guess`, by Newton's method, and the derivative there.
    pub fn root_near(&self, guess: f64) -> (f64, f64) {
        let mut t = guess;
        for _ in 0..2 {
            let (y, dy) = self.at(t);
            t -= y / dy;
        }
        (t, self.at(t).1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn knot(t: f64) -> Knot {
        // y = t (1 - t) (2 - t) = 2t - 3t^2 + t^3
        Knot { t, y: t * (1.0 - t) * (2.0 - t), dy: 2.0 - 6.0 * t + 3.0 * t * t, ddy: 6.0 * t - 6.0 }
    }

    #[test]
    fn reproduces_a_cubic_and_its_roots() {
        let piece = Piece::between(&knot(0.25), &knot(1.5));
        let (y, dy) = piece.at(0.7);
        assert!((y - knot(0.7).y).abs() < 1e-15 && (dy - knot(0.7).dy).abs() < 1e-14);
        assert_eq!(piece.sign_changes(), 1);
        let (root, slope) = piece.root_near(1.01);
        assert!((root - 1.0).abs() < 1e-14 && (slope + 1.0).abs() < 1e-13);
    }

    #[test]
    fn counts_roots() {
        assert_eq!(Piece::between(&knot(0.0), &knot(0.9)).sign_changes(), 0);
        assert!(Piece::between(&knot(0.5), &knot(2.5)).sign_changes() == 2, "a dip below zero inside the step is seen");
    }

    /// A polynomial of degree five is the one that its ends describe; `t = 1` is a root of it, and there are signs of no other in the step.
    #[test]
    fn reproduces_a_quintic_on_any_step() {
        // y = (1 - t) (1 + t^4)
        let knot = |t: f64| Knot {
            t,
            y: (1.0 - t) * (1.0 + t.powi(4)),
            dy: 4.0 * t.powi(3) - 5.0 * t.powi(4) - 1.0,
            ddy: 12.0 * t.powi(2) - 20.0 * t.powi(3),
        };
        for (from, to) in [(0.8, 1.3), (-0.5, 1.25), (0.99, 1.002)] {
            let piece = Piece::between(&knot(from), &knot(to));
            for share in [0.0, 0.1, 0.37, 0.5, 0.9, 1.0] {
                let t = from + share * (to - from);
                let (y, dy) = piece.at(t);
                assert!((y - knot(t).y).abs() < 1e-14 && (dy - knot(t).dy).abs() < 1e-12, "{from} {to} {t}");
            }
            let (root, slope) = piece.root_near(1.0 + 1e-4 * (to - from));
            assert!((root - 1.0).abs() < 1e-13 && (slope + 2.0).abs() < 1e-12, "{from} {to}: {root} {slope}");
        }
        assert!(
            !Knot { dy: f64::NAN, ..knot(0.0) }.is_finite() && !Knot { ddy: f64::INFINITY, ..knot(0.0) }.is_finite()
        );
        assert!(!Knot { y: f64::NEG_INFINITY, ..knot(0.0) }.is_finite() && knot(0.5).is_finite());
    }
}
