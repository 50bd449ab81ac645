// RAU §5.3.3: what a child sends through its parent's six faces, each as a cosine lobe towards the face. Printed,
// eq. 5.9 multiplies band 0 by π at every level; here it is divided by that.

import package::common::constants::PI;
import package::format::basis::{SH0, SH1};

// Solid angles of the parent's faces from a child's centre (RAU eq. 5.3, its labels swapped back):
// 3·(near + far) = 4π.
const FAR_FACE = 1.0747930;
const NEAR_FACE = 3.1139972;
// Coefficients of a cosine lobe (RAU eq. 5.8).
const COSINE0 = 0.8862269254527580;
const COSINE1 = 1.0233267079464885;

// RGB of the child's four coefficients; `inwards` is 1 or −1 along each axis, from the child's centre to the parent's
// in the child's half edges.
fn project_child(c: array<vec4f, 4>, inwards: vec3f) -> array<vec3f, 4> {
    var projected = array<vec3f, 4>();
    for (var face = 0u; face < 6; face++) {
        var centre = inwards;
        centre[face / 2] += select(2.0, -2.0, (face & 1) == 1);
        let far = abs(centre[face / 2]) > 2.0;
        let d = normalize(centre);
        let sent = SH0 * c[0].rgb + SH1 * (d.x * c[1].rgb + d.y * c[2].rgb + d.z * c[3].rgb);
        let share = sent * (select(NEAR_FACE, FAR_FACE, far) / PI);
        projected[0] += share * COSINE0;
        projected[1] += share * (COSINE1 * d.x);
        projected[2] += share * (COSINE1 * d.y);
        projected[3] += share * (COSINE1 * d.z);
    }
    return projected;
}
