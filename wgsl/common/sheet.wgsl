// A voxel's surfaces as pieces of planes: for each axis k that any of them face most a sheet with its front towards +k, one with its
// front towards −k, or both. About the voxel's centre, in voxels, a sheet is where q[k] = height + slope.x · q[k+1] +
// slope.y · q[k+2]. Which squares of the voxel's face along k the surfaces cover says how much of the sheets is there.

struct Sheets {
    // Of the sheet with its front towards +k, and of that towards −k: each in [−1.5, 1.5], to touch the voxel.
    high: f32,
    low: f32,
    // Of both, each in [−1, 1].
    slope: vec2f,
    // A bit for each square, and those below. 0 where no surface faces along the axis.
    covered: u32,
}

// Squares along a side of the voxel's face.
const SQUARES = 5u;
const ALL_SQUARES = 0x1ffffffu;
// Whether there is a sheet with its front towards +k, and one towards −k.
const FRONT_HIGH = 0x20000000u;
const FRONT_LOW = 0x40000000u;
// Whether a surface shows its back as well.
const TWO_SIDED = 0x80000000u;

const HEIGHT_UNITS = 170.0;
const SLOPE_UNITS = 63.0;

fn packed_height(height: f32) -> u32 {
    return u32(clamp(round(height * HEIGHT_UNITS) + 256.0, 0.0, 511.0));
}

fn pack_sheets(sheets: Sheets) -> vec2u {
    let slope = vec2u(clamp(round(sheets.slope * SLOPE_UNITS) + 64.0, vec2f(0.0), vec2f(127.0)));
    let heights = packed_height(sheets.high) | (packed_height(sheets.low) << 9);
    return vec2u(heights | (slope.x << 18) | (slope.y << 25), sheets.covered);
}

fn unpack_sheets(words: vec2u) -> Sheets {
    let height = (vec2f(vec2u(words.x, words.x >> 9) & vec2u(511)) - 256.0) / HEIGHT_UNITS;
    let slope = (vec2f(vec2u(words.x >> 18, words.x >> 25) & vec2u(127)) - 64.0) / SLOPE_UNITS;
    return Sheets(height.x, height.y, slope, words.y);
}

// Not unit: 1 along the axis.
fn sheet_normal(sheets: Sheets, axis: u32) -> vec3f {
    let s = sheets.slope;
    switch axis {
        case 0: { return vec3f(1.0, -s.x, -s.y); }
        case 1: { return vec3f(-s.y, 1.0, -s.x); }
        default: { return vec3f(-s.x, -s.y, 1.0); }
    }
}

// The bit of the square that a point of the voxel lies in, seen along the axis; beyond the voxel the nearest one's.
fn square_at(q: vec3f, axis: u32) -> u32 {
    let at = select(select(q.xy, q.zx, axis == 1), q.yz, axis == 0);
    let square = vec2u(clamp((at + 0.5) * f32(SQUARES), vec2f(0.0), vec2f(f32(SQUARES) - 0.5)));
    return 1u << (square.y * SQUARES + square.x);
}

// A point of the voxel by where it is seen along the axis, and how high it lies along it.
fn unswizzled(at: vec2f, height: f32, axis: u32) -> vec3f {
    switch axis {
        case 0: { return vec3f(height, at); }
        case 1: { return vec3f(at.y, height, at.x); }
        default: { return vec3f(at, height); }
    }
}

// The mean point of what is covered, on a sheet of this height, moved into the voxel.
fn middle_of(sheets: Sheets, height: f32, axis: u32) -> vec3f {
    var sum = vec2f(0.0);
    for (var i = 0u; i < SQUARES * SQUARES; i++) {
        if (((sheets.covered >> i) & 1) != 0) {
            sum += vec2f(vec2u(i % SQUARES, i / SQUARES));
        }
    }
    let count = f32(max(countOneBits(sheets.covered & ALL_SQUARES), 1u));
    let at = (sum / count + 0.5) / f32(SQUARES) - 0.5;
    return unswizzled(at, clamp(height + dot(sheets.slope, at), -0.5, 0.5), axis);
}

// The covered squares that have no uncovered one beside them in the voxel.
fn inner_squares(covered: u32) -> u32 {
    let columns = ((covered << 1) | 0x108421u) & ((covered >> 1) | 0x1084210u);
    let rows = ((covered << 5) | 0x1fu) & ((covered >> 5) | 0x1f00000u);
    return covered & columns & rows;
}

// How far a triangle's edge from a to b leaves a square inside, at most: negative where the square is outside. `facing` is
// positive where the corners turn from x to y.
fn inside_edge(a: vec2f, b: vec2f, facing: f32, centre: vec2f, half_side: f32) -> f32 {
    let along = b - a;
    let at = facing * (along.x * (centre.y - a.y) - along.y * (centre.x - a.x));
    return at + half_side * (abs(along.x) + abs(along.y));
}

fn inside_edges(v: array<vec2f, 3>, facing: f32, centre: vec2f, half_side: f32) -> f32 {
    return min(inside_edge(v[0], v[1], facing, centre, half_side),
        min(inside_edge(v[1], v[2], facing, centre, half_side), inside_edge(v[2], v[0], facing, centre, half_side)));
}

// The squares that a triangle touches; corners relative to the voxel's centre, seen along the axis.
fn covered_squares(v: array<vec2f, 3>, facing: f32) -> u32 {
    if (inside_edges(v, facing, vec2f(0.0), -0.5) >= 0.0) {
        return ALL_SQUARES;
    }
    let side = 1.0 / f32(SQUARES);
    let low = min(v[0], min(v[1], v[2]));
    let high = max(v[0], max(v[1], v[2]));
    var covered = 0u;
    for (var i = 0u; i < SQUARES * SQUARES; i++) {
        let centre = (vec2f(vec2u(i % SQUARES, i / SQUARES)) + 0.5) * side - 0.5;
        let touches = all(low <= centre) && all(high >= centre);
        if (touches && inside_edges(v, facing, centre, 0.0) >= 0.0) {
            covered |= 1u << i;
        }
    }
    return covered;
}
