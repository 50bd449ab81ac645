//! Hard cases as one page of HTML.

use std::fmt::Write;

use super::{distinct, forms, head};
use crate::number::{mark, short};
use crate::plot::{Plot, Point, SERIES, escape};
use crate::stability::{Stability, StabilityRow};

/// The page: a curve for each sweep, then all figures.
pub fn stability_page(stability: &Stability, date: &str) -> String {
    let mut html =
        head("numerical stability", &stability.device, date, "figures of hard cases against their bounds");
    let mut series: Vec<String> = Vec::new();
    for row in stability.rows.iter().filter(|row| row.at.is_some()) {
        if !series.contains(&series_of(row)) {
            series.push(series_of(row));
        }
    }
    html += "<section>\n<h2>Sweeps</h2>\n<ul class=\"legend\">";
    for (index, name) in series.iter().enumerate() {
        let _ = write!(html, "<li class=\"s{}\">{}</li>", index % SERIES, escape(name));
    }
    let tracers =
        distinct(stability.rows.iter().filter(|row| row.at.is_some()).map(|row| row.tracer.as_str()));
    html += &forms(&tracers);
    html += "</ul>\n<div class=\"plots\">\n";
    for (case, axis) in sweeps(stability) {
        let points = stability.rows.iter().filter(|row| row.case == case).filter_map(|row| {
            Some(Point {
                series: series.iter().position(|name| *name == series_of(row))?,
                shape: tracers.iter().position(|tracer| *tracer == row.tracer)?,
                cost: row.at?.1,
                error: row.value.abs(),
                worst: None,
                label: row.resolution.to_string(),
                title: format!(
                    "{} {} {}³, {}: {}",
                    row.format,
                    row.tracer,
                    row.resolution,
                    row.figure,
                    short(row.value)
                ),
            })
        });
        let (points, error) = (points.collect(), "size of the figure");
        let plot = Plot { cost: axis, cost_text: mark, error, error_text: mark, points, joined: true };
        let _ = writeln!(html, "<figure><figcaption>{}</figcaption>{}</figure>", escape(case), plot.svg());
    }
    html += "</div>\n</section>\n";
    table(&mut html, stability);
    html + "</main>\n</body>\n</html>\n"
}

/// What has one colour.
fn series_of(row: &StabilityRow) -> String {
    format!("{} {}", row.format, row.encoding)
}

/// Cases with a sweep, and what is swept, in the order in which they come.
fn sweeps(stability: &Stability) -> Vec<(&str, &'static str)> {
    let mut sweeps: Vec<(&str, &'static str)> = Vec::new();
    for row in &stability.rows {
        if let Some((axis, _)) = row.at
            && !sweeps.iter().any(|(case, _)| *case == row.case)
        {
            sweeps.push((&row.case, axis));
        }
    }
    sweeps
}

fn table(html: &mut String, stability: &Stability) {
    html.push_str("<section>\n<h2>All figures</h2>\n<div class=\"wide\"><table>\n<thead><tr>");
    for head in ["case", "format", "encoding", "tracer", "N", "figure", "value", "bound", "", "reason"] {
        let _ = write!(html, "<th>{head}</th>");
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for row in &stability.rows {
        let cells = [
            row.case.clone(),
            row.format.clone(),
            row.encoding.clone(),
            row.tracer.clone(),
            row.resolution.to_string(),
            row.figure.clone(),
            short(row.value),
            row.bound.map_or_else(|| "-".into(), short),
            row.verdict().to_owned(),
            row.reason.clone().unwrap_or_default(),
        ];
        html.push_str(if row.pass { "<tr>" } else { "<tr class=\"missed\">" });
        for cell in cells {
            let _ = write!(html, "<td>{}</td>", escape(&cell));
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody></table></div>\n</section>\n");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::tests::stability;

    #[test]
    fn a_curve_and_a_table() {
        let html = stability_page(&stability(), "2025-01-02 03:04 UTC");
        assert_eq!(html.matches("<svg").count(), 1);
        assert!(html.contains("<title>six_face rays 32³, leak at 0.5 voxels: 0.250</title>"));
        assert!(html.contains("class=\"curve s0\""));
        assert!(html.contains("<tr class=\"missed\"><td>leak</td>") && html.contains("<td>FAIL</td>"));
        assert!(html.contains("1 at 0, or no number") && !html.contains("Pareto"));
    }
}
