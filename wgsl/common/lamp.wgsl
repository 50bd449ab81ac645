// Area lights in a glossy lobe. Two sums find them, and share the work: rays of the lobe that meet a light, for sharp lobes, and the
// parts of a light as the lobe weighs them, for wide ones. Their shares are by the power heuristic (Veach, "Robust Monte Carlo Methods
// for Light Transport Simulation", 1997, eq. 9.12), but one for all directions, at the lobe's peak and the light's middle: both sums
// have fixed directions, so that each stands for the whole lobe.

import package::common::brdf::{mirror_density, share_above};
import package::common::light::{Light, area_part};
import package::common::light_part::light_piece;
import package::common::trace::Lobe;

// Parts of a light along each of its sides.
const LAMP_SIDES = 4u;

// The share of the rays' sum, as seen from a point; the rest is the parts'. They are even where the lobe's peak is
// as wide as a part.
fn rays_share(light: Light, lobe: Lobe, position: vec3f) -> f32 {
    let offset = light.position - position;
    let distance2 = max(dot(offset, offset), 1e-30);
    let facing = max(abs(dot(offset, light.direction)) * inverseSqrt(distance2), 1e-3);
    let of_parts = f32(LAMP_SIDES * LAMP_SIDES) * distance2 / (max(light.area, 1e-30) * facing);
    let peak = mirror_density(lobe.axis, lobe.view, reflect(-lobe.view, lobe.axis), lobe.width);
    let ratio = of_parts / max(peak, 1e-20);
    return 1.0 / (1.0 + ratio * ratio);
}

// Radiance that a light sends into a lobe, by its parts: their share where rays look for the light as well.
fn lamp_parts(light: Light, lobe: Lobe, position: vec3f, with_rays: bool) -> vec3f {
    var sum = 0.0;
    for (var i = 0u; i < LAMP_SIDES * LAMP_SIDES; i++) {
        let part = area_part(light_piece(light, i, LAMP_SIDES), light, position, vec3f(1.0));
        if (dot(part.direction, lobe.axis) > 0.0) {
            let density = mirror_density(lobe.axis, lobe.view, part.direction, lobe.width);
            let facing = abs(dot(part.direction, light.direction));
            sum += part.irradiance.x * density * facing * light.area / (f32(LAMP_SIDES * LAMP_SIDES) * part.distance * part.distance);
        }
    }
    // The lobe's mean is over what of it is above the surface.
    let of_rays = select(0.0, rays_share(light, lobe, position), with_rays);
    let share = (1.0 - of_rays) / max(share_above(saturate(dot(lobe.axis, lobe.view)), lobe.width), 0.1);
    return light.intensity * (sum * share);
}
