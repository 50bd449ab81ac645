// Samples the volume at given places, levels and directions of travel, also for cones with their apex at given places.

import package::common::dispatch::dispatch_index;
import package::format::sample::{voxel_sample, voxel_sample_ahead};

struct Probe {
    uvw: vec3f,
    level: f32,
    direction: vec3f,
    padding: f32,
    apex: vec3f,
    padding_apex: f32,
    behind: vec3f,
    padding_behind: f32,
}

struct Probed {
    sample: vec4f,
    ahead: vec4f,
    behind: vec3f,
    known: f32,
}

var<storage, read> probes: array<Probe>;
var<storage, read_write> probed: array<Probed>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    if (index < arrayLength(&probes)) {
        let probe = probes[index];
        let sample = voxel_sample(probe.uvw, probe.level, probe.direction);
        let seen = voxel_sample_ahead(probe.uvw, probe.level, probe.direction, probe.apex, probe.behind);
        probed[index] = Probed(sample, seen.value, seen.behind, seen.known);
    }
}
