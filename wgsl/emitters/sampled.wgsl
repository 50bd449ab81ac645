// Light of many emissive polygons, however many: each ray goes to one of a few candidates, drawn by power and chosen by what they
// would give here (resampled importance sampling: Talbot, Cline and Egbert, "Importance Resampling for Global Illumination", EGSR
// 2005, eq. 6). Neighbours draw others.

import package::common::constants::GOLDEN;
import package::common::environment::environment;
import package::common::grid::{from_voxel, grid, to_voxel};
import package::common::light::{Light, area_corners, facing_normal, light_incidence, lights};
import package::common::light_part::quad_point;
import package::common::ray::{Ray, Tangent, arrive, is_of, leave};
import package::common::trace::{Apex, Arriving, LEAST_COSINE, luminance};
import package::walk::first_hit;

const SAMPLED = true;

const CANDIDATES = 8u;
// Powers of one over the plastic number (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
const PLASTIC = vec2f(0.75487767, 0.56984029);

// The polygon to which a share in [0, 1) of all power falls. They follow the other lights, each with the share of all before it and
// itself, and its own.
fn emitter_at(share: f32) -> u32 {
    var low = environment.light_count;
    var high = arrayLength(&lights) - 1;
    while (low < high) {
        let middle = (low + high) / 2;
        if (lights[middle].falloff.x <= share) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

// About what a polygon gives, and more than nothing wherever it gives something.
fn expected(light: Light, position: vec3f, normal: vec3f) -> f32 {
    let offset = light.position - position;
    let distance2 = dot(offset, offset) + light.area;
    let direction = offset * inverseSqrt(distance2);
    let facing = -dot(direction, light.direction);
    let shown = select(select(0.0, 0.05 - facing, light.size > 0.0), 0.05 + facing, facing >= 0.0);
    return luminance(light.intensity) * light.area * shown * max(dot(direction, normal) + 0.05, 0.05) / distance2;
}

// Whether nothing lies before a point of a polygon.
fn sees(apex: Apex, light: Light, u: vec2f) -> bool {
    let origin = leave(apex);
    let point = to_voxel(quad_point(area_corners(light), u.x, u.y));
    let direction = normalize(point - origin.point);
    let goal = Tangent(point, facing_normal(light, direction));
    if (dot(direction, apex.normal) <= 0.0 || is_of(apex.normal, dot(apex.normal, apex.position), goal)) {
        return false;
    }
    // What lies within a voxel before a polygon that is smaller than one is the same lamp: its voxel's planes are means over it.
    let own = select(0.0, 1.0, light.area < grid.voxel_size * grid.voxel_size);
    let reach = arrive(direction, origin.point, goal) - own;
    return !first_hit(Ray(origin.point, direction, reach, origin, goal)).found;
}

fn emitters_irradiance(apex: Apex, normal: vec3f, rays: u32) -> Arriving {
    let position = from_voxel(apex.position);
    var sum = vec3f(0.0);
    var vector = vec3f(0.0);
    for (var ray = 0u; ray < rays; ray++) {
        let turn = f32(apex.share.index * rays + ray);
        let start = fract((turn + 0.5) * GOLDEN);
        var left = fract(0.5 + turn * GOLDEN * GOLDEN);
        var total = 0.0;
        var chosen = 0u;
        var at_chosen = 0.0;
        for (var i = 0u; i < CANDIDATES; i++) {
            let index = emitter_at((f32(i) + start) / f32(CANDIDATES));
            let light = lights[index];
            let gives = expected(light, position, normal);
            let weight = gives / max(light.falloff.y, 1e-20);
            total += weight;
            // One number draws among all candidates: what is left of it is again even in [0, 1).
            let share = weight / max(total, 1e-30);
            if (left < share) {
                chosen = index;
                at_chosen = gives;
                left = left / share;
            } else {
                left = (left - share) / max(1.0 - share, 1e-6);
            }
        }
        if (at_chosen > 0.0) {
            let light = lights[chosen];
            let incidence = light_incidence(light, position, normal);
            let irradiance = incidence.irradiance;
            if (any(irradiance > vec3f(0.0)) && sees(apex, light, fract(0.5 + turn * PLASTIC))) {
                let arriving = irradiance * (total / (at_chosen * f32(CANDIDATES)));
                sum += arriving;
                vector += incidence.direction * (luminance(arriving) / max(dot(normal, incidence.direction), LEAST_COSINE));
            }
        }
    }
    return Arriving(sum / f32(rays), vector / f32(rays));
}
