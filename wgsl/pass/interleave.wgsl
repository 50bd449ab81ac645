// The mean over the pixels that shared out an effect's directions (interleaved sampling, Keller and Heidrich 2001), in two
// steps: over 4 × 4 pixels, then over 2 × 2 of these means 4 pixels apart. Together they hold each of the 64 sets once. Only
// pixels on the same surface count.

import package::common::alone::{is_alone, with_others};
import package::common::guide::{Guide, same_surface, unpack_guide};

var image: texture_storage_2d_array<rgba16float, write>;
var gathered: texture_2d_array<f32>;
var guide: texture_2d_array<f32>;

// The second step.
override APART: bool = false;
// No other step follows.
override LAST: bool = true;

// That of what is in the middle of a texel.
fn guide_at(texel: vec2i, ratio: vec2f) -> Guide {
    return unpack_guide(textureLoad(guide, vec2i((vec2f(texel) + 0.5) * ratio), 0, 0));
}

// Pixel number `index` of the window, from the one that gets the mean.
fn window(index: i32) -> vec2i {
    return select(vec2i(index & 3, index >> 2) - 1, 4 * vec2i(index & 1, index >> 1) - 2, APART);
}

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(image);
    if (any(id.xy >= size)) {
        return;
    }
    let texel = vec2i(id.xy);
    let ratio = vec2f(textureDimensions(guide)) / vec2f(size);
    let own = guide_at(texel, ratio);
    let value = textureLoad(gathered, texel, id.z, 0);
    if (is_alone(value)) {
        // As it is, in the end with its own alpha.
        textureStore(image, id.xy, id.z, select(value, with_others(value), LAST));
        return;
    }
    let count = select(16, 4, APART);
    var sum = vec4f(0.0);
    var found = 0;
    for (var i = 0; own.hit && i < count; i++) {
        let other = texel + window(i);
        let inside = all(other >= vec2i(0)) && all(other < vec2i(size));
        if (inside && same_surface(own, guide_at(other, ratio))) {
            let theirs = textureLoad(gathered, other, id.z, 0);
            if (!is_alone(theirs)) {
                sum += theirs;
                found += 1;
            }
        }
    }
    if (own.hit && APART) {
        // The pixel's own mean stands for those that are missing.
        sum += f32(4 - found) * value;
        found = 4;
    }
    textureStore(image, id.xy, id.z, sum / f32(max(found, 1)));
}
