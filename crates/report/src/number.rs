//! Numbers for people.

/// Three significant digits; plain from 0.001 up to a million, with an exponent beyond.
pub(crate) fn short(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".into();
    }
    if !(1e-3..1e6).contains(&size) {
        return format!("{value:.2e}");
    }
    let digits = (2 - size.log10().floor() as i32).max(0) as usize;
    format!("{value:.digits$}")
}

/// A share in per cent with its sign.
pub(crate) fn percent(share: f64) -> String {
    format!("{:+.1} %", share * 100.0)
}

/// Bytes in decimal units, of which an axis has round ones.
pub(crate) fn bytes(value: f64) -> String {
    let (value, unit) = in_units(value);
    format!("{} {unit}", short(value))
}

/// A mark of an axis: one significant digit.
pub(crate) fn mark(value: f64) -> String {
    let rounded: f64 = format!("{value:.0e}").parse().unwrap_or(value);
    if (1e-3..1e6).contains(&rounded) { rounded.to_string() } else { format!("{rounded:e}") }
}

/// A mark of an axis of bytes.
pub(crate) fn mark_bytes(value: f64) -> String {
    let (value, unit) = in_units(value);
    format!("{} {unit}", mark(value))
}

fn in_units(bytes: f64) -> (f64, &'static str) {
    let units = ["B", "kB", "MB", "GB"];
    // A value on a mark may lie a little below it by rounding.
    let unit = (((bytes.max(1.0).log10() + 1e-9) / 3.0) as usize).min(3);
    (bytes / 1000f64.powi(unit as i32), units[unit])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits() {
        let all = [0.0, 0.001234, -1.5, 12.345, 99999.0, 1234567.0, 1e-5].map(short);
        assert_eq!(all, ["0", "0.00123", "-1.50", "12.3", "99999", "1.23e6", "1.00e-5"]);
        assert_eq!(percent(-0.0512), "-5.1 %");
        assert_eq!([0.0, 999.0, 2048.0, 19.0e6].map(bytes), ["0 B", "999 B", "2.05 kB", "19.0 MB"]);
    }

    #[test]
    fn marks_have_no_trailing_zeros() {
        assert_eq!(
            [0.05, 0.1, 20.0, 3e-5, 2e6, 0.002].map(mark),
            ["0.05", "0.1", "20", "3e-5", "2e6", "0.002"]
        );
        assert_eq!([500.0, 1e3, 2e5, 1e6].map(mark_bytes), ["500 B", "1 kB", "200 kB", "1 MB"]);
    }
}
