//! Depth from the lights.

use super::{Binds, Expansion, step_params};
use crate::plan::{ImageExtent, ImageTexel, ResourceKind, Step};

pub(crate) fn shadow_maps(e: &mut Expansion<'_, '_>) {
    let kind = e.kind;
    let Some(size) = e.params.whole(kind, "size", &mut e.context.faults) else { return };
    let facts = e.context.facts;
    let layers = facts.directional + facts.spot + 6 * facts.point;
    let extent = ImageExtent::Fixed([size; 2]);
    let kind = ResourceKind::Image { extent, texel: ImageTexel::Depth32, layers, mips: 1 };
    let maps = e.context.resource("shadow_maps", kind);
    for layer in 0..layers {
        let binds = Binds { targets: &[step_params(layer)], ..Binds::default() };
        if let Some(program) = e.program_of("pass/shadow_map", &["vertex_main", "fragment_main"], &binds) {
            e.steps.push(Step::Draw { program, colors: Vec::new(), depth: (maps, layer), reversed: false });
        }
    }
}
