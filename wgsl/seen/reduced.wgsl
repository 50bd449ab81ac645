// What an effect's texel stands for: a block of the screen's pixels, as the reduced guide describes it. What the guide does not
// hold is that of the pixel which the block is most like.

import package::common::camera::camera;
import package::common::grid::from_voxel;
import package::common::guide::unpack_guide;
import package::common::surface::{Surface, surface_load};

var guide: texture_2d_array<f32>;

// Pixels of the screen along a texel.
override SEEN_SCALE: u32 = 1;

fn surface_seen(texel: vec2u, size: vec2u) -> Surface {
    let block = unpack_guide(textureLoad(guide, texel, 0, 0));
    var surface = surface_load(SEEN_SCALE * texel + block.pixel);
    surface.position_voxel = block.position;
    surface.position = from_voxel(block.position);
    surface.normal = block.normal;
    surface.view = normalize(camera.eye - surface.position);
    surface.hit = block.hit;
    return surface;
}
