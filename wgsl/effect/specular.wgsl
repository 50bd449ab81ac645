// Glossy reflection (RAU §6.5): the radiance that the lit scene and the sky send along the mirrored view,
// W·m⁻²·sr⁻¹, averaged over a cone as wide as the surface's GGX lobe.

import package::common::cone::{ConeSettings, STEPPER_SPHERES, cone_trace, surface_cone};
import package::common::environment::environment;
import package::common::surface::Surface;

struct Params {
    /// Step over cell size, (0, 1].
    step: f32,
    /// Where cones begin: 1 is where the surface's own voxels end, [0, 4].
    start: f32,
}

// Half-angle of the cone that holds half of the GGX lobe's energy around the mirrored direction. Half of the
// microfacet normals lie within tan θ = α (from ∫ D cosθ dω = tan²θ / (α² + tan²θ)), and mirroring doubles
// the angle.
fn lobe_sine(roughness: f32) -> f32 {
    let alpha = roughness * roughness;
    return sin(min(2.0 * atan(alpha), 1.2));
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let direction = reflect(-surface.view, surface.normal);
    let sine = lobe_sine(surface.roughness);
    let cone = surface_cone(surface.position_voxel, surface.normal_geometric, direction, sine, 1e30, params.start);
    let value = cone_trace(cone, ConeSettings(STEPPER_SPHERES, params.step), 0.0);
    return vec4f(value.rgb + (1.0 - value.a) * environment.sky, value.a);
}
