//! Many scenes side by side: each setting's errors in each scene, their mean, and the worst.

use std::fmt::Write;

use crate::number::{percent, short};
use crate::pareto::pareto_front;
use crate::plot::escape;
use crate::results::{Outcome, Results, Row, setting_words};
use crate::text::align;

/// What an effect is asked to stay within in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// The scene's name.
    pub scene: String,
    /// The effect's name.
    pub effect: String,
    /// Largest |bias| over the reference's mean.
    pub bias: f64,
    /// Largest RMSE, if one is stated.
    pub rmse: Option<f64>,
    /// Largest FLIP, if one is stated.
    pub flip: Option<f64>,
}

/// A scene's figures in a line.
#[derive(Clone, Debug)]
struct Cell {
    bias: Option<f64>,
    rmse: f64,
    total_ms: f64,
    /// Whether a bound is exceeded.
    out: bool,
}

/// An effect in a setting.
#[derive(Clone, Debug)]
struct Line {
    effect: String,
    setting: String,
    row: usize,
    /// One for each scene.
    cells: Vec<Option<Cell>>,
    mean_ms: f64,
    mean_bias: f64,
    mean_rmse: f64,
    /// The scene with the largest RMSE, and that.
    worst: Option<(usize, f64)>,
    /// On the front of its effect, by mean time and mean RMSE.
    front: bool,
}

/// Results of several scenes by effect and setting.
#[derive(Clone, Debug)]
pub struct Overview {
    scenes: Vec<String>,
    lines: Vec<Line>,
}

impl Overview {
    /// `None` where there are fewer than two scenes.
    pub fn of(results: &Results, bounds: &[Bound]) -> Option<Overview> {
        let mut scenes: Vec<String> = Vec::new();
        let mut lines: Vec<Line> = Vec::new();
        for row in &results.rows {
            if !scenes.contains(&row.scene) {
                scenes.push(row.scene.clone());
            }
        }
        if scenes.len() < 2 {
            return None;
        }
        for (index, row) in results.rows.iter().enumerate() {
            let setting = words(row);
            let known = lines.iter().position(|line| line.effect == row.effect && line.setting == setting);
            let line = known.unwrap_or_else(|| {
                lines.push(Line {
                    effect: row.effect.clone(),
                    setting,
                    row: index,
                    cells: vec![None; scenes.len()],
                    mean_ms: 0.0,
                    mean_bias: 0.0,
                    mean_rmse: 0.0,
                    worst: None,
                    front: false,
                });
                lines.len() - 1
            });
            let scene = scenes.iter().position(|scene| *scene == row.scene).unwrap_or(0);
            lines[line].cells[scene] = cell(row, bounds);
        }
        lines.iter_mut().for_each(Line::sum_up);
        let mut effects: Vec<String> = lines.iter().map(|line| line.effect.clone()).collect();
        effects.dedup();
        for effect in effects {
            let of_effect: Vec<usize> = (0..lines.len()).filter(|i| lines[*i].effect == effect).collect();
            let points: Vec<_> = of_effect.iter().map(|i| (lines[*i].mean_ms, lines[*i].mean_rmse)).collect();
            for (index, front) in of_effect.into_iter().zip(pareto_front(&points)) {
                lines[index].front = front;
            }
        }
        Some(Overview { scenes, lines })
    }

    /// How many figures are out of their bounds.
    pub fn out_of_bounds(&self) -> usize {
        self.lines.iter().flat_map(|line| line.cells.iter().flatten()).filter(|cell| cell.out).count()
    }

    /// Aligned columns of plain text. Ends with a line feed.
    pub fn text(&self) -> String {
        let mut rows = vec![(self.head(), String::new())];
        for line in &self.lines {
            let note = if line.front { "Pareto front" } else { "" };
            rows.push((self.cells(line), note.to_owned()));
        }
        align(&rows, 2)
    }

    /// A section of the page.
    pub(crate) fn html(&self) -> String {
        let mut html = "<section>\n<h2>All scenes</h2>\n<p>Bias over the reference's mean, and RMSE; <b>!</b> is out of its bound. \
                        The front is that of mean time against mean RMSE.</p>\n<div class=\"wide\"><table>\n<thead><tr>"
            .to_owned();
        for head in self.head() {
            let _ = write!(html, "<th>{}</th>", escape(&head));
        }
        html += "<th>Pareto front</th></tr></thead>\n<tbody>\n";
        for line in &self.lines {
            html += "<tr>";
            for cell in self.cells(line) {
                let _ = write!(html, "<td>{}</td>", escape(&cell));
            }
            let _ = writeln!(html, "<td>{}</td></tr>", if line.front { "yes" } else { "" });
        }
        html + "</tbody></table></div>\n</section>\n"
    }

    fn head(&self) -> Vec<String> {
        let fixed = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        [
            fixed(&["effect", "setting"]),
            self.scenes.clone(),
            fixed(&["mean |bias|", "mean RMSE", "worst RMSE", "mean ms"]),
        ]
        .concat()
    }

    fn cells(&self, line: &Line) -> Vec<String> {
        let mut cells = vec![line.effect.clone(), line.setting.clone()];
        cells.extend(line.cells.iter().map(|cell| match cell {
            Some(Cell { bias, rmse, out, .. }) => {
                let bias = bias.map_or_else(|| "-".into(), percent);
                format!("{}{bias}, {}", if *out { "! " } else { "" }, short(*rmse))
            }
            None => "-".into(),
        }));
        let worst = line.worst.map(|(scene, rmse)| format!("{} {}", self.scenes[scene], short(rmse)));
        cells.extend([
            format!("{:.1} %", 100.0 * line.mean_bias),
            short(line.mean_rmse),
            worst.unwrap_or_else(|| "-".into()),
            format!("{:.1}", line.mean_ms),
        ]);
        cells
    }

    /// For each line of an effect the row that stands for its setting, its mean time, and its mean and worst RMSE.
    pub(crate) fn points<'a>(&'a self, effect: &'a str) -> impl Iterator<Item = (usize, f64, [f64; 2])> + 'a {
        let of_effect = self.lines.iter().filter(move |line| line.effect == effect);
        of_effect.filter_map(|line| Some((line.row, line.mean_ms, [line.mean_rmse, line.worst?.1])))
    }

    /// The effect that a plot of all scenes is about: the whole image, or the last.
    pub(crate) fn plotted(&self) -> &str {
        let last = self.lines.last().map_or("", |line| line.effect.as_str());
        self.lines.iter().map(|line| line.effect.as_str()).find(|effect| *effect == "final").unwrap_or(last)
    }
}

impl Line {
    fn sum_up(&mut self) {
        let there: Vec<(usize, &Cell)> =
            self.cells.iter().enumerate().filter_map(|(i, cell)| Some((i, cell.as_ref()?))).collect();
        let count = there.len().max(1) as f64;
        self.mean_ms = there.iter().map(|(_, cell)| cell.total_ms).sum::<f64>() / count;
        self.mean_rmse = there.iter().map(|(_, cell)| cell.rmse).sum::<f64>() / count;
        let biases: Vec<f64> = there.iter().filter_map(|(_, cell)| Some(cell.bias?.abs())).collect();
        self.mean_bias = biases.iter().sum::<f64>() / biases.len().max(1) as f64;
        let largest = |a: &(usize, f64), b: &(usize, f64)| a.1.total_cmp(&b.1);
        self.worst = there.iter().map(|(i, cell)| (*i, cell.rmse)).max_by(largest);
    }
}

fn cell(row: &Row, bounds: &[Bound]) -> Option<Cell> {
    let Outcome::Measured { total_ms, error, .. } = &row.outcome else { return None };
    let bound = bounds.iter().find(|bound| bound.scene == row.scene && bound.effect == row.effect);
    let out = bound.is_some_and(|bound| {
        error.bias_rel.is_some_and(|bias| bias.abs() > bound.bias)
            || bound.rmse.is_some_and(|rmse| error.rmse > rmse)
            || bound.flip.is_some_and(|flip| error.flip > flip)
    });
    Some(Cell { bias: error.bias_rel, rmse: error.rmse, total_ms: *total_ms, out })
}

fn words(row: &Row) -> String {
    setting_words(&row.format, &row.encoding, &row.tracer, row.resolution, row.scale)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::results::tests::{results, row};

    fn two_scenes() -> Results {
        let of = |scene: &str, format: &str, ms, rmse| {
            let mut row = Row { scene: scene.into(), ..row(format, ms, rmse) };
            if let Outcome::Measured { error, .. } = &mut row.outcome {
                error.bias_rel = Some(-rmse / 10.0);
            }
            row
        };
        let rows = vec![
            of("hall", "isotropic", 2.0, 0.5),
            of("hall", "sh2", 3.0, 0.75),
            of("room", "isotropic", 4.0, 0.25),
            of("room", "sh2", 5.0, 0.75),
        ];
        Results { rows, ..results() }
    }

    #[test]
    fn scenes_stand_side_by_side() {
        let bound =
            Bound { scene: "hall".into(), effect: "diffuse".into(), bias: 0.06, rmse: Some(0.6), flip: None };
        let overview = Overview::of(&two_scenes(), &[bound]).unwrap();
        let expected = "\
effect   setting                                    hall           room  mean |bias|  mean RMSE  worst RMSE  mean ms
diffuse  isotropic rgba16float 64³ rays    -5.0 %, 0.500  -2.5 %, 0.250        3.8 %      0.375  hall 0.500      3.0  Pareto front
diffuse  sh2 rgba16float 64³ rays        ! -7.5 %, 0.750  -7.5 %, 0.750        7.5 %      0.750  room 0.750      4.0
";
        assert_eq!(overview.text(), expected);
        assert_eq!(overview.out_of_bounds(), 1);
        assert!(overview.html().contains("<td>! -7.5 %, 0.750</td>"));
    }

    #[test]
    fn one_scene_needs_no_overview() {
        assert!(Overview::of(&results(), &[]).is_none());
    }
}
