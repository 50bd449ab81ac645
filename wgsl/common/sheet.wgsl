// A voxel's surfaces as pieces of planes, sheets: for each axis k that any of them face most one with its front towards +k, one
// with its front towards −k, or both. About the voxel's centre, in voxels, a sheet is where q[k] = height + slope.x · q[k+1] +
// slope.y · q[k+2]. Which squares of the voxel's face along k the surfaces cover says how much of it is there.

// Of each voxel: as many sheets as it may have, and as many sides, whose materials follow, two in an entry, and then what they emit, if voxels keep that.
const SHEETS = 6u;
const SIDES = 6u;
const FIRST_EMISSION = SHEETS + SIDES / 2;
override SHEET_ENTRIES: u32 = FIRST_EMISSION;

struct Sheet {
    // In [−1.5, 1.5], to touch the voxel.
    height: f32,
    // Each in [−1, 1].
    slope: vec2f,
    // 0, 1, 2.
    axis: u32,
    // A bit for each square, and those below.
    bits: u32,
    // A mask has cut squares out of it.
    has_holes: bool,
    // It ends where it meets the voxel's sheets of other axes, all of it at their backs. Its squares reach beyond.
    ends: bool,
}

// Squares along a side of the voxel's face.
const SQUARES = 5u;
const ALL_SQUARES = 0x1ffffffu;
// The front looks towards −k.
const LOW = 0x8000000u;
// The back is shown as well.
const TWO_SIDED = 0x10000000u;
// The back has a radiance of its own: no other sheet of the voxel has its front there.
const HAS_BACK = 0x20000000u;
// Another of the voxel's sheets follows.
const MORE = 0x40000000u;
// There is a sheet.
const THERE = 0x80000000u;
const AXIS_SHIFT = 25u;

const HEIGHT_UNITS = 5461.0;
const SLOPE_UNITS = 127.0;
// Of the first word.
const HOLES = 0x8000u;
const ENDS = 0x4000u;

fn pack_sheet(sheet: Sheet) -> vec2u {
    let height = u32(clamp(round(sheet.height * HEIGHT_UNITS) + 8192.0, 0.0, 16383.0)) | select(0u, HOLES, sheet.has_holes) | select(0u, ENDS, sheet.ends);
    let slope = vec2u(clamp(round(sheet.slope * SLOPE_UNITS) + 128.0, vec2f(0.0), vec2f(255.0)));
    return vec2u(height | (slope.x << 16) | (slope.y << 24), sheet.bits | (sheet.axis << AXIS_SHIFT));
}

fn unpack_sheet(words: vec2u) -> Sheet {
    let height = (f32(words.x & 0x3fff) - 8192.0) / HEIGHT_UNITS;
    let slope = (vec2f(vec2u(words.x >> 16, words.x >> 24) & vec2u(255)) - 128.0) / SLOPE_UNITS;
    return Sheet(height, slope, (words.y >> AXIS_SHIFT) & 3, words.y, (words.x & HOLES) != 0, (words.x & ENDS) != 0);
}

// What a side reflects, by glTF's words, all in [0, 1].
struct SideMaterial {
    // Kept to 1/500 of its square root.
    base_color: vec3f,
    // To 1/30.
    roughness: f32,
    // To 1/6.
    metallic: f32,
}

const COLOR_UNITS = vec3f(511.0, 511.0, 255.0);

fn pack_side_material(material: SideMaterial) -> u32 {
    let color = vec3u(round(sqrt(saturate(material.base_color)) * COLOR_UNITS));
    let shine = vec2u(round(saturate(vec2f(material.roughness, material.metallic)) * vec2f(15.0, 3.0)));
    return color.x | (color.y << 9) | (color.z << 18) | (shine.x << 26) | (shine.y << 30);
}

fn unpack_side_material(word: u32) -> SideMaterial {
    let root = vec3f(vec3u(word & 511, (word >> 9) & 511, (word >> 18) & 255)) / COLOR_UNITS;
    return SideMaterial(root * root, f32((word >> 26) & 15) / 15.0, f32(word >> 30) / 3.0);
}

// Not unit: 1 along the axis.
fn sheet_normal(sheet: Sheet) -> vec3f {
    let s = sheet.slope;
    switch sheet.axis {
        case 0: { return vec3f(1.0, -s.x, -s.y); }
        case 1: { return vec3f(-s.y, 1.0, -s.x); }
        default: { return vec3f(-s.x, -s.y, 1.0); }
    }
}

// How far a point lies before a sheet's front, in lengths of its normal.
fn before(sheet: Sheet, q: vec3f) -> f32 {
    let over = dot(sheet_normal(sheet), q) - sheet.height;
    return select(over, -over, (sheet.bits & LOW) != 0);
}

fn square_middle(index: u32) -> vec2f {
    return (vec2f(vec2u(index % SQUARES, index / SQUARES)) + 0.5) / f32(SQUARES) - 0.5;
}

// The bit of the square that a point of the voxel's face lies in; beyond the voxel the nearest one's.
fn square_bit(at: vec2f) -> u32 {
    let square = vec2u(clamp((at + 0.5) * f32(SQUARES), vec2f(0.0), vec2f(f32(SQUARES) - 0.5)));
    return 1u << (square.y * SQUARES + square.x);
}

// The same of a point of the voxel, seen along the axis.
fn square_at(q: vec3f, axis: u32) -> u32 {
    return square_bit(select(select(q.xy, q.zx, axis == 1), q.yz, axis == 0));
}

// A point of the voxel by where it is seen along the axis, and how high it lies along it.
fn unswizzled(at: vec2f, height: f32, axis: u32) -> vec3f {
    switch axis {
        case 0: { return vec3f(height, at); }
        case 1: { return vec3f(at.y, height, at.x); }
        default: { return vec3f(at, height); }
    }
}

// The mean point of what is covered, moved into the voxel.
fn middle_of(sheet: Sheet) -> vec3f {
    let covered = sheet.bits & ALL_SQUARES;
    var at = vec2f(0.0);
    if (covered != ALL_SQUARES && covered != 0) {
        var sum = vec2f(0.0);
        for (var i = 0u; i < SQUARES * SQUARES; i++) {
            sum += select(vec2f(0.0), vec2f(vec2u(i % SQUARES, i / SQUARES)), ((covered >> i) & 1) != 0);
        }
        at = (sum / f32(countOneBits(covered)) + 0.5) / f32(SQUARES) - 0.5;
    }
    return unswizzled(at, clamp(sheet.height + dot(sheet.slope, at), -0.5, 0.5), sheet.axis);
}

// The covered squares that have no uncovered one beside them in the voxel.
fn inner_squares(covered: u32) -> u32 {
    let columns = ((covered << 1) | 0x108421u) & ((covered >> 1) | 0x1084210u);
    let rows = ((covered << 5) | 0x1fu) & ((covered >> 5) | 0x1f00000u);
    return covered & columns & rows;
}
