//! Error against cost, as SVG.

use std::fmt::Write;

use crate::axis::Axis;
use crate::label::Labels;
use crate::pareto::pareto_front;

/// A plot of points on logarithmic axes.
pub(crate) struct Plot<'a> {
    /// What the horizontal axis has, with its unit.
    pub(crate) cost: &'a str,
    /// Writes a cost on the axis.
    pub(crate) cost_text: fn(f64) -> String,
    /// What the vertical axis has.
    pub(crate) error: &'a str,
    pub(crate) error_text: fn(f64) -> String,
    pub(crate) points: Vec<Point>,
    /// Points of a series and a label are joined, in their order; else the Pareto front is marked.
    pub(crate) joined: bool,
}

/// A point.
pub(crate) struct Point {
    /// Colour, from 0.
    pub(crate) series: usize,
    /// Its mark's form, from 0.
    pub(crate) shape: usize,
    pub(crate) cost: f64,
    pub(crate) error: f64,
    /// Of several such points the worst one's error: an empty mark above, joined to this one.
    pub(crate) worst: Option<f64>,
    /// Beside the point, where it differs among points and there is room.
    pub(crate) label: String,
    /// In the tooltip.
    pub(crate) title: String,
}

/// Colours in `page.css`.
pub(crate) const SERIES: usize = 8;

/// Forms of marks.
const SHAPES: usize = 4;

/// A mark around a place: a circle, a square, a triangle or a diamond.
pub(crate) fn mark_at(shape: usize, h: f64, v: f64) -> String {
    match shape % SHAPES {
        0 => format!("<circle cx=\"{h:.1}\" cy=\"{v:.1}\" r=\"4.5\"/>"),
        1 => format!("<rect x=\"{:.1}\" y=\"{:.1}\" width=\"8.4\" height=\"8.4\"/>", h - 4.2, v - 4.2),
        2 => format!("<path d=\"M{h:.1} {:.1}l5.4 9.4h-10.8z\"/>", v - 5.9),
        _ => format!("<path d=\"M{h:.1} {:.1}l5.6 5.6l-5.6 5.6l-5.6 -5.6z\"/>", v - 5.6),
    }
}

const WIDTH: f64 = 480.0;
const HEIGHT: f64 = 340.0;
/// Left, top, right, bottom.
const MARGIN: [f64; 4] = [58.0, 14.0, 22.0, 46.0];

impl Plot<'_> {
    /// The picture. A logarithmic axis has no place for 0: such points are counted beneath.
    pub(crate) fn svg(&self) -> String {
        let shown: Vec<&Point> = self.points.iter().filter(|p| p.cost > 0.0 && p.error > 0.0).collect();
        let costs: Vec<f64> = shown.iter().map(|point| point.cost).collect();
        let errors: Vec<f64> = shown.iter().flat_map(|p| [Some(p.error), p.worst]).flatten().collect();
        let (Some(x), Some(y)) = (Axis::around(&costs), Axis::around(&errors)) else {
            return "<p>Nothing to plot.</p>".into();
        };
        let [left, top, right, bottom] = MARGIN;
        let at_x = |cost: f64| left + x.place(cost) * (WIDTH - left - right);
        let at_y = |error: f64| HEIGHT - bottom - y.place(error) * (HEIGHT - top - bottom);
        let mut svg = format!(
            "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" aria-label=\"{} against {}\">",
            escape(self.error),
            escape(self.cost)
        );
        for tick in &x.ticks {
            let (at, text) = (at_x(*tick), escape(&(self.cost_text)(*tick)));
            let (end, below) = (HEIGHT - bottom, HEIGHT - bottom + 16.0);
            let _ = write!(svg, "<path class=\"grid\" d=\"M{at:.1} {top}V{end}\"/>");
            let _ = write!(svg, "<text x=\"{at:.1}\" y=\"{below}\" text-anchor=\"middle\">{text}</text>");
        }
        for tick in &y.ticks {
            let (at, text) = (at_y(*tick), escape(&(self.error_text)(*tick)));
            let (end, before, middle) = (WIDTH - right, left - 6.0, at + 4.0);
            let _ = write!(svg, "<path class=\"grid\" d=\"M{left} {at:.1}H{end}\"/>");
            let _ = write!(svg, "<text x=\"{before}\" y=\"{middle:.1}\" text-anchor=\"end\">{text}</text>");
        }
        let (middle, low) = ((left + WIDTH - right) / 2.0, HEIGHT - 8.0);
        let _ = write!(
            svg,
            "<text class=\"name\" x=\"{middle}\" y=\"{low}\" text-anchor=\"middle\">{}</text>\
             <text class=\"name\" transform=\"translate(13 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            escape(self.cost),
            (top + HEIGHT - bottom) / 2.0,
            escape(self.error)
        );

        let pairs: Vec<(f64, f64)> = shown.iter().map(|point| (point.cost, point.error)).collect();
        let front = if self.joined { vec![false; pairs.len()] } else { pareto_front(&pairs) };
        let mut on_front: Vec<(f64, f64)> =
            pairs.iter().zip(&front).filter(|(_, front)| **front).map(|(pair, _)| *pair).collect();
        on_front.sort_by(|a, b| a.0.total_cmp(&b.0));
        // To the right of a point of the front nothing worse than it is needed: a staircase.
        let mut stairs = String::new();
        for (index, (cost, error)) in on_front.iter().enumerate() {
            let (step, h, v) = (if index == 0 { "M" } else { "H" }, at_x(*cost), at_y(*error));
            let _ = if index == 0 {
                write!(stairs, "{step}{h:.1} {v:.1}")
            } else {
                write!(stairs, "{step}{h:.1}V{v:.1}")
            };
        }
        if self.joined {
            svg += &curves(&shown, at_x, at_y);
        } else {
            let _ = write!(svg, "<path class=\"front\" d=\"{stairs}\"/>");
        }
        let marks: Vec<(f64, f64)> = shown.iter().map(|p| (at_x(p.cost), at_y(p.error))).collect();
        let mut labels = Labels::among(&marks, [left, top, WIDTH - right, HEIGHT - bottom]);
        let says = shown.iter().any(|point| point.label != shown[0].label);
        for (point, front) in shown.iter().zip(front) {
            let (h, v) = (at_x(point.cost), at_y(point.error));
            let _ = write!(svg, "<g class=\"point s{}\" tabindex=\"0\">", point.series % SERIES);
            let title = if front { format!("{} · Pareto front", point.title) } else { point.title.clone() };
            let _ = write!(svg, "<title>{}</title>", escape(&title));
            if front {
                let _ = write!(svg, "<circle class=\"ring\" cx=\"{h:.1}\" cy=\"{v:.1}\" r=\"8\"/>");
            }
            if let Some(worst) = point.worst.map(at_y) {
                let _ = write!(svg, "<path class=\"span\" d=\"M{h:.1} {v:.1}V{worst:.1}\"/>");
                let _ = write!(svg, "<g class=\"worst\">{}</g>", mark_at(point.shape, h, worst));
            }
            svg += &mark_at(point.shape, h, v);
            if let Some((x, y)) = labels.place((h, v), &point.label).filter(|_| says) {
                let _ = write!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\">{}</text>", escape(&point.label));
            }
            svg += "</g>";
        }
        svg += "</svg>";
        match self.points.len() - shown.len() {
            0 => svg,
            absent => {
                svg + &format!(
                    "<p class=\"absent\">{absent} at 0, or no number: without a place on a logarithmic axis.</p>"
                )
            }
        }
    }
}

impl Plot<'_> {
    /// The picture as a file of its own, with what its colours and forms mean beneath.
    pub(crate) fn file(&self, series: &[(&str, &str)], tracers: &[&str]) -> String {
        let height = HEIGHT + LEGEND_LINE * (series.len().max(tracers.len() + 1) as f64 + 0.5);
        let mut svg = self.svg().replacen(
            &format!("<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\""),
            &format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\""),
            1,
        );
        let style = include_str!("page.css").lines().filter(|line| {
            ["svg ", ".grid", ".front", ".point", ".span", ".s0", ".s4", ":root"]
                .iter()
                .any(|of| line.starts_with(of))
        });
        let style: String = style.collect();
        let at = svg.find('>').map_or(0, |end| end + 1);
        svg.insert_str(
            at,
            &format!("<style>{style}</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"),
        );
        let mut legend = String::new();
        let line = |index: usize| HEIGHT + LEGEND_LINE * (index as f64 + 0.5);
        for (index, (format, encoding)) in series.iter().enumerate() {
            let (series, mark, y) = (index % SERIES, mark_at(0, 66.0, line(index)), line(index) + 4.0);
            let name = escape(&format!("{format} {encoding}"));
            let _ = write!(
                legend,
                "<g class=\"point s{series}\">{mark}</g><text x=\"76\" y=\"{y}\">{name}</text>"
            );
        }
        let words = tracers.iter().enumerate().map(|(shape, tracer)| (shape, "", *tracer));
        for (index, (shape, class, word)) in
            words.chain([(0, "worst", "worst scene; filled: mean")]).enumerate()
        {
            let (mark, y) = (mark_at(shape, 266.0, line(index)), line(index) + 4.0);
            let _ = write!(
                legend,
                "<g class=\"point\"><g class=\"{class}\">{mark}</g></g><text x=\"276\" y=\"{y}\">{}</text>",
                escape(word)
            );
        }
        match svg.rfind("</svg>") {
            Some(end) => format!("{}{legend}</svg>\n", &svg[..end]),
            None => svg,
        }
    }
}

/// Height of a line of a file's legend.
const LEGEND_LINE: f64 = 18.0;

/// A line through the points of each series, shape and label.
fn curves(points: &[&Point], at_x: impl Fn(f64) -> f64, at_y: impl Fn(f64) -> f64) -> String {
    let mut lines: Vec<((usize, usize, &str), String)> = Vec::new();
    for point in points {
        let key = (point.series, point.shape, point.label.as_str());
        let place = format!("{:.1} {:.1}", at_x(point.cost), at_y(point.error));
        match lines.iter_mut().find(|(known, _)| *known == key) {
            Some((_, line)) => *line += &format!("L{place}"),
            None => lines.push((key, format!("M{place}"))),
        }
    }
    let path = |((series, shape, _), line): &((usize, usize, &str), String)| {
        let dashes = if shape % SHAPES == 0 {
            String::new()
        } else {
            format!(" stroke-dasharray=\"{} 3\"", 2 * shape + 1)
        };
        format!("<path class=\"curve s{}\"{dashes} d=\"{line}\"/>", series % SERIES)
    };
    lines.iter().map(path).collect()
}

/// Text for HTML, also within attributes.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::short;

    fn plot(points: &[(f64, f64)]) -> String {
        let point = |(cost, error): &(f64, f64)| Point {
            series: 0,
            shape: *cost as usize,
            cost: *cost,
            error: *error,
            worst: None,
            label: format!("{cost}<"),
            title: format!("{cost}"),
        };
        let points = points.iter().map(point).collect();
        Plot { cost: "ms", cost_text: short, error: "RMSE", error_text: short, points, joined: false }.svg()
    }

    #[test]
    fn the_front_is_marked_and_text_is_escaped() {
        let svg = plot(&[(1.0, 2.0), (2.0, 1.0), (3.0, 3.0)]);
        assert_eq!(svg.matches("class=\"ring\"").count(), 2);
        assert_eq!(svg.matches("Pareto front</title>").count(), 2);
        assert_eq!(svg.matches("&lt;</text>").count(), 3);
        assert!(svg.contains("<title>3</title>"));
        assert_eq!([svg.matches("<rect").count(), svg.matches("h-10.8z").count()], [1, 1]);
    }

    #[test]
    fn no_place_for_nothing() {
        assert!(plot(&[(1.0, 0.0), (1.0, 1.0)]).ends_with(
            "<p class=\"absent\">1 at 0, or no number: without a place on a logarithmic axis.</p>"
        ));
        assert_eq!(plot(&[]), "<p>Nothing to plot.</p>");
        assert!(!plot(&[(1.0, 1.0)]).contains("NaN"));
    }
}
