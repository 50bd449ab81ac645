// How far blocks are from occupied ones, an axis at a time: along x from the bitmask, then along y and z from the pass before, since
// the distance is the largest of the coordinates' differences. One thread a word of four blocks.

import package::common::dispatch::dispatch_index;
import package::common::grid::{brick_count, brick_strides};
import package::common::leap::{MOST_LEAP, block_counts, leap_first, leap_rows};

var<storage, read_write> occupancy: array<u32>;

fn row_of(index: u32) -> vec3u {
    let rows = leap_rows();
    return vec3u(index % rows.x, index / rows.x % rows.y, index / (rows.x * rows.y));
}

fn packed(distances: vec4u) -> u32 {
    return distances.x | (distances.y << 8) | (distances.z << 16) | (distances.w << 24);
}

fn unpacked(word: u32) -> vec4u {
    return (vec4u(word) >> vec4u(0, 8, 16, 24)) & vec4u(255);
}

// 1 where one of the block's two bricks has a cell.
fn block_bit(x: i32, row: vec3u) -> u32 {
    if (x < 0 || u32(x) >= block_counts().x) {
        return 0;
    }
    let brick = vec3u(u32(x), row.y, 2 * row.z);
    let strides = brick_strides(0);
    let first = dot(brick, strides);
    var cells = occupancy[first];
    if (brick.z + 1 < brick_count(0).z) {
        cells |= occupancy[first + strides.z];
    }
    return select(0u, 1u, cells != 0);
}

@compute @workgroup_size(64)
fn along_x(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    let rows = leap_rows();
    if (index >= rows.x * rows.y * rows.z) {
        return;
    }
    let row = row_of(index);
    // Bit number MOST_LEAP is the first of the four.
    var bits = 0u;
    for (var i = 0u; i < 2 * MOST_LEAP + 4; i++) {
        bits |= block_bit(i32(4 * row.x + i) - i32(MOST_LEAP), row) << i;
    }
    let at = vec4u(0, 1, 2, 3) + MOST_LEAP;
    let after = countTrailingZeros(vec4u(bits) >> at);
    let before = countLeadingZeros(vec4u(bits) << (vec4u(31) - at));
    occupancy[leap_first(0) + index] = packed(min(min(after, before), vec4u(MOST_LEAP)));
}

// Of the words along an axis, `stride` apart.
fn nearest(part: u32, index: u32, at: u32, count: u32, stride: u32) -> u32 {
    let first = leap_first(part) + index;
    var least = unpacked(occupancy[first]);
    for (var i = 1u; i < MOST_LEAP; i++) {
        if (at >= i) {
            least = min(least, max(unpacked(occupancy[first - i * stride]), vec4u(i)));
        }
        if (at + i < count) {
            least = min(least, max(unpacked(occupancy[first + i * stride]), vec4u(i)));
        }
    }
    return packed(least);
}

@compute @workgroup_size(64)
fn along_y(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    let rows = leap_rows();
    if (index < rows.x * rows.y * rows.z) {
        occupancy[leap_first(1) + index] = nearest(0, index, row_of(index).y, rows.y, rows.x);
    }
}

@compute @workgroup_size(64)
fn along_z(@builtin(global_invocation_id) id: vec3u) {
    let index = dispatch_index(id, 64);
    let rows = leap_rows();
    if (index < rows.x * rows.y * rows.z) {
        occupancy[leap_first(0) + index] = nearest(1, index, row_of(index).z, rows.z, rows.x * rows.y);
    }
}
