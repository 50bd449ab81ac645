// A guide of half the size: of each block of 2 × 2, the mean over those that show the surface which most of them show. So no
// single pixel stands for its block.

import package::common::guide::{Guide, pack_guide, same_surface, unpack_guide};

var image: texture_storage_2d_array<rgba32float, write>;
var guide: texture_2d_array<f32>;

// Pixels of the screen along a texel of the finer guide.
override SCALE: u32 = 1;

// At the border of an odd size a block repeats its texels.
fn block_texel(coarse: vec2u, index: u32) -> vec2u {
    return min(2 * coarse + vec2u(index & 1, index >> 1), textureDimensions(guide) - 1);
}

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if (any(id.xy >= textureDimensions(image))) {
        return;
    }
    var block: array<Guide, 4>;
    for (var i = 0u; i < 4; i++) {
        block[i] = unpack_guide(textureLoad(guide, block_texel(id.xy, i), 0, 0));
    }
    var most = 0u;
    var chosen = 0u;
    for (var i = 0u; i < 4; i++) {
        var alike = 0u;
        for (var j = 0u; j < 4; j++) {
            alike += u32(same_surface(block[i], block[j]));
        }
        // Pixels that show nothing stand for their block only where all do.
        if (block[i].hit && alike > most) {
            most = alike;
            chosen = i;
        }
    }
    var sum = Guide(vec3f(0.0), vec3f(0.0), vec2u(0), most > 0);
    var count = 0.0;
    for (var j = 0u; j < 4; j++) {
        if (same_surface(block[chosen], block[j])) {
            sum.position += block[j].position;
            sum.normal += block[j].normal;
            count += 1.0;
        }
    }
    if (sum.hit) {
        sum.position /= count;
        sum.normal = normalize(sum.normal);
        sum.pixel = SCALE * (block_texel(id.xy, chosen) - 2 * id.xy) + block[chosen].pixel;
    }
    textureStore(image, id.xy, 0, pack_guide(sum));
}
