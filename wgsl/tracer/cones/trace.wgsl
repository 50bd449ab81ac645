// Voxel cone tracing (RAU §6.1, DVS §4): a lobe as one cone as wide as it is, or the hemisphere as several of 60°.

import package::common::basis::basis_around;
import package::common::diffuse_cones::{DIFFUSE_HALF_SINE, DiffuseCones, FULL_RING, diffuse_direction, diffuse_weight};
import package::common::environment::environment;
import package::common::trace::{Apex, Gathered, LOBE_CONE, LOBE_GGX, LOBE_HEMISPHERE, Lobe, Reach, turn_of, vector_of};
import package::tracer::composite::composite_cone;
import package::tracer::cone::{Cone, cone_of};
import package::tracer::step::trace_params;

// Half-angle of the cone that holds half of the GGX lobe's energy around the mirrored direction. Half of the
// microfacet normals lie within tan θ = α (from ∫ D cosθ dω = tan²θ / (α² + tan²θ)), and mirroring doubles
// the angle.
fn ggx_half_sine(roughness: f32) -> f32 {
    let alpha = roughness * roughness;
    return sin(min(2.0 * atan(alpha), 1.2));
}

// A full ring stands for itself, and isn't turned.
fn hemisphere_cones(turn: f32) -> DiffuseCones {
    return DiffuseCones(trace_params.ring, select(turn, 0.0, trace_params.ring >= FULL_RING));
}

fn cone_count(lobe: Lobe) -> u32 {
    return select(1, trace_params.ring + 1, lobe.shape == LOBE_HEMISPHERE);
}

fn cone_weight(lobe: Lobe, index: u32) -> f32 {
    if (lobe.shape != LOBE_HEMISPHERE) {
        return 1.0;
    }
    return diffuse_weight(hemisphere_cones(0.0), index);
}

fn lobe_cone(apex: Apex, lobe: Lobe, reach: Reach, index: u32) -> Cone {
    if (lobe.shape == LOBE_CONE) {
        return cone_of(apex, trace_params.start, lobe.axis, lobe.width, reach);
    }
    if (lobe.shape == LOBE_GGX) {
        return cone_of(apex, trace_params.start, reflect(-lobe.view, lobe.axis), ggx_half_sine(lobe.width), reach);
    }
    // A hemisphere keeps clear of the plane that it stands on, be that the surface's own or that of its shading.
    var upright = apex;
    upright.normal = lobe.axis;
    let direction = basis_around(lobe.axis) * diffuse_direction(hemisphere_cones(turn_of(apex.share)), index);
    return cone_of(upright, trace_params.start, direction, DIFFUSE_HALF_SINE, reach);
}

fn trace_gather(apex: Apex, lobe: Lobe, reach: Reach) -> Gathered {
    var sum = vec4f(0.0);
    var vector = vec3f(0.0);
    var distance = 1e30;
    for (var i = 0u; i < cone_count(lobe); i++) {
        let cone = lobe_cone(apex, lobe, reach, i);
        let found = composite_cone(cone, 0.0, true);
        let arriving = found.radiance + (1.0 - found.opacity) * environment.sky;
        sum += cone_weight(lobe, i) * vec4f(arriving, found.opacity);
        vector += cone_weight(lobe, i) * vector_of(lobe, cone.direction, arriving);
        distance = min(distance, found.distance);
    }
    return Gathered(sum.rgb, sum.a, distance, vector, false);
}

fn trace_opacity(apex: Apex, lobe: Lobe, reach: Reach, falloff: f32) -> f32 {
    var sum = 0.0;
    for (var i = 0u; i < cone_count(lobe); i++) {
        sum += cone_weight(lobe, i) * composite_cone(lobe_cone(apex, lobe, reach, i), falloff, false).opacity;
    }
    return sum;
}
