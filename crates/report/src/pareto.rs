//! The Pareto front.

/// For each point (cost, error) whether no other is at least as good in both and better in one.
pub fn pareto_front(points: &[(f64, f64)]) -> Vec<bool> {
    let beats = |a: &(f64, f64), b: &(f64, f64)| a.0 <= b.0 && a.1 <= b.1 && a != b;
    points.iter().map(|point| !points.iter().any(|other| beats(other, point))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_has_no_better_neighbour() {
        let points = [(1.0, 9.0), (2.0, 5.0), (3.0, 5.0), (4.0, 1.0), (2.0, 5.0), (5.0, 1.5)];
        assert_eq!(pareto_front(&points), [true, true, false, true, true, false]);
        assert!(pareto_front(&[]).is_empty());
    }
}
