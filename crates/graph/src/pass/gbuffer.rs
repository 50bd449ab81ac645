//! What the camera sees.

use super::{PassKind, Port, Sort};
use crate::bundle::Bundle;
use crate::expansion::{Expansion, Over, screen_image};
use crate::plan::{ImageTexel, Target};

/// See [`PassKind::sentence`].
#[derive(Debug)]
pub(crate) struct Gbuffer;

impl PassKind for Gbuffer {
    fn name(&self) -> &str {
        "gbuffer"
    }

    fn sentence(&self) -> &str {
        "draws what the camera sees"
    }

    fn writes(&self) -> &[Port] {
        &[const {
            Port::new(
                "surface",
                Sort::SURFACE,
                "albedo, normal, geometry, emission and depth, one image each",
            )
        }]
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let emissive = pass.facts().emissive;
        let targets = [
            ("albedo", ImageTexel::Rgba8Srgb, true),
            ("normal", ImageTexel::Rgba16Float, true),
            ("geometry", ImageTexel::Rgba16Float, true),
            ("emission", ImageTexel::Rgba16Float, emissive || pass.is_output("emission")),
        ];
        let mut bundle = Bundle::default();
        // Images that nobody reads are left out once all passes are known.
        let colors = targets.map(|(name, texel, needed)| {
            let image = needed.then(|| pass.part("surface", name, screen_image(texel, 1)))?;
            bundle.add(name, Target::Resource(image));
            Some(image)
        });
        let depth = pass.part("surface", "depth", screen_image(ImageTexel::Depth32, 1));
        bundle.add("depth", Target::Resource(depth));
        let guide = pass.is_interleaved().then(|| {
            let guide = pass.part("surface", "guide", screen_image(ImageTexel::Rgba32Float, 1));
            bundle.add("guide", Target::Resource(guide));
            guide
        });
        pass.makes(bundle);
        pass.run("pass/gbuffer").with("HAS_EMISSION", emissive).draws(&colors, (depth, 0), true);
        if let Some(guide) = guide {
            pass.run("pass/guide").writes("image", Target::Resource(guide)).over(Over::Texels(guide));
        }
        if !emissive {
            let [width, height] = pass.screen().map(u64::from);
            pass.leaves_out("emission image", "no material emits", 8 * width * height);
        }
    }
}
