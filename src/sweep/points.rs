//! The points of a sweep: all combinations of the values of its axes, the last axis fastest. Random axes vary together, as one axis in the place of the first
//! of them.

use super::{Axis, Value};

/// The points of some axes, by number.
#[derive(Debug, Clone, PartialEq)]
pub struct Points {
    dimensions: Vec<Dimension>,
    seed: u64,
    count: usize,
}

#[derive(Debug, Clone, PartialEq)]
struct Dimension {
    axis: Axis,
    /// After how many points it takes its next value.
    step: usize,
    /// How many values it has.
    count: usize,
    /// The values, and how each is written in a table; nothing where they are too many to be kept.
    known: Vec<(Value, String)>,
}

/// The most values of an axis that are kept.
const MOST_KNOWN: usize = 1 << 20;

impl Dimension {
    fn new(axis: Axis, step: usize, seed: u64) -> Self {
        let count = axis.spread.count();
        let mut known = Vec::new();
        for place in 0..if count <= MOST_KNOWN { count } else { 0 } {
            let value = axis.value(place, seed);
            let mut text = String::new();
            value.write(&mut text);
            known.push((value, text));
        }
        Self { axis, step, count, known }
    }

    fn place(&self, point: usize) -> usize {
        point / self.step % self.count
    }
}

impl Points {
    /// The points of these axes; `None` if there are more than a number can count.
    pub fn new(axes: Vec<Axis>, seed: u64) -> Option<Self> {
        let first = axes.iter().position(|axis| axis.spread.is_random());
        let mut count = 1_usize;
        let mut steps = vec![0; axes.len()];
        for (place, (axis, step)) in axes.iter().zip(&mut steps).enumerate().rev() {
            *step = count;
            if !axis.spread.is_random() || first == Some(place) {
                count = count.checked_mul(axis.spread.count())?;
            }
        }
        let step_of_random = first.and_then(|first| steps.get(first).copied());
        let dimensions = axes.into_iter().zip(steps).map(|(axis, step)| {
            let step = step_of_random.filter(|_| axis.spread.is_random()).unwrap_or(step);
            Dimension::new(axis, step, seed)
        });
        Some(Self { dimensions: dimensions.collect(), seed, count })
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The axes.
    pub fn axes(&self) -> impl Iterator<Item = &Axis> {
        self.dimensions.iter().map(|dimension| &dimension.axis)
    }

    /// The value on each axis at a point, the first being 0.
    pub fn values(&self, point: usize) -> impl Iterator<Item = Value> {
        self.dimensions.iter().map(move |dimension| {
            let place = dimension.place(point);
            let known = dimension.known.get(place).map(|(value, _)| value.clone());
            known.unwrap_or_else(|| dimension.axis.value(place, self.seed))
        })
    }

    /// What the row of a point begins with: its values, each with a comma after it.
    pub fn write(&self, point: usize, row: &mut String) {
        for dimension in &self.dimensions {
            let place = dimension.place(point);
            match dimension.known.get(place) {
                Some((_, text)) => row.push_str(text),
                None => dimension.axis.value(place, self.seed).write(row),
            }
            row.push(',');
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::{Range, Spread},
        *,
    };

    fn axis(name: &str, spread: Spread) -> Axis {
        Axis { name: name.to_owned(), spread }
    }

    fn list(values: &[f64]) -> Spread {
        Spread::List(values.iter().copied().map(Value::Number).collect())
    }

    fn all(points: &Points) -> Vec<Vec<f64>> {
        (0..points.count()).map(|point| points.values(point).filter_map(|value| value.number()).collect()).collect()
    }

    #[test]
    fn the_last_axis_is_the_fastest() {
        let points = Points::new(vec![axis("a", list(&[1.0, 2.0])), axis("b", list(&[3.0, 4.0, 5.0]))], 0).unwrap();
        let expected = [[1.0, 3.0], [1.0, 4.0], [1.0, 5.0], [2.0, 3.0], [2.0, 4.0], [2.0, 5.0]];
        assert_eq!(all(&points), expected);
    }

    #[test]
    fn random_axes_vary_together_in_the_place_of_the_first() {
        let random = || Spread::Random(Range { low: 0.0, high: 1.0, count: 3 });
        let axes =
            vec![axis("a", list(&[1.0, 2.0])), axis("b", random()), axis("c", list(&[5.0, 6.0])), axis("d", random())];
        let rows = all(&Points::new(axes, 7).unwrap());
        assert_eq!(rows.len(), 12);
        // a, and then b with d, and then c.
        assert!(rows.chunks(2).all(|two| two[0][1] == two[1][1] && two[0][3] == two[1][3] && two[0][2] != two[1][2]));
        assert!(rows[0][1] != rows[2][1] && rows[0][3] != rows[2][3]);
        assert!(rows[..6].iter().zip(&rows[6..]).all(|(one, other)| one[1..] == other[1..] && one[0] != other[0]));
    }

    #[test]
    fn too_many_are_none() {
        let long = || Spread::Linear(Range { low: 0.0, high: 1.0, count: usize::MAX / 2 });
        assert!(Points::new(vec![axis("a", long()), axis("b", long())], 0).is_none());
    }
}
