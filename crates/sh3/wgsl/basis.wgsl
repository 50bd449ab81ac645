// Three bands of the real spherical harmonics in the order 1, x, y, z, xy, yz, xz, 3z² − 1, x² − y². The nine
// coefficients stand one above the other along z in one texture.

const BANDS = 9u;

// The functions' factors, 1/(2√π), √3/(2√π), √15/(2√π), √5/(4√π) and √15/(4√π), times 16/3: so the coefficients of
// opacity are at most 1, which is all that bytes hold.
const Y0 = 1.50450556;
const Y1 = 2.60588007;
const Y2 = 5.82692497;
const Y20 = 1.68208836;
const Y22 = 2.91346249;
// The clamped cosine is about 1/4 + z/2 + 5/32·(3z² − 1).
const COSINE2 = 0.15625;

// Function k in direction d.
fn harmonic(k: u32, d: vec3f) -> f32 {
    switch k {
        case 0u: { return Y0; }
        case 1u: { return Y1 * d.x; }
        case 2u: { return Y1 * d.y; }
        case 3u: { return Y1 * d.z; }
        case 4u: { return Y2 * d.x * d.y; }
        case 5u: { return Y2 * d.y * d.z; }
        case 6u: { return Y2 * d.x * d.z; }
        case 7u: { return Y20 * (3.0 * d.z * d.z - 1.0); }
        default: { return Y22 * (d.x * d.x - d.y * d.y); }
    }
}

// Coefficient k of the area that a voxel's surfaces show: of a plane about its normal, or, where normals cancel, of six
// sides.
fn area_coefficient(k: u32, normal: vec3f, front: vec3f, back: vec3f) -> f32 {
    let both = front + back;
    let sum = both.x + both.y + both.z;
    let flat = any(normal != vec3f(0.0));
    let size = abs(normal.x) + abs(normal.y) + abs(normal.z);
    let area = select(sum, sum / max(size, 1.0), flat);
    let odd = front - back;
    // Weights of x², y², z² and of xy, yz, xz.
    let square = select(both, area * normal * normal, flat);
    let mixed = area * normal.xyx * normal.yzz;
    switch k {
        case 0u: { return 0.25 / Y0 * area; }
        case 1u: { return 0.5 / Y1 * odd.x; }
        case 2u: { return 0.5 / Y1 * odd.y; }
        case 3u: { return 0.5 / Y1 * odd.z; }
        case 4u: { return 6.0 * COSINE2 / Y2 * mixed.x; }
        case 5u: { return 6.0 * COSINE2 / Y2 * mixed.y; }
        case 6u: { return 6.0 * COSINE2 / Y2 * mixed.z; }
        case 7u: { return COSINE2 / Y20 * (square.z - 0.5 * (square.x + square.y)); }
        default: { return 1.5 * COSINE2 / Y22 * (square.x - square.y); }
    }
}
