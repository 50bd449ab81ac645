//! A WGSL file run for every pixel of an image.

use super::{PassKind, Port, Sort};
use crate::bundle::Bundle;
use crate::expansion::{Expansion, Over};
use crate::plan::{ImageExtent, ImageTexel, ResourceKind, Target};

/// Effects are made by a kind of their own, which has no word: `run` names the effect.
#[derive(Debug)]
pub(crate) struct Effect;

impl PassKind for Effect {
    fn name(&self) -> &str {
        "effect"
    }

    fn sentence(&self) -> &str {
        "runs an effect for every pixel of its image"
    }

    fn writes(&self) -> &[Port] {
        &[const { Port::new("image", Sort::IMAGE, "what the effect gives") }]
    }

    fn traces(&self) -> bool {
        true
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let entry = pass.entry();
        let module = entry.run.value.trim_end_matches(".wgsl").to_owned();
        let (extent, texel, interleave) = (entry.image.extent, entry.image.texel, entry.interleave);
        let layers = if entry.layers.is_some() { pass.light_count().div_ceil(4).max(1) } else { 1 };
        let kind = ResourceKind::Image { extent, texel, layers, mips: 1 };
        let image = pass.resource(&pass.written(), kind.clone());
        pass.makes(Bundle::of(&pass.written(), Target::Resource(image)));
        if pass.checked_effect(&module).is_none() {
            return;
        }
        // Shared by all of one size: each is read right after it is written.
        let between =
            |pass: &mut Expansion<'_, '_>| pass.resource(&interleaved_name(extent, layers), kind.clone());
        let traced = if interleave == 4 { between(pass) } else { image };
        pass.run("pass/effect")
            .mount("effect", &module)
            .mount("texel", texel_module(texel))
            .writes("image", Target::Resource(traced))
            .with("INTERLEAVE", interleave)
            .over(Over::Texels(image));
        let means = match interleave {
            8 => {
                let between = between(pass);
                vec![(image, between, false), (between, image, true)]
            }
            4 => vec![(traced, image, false)],
            _ => vec![],
        };
        for (from, to, apart) in means {
            pass.run("pass/interleave")
                .reads("interleaved", Target::Resource(from))
                .writes("image", Target::Resource(to))
                .with("APART", apart)
                .over(Over::Texels(image));
        }
    }
}

fn interleaved_name(extent: ImageExtent, layers: u32) -> String {
    match extent {
        ImageExtent::Screen { divisor: 1 } => format!("interleaved_{layers}"),
        ImageExtent::Screen { divisor } => format!("interleaved_{layers}_of_{divisor}"),
        ImageExtent::Fixed([width, height]) => format!("interleaved_{layers}_of_{width}x{height}"),
    }
}

/// The WGSL module that stores texels of an image.
fn texel_module(texel: ImageTexel) -> &'static str {
    match texel {
        ImageTexel::Rgba32Float => "texel/rgba32float",
        ImageTexel::Rg32Float => "texel/rg32float",
        ImageTexel::R32Float => "texel/r32float",
        ImageTexel::R32Uint => "texel/r32uint",
        ImageTexel::Rgba8Unorm => "texel/rgba8unorm",
        ImageTexel::Rgba16Float | ImageTexel::Rgba8Srgb | ImageTexel::Depth32 => "texel/rgba16float",
    }
}
