// The mean over the pixels that shared out an effect's directions (interleaved sampling, Keller and Heidrich 2001), in two
// steps: over 4 × 4 pixels, then over 2 × 2 of these means 4 pixels apart. Together they hold each of the 64 sets once. Only
// pixels on the same surface count.

import package::common::surface::{screen_pixel, surface_load};

var image: texture_storage_2d_array<rgba16float, write>;
var interleaved: texture_2d_array<f32>;

// The second step.
override APART: bool = false;

// Another pixel's surface is the same one where it lies this near to the plane, in voxels, and its normal's cosine
// with this one's is at least so much.
const SAME_PLANE = 1.0;
const SAME_NORMAL = 0.9;

// Pixels around a workgroup's own that it reads, and all along a side.
const MARGIN = 2;
const SIDE = 12;

struct Neighbour {
    value: vec4f,
    position: vec3f,
    // Zero where nothing is behind the pixel.
    normal: vec3f,
}

var<workgroup> tile: array<Neighbour, SIDE * SIDE>;

fn neighbour(pixel: vec2i, layer: u32) -> Neighbour {
    let size = textureDimensions(interleaved);
    if (any(pixel < vec2i(0)) || any(pixel >= vec2i(size))) {
        return Neighbour(vec4f(0.0), vec3f(0.0), vec3f(0.0));
    }
    let surface = surface_load(screen_pixel(vec2u(pixel), size));
    let value = textureLoad(interleaved, pixel, layer, 0);
    return Neighbour(value, surface.position_voxel, select(vec3f(0.0), surface.normal, surface.hit));
}

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u, @builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let corner = vec2i(group.xy) * 8 - MARGIN;
    for (var i = i32(lane); i < SIDE * SIDE; i += 64) {
        tile[i] = neighbour(corner + vec2i(i % SIDE, i / SIDE), id.z);
    }
    workgroupBarrier();
    let at = vec2i(id.xy) - corner;
    let own = tile[at.y * SIDE + at.x];
    let geometric = surface_load(screen_pixel(min(id.xy, textureDimensions(image) - 1), textureDimensions(image))).normal_geometric;
    let first = select(-1, -2, APART);
    let step = select(1, 4, APART);
    let count = select(4, 2, APART);
    var sum = vec4f(0.0);
    var weight = 0.0;
    for (var i = 0; i < count * count; i++) {
        let offset = first + step * vec2i(i % count, i / count);
        let other = tile[(at.y + offset.y) * SIDE + at.x + offset.x];
        let distance = abs(dot(other.position - own.position, geometric));
        if (distance < SAME_PLANE && dot(other.normal, own.normal) > SAME_NORMAL) {
            sum += other.value;
            weight += 1.0;
        }
    }
    if (all(id.xy < textureDimensions(image))) {
        // 4 × 4 hold the pixel's own; of 2 × 2 none may be on its surface.
        let alone = select(vec4f(0.0), own.value, any(own.normal != vec3f(0.0)));
        textureStore(image, id.xy, id.z, select(alone, sum / max(weight, 1.0), weight > 0.0));
    }
}
