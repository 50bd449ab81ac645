// For textures that the device doesn't filter: sixteen loads do what a linear sampler would.

fn filter_level(volume: texture_3d<f32>, uvw: vec3f, level: i32) -> vec4f {
    let last = vec3i(textureDimensions(volume, level)) - 1;
    let p = uvw * vec3f(last + 1) - 0.5;
    let low = vec3i(floor(p));
    let share = p - floor(p);
    var sum = vec4f(0.0);
    for (var i = 0; i < 8; i++) {
        let corner = vec3i(i & 1, (i >> 1) & 1, i >> 2);
        let weights = select(1.0 - share, share, corner == vec3i(1));
        let texel = textureLoad(volume, clamp(low + corner, vec3i(0), last), level);
        sum += weights.x * weights.y * weights.z * texel;
    }
    return sum;
}

// What a level has to say at a place between levels.
fn filter_share(volume: texture_3d<f32>, uvw: vec3f, place: f32, level: i32) -> vec4f {
    let weight = 1.0 - abs(f32(level) - place);
    if (weight <= 0.0) {
        return vec4f(0.0);
    }
    return weight * filter_level(volume, uvw, level);
}

fn filter_volume(volume: texture_3d<f32>, uvw: vec3f, level: f32) -> vec4f {
    let place = clamp(level, 0.0, f32(textureNumLevels(volume) - 1));
    // Each level in its own words, though at most two count: Mesa 22.3's llvmpipe loads every lane's texels from the
    // level of the first lane, which may have left the loop that calls this. 512 voxels have ten levels.
    return filter_share(volume, uvw, place, 0) + filter_share(volume, uvw, place, 1)
        + filter_share(volume, uvw, place, 2) + filter_share(volume, uvw, place, 3)
        + filter_share(volume, uvw, place, 4) + filter_share(volume, uvw, place, 5)
        + filter_share(volume, uvw, place, 6) + filter_share(volume, uvw, place, 7)
        + filter_share(volume, uvw, place, 8) + filter_share(volume, uvw, place, 9);
}
