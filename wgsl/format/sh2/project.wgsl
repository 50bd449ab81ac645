// RAU §5.3.3: what a child sends through its parent's six faces, each as a cosine lobe towards the face. Printed,
// eq. 5.9 multiplies band 0 by π at every level; here it is divided by that.

import package::common::constants::PI;
import package::format::bands::bands_towards;
import package::format::cell::Cell;

// Solid angles of the parent's faces from a child's centre (RAU eq. 5.3, its labels swapped back):
// 3·(near + far) = 4π.
const FAR_FACE = 1.0747930;
const NEAR_FACE = 3.1139972;
// Coefficients of a cosine lobe, √π/2 and √(π/3) (RAU eq. 5.8), over those of a facet, 2√π and √(3π)/2.
const COSINE0 = 0.25;
const COSINE1 = 0.6666667;

// The child's bands as the parent has them; `inwards` is 1 or −1 along each axis, from the child's centre to the parent's
// in the child's half edges.
fn project_child(child: Cell, inwards: vec3f) -> Cell {
    var projected = child;
    projected.band0 = vec3f(0.0);
    projected.band1 = mat3x3f();
    for (var face = 0u; face < 6; face++) {
        var centre = inwards;
        centre[face / 2] += select(2.0, -2.0, (face & 1) == 1);
        let far = abs(centre[face / 2]) > 2.0;
        let d = normalize(centre);
        let share = bands_towards(child, d, vec3f(1.0)) * (select(NEAR_FACE, FAR_FACE, far) / PI);
        projected.band0 += share * COSINE0;
        projected.band1 += mat3x3f(share * d.x, share * d.y, share * d.z) * COSINE1;
    }
    return projected;
}
