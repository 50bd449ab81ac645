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
        Some(_) => {
            let depth = renderer.picture("depth")?.pixels;
            // Depth is reversed: 0 is infinitely far.
            screen_pixels(plan.screen, [picture.width, picture.height])
                .map(|pixel| depth[pixel][0] > 0.0)
                .collect()
        }
        // A plan that doesn't draw the scene has no other pixels.
        None => vec![true; picture.pixels.len()],
    };
    let (passes, total_ms) = (frames.passes(), frames.total().0);
    Ok(Measured { picture, surface, passes, total_ms, volume_bytes, out_of_range })
}

/// Texels of the image that a plan makes, along x and y.
pub fn image_size(plan: &Plan) -> [u32; 2] {
    match plan.resources[plan.output].kind {
        ResourceKind::Image { extent, .. } => extent.size(plan.screen),
        _ => plan.screen,
    }
}

/// For each texel of an image, the index of the pixel of the screen that it shades; WGSL's `screen_pixel`.
pub fn screen_pixels(
    [screen_width, screen_height]: [u32; 2],
    [width, height]: [u32; 2],
) -> impl Iterator<Item = usize> {
    let middle = |texel: u32, screen: u32, size: u32| {
        ((2 * texel as usize + 1) * screen as usize) / (2 * size as usize)
    };
    (0..height).flat_map(move |y| {
        let row = middle(y, screen_height, height) * screen_width as usize;
        (0..width).map(move |x| row + middle(x, screen_width, width))
    })
}

#[cfg(test)]
mod tests {
    use super::screen_pixels;

    #[test]
    fn a_texel_shades_the_pixel_in_its_middle() {
        assert_eq!(screen_pixels([3, 2], [3, 2]).collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5]);
        assert_eq!(screen_pixels([4, 4], [2, 2]).collect::<Vec<_>>(), [5, 7, 13, 15]);
        // 5 pixels over 3 texels: the middles are at 0.83, 2.5 and 4.17.
        assert_eq!(screen_pixels([5, 1], [3, 1]).collect::<Vec<_>>(), [0, 2, 4]);
    }
}
