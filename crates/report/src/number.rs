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

/// Bytes in binary units.
pub(crate) fn bytes(value: f64) -> String {
    let units = ["B", "KiB", "MiB", "GiB"];
    let unit = ((value.max(1.0).log2() / 10.0) as usize).min(3);
    format!("{} {}", short(value / 1024f64.powi(unit as i32)), units[unit])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits() {
        let all = [0.0, 0.001234, -1.5, 12.345, 99999.0, 1234567.0, 1e-5].map(short);
        assert_eq!(all, ["0", "0.00123", "-1.50", "12.3", "99999", "1.23e6", "1.00e-5"]);
        assert_eq!(percent(-0.0512), "-5.1 %");
        assert_eq!([0.0, 1000.0, 2048.0, 19.0e6].map(bytes), ["0 B", "1000 B", "2.00 KiB", "18.1 MiB"]);
    }
}
