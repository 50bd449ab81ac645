//! Another build of the program, in turn with this one.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use voxlume_benches::table::{self, digits};

use crate::arguments::{Arguments, or, scene};

/// A frame that both render, everything redone.
struct Shot {
    scene: &'static str,
    resolution: u32,
    set: &'static [&'static str],
}

const OCCLUDED: &str = "composite.ao_weight=1";
const SHOTS: [Shot; 5] = [
    Shot { scene: "cornell", resolution: 128, set: &[OCCLUDED] },
    Shot { scene: "cornell", resolution: 128, set: &[OCCLUDED, "bounce.bounces=1"] },
    Shot { scene: "cornell", resolution: 256, set: &[OCCLUDED, "bounce.bounces=1"] },
    Shot { scene: "sponza", resolution: 128, set: &[OCCLUDED] },
    Shot { scene: "sponza", resolution: 256, set: &[OCCLUDED] },
];

/// An option of `voxlume render` with its value.
type Word = (&'static str, String);

/// A build of the program.
#[derive(Debug)]
struct Program {
    path: PathBuf,
    /// Options that it doesn't know, and does without.
    lacks: BTreeSet<String>,
}

/// Renders each frame with both programs, in turn, and prints how their times compare.
pub fn table(arguments: &Arguments, other: &Path, device: &str) -> Result<(), String> {
    let mut programs =
        [other.to_owned(), arguments.program()].map(|path| Program { path, lacks: BTreeSet::new() });
    for program in &programs {
        if !program.path.is_file() {
            let build = "`cargo build --release -p voxlume-cli` makes target/release/voxlume";
            return Err(format!("there is no program {}; {build}", program.path.display()));
        }
    }
    let [other, this] = programs.each_ref().map(|program| program.path.display().to_string());
    println!(
        "Milliseconds of all passes of a frame, everything redone: medians of {} rounds, in each both programs in turn, {} frames \
         after one of warm-up. Ratio: of `{this}` to `{other}`, the least, median and greatest of the rounds; below 1 `{this}` is faster.\n",
        arguments.rounds, arguments.repeat
    );
    let numbers = [other.as_str(), &this, "least", "median", "greatest"].map(str::to_owned);
    table::head(&["frame".to_owned()], &numbers);
    let mut failed = Vec::new();
    let mut absent = BTreeSet::new();
    for (label, words) in shots(arguments, &mut absent)? {
        match rounds(&mut programs, &label, &words, arguments, device) {
            Ok(rounds) => table::row([&label].into_iter().chain(&cells(&rounds))),
            Err(message) => failed.push(format!("{label}: {message}")),
        }
    }
    for path in absent {
        println!("\nskipped: there is no {}", path.display());
    }
    for Program { path, lacks } in &programs {
        for option in lacks {
            println!("\n`{}` knows no `{option}`, and ran without.", path.display());
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\nerror: ")) }
}

/// The frames that are selected.
fn shots(arguments: &Arguments, absent: &mut BTreeSet<PathBuf>) -> Result<Vec<(String, Vec<Word>)>, String> {
    let formats = or(&arguments.formats, &["six_face".to_owned()]);
    let tracers: Vec<Option<&String>> = match arguments.tracers.as_slice() {
        [] => vec![None],
        some => some.iter().map(Some).collect(),
    };
    let mut shots = Vec::new();
    for shot in &SHOTS {
        let path = scene(shot.scene)?;
        let of = |list: &[PathBuf]| list.is_empty() || list.contains(&path);
        let at = |list: &[u32]| list.is_empty() || list.contains(&shot.resolution);
        if !of(&arguments.scenes) || !at(&arguments.resolutions) {
            continue;
        }
        if !path.is_file() {
            absent.insert(path);
            continue;
        }
        for [width, height] in or(&arguments.sizes, &[[640, 360]]) {
            for format in &formats {
                for tracer in &tracers {
                    let mut words = vec![
                        ("", path.display().to_string()),
                        ("--size", format!("{width}x{height}")),
                        ("--resolution", shot.resolution.to_string()),
                        ("--format", format.clone()),
                        ("--output", "final".to_owned()),
                        ("--repeat", arguments.repeat.to_string()),
                    ];
                    words.extend(tracer.map(|tracer| ("--tracer", tracer.clone())));
                    words.extend(shot.set.iter().map(|set| ("--set", (*set).to_owned())));
                    let tracer = tracer.map(|tracer| format!(" {tracer}")).unwrap_or_default();
                    let label = format!(
                        "{} {width}x{height} {}³ {format}{tracer} {}",
                        shot.scene,
                        shot.resolution,
                        shot.set.join(" ")
                    );
                    shots.push((label, words));
                }
            }
        }
    }
    Ok(shots)
}

/// Milliseconds of both programs in each round.
fn rounds(
    programs: &mut [Program; 2],
    label: &str,
    words: &[Word],
    arguments: &Arguments,
    device: &str,
) -> Result<Vec<[f64; 2]>, String> {
    let round = |round: u32| {
        eprintln!("{label}: round {} of {}", round + 1, arguments.rounds);
        let mut times = [0.0; 2];
        // Who begins changes, so that a machine that slows down slows both.
        for index in if round.is_multiple_of(2) { [0, 1] } else { [1, 0] } {
            times[index] = programs[index].render(words, device)?;
        }
        Ok(times)
    };
    (0..arguments.rounds).map(round).collect()
}

fn cells(rounds: &[[f64; 2]]) -> [String; 5] {
    let sorted = |of: fn(&[f64; 2]) -> f64| {
        let mut values: Vec<f64> = rounds.iter().map(of).collect();
        values.sort_by(f64::total_cmp);
        values
    };
    let median = |values: &[f64]| f64::midpoint(values[(values.len() - 1) / 2], values[values.len() / 2]);
    let (other, this, ratio) =
        (sorted(|times| times[0]), sorted(|times| times[1]), sorted(|[other, this]| this / other));
    [median(&other), median(&this), ratio[0], median(&ratio), ratio[ratio.len() - 1]].map(digits)
}

impl Program {
    /// Milliseconds of all passes, the median that the program prints.
    fn render(&mut self, words: &[Word], device: &str) -> Result<f64, String> {
        let picture = std::env::temp_dir().join(format!("voxlume-bench-{}.png", std::process::id()));
        loop {
            let mut command = Command::new(&self.path);
            command.arg("render").arg("-o").arg(&picture);
            for (option, value) in words.iter().filter(|(option, _)| !self.lacks.contains(*option)) {
                command.args([*option, value.as_str()].iter().filter(|word| !word.is_empty()));
            }
            let output = command.output().map_err(|error| format!("{}: {error}", self.path.display()))?;
            // A picture that isn't there needs no removing.
            let _ = std::fs::remove_file(&picture);
            let said = String::from_utf8_lossy(&output.stderr);
            if output.status.success() {
                return milliseconds(&String::from_utf8_lossy(&output.stdout), device);
            }
            let known = |option: &&Word| said.contains(&format!("unexpected argument '{}'", option.0));
            match words.iter().find(known) {
                Some((option, _)) if self.lacks.insert((*option).to_owned()) => {}
                _ => {
                    let error = said.lines().rfind(|line| line.starts_with("error")).unwrap_or("it failed");
                    return Err(format!("{}: {error}", self.path.display()));
                }
            }
        }
    }
}

/// Read off what `voxlume render` prints.
fn milliseconds(printed: &str, device: &str) -> Result<f64, String> {
    let name = printed.lines().next().and_then(|line| line.split(" · ").next()).unwrap_or_default();
    if name != device {
        return Err(format!("it ran on `{name}`, not on `{device}`"));
    }
    let total = printed.lines().find_map(|line| line.strip_prefix("all passes"));
    let median = total.and_then(|rest| rest.split_whitespace().next()?.parse().ok());
    median.ok_or_else(|| "it printed no time of all passes".to_owned())
}
