// Direct light on every side of every voxel: RAU eq. 7.1, DVS §2. One thread an active voxel.

import package::common::attributes::voxel_surface;
import package::common::constants::PI;
import package::common::environment::environment;
import package::common::grid::{cell_height, grid, from_voxel, to_voxel};
import package::common::light::{Light, facing_normal, lights, light_incidence, Incidence, LIGHT_AREA, HAS_AREA};
import package::common::light_part::light_part;
import package::common::shadow_map::shadow_map_visibility;
import package::common::ray::{Ray, Tangent, arrive, is_of, leave};
import package::common::radiance::pack_radiance;
import package::common::side::{Side, next_side, side_reflectance};
import package::common::trace::{Apex, turn_of};
import package::common::voxels::level_cell;
import package::common::dispatch::dispatch_index;
import package::common::share::share_at;
import package::emitters::{SAMPLED, emitters_irradiance};
import package::walk::first_hit;

struct Params {
    /// How far over a voxel's centre a shadow map is asked; 1.5 is over every cell of a plane through it.
    bias: f32,
    /// Parts of a light along each of its sides, [1, 4]: neighbouring voxels send their rays to different ones.
    parts: u32,
    /// Rays of a voxel's side to emissive polygons, where there are many, [1, 64]; 2 unless given.
    lamps: u32,
}

var<uniform> params: Params;
var<storage, read_write> direct: array<u32>;

// Occlusion from shadow maps where the light has one, else by a ray through the voxels.
override USE_SHADOW_MAP: bool = true;

fn visibility(light: Light, incidence: Incidence, apex: Apex) -> f32 {
    if (USE_SHADOW_MAP && light.shadow_layer >= 0) {
        return shadow_map_visibility(light, from_voxel(apex.position + apex.normal * (params.bias * cell_height(apex.normal))));
    }
    let origin = leave(apex);
    var goal = Tangent(vec3f(0.0), vec3f(0.0));
    var reach = incidence.distance / grid.voxel_size;
    if (HAS_AREA && light.kind == LIGHT_AREA) {
        goal = Tangent(to_voxel(light.position), facing_normal(light, incidence.direction));
        // A surface in the light's own voxels lies beside it, not before it.
        if (is_of(apex.normal, dot(apex.normal, apex.position), goal)) {
            return 0.0;
        }
        reach = arrive(incidence.direction, origin.point, goal);
    }
    return select(1.0, 0.0, first_hit(Ray(origin.point, incidence.direction, reach, origin, goal)).found);
}

// Radiosity over π of what lights send.
fn reflected(side: Side) -> vec3f {
    let apex = side.apex;
    let position = from_voxel(apex.position);
    var sum = vec3f(0.0);
    for (var i = 0u; i < environment.light_count; i++) {
        let light = lights[i];
        let whole = light_incidence(light, position, apex.normal);
        if (all(whole.irradiance <= vec3f(0.0))) {
            continue;
        }
        let part = light_part(light, whole, params.parts, turn_of(apex.share), position, apex.normal);
        sum += side_reflectance(side, whole.direction) * whole.irradiance * visibility(light, part, apex);
    }
    return (sum + side.reflectance * emitters_irradiance(apex, apex.normal, params.lamps).irradiance) / PI;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let slot = dispatch_index(id, 64);
    var cell: vec3u;
    if (!level_cell(slot, 0, &cell)) {
        return;
    }
    let surface = voxel_surface(slot);
    let share = share_at(cell.xy ^ cell.zz, 8);
    // What gathers get from polygons they don't get from voxels.
    var at = 0u;
    var side: Side;
    while (next_side(cell, slot, surface, share, &at, &side)) {
        direct[side.index] = pack_radiance(select(side.emission, vec3f(0.0), SAMPLED) + reflected(side));
    }
}
