//! Logarithmic axes.

/// A range of values on a logarithmic scale, ending at 1, 2 or 5 times powers of ten.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Axis {
    low: f64,
    high: f64,
    /// Where marks are.
    pub(crate) ticks: Vec<f64>,
}

impl Axis {
    /// An axis that holds all of some positive values; none for none.
    pub(crate) fn around(values: &[f64]) -> Option<Axis> {
        let low = values.iter().copied().reduce(f64::min)?;
        let high = values.iter().copied().reduce(f64::max)?;
        let all = steps(&[1.0, 2.0, 5.0], low, high);
        let (first, last) = (all.first().copied()?, all.last().copied()?);
        let ticks = if all.len() > 9 { steps(&[1.0], low, high) } else { all };
        let ticks = ticks.into_iter().filter(|tick| (first..=last).contains(tick)).collect();
        Some(Axis { low: first, high: last, ticks })
    }

    /// 0 at the axis' start, 1 at its end.
    pub(crate) fn place(&self, value: f64) -> f64 {
        (value / self.low).ln() / (self.high / self.low).ln()
    }
}

/// Round values from the last below `low` to the first above `high`, two at least.
fn steps(mantissas: &[f64], low: f64, high: f64) -> Vec<f64> {
    let (from, to) = (low.log10().floor() as i32 - 1, high.log10().ceil() as i32 + 1);
    let all: Vec<f64> =
        (from..=to).flat_map(|power| mantissas.iter().map(move |m| m * 10f64.powi(power))).collect();
    // A value on a mark lies a little off it by rounding.
    let first = all.iter().rposition(|step| *step < low * (1.0 - 1e-9)).unwrap_or(0);
    let last = all.iter().position(|step| *step > high * (1.0 + 1e-9)).unwrap_or(all.len() - 1);
    all[first..=last].to_vec()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn ticks(values: &[f64]) -> Vec<String> {
        Axis::around(values).unwrap().ticks.iter().map(|tick| format!("{tick:.3}")).collect()
    }

    #[test]
    fn ends_are_round() {
        assert_eq!(ticks(&[3.0, 60.0]), ["2.000", "5.000", "10.000", "20.000", "50.000", "100.000"]);
        assert_eq!(ticks(&[0.1]), ["0.050", "0.100", "0.200"]);
        assert_eq!(
            ticks(&[0.02, 300.0]),
            ["0.010", "0.100", "1.000", "10.000", "100.000"].into_iter().collect::<Vec<_>>()
        );
        assert_eq!(Axis::around(&[]), None);
    }

    #[test]
    fn decades_are_as_far_apart_as_each_other() {
        let axis = Axis::around(&[2.0, 50.0]).unwrap();
        let step = axis.place(10.0) - axis.place(2.0);
        assert!((axis.place(50.0) - axis.place(10.0) - step).abs() < 1e-12);
        assert_eq!(axis.place(axis.ticks[0]), 0.0);
    }
}
