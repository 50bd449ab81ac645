// How many workgroups cover all tiles.

import package::common::frame::frame;
import package::common::tile_walk::tile_ranks;
import package::common::dispatch::dispatch_groups;

@group(1) @binding(7) var<storage, read_write> tile_groups: vec3u;

@compute @workgroup_size(1)
fn main() {
    tile_groups = dispatch_groups(tile_ranks[frame.triangle_count], 64);
}
