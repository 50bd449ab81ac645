// A voxel's surfaces as planes: one for each axis that any of them face most. About the voxel's centre, in voxels, a plane of axis k
// is where q[k] = height + slope.x · q[k+1] + slope.y · q[k+2].

struct Plane {
    // In [−1.5, 1.5]: a plane that touches the voxel.
    height: f32,
    // Each in [−1, 1].
    slope: vec2f,
    // Whether it shows its side towards +k, and that towards −k.
    shown: vec2<bool>,
}

const HEIGHT_UNITS = 1365.0;
const SLOPE_UNITS = 256.0;

// 0 stands for no plane: one that is there shows a side.
fn pack_plane(plane: Plane) -> u32 {
    let height = u32(clamp(round(plane.height * HEIGHT_UNITS) + 2048.0, 0.0, 4095.0));
    let slope = vec2u(clamp(round(plane.slope * SLOPE_UNITS) + 256.0, vec2f(0.0), vec2f(511.0)));
    let shown = select(0u, 1u, plane.shown.x) | select(0u, 2u, plane.shown.y);
    return shown | (height << 2) | (slope.x << 14) | (slope.y << 23);
}

fn unpack_plane(word: u32) -> Plane {
    let height = (f32((word >> 2) & 4095) - 2048.0) / HEIGHT_UNITS;
    let slope = (vec2f(vec2u(word >> 14, word >> 23) & vec2u(511)) - 256.0) / SLOPE_UNITS;
    return Plane(height, slope, vec2((word & 1) != 0, (word & 2) != 0));
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
