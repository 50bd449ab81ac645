//! Results beside those of another time.

use crate::number::{percent, short};
use crate::results::{Outcome, Results, Row};
use crate::table::{NUMBERS, SUBJECT, subject};
use crate::text::align;

/// For each row of `now` that `then` has too: time and error of both, and how they changed. Says which rows only one
/// of them has, and where the devices differ, so that times are not comparable. Ends with a line feed.
pub fn against(now: &Results, then: &Results) -> String {
    let compared = ["total ms", "was", "×", "RMSE", "was", "×", "bias/mean", "was"];
    let head = SUBJECT.iter().chain(&compared).map(|head| (*head).to_owned()).collect();
    let mut lines = vec![(head, String::new())];
    for row in &now.rows {
        let old = then.rows.iter().find(|old| key(old) == key(row));
        let mut cells = subject(row).to_vec();
        let note = match (&row.outcome, old.map(|old| &old.outcome)) {
            (
                Outcome::Measured { total_ms, error, .. },
                Some(Outcome::Measured { total_ms: old_ms, error: old_error, .. }),
            ) => {
                let bias = |share: Option<f64>| share.map_or_else(|| "-".into(), percent);
                cells.extend([
                    format!("{total_ms:.2}"),
                    format!("{old_ms:.2}"),
                    ratio(*total_ms, *old_ms),
                    short(error.rmse),
                    short(old_error.rmse),
                    ratio(error.rmse, old_error.rmse),
                    bias(error.bias_rel),
                    bias(old_error.bias_rel),
                ]);
                ""
            }
            (Outcome::Failed { .. }, _) => "failed",
            (_, Some(Outcome::Failed { .. })) => "had failed",
            (_, None) => "new",
        };
        lines.push((cells, note.to_owned()));
    }
    let mut text = align(&lines, NUMBERS);
    let gone = then.rows.iter().filter(|old| now.rows.iter().all(|row| key(row) != key(old))).count();
    if gone > 0 {
        text += &format!("{gone} rows of the baseline were not run\n");
    }
    if now.device != then.device {
        text += &format!(
            "times are not comparable: now on {} ({}), the baseline on {} ({})\n",
            now.device.name, now.device.driver, then.device.name, then.device.driver
        );
    }
    text
}

/// What two rows have in common that can be compared.
fn key(row: &Row) -> ([&str; 5], Option<u32>, [u32; 3]) {
    let Row { scene, effect, format, encoding, tracer, resolution, scale, width, height, .. } = row;
    ([scene, effect, format, encoding, tracer], *scale, [*resolution, *width, *height])
}

fn ratio(now: f64, then: f64) -> String {
    if then > 0.0 { format!("{:.2}", now / then) } else { "-".to_owned() }
}

#[cfg(test)]
mod tests {
    use crate::results::tests::{results, row};

    #[test]
    fn rows_find_their_older_selves() {
        let mut then = results();
        then.rows = vec![row("isotropic", 4.0, 0.5), row("gone", 1.0, 1.0)];
        then.device.driver = "Mesa 21".into();
        let mut now = results();
        now.rows.push(row("six_face", 1.0, 1.0));
        let expected = "\
scene    effect   format     encoding     tracer  scale   N  total ms   was     ×  RMSE    was     ×  bias/mean  was
cornell  diffuse  isotropic  rgba16float  rays    -      64      2.00  4.00  0.50  1.00  0.500  2.00          -    -
cornell  diffuse  sh2        rgba16float  rays    -      64  failed
cornell  diffuse  six_face   rgba16float  rays    -      64  new
1 rows of the baseline were not run
times are not comparable: now on llvmpipe (Mesa 22.3), the baseline on llvmpipe (Mesa 21)
";
        assert_eq!(super::against(&now, &then), expected);
    }
}
