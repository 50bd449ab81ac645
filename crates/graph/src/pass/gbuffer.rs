//! What the camera sees.

use super::{ParamWords, PassKind, Port, Sort, Values};
use crate::bundle::Bundle;
use crate::expansion::{Expansion, Over, screen_image};
use crate::pipeline::SCALES;
use crate::plan::{ImageExtent, ImageTexel, ResourceKind, Target};

/// The guide of the screen over `scale` (see wgsl/common/guide.wgsl).
pub(super) fn guide_name(scale: u32) -> String {
    if scale == 1 { "guide".to_owned() } else { format!("guide_{scale}") }
}

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

    fn words(&self) -> &[ParamWords] {
        const WORDS: &[ParamWords] = &[ParamWords {
            name: "textures",
            sentence: "how they are looked up: the mean over a pixel, or the place at its middle",
            values: Values::Words(&["filtered", "at_centre"]),
        }];
        WORDS
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
        let scales = SCALES.into_iter().filter(|scale| Some(*scale) <= pass.coarsest_mean());
        let scales: Vec<u32> = scales.collect();
        let guides: Vec<usize> = scales
            .into_iter()
            .map(|scale| {
                let (extent, texel) = (ImageExtent::Screen { divisor: scale }, ImageTexel::Rgba32Float);
                let name = guide_name(scale);
                let guide =
                    pass.part("surface", &name, ResourceKind::Image { extent, texel, layers: 1, mips: 1 });
                bundle.add(&name, Target::Resource(guide));
                guide
            })
            .collect();
        pass.makes(bundle);
        let filtered = pass.word_or("textures", "filtered") == Some("filtered");
        pass.run("pass/gbuffer").with("HAS_EMISSION", emissive).with("FILTERS_TEXTURES", filtered).draws(
            &colors,
            (depth, 0),
            true,
        );
        if let Some(&guide) = guides.first() {
            pass.run("pass/guide").writes("image", Target::Resource(guide)).over(Over::Texels(guide));
        }
        for (pair, scale) in guides.windows(2).zip(SCALES) {
            pass.run("pass/reduce")
                .reads("guide", Target::Resource(pair[0]))
                .writes("image", Target::Resource(pair[1]))
                .with("SCALE", scale)
                .over(Over::Texels(pair[1]));
        }
        if !emissive {
            let [width, height] = pass.screen().map(u64::from);
            pass.leaves_out("emission image", "no material emits", 8 * width * height);
        }
    }
}
