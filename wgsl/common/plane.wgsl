// A voxel's surfaces as pieces of planes: one for each axis that any of them face most. About the voxel's centre, in voxels, a
// plane of axis k is where q[k] = height + slope.x · q[k+1] + slope.y · q[k+2]. Which squares of the voxel's face along k
// the surfaces cover says how much of the plane is there.

struct Plane {
    // In [−1.5, 1.5]: a plane that touches the voxel.
    height: f32,
    // Each in [−1, 1].
    slope: vec2f,
    // A bit for each square, and `SHOWS_HIGH`, `SHOWS_LOW`. 0 where no surface faces along the axis.
    covered: u32,
}

// Squares along a side of the voxel's face.
const SQUARES = 5u;
const ALL_SQUARES = 0x1ffffffu;
// Whether fronts look towards +k, and towards −k.
const FRONT_HIGH = 0x10000000u;
const FRONT_LOW = 0x20000000u;
// Whether surfaces show their side towards +k, and that towards −k: fronts, and backs of surfaces of two sides.
const SHOWS_HIGH = 0x40000000u;
const SHOWS_LOW = 0x80000000u;

const HEIGHT_UNITS = 21845.0;
const SLOPE_UNITS = 127.0;

fn pack_plane(plane: Plane) -> vec2u {
    let height = u32(clamp(round(plane.height * HEIGHT_UNITS) + 32768.0, 0.0, 65535.0));
    let slope = vec2u(clamp(round(plane.slope * SLOPE_UNITS) + 128.0, vec2f(0.0), vec2f(255.0)));
    return vec2u(height | (slope.x << 16) | (slope.y << 24), plane.covered);
}

fn unpack_plane(words: vec2u) -> Plane {
    let height = (f32(words.x & 0xffff) - 32768.0) / HEIGHT_UNITS;
    let slope = (vec2f(vec2u(words.x >> 16, words.x >> 24) & vec2u(255)) - 128.0) / SLOPE_UNITS;
    return Plane(height, slope, words.y);
}

// Not unit: 1 along the axis.
fn plane_normal(plane: Plane, axis: u32) -> vec3f {
    let s = plane.slope;
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

// The mean point of what is covered, moved into the voxel.
fn middle_of(plane: Plane, axis: u32) -> vec3f {
    var sum = vec2f(0.0);
    for (var i = 0u; i < SQUARES * SQUARES; i++) {
        if (((plane.covered >> i) & 1) != 0) {
            sum += vec2f(vec2u(i % SQUARES, i / SQUARES));
        }
    }
    let count = f32(max(countOneBits(plane.covered & ALL_SQUARES), 1u));
    let at = (sum / count + 0.5) / f32(SQUARES) - 0.5;
    return unswizzled(at, clamp(plane.height + dot(plane.slope, at), -0.5, 0.5), axis);
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
        let touches = all(low <= centre + 0.5 * side) && all(high >= centre - 0.5 * side);
        if (touches && inside_edges(v, facing, centre, 0.5 * side) >= 0.0) {
            covered |= 1u << i;
        }
    }
    return covered;
}
