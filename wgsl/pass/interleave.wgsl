// The mean over the pixels that shared out an effect's directions (interleaved sampling, Keller and Heidrich 2001): any
// window of 4 × 4 holds each of the 16 sets once. Only pixels on the same surface count.

import package::common::surface::{screen_pixel, surface_load};

var image: texture_storage_2d_array<rgba16float, write>;
var interleaved: texture_2d_array<f32>;

// Another pixel's surface is the same one where it lies this near to the plane, in voxels, and its normal's cosine
// with this one's is at least so much.
const SAME_PLANE = 1.0;
const SAME_NORMAL = 0.9;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(image);
    if (any(id.xy >= size)) {
        return;
    }
    let own = surface_load(screen_pixel(id.xy, size));
    if (!own.hit) {
        textureStore(image, id.xy, id.z, vec4f(0.0));
        return;
    }
    var sum = vec4f(0.0);
    var weight = 0.0;
    for (var y = -1; y < 3; y++) {
        for (var x = -1; x < 3; x++) {
            let pixel = vec2i(id.xy) + vec2i(x, y);
            if (any(pixel < vec2i(0)) || any(pixel >= vec2i(size))) {
                continue;
            }
            let other = surface_load(screen_pixel(vec2u(pixel), size));
            let distance = abs(dot(other.position_voxel - own.position_voxel, own.normal_geometric));
            if (other.hit && distance < SAME_PLANE && dot(other.normal, own.normal) > SAME_NORMAL) {
                sum += textureLoad(interleaved, pixel, id.z, 0);
                weight += 1.0;
            }
        }
    }
    // Its own pixel is always among them.
    textureStore(image, id.xy, id.z, sum / weight);
}
