//! Depth from the lights.

use super::{ParamWords, PassKind, Port, Sort, Values};
use crate::bundle::Bundle;
use crate::expansion::{Expansion, step_params};
use crate::plan::{ImageExtent, ImageTexel, ResourceKind, Target};

/// See [`PassKind::sentence`].
#[derive(Debug)]
pub(crate) struct ShadowMaps;

impl PassKind for ShadowMaps {
    fn name(&self) -> &str {
        "shadow_maps"
    }

    fn sentence(&self) -> &str {
        "draws the scene's depth from every directional, spot and point light"
    }

    fn writes(&self) -> &[Port] {
        &[const { Port::new("shadow_maps", Sort::SHADOW_MAPS, "depth maps") }]
    }

    fn words(&self) -> &[ParamWords] {
        &[ParamWords { name: "size", sentence: "side of a map in texels", values: Values::Whole(16, 4096) }]
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let Some(size) = pass.whole("size") else { return };
        let facts = pass.facts();
        let layers = facts.directional + facts.spot + 6 * facts.point;
        let extent = ImageExtent::Fixed([size; 2]);
        let kind = ResourceKind::Image { extent, texel: ImageTexel::Depth32, layers, mips: 1 };
        let maps = pass.resource(&pass.written(), kind);
        pass.makes(Bundle::of("shadow_maps", Target::Resource(maps)));
        for layer in 0..layers {
            pass.run("pass/shadow_map").reads("step_params", step_params(layer)).draws(
                &[],
                (maps, layer),
                false,
            );
        }
    }
}
