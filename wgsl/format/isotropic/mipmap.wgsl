// Isotropic mipmapping. Radiance is the mean of eight children, weighted by their opacity (RAU §5.3.1). The mean
// of their opacities would halve a wall one voxel thick at every level, and light would pass; so the parent
// is as opaque as along the axis on which its children cover the most.

import package::common::coverage::composite_coverage;
import package::common::volume::load_volume;
import package::encoding::{VolumeTarget, encode_texel};

var base_source: texture_3d<f32>;
var base_target: VolumeTarget;

fn voxel_mipmap(cell: vec3u, level: u32) {
    var sum = vec4f(0.0);
    var opacity: array<vec3f, 8>;
    for (var i = 0u; i < 8; i++) {
        let child = load_volume(base_source, cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2));
        sum += child;
        opacity[i] = vec3f(child.a);
    }
    let coverage = composite_coverage(opacity);
    let most = max(coverage.x, max(coverage.y, coverage.z));
    textureStore(base_target, cell, encode_texel(vec4f(sum.rgb * (most / max(sum.a, 1e-6)), most)));
}
