// Direct light on every voxel: RAU eq. 7.1, DVS §2. One thread an active voxel.

import package::common::attributes::{voxel_facing, voxel_facings, voxel_surface};
import package::common::constants::PI;
import package::common::environment::environment;
import package::common::grid::{grid, from_voxel, to_voxel};
import package::common::light::{Light, lights, light_incidence, Incidence, LIGHT_AREA, HAS_AREA};
import package::common::light_part::light_part;
import package::common::shadow_map::shadow_map_visibility;
import package::common::ray::{Ray, Tangent};
import package::common::trace::{Apex, voxel_apex};
import package::common::voxels::level_cell;
import package::common::dispatch::dispatch_index;
import package::common::turn::turn_at;
import package::meet::{arrive, leave};
import package::walk::first_hit;

struct Params {
    /// How far over a voxel's centre a shadow map is asked; 1.5 is over every cell of a plane through it.
    bias: f32,
    /// Parts of a light along each of its sides, [1, 4]: neighbouring voxels send their rays to different ones.
    parts: u32,
}

var<uniform> params: Params;
var<storage, read_write> direct: array<vec4f>;

// Occlusion from shadow maps where the light has one, else by a ray through the voxels.
override USE_SHADOW_MAP: bool = true;

fn visibility(light: Light, incidence: Incidence, apex: Apex) -> f32 {
    if (USE_SHADOW_MAP && light.shadow_layer >= 0) {
        return shadow_map_visibility(light, from_voxel(apex.position + apex.normal * (2.0 * params.bias * apex.depth)));
    }
    let origin = leave(apex);
    var goal = Tangent(vec3f(0.0), vec3f(0.0));
    var reach = incidence.distance / grid.voxel_size;
    if (HAS_AREA && light.kind == LIGHT_AREA) {
        // The voxel may be behind a light of two sides.
        let facing = select(-light.direction, light.direction, dot(light.direction, incidence.direction) < 0.0);
        goal = Tangent(to_voxel(light.position), facing);
        reach = arrive(incidence.direction, origin.point, goal);
    }
    return select(1.0, 0.0, first_hit(Ray(origin.point, incidence.direction, reach, origin, goal), 0).found);
}

fn irradiance(p_voxel: vec3f, normal: vec3f, turn: f32) -> vec3f {
    let apex = voxel_apex(p_voxel, normal, turn);
    // The surface lies at most half of |n|₁ from the voxel's centre; the centre stands for it.
    let position = from_voxel(p_voxel);
    var sum = vec3f(0.0);
    for (var i = 0u; i < environment.light_count; i++) {
        let light = lights[i];
        let whole = light_incidence(light, position, normal);
        if (all(whole.irradiance <= vec3f(0.0))) {
            continue;
        }
        let part = light_part(light, whole, params.parts, turn, position, normal);
        sum += whole.irradiance * visibility(light, part, apex);
    }
    return sum;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    let surface = voxel_surface(slot);
    let p_voxel = vec3f(cell) + 0.5;
    let turn = turn_at(cell.xy ^ cell.zz);
    let facings = voxel_facings(surface);
    var arriving = vec3f(0.0);
    for (var i = 0u; i < facings.count; i++) {
        let normal = voxel_facing(surface, facings, i);
        var both = irradiance(p_voxel, normal, turn);
        if (facings.opposite > 0.0) {
            // One value stands for both sides: what arrives at either.
            both += facings.opposite * irradiance(p_voxel, -normal, turn);
        }
        arriving += both / facings.divisor;
    }
    direct[slot] = vec4f(surface.emission + surface.albedo / PI * arriving, 1.0);
}
