/// A sum with the rounding errors of its additions carried along (Neumaier): more than 1000 terms, right to an ulp or two.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Compensated {
    sum: f64,
    lost: f64,
}

impl Compensated {
    pub(crate) fn add(&mut self, term: f64) {
        let sum = self.sum + term;
        self.lost += if self.sum.abs() >= term.abs() { (self.sum - sum) + term } else { (term - sum) + self.sum };
        self.sum = sum;
    }

    pub(crate) fn value(&self) -> f64 {
        self.sum + self.lost
    }
}

#[cfg(test)]
mod tests {
    use super::Compensated;

    #[test]
    fn keeps_what_plain_addition_loses() {
        let mut sum = Compensated::default();
        for term in [1.0, 1e100, 1.0, -1e100] {
            sum.add(term);
        }
        assert_eq!(sum.value(), 2.0);
    }

    /// What is lost is found again on whichever side it was, and its own sum is exact while it has few digits.
    #[test]
    fn what_cancels_leaves_what_was_lost() {
        for (terms, expected) in [
            (&[1.0, 1e-20, -1.0][..], 1e-20),
            (&[1e-20, 1.0, -1.0], 1e-20),
            (&[1e-20, 1.0, 1e-20, 4.0, -1.0, -4.0], 2e-20),
            (&[-3.0, 1e-18, -1e-18, 3.0], 0.0),
            (&[1e16, 1.0, 1.0, 1.0, -1e16], 3.0),
        ] {
            let mut sum = Compensated::default();
            terms.iter().for_each(|&term| sum.add(term));
            assert_eq!(sum.value(), expected, "{terms:?}");
        }
    }
}
