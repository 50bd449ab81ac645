//! What the camera sees.

use super::screen_image;
use super::{Binds, Expansion};
use crate::plan::{ImageTexel, Step};

pub(crate) fn gbuffer(e: &mut Expansion<'_, '_>) {
    let depth = e.context.resource("depth", screen_image(ImageTexel::Depth32, 1));
    let targets = [
        ("albedo", ImageTexel::Rgba8Srgb),
        ("normal", ImageTexel::Rgba16Float),
        ("geometry", ImageTexel::Rgba16Float),
        ("emission", ImageTexel::Rgba16Float),
    ];
    let colors = targets.map(|(name, texel)| {
        e.context.surface_images.contains(name).then(|| e.context.resource(name, screen_image(texel, 1)))
    });
    let emission = [("HAS_EMISSION", f64::from(e.context.facts.emissive))];
    let binds = Binds { constants: &emission, ..Binds::default() };
    if let Some(program) = e.program_of("pass/gbuffer", &["vertex_main", "fragment_main"], &binds) {
        e.steps.push(Step::Draw { program, colors: colors.to_vec(), depth: (depth, 0), reversed: true });
    }
}
