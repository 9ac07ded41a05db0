use crate::number::Number;

/// The solution of a small system of linear equations, each row its coefficients and then its right side, by elimination with pivots; `None` if it
/// is singular.
pub(crate) fn solve<T: Number>(mut rows: Vec<Vec<T>>) -> Option<Vec<T>> {
    let mut solved: Vec<Vec<T>> = Vec::with_capacity(rows.len());
    while !rows.is_empty() {
        let size = |row: &[T]| row.first().map_or(0.0, |first| first.rounded().abs());
        let (best, _) = rows.iter().enumerate().max_by(|(_, a), (_, b)| size(a).total_cmp(&size(b)))?;
        let pivot = rows.swap_remove(best);
        let (&first, rest) = pivot.split_first()?;
        if first.rounded() == 0.0 {
            return None;
        }
        rows = rows
            .iter()
            .filter_map(|row| {
                let (&entry, row) = row.split_first()?;
                let factor = entry.over(first);
                Some(row.iter().zip(rest).map(|(&a, &b)| a - factor * b).collect())
            })
            .collect();
        solved.push(pivot);
    }
    // From the last unknown back.
    let mut unknowns: Vec<T> = Vec::with_capacity(solved.len());
    for row in solved.iter().rev() {
        let [first, factors @ .., right] = row.as_slice() else { return None };
        let known = factors.iter().rev().zip(&unknowns).fold(*right, |left, (&factor, &x)| left - factor * x);
        unknowns.push(known.over(*first));
    }
    unknowns.reverse();
    Some(unknowns)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_whose_first_pivot_is_zero() {
        let rows = vec![vec![0.0, 2.0, 1.0, 7.0], vec![1.0, 1.0, 1.0, 6.0], vec![2.0, -1.0, 3.0, 9.0]];
        assert_eq!(solve(rows), Some(vec![1.0, 2.0, 3.0]));
        assert_eq!(solve(vec![vec![1.0, 2.0, 3.0], vec![2.0, 4.0, 6.0]]), None);
    }
}
