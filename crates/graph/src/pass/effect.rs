//! A WGSL file run for every pixel of an image.

use super::gbuffer::guide_name;
use super::{PassKind, Port, Sort};
use crate::bundle::Bundle;
use crate::expansion::{Expansion, Over};
use crate::facts::Emission;
use crate::pipeline::SCALES;
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
        let (extent, texel, scale) = (entry.image.extent, entry.image.texel, pass.scale());
        let layers = if entry.layers.is_some() { pass.light_count().div_ceil(4).max(1) } else { 1 };
        let kind = |extent, layers| ResourceKind::Image { extent, texel, layers, mips: 1 };
        let image = pass.resource(&pass.written(), kind(extent, layers));
        pass.makes(Bundle::of(&pass.written(), Target::Resource(image)));
        let Some(shader) = pass.checked_effect(&module) else { return };
        // Reduced, such an effect has as many layers more, which say from where its light comes.
        let leans = scale > 1 && shader.links("common/leaning");
        let means = means(entry.interleave, scale);
        // The last mean writes the image. Others write one of two that all effects of a size share: each is read right after it
        // is written.
        let place = |pass: &mut Expansion<'_, '_>, at: u32, left: usize| {
            let extent = if at == 1 { extent } else { ImageExtent::Screen { divisor: at } };
            let layers = if leans && at > 1 { 2 * layers } else { layers };
            match left.is_multiple_of(2) {
                true if at == 1 => image,
                even => pass.resource(&between_name(even, extent, layers), kind(extent, layers)),
            }
        };
        let mut from = place(pass, scale, means.len());
        let guide = pass.variable(&guide_name(scale));
        let lamps = match pass.emission() {
            Emission::AreaLights => "lamps/area",
            Emission::Sampled => "lamps/voxels",
            Emission::Gathered => "lamps/none",
        };
        let gather = pass
            .run("pass/effect")
            .mount("effect", &module)
            .mount("texel", texel_module(texel))
            .mount("lamps", lamps)
            .writes("image", Target::Resource(from))
            .with("INTERLEAVE", entry.interleave)
            .with("LEANS", leans);
        match guide.filter(|_| scale > 1) {
            Some(guide) => {
                gather.mount("seen", "seen/reduced").reads("guide", guide).with("SEEN_SCALE", scale)
            }
            None => gather,
        }
        .over(Over::Layers(from, layers));
        for (index, mean) in means.iter().enumerate() {
            let at = mean.scale();
            let to = place(pass, at, means.len() - 1 - index);
            // Missing only where the entry reads no surface, which is a fault of its own.
            let guide = |pass: &Expansion<'_, '_>, scale| pass.variable(&guide_name(scale));
            let (fine, coarse) = (guide(pass, at), guide(pass, 2 * at));
            let (step, over) = match (mean, fine, coarse) {
                (Mean::Shared { apart, .. }, Some(fine), _) => {
                    let last = !matches!(means.get(index + 1), Some(Mean::Shared { .. }));
                    let step = pass.run("pass/interleave").reads("guide", fine);
                    (step.with("APART", *apart).with("LAST", last), Over::Texels(to))
                }
                (Mean::Up { .. }, Some(fine), Some(coarse)) => {
                    let step = pass.run("pass/upsample").reads("guide", fine).reads("coarse_guide", coarse);
                    (step.with("LEANS", leans), Over::Quads(to))
                }
                _ => return,
            };
            step.reads("gathered", Target::Resource(from)).writes("image", Target::Resource(to)).over(over);
            from = to;
        }
    }
}

/// A mean over what an effect gave for several pixels.
enum Mean {
    /// Over pixels that shared out directions, next to each other or apart.
    Shared { scale: u32, apart: bool },
    /// Over texels of half the size, by what they show.
    Up { scale: u32 },
}

impl Mean {
    /// What the screen's size is divided by where it gives values.
    fn scale(&self) -> u32 {
        match self {
            Mean::Shared { scale, .. } | Mean::Up { scale } => *scale,
        }
    }
}

/// The means that an entry asks for, in their order.
fn means(interleave: u32, scale: u32) -> Vec<Mean> {
    let apart = match interleave {
        8 => [Some(false), Some(true)],
        4 => [Some(false), None],
        _ => [None, None],
    };
    let shared = apart.into_iter().flatten().map(|apart| Mean::Shared { scale, apart });
    let up = SCALES.into_iter().rev().filter(|finer| *finer < scale).map(|scale| Mean::Up { scale });
    shared.chain(up).collect()
}

fn between_name(even: bool, extent: ImageExtent, layers: u32) -> String {
    let name = format!("{}_{layers}", if even { "gathered" } else { "interleaved" });
    match extent {
        ImageExtent::Screen { divisor: 1 } => name,
        ImageExtent::Screen { divisor } => format!("{name}_of_{divisor}"),
        ImageExtent::Fixed([width, height]) => format!("{name}_of_{width}x{height}"),
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
