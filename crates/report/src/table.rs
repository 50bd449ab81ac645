//! Results as a table of plain text.

use crate::number::{bytes, percent, short};
use crate::results::{Outcome, Results, Row};
use crate::text::align;

/// Head of the columns shared with the page's table, after effect and place.
pub(crate) const FIGURES: [&str; 9] =
    ["total ms", "volume", "RMSE", "rel. MSE", "bias", "bias/mean", "p99", "FLIP", "ref. s.e."];

/// The figures of a measured row, for people, under [`FIGURES`].
pub(crate) fn figures(total_ms: f64, volume_bytes: u64, error: &crate::Errors) -> [String; 9] {
    [
        format!("{total_ms:.2}"),
        bytes(volume_bytes as f64),
        short(error.rmse),
        error.rel_mse.map_or_else(|| "-".into(), short),
        short(error.bias),
        error.bias_rel.map_or_else(|| "-".into(), percent),
        short(error.p99),
        format!("{:.4}", error.flip),
        short(error.reference_se),
    ]
}

/// Heads of the columns that say what a row is about.
pub(crate) const SUBJECT: [&str; 7] = ["scene", "effect", "format", "encoding", "tracer", "scale", "N"];

/// Where the columns of numbers begin.
pub(crate) const NUMBERS: usize = SUBJECT.len() - 1;

/// What a row is about, as [`SUBJECT`] has it.
pub(crate) fn subject(row: &Row) -> [String; 7] {
    let Row { scene, effect, format, encoding, tracer, resolution, scale, .. } = row;
    let scale = scale.map_or_else(|| "-".into(), |scale| format!("1/{scale}"));
    let [scene, effect, format, encoding, tracer] =
        [scene, effect, format, encoding, tracer].map(Clone::clone);
    [scene, effect, format, encoding, tracer, scale, resolution.to_string()]
}

/// Aligned columns: figures to the right, notes and faults last. Ends with a line feed.
pub fn table(results: &Results) -> String {
    let head = SUBJECT.iter().chain(&FIGURES).map(|head| (*head).to_owned()).collect();
    let mut rows = vec![(head, String::new())];
    for row in &results.rows {
        let mut cells = subject(row).to_vec();
        let note = match &row.outcome {
            Outcome::Measured { passes: _, total_ms, volume_bytes, error, .. } => {
                cells.extend(figures(*total_ms, *volume_bytes, error));
                row.note()
            }
            Outcome::Failed { fault } => format!("failed: {}", fault.lines().next().unwrap_or_default()),
        };
        rows.push((cells, note));
    }
    align(&rows, NUMBERS)
}

#[cfg(test)]
mod tests {
    use crate::results::tests::results;

    #[test]
    fn columns_align() {
        let expected = "\
scene    effect   format     encoding     tracer  scale   N  total ms   volume  RMSE  rel. MSE    bias  bias/mean   p99    FLIP  ref. s.e.
cornell  diffuse  isotropic  rgba16float  rays    -      64      2.00  4.10 kB  1.00     0.500  -0.250          -  2.00  0.1250     0.0625
cornell  diffuse  sh2        rgba16float  rays    -      64  failed: too <large>, \"so\"
";
        assert_eq!(super::table(&results()), expected);
    }
}
