//! What a run cost, as a table and as JSON.

use serde::Serialize;
use voxlume_measure::Frames;
use voxlume_report::{Device, OutOfRange, Pass};

use crate::table::Table;

/// Times and bytes of a run. Its JSON is version 1 of `render --json`.
#[derive(Debug, Serialize)]
pub struct Report {
    /// Version of the JSON's form.
    pub schema: u32,
    /// What it ran on.
    pub device: Device,
    /// The scene's name.
    pub scene: String,
    /// Storage format.
    pub format: String,
    /// Texel encoding.
    pub encoding: String,
    /// Voxels along the grid's longest side.
    pub resolution: u32,
    /// In the order of execution.
    pub passes: Vec<Pass>,
    /// Median over the frames of the sum of all passes.
    pub total_ms: f64,
    /// Buffers and textures.
    pub resources: Vec<Resource>,
    /// Voxels that a triangle touches.
    pub occupied_voxels: u64,
    /// What the encoding could not hold; absent where it held all. With several frames, of the last.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub out_of_range: Option<OutOfRange>,
    /// Which frames of the animation these are; absent for a still picture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frames: Option<Numbers>,
}

/// Frames of an animation.
#[derive(Debug, Serialize)]
pub struct Numbers {
    /// The first.
    pub first: u32,
    /// The one after the last.
    pub end: u32,
    /// Frames a second.
    pub fps: f64,
    /// What each of them did.
    pub each: Vec<Ran>,
}

/// What a frame of an animation did.
#[derive(Debug, Serialize)]
pub struct Ran {
    /// Its number.
    pub frame: u32,
    /// The passes that ran, in order.
    pub ran: Vec<String>,
}

impl Numbers {
    /// The passes that ran, a line for frames in a row that ran the same.
    pub fn runs(&self) -> String {
        let mut text = "passes that ran\n".to_owned();
        for alike in self.each.chunk_by(|one, next| one.ran == next.ran) {
            let (Some(first), Some(last)) = (alike.first(), alike.last()) else { continue };
            let frames = match first.frame == last.frame {
                true => format!("frame {}", first.frame),
                false => format!("frames {} to {}", first.frame, last.frame),
            };
            let passes = if first.ran.is_empty() { "none".to_owned() } else { first.ran.join(", ") };
            text += &format!("{frames}: {passes}\n");
        }
        text
    }
}

/// A resource's size.
#[derive(Debug, Serialize)]
pub struct Resource {
    /// Its name in the plan.
    pub name: String,
    /// Its bytes.
    pub bytes: u64,
}

impl Report {
    /// The tables that `render` prints.
    pub fn tables(&self, frames: &Frames) -> String {
        let Device { name, kind, driver } = &self.device;
        let (format, encoding, n, occupied) =
            (&self.format, &self.encoding, self.resolution, self.occupied_voxels);
        let clock = match self.passes.first().map(|pass| pass.clock.as_str()) {
            Some("gpu") => "the device's timestamps",
            _ => "the host's clock, as the device has no timestamps to rely on",
        };
        let mut passes = Table::new(["pass", "median ms", "spread ms"]).numbers_from(1);
        let count = frames.count();
        let mut time = |name: &str, (median, spread): (f64, f64)| {
            // A single frame doesn't spread.
            let spread = if count > 1 { format!("{spread:.2}") } else { "-".to_owned() };
            passes.row([name.to_owned(), format!("{median:.2}"), spread]);
        };
        for pass in &self.passes {
            time(&pass.name, (pass.median_ms, pass.spread_ms));
        }
        time("all passes", frames.total());
        time("frame by the host's clock", frames.wall());
        let mut resources = Table::new(["resource", "bytes"]).numbers_from(1);
        for resource in &self.resources {
            resources.row([resource.name.clone(), resource.bytes.to_string()]);
        }
        let bytes: u64 = self.resources.iter().map(|resource| resource.bytes).sum();
        resources.row(["all resources".to_owned(), bytes.to_string()]);
        let count = match count {
            1 => "one frame".to_owned(),
            count => format!("{count} frames (spread: interquartile range)"),
        };
        format!(
            "{name} · {kind} · {driver}\n\
             {} · {format} {encoding} · {n} × {n} × {n} voxels, {occupied} occupied\n\n\
             times of {count} after one of warm-up, by {clock}\n{passes}\n{resources}",
            self.scene
        )
    }
}
