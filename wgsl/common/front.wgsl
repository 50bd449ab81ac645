// What each side of a voxel shows: at four points of the voxel's face the triangle that lies in front of all others there. What
// lies behind it within the voxel is hidden.

import package::common::mesh::{vertices, triangle_indices};
import package::common::sheet::SIDES;
import package::common::triangle_box::swizzle;

// Points of a side, (±¼, ±¼) about the middle of the face; of each the word of the triangle in front. Then two words for each axis:
// which squares its triangles cover (see common/sheet.wgsl), and which they touch, with CUT if a mask has cut any.
const FRONTS = 4u;
const FRONT_STRIDE = SIDES * FRONTS + 6u;

// The word of a triangle at a point that it covers: the larger, the further in front. From the top: COVERS, how high it lies there
// towards the side's outside, its number. 0: no triangle.
override TRIANGLE_BITS: u32 = 24;
const COVERS = 0x80000000u;
// Heights that are told apart, voxels. What covers a point lies in the voxel.
const FRONT_RANGE = 1.1;

fn pack_front(height: f32, triangle: u32) -> u32 {
    let highest = (1u << (31 - TRIANGLE_BITS)) - 1;
    return COVERS | (u32(saturate(height / FRONT_RANGE + 0.5) * f32(highest)) << TRIANGLE_BITS) | triangle;
}

// That of a triangle that covers no point: noise made of its corners, the same whatever the order, in place of the height.
fn pack_small(f: Facet, triangle: u32) -> u32 {
    let corners = bitcast<vec4u>(vec4f(f.corners[0], f.corners[1])) ^ bitcast<vec4u>(vec4f(f.corners[2], f.slope));
    var noise = 1u;
    for (var i = 0; i < 4; i++) {
        noise = (noise ^ corners[i]) * 0x9e3779b1u;
        noise ^= noise >> 15;
    }
    return (max(noise >> (TRIANGLE_BITS + 1), 1u) << TRIANGLE_BITS) | triangle;
}

fn front_triangles(words: vec4u) -> vec4u {
    return words & vec4u((1u << TRIANGLE_BITS) - 1);
}

fn front_point(index: u32) -> vec2f {
    return 0.5 * vec2f(vec2u(index & 1, index >> 1)) - 0.25;
}

fn side_fronts(slot: u32, side: u32) -> u32 {
    return slot * FRONT_STRIDE + side * FRONTS;
}

// Of the squares that are touched: a mask has cut some off.
const CUT = 0x80000000u;

fn axis_squares(slot: u32, axis: u32) -> u32 {
    return slot * FRONT_STRIDE + SIDES * FRONTS + axis;
}

fn axis_touched(slot: u32, axis: u32) -> u32 {
    return axis_squares(slot, axis) + 3;
}

// A triangle seen along an axis, about the middle of a voxel, in voxels.
struct Facet {
    corners: array<vec2f, 3>,
    // Positive where its front looks towards the axis' end; 0: a line.
    facing: f32,
    // Where the axis is the one that the normal is nearest to: height + slope · point is how high its plane lies.
    height: f32,
    slope: vec2f,
}

fn facet(corners: array<vec3f, 3>, axis: u32, cell: vec3u) -> Facet {
    let centre = vec3f(cell) + 0.5;
    let v = array(swizzle(corners[0] - centre, axis), swizzle(corners[1] - centre, axis), swizzle(corners[2] - centre, axis));
    let n = cross(v[1] - v[0], v[2] - v[1]);
    let slope = select(clamp(-n.xy / n.z, vec2f(-1.0), vec2f(1.0)), vec2f(0.0), n.z == 0.0);
    return Facet(array(v[0].xy, v[1].xy, v[2].xy), n.z, v[0].z - dot(slope, v[0].xy), slope);
}
