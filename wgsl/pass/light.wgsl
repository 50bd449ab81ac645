// Direct light on every voxel: RAU eq. 7.1, DVS §2. One thread an active voxel.

import package::common::attributes::{voxel_facing, voxel_facings, voxel_surface};
import package::common::constants::PI;
import package::common::environment::environment;
import package::common::grid::{grid, from_voxel, to_voxel};
import package::common::light::{Light, lights, light_incidence, Incidence, LIGHT_AREA, HAS_AREA};
import package::common::light_part::light_part;
import package::common::shadow_map::shadow_map_visibility;
import package::common::voxel_ray::ray_blocked;
import package::common::voxels::level_cell;
import package::common::dispatch::dispatch_index;
import package::common::turn::turn_at;

struct Params {
    /// How far over a voxel's centre it looks for the light; 1.5 is over every cell of a plane through it.
    bias: f32,
    /// Parts of a light along each of its sides, [1, 4]: neighbouring voxels send their rays to different ones.
    parts: u32,
}

var<uniform> params: Params;
var<storage, read_write> direct: array<vec4f>;

// Occlusion from shadow maps where the light has one, else by a ray through the voxels.
override USE_SHADOW_MAP: bool = true;

// How far over a plane of this normal the cells that it touches reach, in voxels.
fn cell_height(normal: vec3f) -> f32 {
    return abs(normal.x) + abs(normal.y) + abs(normal.z);
}

fn visibility(light: Light, incidence: Incidence, p_voxel: vec3f, normal: vec3f) -> f32 {
    let lift = normal * (params.bias * cell_height(normal));
    let origin = p_voxel + lift;
    if (USE_SHADOW_MAP && light.shadow_layer >= 0) {
        return shadow_map_visibility(light, from_voxel(origin));
    }
    var reach = incidence.distance / grid.voxel_size - dot(lift, incidence.direction);
    if (HAS_AREA && light.kind == LIGHT_AREA) {
        // Stops short of the voxels of the light itself.
        let cosine = dot(light.direction, incidence.direction);
        let height = abs(dot(to_voxel(light.position) - origin, light.direction));
        reach = (height - cell_height(light.direction)) / max(abs(cosine), 1e-3);
    }
    return select(1.0, 0.0, ray_blocked(origin, incidence.direction, reach));
}

fn irradiance(p_voxel: vec3f, normal: vec3f, turn: f32) -> vec3f {
    // The surface lies at most half a voxel from the voxel's centre; the centre stands for it.
    let position = from_voxel(p_voxel);
    var sum = vec3f(0.0);
    for (var i = 0u; i < environment.light_count; i++) {
        let light = lights[i];
        let whole = light_incidence(light, position, normal);
        if (all(whole.irradiance <= vec3f(0.0))) {
            continue;
        }
        let part = light_part(light, whole, params.parts, turn, position, normal);
        sum += whole.irradiance * visibility(light, part, p_voxel, normal);
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
