// The mean of an image around each of its texels.

import package::common::surface::Surface;

struct Params {
    /// Texels, [0, 8].
    radius: u32,
}

var source: texture_2d_array<f32>;

fn effect(surface: Surface, params: Params) -> vec4f {
    let radius = i32(params.radius);
    var sum = vec4f(0.0);
    var count = 0.0;
    for (var y = -radius; y <= radius; y++) {
        for (var x = -radius; x <= radius; x++) {
            let texel = vec2i(surface.pixel) + vec2i(x, y);
            if (all(texel >= vec2i(0)) && all(texel < vec2i(surface.image_size))) {
                sum += textureLoad(source, texel, 0, 0);
                count += 1.0;
            }
        }
    }
    return sum / count;
}
