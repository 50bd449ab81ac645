//! A plan carried out and timed.

use std::time::Instant;

use voxlume::{Camera, Error, Gpu, Passes, Picture, Plan, Renderer, ResourceKind, Scene};
use voxlume_report::{OutOfRange, Pass};

use crate::Frames;

/// What a plan made and cost.
pub struct Measured {
    /// The plan's output.
    pub picture: Picture,
    /// Whether each pixel shows a surface.
    pub surface: Vec<bool>,
    pub passes: Vec<Pass>,
    pub total_ms: f64,
    pub volume_bytes: u64,
    pub out_of_range: Option<OutOfRange>,
}

/// Renders one frame of warm-up and `repeat` more.
///
/// # Errors
/// The device refuses something or is lost.
pub fn measure(
    gpu: &Gpu,
    plan: Plan,
    scene: &Scene,
    camera: &Camera,
    repeat: u32,
) -> Result<Measured, Error> {
    let mut renderer = Renderer::new(gpu, plan, scene)?;
    renderer.render(scene, camera, Passes::All)?;
    let mut frames = Frames::default();
    for _ in 0..repeat {
        let start = Instant::now();
        let times = renderer.render(scene, camera, Passes::All)?;
        frames.push(times, start.elapsed().as_secs_f64() * 1e3);
    }
    let plan = renderer.plan();
    let is_volume = |name: &str| {
        plan.resource(name).is_some_and(|i| matches!(plan.resources[i].kind, ResourceKind::Volume { .. }))
    };
    let volume_bytes =
        renderer.bytes().iter().filter(|(name, _)| is_volume(name)).map(|(_, bytes)| bytes).sum();
    let clamped = renderer.out_of_range()?;
    let out_of_range = clamped.map(|clamped| OutOfRange { texels: clamped.values, worst: clamped.worst });
    let picture = renderer.picture(&plan.resources[plan.output].name)?;
    let surface = match plan.resource("depth") {
        // Depth is reversed: 0 is infinitely far.
        Some(_) => renderer.picture("depth")?.pixels.iter().map(|pixel| pixel[0] > 0.0).collect(),
        // A plan that doesn't draw the scene has no other pixels.
        None => vec![true; picture.pixels.len()],
    };
    let (passes, total_ms) = (frames.passes(), frames.total().0);
    Ok(Measured { picture, surface, passes, total_ms, volume_bytes, out_of_range })
}
