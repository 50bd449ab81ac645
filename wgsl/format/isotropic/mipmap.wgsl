// Isotropic mipmapping: the mean of eight children (RAU §5.3.1).

@group(2) @binding(1) var base_source: texture_3d<f32>;
@group(2) @binding(8) var base_target: texture_storage_3d<rgba16float, write>;

fn voxel_mipmap(cell: vec3u, level: u32) {
    var sum = vec4f(0.0);
    for (var i = 0u; i < 8; i++) {
        sum += textureLoad(base_source, cell * 2 + vec3u(i & 1, (i >> 1) & 1, i >> 2), 0);
    }
    textureStore(base_target, cell, sum / 8.0);
}
