//! The table of all figures.

use std::fmt::Write;

use crate::plot::escape;
use crate::results::{Outcome, Results};
use crate::table::{FIGURES, SUBJECT, figures, subject};

/// Adds the table; the page's script sorts by what `data-value` has, or else by the text.
pub(super) fn table(html: &mut String, results: &Results) {
    html.push_str("<section>\n<h2>All figures</h2>\n<p>A click on a head sorts.</p>\n<div class=\"wide\"><table>\n<thead><tr>");
    for head in SUBJECT.iter().chain(&FIGURES).chain(&["note"]) {
        let _ = write!(html, "<th><button type=\"button\">{head}</button></th>");
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for row in &results.rows {
        html.push_str("<tr>");
        let [words @ .., resolution] = subject(row);
        for word in words {
            let _ = write!(html, "<td>{}</td>", escape(&word));
        }
        let _ = write!(html, "<td data-value=\"{resolution}\">{resolution}</td>");
        match &row.outcome {
            Outcome::Measured { passes: _, total_ms, volume_bytes, error, .. } => {
                let values = [
                    Some(*total_ms),
                    Some(*volume_bytes as f64),
                    Some(error.rmse),
                    error.rel_mse,
                    Some(error.bias),
                    error.bias_rel,
                    Some(error.p99),
                    Some(error.flip),
                    Some(error.reference_se),
                ];
                for (text, value) in figures(*total_ms, *volume_bytes, error).iter().zip(values) {
                    let value = value.map(|value| value.to_string()).unwrap_or_default();
                    let _ = write!(html, "<td data-value=\"{value}\">{}</td>", escape(text));
                }
                let note = row.note();
                let _ = write!(html, "<td>{}</td>", escape(&note));
            }
            Outcome::Failed { fault } => {
                html.push_str(&"<td data-value=\"\">-</td>".repeat(FIGURES.len()));
                let _ = write!(html, "<td class=\"fault\">{}</td>", escape(fault));
            }
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody></table></div>\n</section>\n");
}
