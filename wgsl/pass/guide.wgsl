// What the passes that take means over pixels need of each (see common/guide.wgsl).

import package::common::guide::{Guide, pack_guide};
import package::common::surface::surface_load;

var image: texture_storage_2d_array<rgba32float, write>;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if (all(id.xy < textureDimensions(image))) {
        let surface = surface_load(id.xy);
        let guide = Guide(surface.position_voxel, surface.normal, vec2u(0), surface.hit);
        textureStore(image, id.xy, 0, pack_guide(guide));
    }
}
