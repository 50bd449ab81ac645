//! The report as one page of HTML, which needs nothing beside it.

mod figures;
mod pictures;
mod stability;

use std::collections::BTreeMap;
use std::fmt::Write;

use self::pictures::{Pictures, ScriptStrip};
use crate::number::{bytes, mark, mark_bytes, short};
use crate::overview::{Bound, Overview};
use crate::plot::{Plot, Point, SERIES, escape, mark_at};
use crate::results::{Device, Outcome, Results, Row};

pub use stability::stability_page;

/// Pictures of one row, as PNG files.
#[derive(Clone, Debug)]
pub struct Strip {
    /// Which of the results' rows.
    pub row: usize,
    /// What was rendered.
    pub image: Vec<u8>,
    /// What it should be.
    pub reference: Vec<u8>,
    /// Their difference.
    pub error: Vec<u8>,
    /// The error at which its colour is full.
    pub error_scale: f64,
}

/// The page. `date` and `subtitle` (what was asked for) stand in its head. Where there are several scenes, they stand first side by
/// side, held against `bounds`.
pub fn page(results: &Results, strips: &[Strip], bounds: &[Bound], date: &str, subtitle: &str) -> String {
    let mut html = head("speed against error", &results.device, date, subtitle);
    if let Some(overview) = Overview::of(results, bounds) {
        all_scenes(&mut html, results, &overview);
    }
    let mut pictures = Pictures::default();
    let mut scripts = BTreeMap::new();
    for (number, (scene, effect)) in groups(results).into_iter().enumerate() {
        let open = if results.rows.iter().all(|row| row.scene == scene) { " open" } else { "" };
        section(&mut html, results, (scene, effect), number, open);
        let of_group = strips.iter().filter(|strip| {
            results.rows.get(strip.row).is_some_and(|row| row.scene == scene && row.effect == effect)
        });
        let list: Vec<ScriptStrip> =
            of_group.map(|strip| pictures.script(strip, &results.rows[strip.row])).collect();
        if !list.is_empty() {
            scripts.insert(number, list);
        }
        html += "</section>\n";
    }
    figures::table(&mut html, results);
    if pictures.are_reduced() {
        html += "<p>Pictures on this page are JPEG. What was rendered is in the folder <code>images</code> beside it, as EXR and PNG.</p>\n";
    }
    html += "</main>\n";
    let data = serde_json::json!({ "pictures": pictures.uris(), "strips": scripts }).to_string();
    // Within a script element only `<` could end it.
    let data = data.replace('<', "\\u003c");
    let _ = write!(
        html,
        "<script type=\"application/json\" id=\"data\">{data}</script>\n<script>\n{}</script>\n</body>\n</html>\n",
        include_str!("page.js")
    );
    html
}

/// All up to the first section.
fn head(title: &str, device: &Device, date: &str, subtitle: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>Voxlume: {title}</title>\n<style>\n{}</style>\n</head>\n<body>\n\
         <header><h1>Voxlume: {title}</h1>\n<p><b>{}</b> · {} · {}</p>\n<p>{}</p>\n<p>{}</p></header>\n<main>\n",
        include_str!("page.css"),
        escape(&device.name),
        escape(&device.kind),
        escape(&device.driver),
        escape(date),
        escape(subtitle),
    )
}

/// Scenes and effects in the order in which they come.
fn groups(results: &Results) -> Vec<(&str, &str)> {
    distinct(results.rows.iter().map(|row| (row.scene.as_str(), row.effect.as_str())))
}

/// Tracers in the order in which they come: each has its form.
fn tracers(results: &Results) -> Vec<&str> {
    distinct(results.rows.iter().map(|row| row.tracer.as_str()))
}

/// The forms of tracers' marks, for a legend; nothing where there is only one tracer.
fn forms(tracers: &[&str]) -> String {
    let form = |(shape, tracer): (usize, &&str)| {
        let mark = mark_at(shape, 7.0, 7.0);
        format!(
            "<li class=\"formed\"><svg viewBox=\"0 0 14 14\" aria-hidden=\"true\">{mark}</svg>{}</li>",
            escape(tracer)
        )
    };
    if tracers.len() < 2 { String::new() } else { tracers.iter().enumerate().map(form).collect() }
}

/// Formats and encodings in the order in which they come: each has its colour.
fn series(results: &Results) -> Vec<(&str, &str)> {
    distinct(results.rows.iter().map(|row| (row.format.as_str(), row.encoding.as_str())))
}

fn distinct<T: PartialEq>(items: impl Iterator<Item = T>) -> Vec<T> {
    let mut distinct = Vec::new();
    for item in items {
        if !distinct.contains(&item) {
            distinct.push(item);
        }
    }
    distinct
}

/// The table of all scenes, and one plot: for each setting the mean over scenes, and the worst.
fn all_scenes(html: &mut String, results: &Results, overview: &Overview) {
    *html += &overview.html();
    let _ = write!(html, "<section>\n<h2>All scenes: {}</h2>\n", escape(overview.plotted()));
    let _ = write!(html, "<figure class=\"large\">{}</figure>", scenes_plot(results, overview).svg());
    *html += "\n<p class=\"told\" aria-live=\"polite\"></p>\n";
    legend(html, &series(results), &tracers(results));
    *html += "<p>Of each setting: the mean over scenes, filled, and above it the worst scene, empty.</p>\n</section>\n";
}

fn scenes_plot<'a>(results: &Results, overview: &'a Overview) -> Plot<'a> {
    let (series, tracers) = (series(results), tracers(results));
    let points = overview.points(overview.plotted()).map(|(row, cost, [mean, worst])| {
        let row = &results.rows[row];
        let more = format!("mean of all scenes, worst {}, ", short(worst));
        Point { worst: Some(worst), ..point(row, &series, &tracers, cost, mean, more) }
    });
    let (cost, error) = ("mean time of all passes, ms", "RMSE");
    Plot { cost, cost_text: mark, error, error_text: mark, points: points.collect(), joined: false }
}

/// The plot of all scenes by itself, as an SVG file; `None` where there are fewer than two scenes.
pub fn overview_plot(results: &Results) -> Option<String> {
    let overview = Overview::of(results, &[])?;
    let (series, tracers) = (series(results), tracers(results));
    Some(scenes_plot(results, &overview).file(&series, &tracers))
}

/// A setting's mark in a plot.
fn point(row: &Row, series: &[(&str, &str)], tracers: &[&str], cost: f64, error: f64, more: String) -> Point {
    let is_of = |one: &(&str, &str)| *one == (row.format.as_str(), row.encoding.as_str());
    Point {
        series: series.iter().position(is_of).unwrap_or(0),
        shape: tracers.iter().position(|tracer| *tracer == row.tracer).unwrap_or(0),
        cost,
        error,
        worst: None,
        label: match row.scale {
            Some(scale) => format!("{} 1/{scale}", row.resolution),
            None => row.resolution.to_string(),
        },
        title: format!("{}: {}RMSE {}", row.setting(), more, short(error)),
    }
}

/// What colours and forms mean.
fn legend(html: &mut String, series: &[(&str, &str)], tracers: &[&str]) {
    *html += "<ul class=\"legend\">";
    for (index, (format, encoding)) in series.iter().enumerate() {
        let _ =
            write!(html, "<li class=\"s{}\">{} {}</li>", index % SERIES, escape(format), escape(encoding));
    }
    *html += &forms(tracers);
    *html += "<li class=\"ringed\">Pareto front</li></ul>\n";
}

fn section(html: &mut String, results: &Results, group: (&str, &str), number: usize, open: &str) {
    let (series, tracers) = (series(results), tracers(results));
    let (mut by_time, mut by_bytes) = (Vec::new(), Vec::new());
    let mut held_against = None;
    for row in results.rows.iter().filter(|row| (row.scene.as_str(), row.effect.as_str()) == group) {
        held_against = row.held_against.as_deref();
        let Outcome::Measured { passes: _, total_ms, volume_bytes, error, .. } = &row.outcome else {
            continue;
        };
        let note = Some(row.note()).filter(|note| !note.is_empty());
        let note = note.map(|note| format!(" ({note})")).unwrap_or_default();
        let push = |list: &mut Vec<Point>, cost: f64, cost_text: String| {
            let mut point = point(row, &series, &tracers, cost, error.rmse, format!("{cost_text}, "));
            point.title += &note;
            list.push(point);
        };
        push(&mut by_time, *total_ms, format!("{total_ms:.2} ms"));
        push(&mut by_bytes, *volume_bytes as f64, bytes(*volume_bytes as f64));
    }
    let (scene, effect) = group;
    let _ = write!(html, "<section>\n<h2>{}: {}</h2>\n", escape(scene), escape(effect));
    if let Some(setting) = held_against {
        let _ = writeln!(
            html,
            "<p>Held against the same effect in {}: it names no reference.</p>",
            escape(setting)
        );
    }
    html.push_str("<div class=\"plots\">");
    let time = Plot {
        cost: "time of all passes, ms",
        cost_text: mark,
        error: "RMSE",
        error_text: mark,
        points: by_time,
        joined: false,
    };
    let size = Plot {
        cost: "bytes of the volume",
        cost_text: mark_bytes,
        error: "RMSE",
        error_text: mark,
        points: by_bytes,
        joined: false,
    };
    for plot in [time, size] {
        let _ = write!(html, "<figure>{}</figure>", plot.svg());
    }
    html.push_str("</div>\n<p class=\"told\" aria-live=\"polite\"></p>\n");
    legend(html, &series, &tracers);
    let _ = writeln!(
        html,
        "<details{open}><summary>Pictures</summary><div class=\"strips\" data-strips=\"{number}\"></div></details>"
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::results::tests::results;

    fn html() -> String {
        let strip = |image: &[u8]| Strip {
            row: 0,
            image: image.to_vec(),
            reference: b"reference".to_vec(),
            error: b"error".to_vec(),
            error_scale: 0.5,
        };
        page(&results(), &[strip(b"one"), strip(b"two")], &[], "2025-01-02 03:04 UTC", "64 samples")
    }

    #[test]
    fn it_needs_nothing_beside_it() {
        let html = html();
        for outside in ["http:", "https:", "src=\"", "href=", "@import", "url("] {
            assert!(!html.contains(outside), "{outside}");
        }
    }

    #[test]
    fn it_says_what_was_measured_on_what_and_when() {
        let html = html();
        assert!(
            html.contains(
                "<p><b>llvmpipe</b> · software device · Mesa 22.3</p>\n<p>2025-01-02 03:04 UTC</p>"
            )
        );
        assert!(
            html.contains("<title>isotropic rgba16float 64³ rays: 2.00 ms, RMSE 1.00 · Pareto front</title>")
        );
        assert!(html.contains("<td class=\"fault\">too &lt;large&gt;, &quot;so&quot;</td>"));
    }

    #[test]
    fn shared_pictures_are_stored_once() {
        let html = html();
        assert_eq!(html.matches("data:image/png;base64,").count(), 4);
        assert!(html.contains("red: too bright, blue: too dark, full at 0.500"));
    }
}
