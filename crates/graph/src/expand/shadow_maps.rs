//! Depth from the lights.

use super::{Binds, Expansion, step_params};
use crate::plan::{ResourceKind, Step};

pub(crate) fn shadow_maps(e: &mut Expansion<'_, '_>) {
    let kind = e.kind;
    let Some(size) = e.params.whole(kind, "size", &mut e.context.faults) else { return };
    let facts = e.context.facts;
    let layers = facts.directional + facts.spot + 6 * facts.point;
    let maps = e.context.resource("shadow_maps", ResourceKind::ShadowMaps { size, layers });
    for layer in 0..layers {
        let binds = Binds { targets: &[step_params(layer)], ..Binds::default() };
        if let Some(program) = e.program_of("pass/shadow_map", &["vertex_main", "fragment_main"], &binds) {
            e.steps.push(Step::Draw { program, colors: Vec::new(), depth: (maps, layer), reversed: false });
        }
    }
}
