// Glossy reflection (RAU §6.5): the radiance that the lit scene and the sky send along the mirrored view,
// W·m⁻²·sr⁻¹, averaged over a cone as wide as the surface's GGX lobe.

import package::common::environment::environment;
import package::common::surface::Surface;
import package::common::trace::{Apex, reach_of};
import package::tracer::trace::trace_gather;

struct Params {
    /// Where traces begin: 1 is where the surface's own voxels end, [0, 4].
    start: f32,
}

// Half-angle of the cone that holds half of the GGX lobe's energy around the mirrored direction. Half of the
// microfacet normals lie within tan θ = α (from ∫ D cosθ dω = tan²θ / (α² + tan²θ)), and mirroring doubles
// the angle.
fn lobe_half_sine(roughness: f32) -> f32 {
    let alpha = roughness * roughness;
    return sin(min(2.0 * atan(alpha), 1.2));
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let apex = Apex(surface.position_voxel, surface.normal_geometric, params.start);
    let direction = reflect(-surface.view, surface.normal);
    let found = trace_gather(apex, direction, lobe_half_sine(surface.roughness), reach_of(1e30));
    return vec4f(found.radiance + (1.0 - found.opacity) * environment.sky, found.opacity);
}
