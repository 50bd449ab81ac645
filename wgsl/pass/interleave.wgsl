// The mean over the pixels that shared out an effect's directions (interleaved sampling, Keller and Heidrich 2001), in two
// steps: over 4 × 4 pixels, then over 2 × 2 of these means 4 pixels apart. Together they hold each of the 64 sets once. Only
// pixels on the same surface count.

import package::common::guide::{Guide, same_surface, unpack_guide};
import package::common::camera::camera;

var image: texture_storage_2d_array<rgba16float, write>;
var interleaved: texture_2d_array<f32>;
var guide: texture_2d_array<f32>;

// The second step.
override APART: bool = false;

// The guide of the screen's pixel in the middle of a texel.
fn guide_at(texel: vec2i, ratio: vec2f) -> Guide {
    return unpack_guide(textureLoad(guide, vec2i((vec2f(texel) + 0.5) * ratio), 0, 0));
}

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(image);
    if (any(id.xy >= size)) {
        return;
    }
    let ratio = vec2f(camera.screen) / vec2f(size);
    let own = guide_at(vec2i(id.xy), ratio);
    let first = select(-1, -2, APART);
    let step = select(1, 4, APART);
    let count = select(4, 2, APART);
    var sum = vec4f(0.0);
    var weight = 0.0;
    for (var i = 0; i < count * count; i++) {
        let pixel = clamp(vec2i(id.xy) + first + step * vec2i(i % count, i / count), vec2i(0), vec2i(size) - 1);
        let other = guide_at(pixel, ratio);
        if (own.hit && same_surface(own, other)) {
            sum += textureLoad(interleaved, pixel, id.z, 0);
            weight += 1.0;
        }
    }
    // 4 × 4 hold the pixel's own; of 2 × 2 none may be on its surface.
    if (own.hit && weight == 0.0) {
        sum = textureLoad(interleaved, id.xy, id.z, 0);
    }
    textureStore(image, id.xy, id.z, sum / max(weight, 1.0));
}
