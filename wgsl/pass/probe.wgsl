// Samples the volume at given places, levels and directions of travel.

import package::common::dispatch::dispatch_index;
import package::format::sample::voxel_sample;

struct Probe {
    uvw: vec3f,
    level: f32,
    direction: vec3f,
    padding: f32,
}

var<storage, read> probes: array<Probe>;
var<storage, read_write> probed: array<vec4f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    if (index < arrayLength(&probes)) {
        probed[index] = voxel_sample(probes[index].uvw, probes[index].level, probes[index].direction);
    }
}
