//! Median and spread of a few times.

/// The median and the interquartile range (third minus first quartile, by linear interpolation between the
/// sorted values). Both are 0 without values, the range also of a single one.
pub fn median_and_spread(values: &[f64]) -> (f64, f64) {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let quantile = |share: f64| {
        let Some(last) = sorted.len().checked_sub(1) else { return 0.0 };
        let at = share * last as f64;
        let (below, above) = (sorted[at.floor() as usize], sorted[at.ceil() as usize]);
        below + (above - below) * at.fract()
    };
    (quantile(0.5), quantile(0.75) - quantile(0.25))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_interpolate() {
        assert_eq!(median_and_spread(&[]), (0.0, 0.0));
        assert_eq!(median_and_spread(&[3.0]), (3.0, 0.0));
        assert_eq!(median_and_spread(&[5.0, 1.0, 3.0, 2.0, 4.0]), (3.0, 2.0));
        assert_eq!(median_and_spread(&[4.0, 1.0, 2.0, 3.0]), (2.5, 1.5));
        // One frame that was interrupted moves neither.
        assert_eq!(median_and_spread(&[1.0, 2.0, 3.0, 4.0, 900.0]), (3.0, 2.0));
    }
}
