// Which squares of a voxel's face a triangle covers, seen along the axis that its normal is nearest to.

import package::common::fragment::{Corners, Fragment};
import package::common::front::Facet;
import package::common::material::{HAS_ALPHA_MASK, Material, base_color};
import package::common::sheet::{ALL_SQUARES, SQUARES, square_middle};

// Whether a square lies with all of it inside a triangle's edge from a to b. `facing` is positive where the corners turn from x to y. A
// point on an edge that two triangles share belongs to one of them, so that no order of triangles matters: both find the same number
// there, up to its sign.
fn is_within(a: vec2f, b: vec2f, facing: f32, centre: vec2f, half_side: f32) -> bool {
    let turned = b.x < a.x || (b.x == a.x && b.y < a.y);
    let low = select(a, b, turned);
    let along = select(b, a, turned) - low;
    let left = along.x * (centre.y - low.y) - along.y * (centre.x - low.x);
    let clockwise = (facing < 0.0) != turned;
    let margin = half_side * (abs(along.x) + abs(along.y));
    return select(left - margin >= 0.0, -left - margin > 0.0, clockwise);
}

fn is_inside(f: Facet, centre: vec2f, half_side: f32) -> bool {
    return is_within(f.corners[0], f.corners[1], f.facing, centre, half_side)
        && is_within(f.corners[1], f.corners[2], f.facing, centre, half_side)
        && is_within(f.corners[2], f.corners[0], f.facing, centre, half_side);
}

// The squares whose middles a triangle covers, and those below.
fn covered_squares(f: Facet) -> u32 {
    if (is_inside(f, vec2f(0.0), 0.5)) {
        return ALL_SQUARES;
    }
    var covered = 0u;
    for (var i = 0u; i < SQUARES * SQUARES; i++) {
        covered |= select(0u, 1u << i, is_inside(f, square_middle(i), 0.0));
    }
    return covered;
}

// Width from which a triangle is a wall, in voxels: narrower ones are bars and pieces of surfaces, of which many are in a voxel, and what
// is left out of one is covered by others or is a gap.
const WALL = 0.5;

fn is_wall(f: Facet) -> bool {
    let longest = max(distance(f.corners[0], f.corners[1]), max(distance(f.corners[1], f.corners[2]), distance(f.corners[2], f.corners[0])));
    return abs(f.facing) >= WALL * longest;
}

// The squares of which a wall covers any part, and some beyond sharp corners within its box; of a narrower triangle those covered.
fn touched_squares(f: Facet, covered: u32) -> u32 {
    if (covered == ALL_SQUARES || !is_wall(f)) {
        return covered;
    }
    let half_side = 0.5 / f32(SQUARES);
    let low = min(f.corners[0], min(f.corners[1], f.corners[2])) - half_side;
    let high = max(f.corners[0], max(f.corners[1], f.corners[2])) + half_side;
    var touched = 0u;
    for (var i = 0u; i < SQUARES * SQUARES; i++) {
        let middle = square_middle(i);
        let in_box = all(middle >= low) && all(middle <= high);
        touched |= select(0u, 1u << i, in_box && is_inside(f, middle, -half_side));
    }
    return touched;
}

// What a triangle has left of itself in a voxel.
struct Remains {
    // False: its alpha mask has cut it all off.
    there: bool,
    squares: u32,
    // Of a wall those of which any part may be covered; of others and where a mask has cut, the same.
    touched: u32,
    // Of the squares that it would cover without a mask.
    share: f32,
    // Whether a mask may have cut any off.
    cut: bool,
}

// Levels between a texel as large as a voxel and one as large as a square.
const SQUARE_LEVELS = 2.0;

// The mean alpha from which a square counts as covered where texels are finer than squares: each square has another, so that as many
// are covered as the mask leaves.
fn mask_threshold(index: u32) -> f32 {
    let x = index % SQUARES;
    let y = index / SQUARES;
    return (f32((x + 2 * y) % SQUARES * SQUARES + (x + 3 * y) % SQUARES) + 0.5) / f32(SQUARES * SQUARES);
}

// `nearest` is what the triangle shows at its point nearest the voxel's middle.
fn remains(f: Facet, corners: Corners, nearest: Fragment, material: Material) -> Remains {
    let covered = covered_squares(f);
    if (!HAS_ALPHA_MASK || material.alpha_cutoff <= 0.0) {
        return Remains(true, covered, touched_squares(f, covered), 1.0, false);
    }
    if (covered == 0) {
        return Remains(base_color(material, nearest.uv, nearest.lod).a >= material.alpha_cutoff, 0, 0, 1.0, true);
    }
    let lod = max(corners.lod - SQUARE_LEVELS, 0.0);
    var left = 0u;
    for (var i = 0u; i < SQUARES * SQUARES; i++) {
        if (((covered >> i) & 1) != 0) {
            let p = square_middle(i);
            let a = f.corners[0] - p;
            let b = f.corners[1] - p;
            let c = f.corners[2] - p;
            let w = vec3f(b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x) / f.facing;
            let alpha = base_color(material, w.x * corners.uv[0] + w.y * corners.uv[1] + w.z * corners.uv[2], lod).a;
            let threshold = select(material.alpha_cutoff, mask_threshold(i), lod > 0.0);
            left |= select(0u, 1u << i, alpha >= threshold);
        }
    }
    return Remains(left != 0, left, left, f32(countOneBits(left)) / f32(countOneBits(covered)), true);
}
