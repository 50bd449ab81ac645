// Glossy reflection (RAU §6.5): the radiance that the lit scene and the sky send along the mirrored view,
// W·m⁻²·sr⁻¹, averaged over the surface's GGX lobe. Alpha is the mean opacity met.

import package::common::grid::longest_side;
import package::common::surface::{Surface, surface_apex};
import package::common::trace::{ggx_lobe, reach_of};
import package::tracer::trace::trace_gather;

struct Params {
    /// Farthest surface that sends light, as a share of the grid's longest side; beyond it is the sky; 1000 unless given.
    distance: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let lobe = ggx_lobe(surface.normal, surface.view, surface.roughness);
    let found = trace_gather(surface_apex(surface), lobe, reach_of(params.distance * longest_side()));
    return vec4f(found.radiance, found.opacity);
}
