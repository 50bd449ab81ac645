//! `voxlume render --frames`: an animation as numbered pictures.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Instant;

use voxlume::{Fault, Frame, Gpu, Passes, Renderer};
use voxlume_measure::outfile::{self, OutFile};
use voxlume_measure::picture::Kind;
use voxlume_measure::{Frames, Progress as _, shows};

use super::{Args, report};
use crate::Registry;
use crate::failure::Failure;
use crate::interrupt;
use crate::progress::Progress;
use crate::timing::{Numbers, Ran};

/// `A..B`: from A on, up to the one before B.
pub fn numbers(text: &str) -> Result<Range<u32>, String> {
    let ends = text.split_once("..").and_then(|(first, end)| Some(first.parse().ok()?..end.parse().ok()?));
    let ends = ends.filter(|ends: &Range<u32>| !ends.is_empty());
    ends.ok_or_else(|| "two whole numbers, the second above the first, such as 0..48".into())
}

/// Frames a second.
pub fn rate(text: &str) -> Result<f64, String> {
    let rate = text.parse().ok().filter(|rate: &f64| *rate > 0.0 && rate.is_finite());
    rate.ok_or_else(|| "a number above 0".into())
}

/// A path with a place for a number: `{}`, or `{:04}` for four digits at least.
#[derive(Debug, PartialEq)]
struct Pattern {
    before: String,
    digits: usize,
    after: String,
}

impl Pattern {
    fn of(path: &Path) -> Result<Pattern, Fault> {
        let text = path.to_string_lossy();
        let none = || {
            let fault = Fault::new(format!("`{text}` has no place for the frame's number, or several"));
            fault.note("such as frame_{:04}.png")
        };
        let (before, rest) = text.split_once('{').ok_or_else(none)?;
        let (place, after) = rest.split_once('}').ok_or_else(none)?;
        let digits = match place.strip_prefix(":0") {
            Some(digits) => digits.parse().ok().filter(|digits| (1..=9).contains(digits)),
            None => place.is_empty().then_some(1),
        };
        match digits {
            Some(digits) if !after.contains(['{', '}']) => {
                Ok(Pattern { before: before.to_owned(), digits, after: after.to_owned() })
            }
            _ => Err(none()),
        }
    }

    fn path(&self, number: u32) -> PathBuf {
        let Pattern { before, digits, after } = self;
        PathBuf::from(format!("{before}{number:0digits$}{after}"))
    }
}

/// Renders the frames, each written when it is done.
pub fn run(args: &Args, registry: &Registry, range: &Range<u32>) -> Result<(), Failure> {
    interrupt::wish();
    let patterns = args.out.iter().map(|path| Ok((Kind::of(path)?, Pattern::of(path)?)));
    let patterns: Vec<(Kind, Pattern)> = patterns.collect::<Result<_, Fault>>()?;
    let first = patterns.iter().map(|(_, pattern)| OutFile::new(&pattern.path(range.start)));
    let first = first.collect::<Result<Vec<_>, Fault>>()?;
    let json = args.json.as_deref().map(OutFile::new).transpose()?;
    outfile::distinct(first.iter().chain(&json))?;
    let pipeline = args.image.plan.pipeline()?;

    let mut progress = Progress::new();
    progress.stage(format!("loading {}", args.image.plan.scene.display()));
    let mut scene = args.image.plan.scene()?;
    if scene.animation == Default::default() {
        let fault = Fault::new(format!("nothing moves in `{}`", args.image.plan.scene.display()));
        return Err(fault.note("`--frames` needs an object, a light or a camera with a `path`").into());
    }
    let name = scene.camera(args.camera.as_deref())?.name.clone();
    let fps = args.fps.unwrap_or(24.0);
    let time = |number: u32| f64::from(number) / fps;
    scene.set_time(time(range.start));
    progress.stage("planning".into());
    args.image.plan(registry, &pipeline, &scene, None)?;
    let gpu = Gpu::open(args.adapter.as_deref())?;
    let plan = args.image.plan(registry, &pipeline, &scene, Some(&gpu))?;
    progress.stage(format!("compiling {} passes", plan.passes.len()));
    let mut renderer = Renderer::new(&gpu, plan, &scene)?;
    progress.stage("rendering".into());
    renderer.render(&scene, scene.camera(Some(&name))?, Passes::All)?;
    // The first frame does all that a first frame has to do.
    renderer.session_mut().forget();

    let mut frames = Frames::default();
    for number in range.clone() {
        if interrupt::wished() {
            let (done, all) = (frames.count(), range.len());
            return Err(Failure::work(format!("interrupted; {done} of {all} frames were written")));
        }
        let done = frames.count() as f32 / range.len() as f32;
        progress.share(&format!("frame {number}"), done);
        scene.set_time(time(number));
        let start = Instant::now();
        renderer.update(&scene)?;
        let camera = scene.camera(Some(&name))?;
        let times = renderer.frame(&Frame { seconds: time(number) as f32, ..Frame::of(camera) })?;
        frames.push(times, start.elapsed().as_secs_f64() * 1e3);

        let image = &renderer.plan().resources[renderer.plan().output].name;
        let picture = renderer.picture(image)?;
        let shows = shows(&pipeline, &args.image.plan.set, image);
        let encode = |(kind, pattern): &(Kind, Pattern)| {
            Ok((OutFile::new(&pattern.path(number))?, kind.encode(&picture, shows, args.exposure.exp2())?))
        };
        outfile::write(&patterns.iter().map(encode).collect::<Result<Vec<_>, Failure>>()?)?;
    }

    let each = range.clone().zip(frames.ran()).map(|(frame, ran)| Ran { frame, ran }).collect();
    let numbers = Numbers { first: range.start, end: range.end, fps, each };
    let runs = numbers.runs();
    let clamped = renderer.out_of_range()?;
    let mut report = report(&gpu, &scene, &renderer, &frames, clamped);
    report.frames = Some(numbers);
    if let Some(file) = json {
        outfile::write(&[(file, super::json(&report)?)])?;
    }
    drop(progress);
    crate::print(&(report.tables(&frames) + "\n" + &runs))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn ranges() {
        assert_eq!(numbers("3..10"), Ok(3..10));
        for wrong in ["", "3", "3..", "..3", "3..3", "4..3", "-1..3", "1...3", "a..b"] {
            assert!(numbers(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn paths_with_a_number() {
        let path = |text: &str, number| Pattern::of(Path::new(text)).unwrap().path(number);
        assert_eq!(path("out/frame_{:04}.png", 7), Path::new("out/frame_0007.png"));
        assert_eq!(path("{}.exr", 12345), Path::new("12345.exr"));
        assert_eq!(path("a{:02}b", 123), Path::new("a123b"));
        for wrong in ["a.png", "{.png", "{}{}.png", "{:4}.png", "{:0}.png", "{:010}.png", "{x}.png", "}{.png"]
        {
            assert!(Pattern::of(Path::new(wrong)).is_err(), "{wrong}");
        }
    }
}
