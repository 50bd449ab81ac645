// Isotropic mipmapping. Radiance is the mean of eight children, weighted by their opacity (RAU §5.3.1). The mean
// of their opacities would halve a wall one voxel thick at every level, and light would pass; so the parent
// is as opaque as along the axis on which its children cover the most.

import package::common::coverage::composite_columns;
import package::common::volume::load_volume;
import package::encoding::{VolumeTarget, encode_texel};

var base_source: texture_3d<f32>;
var base_target: VolumeTarget;

fn voxel_mipmap(cell: vec3u, level: u32) {
    var sum = vec4f(0.0);
    var children: array<vec4f, 8>;
    for (var i = 0u; i < 8; i++) {
        children[i] = load_volume(base_source, cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2));
        sum += children[i];
    }
    var most = 0.0;
    for (var axis = 0u; axis < 3; axis++) {
        most = max(most, composite_columns(children, axis, 0).a);
    }
    textureStore(base_target, cell, encode_texel(vec4f(sum.rgb * (most / max(sum.a, 1e-6)), most)));
}
