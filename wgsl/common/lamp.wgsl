// Area lights in a glossy lobe. Two ways share the work, each where it is the better (the balance heuristic: Veach, "Robust Monte
// Carlo Methods for Light Transport Simulation", 1997, eq. 9.8): rays of the lobe that meet a light, for sharp lobes, and the parts of
// a light as the lobe weighs them, for wide ones.

import package::common::brdf::{mirror_density, share_above};
import package::common::light::{Light, area_part};
import package::common::light_part::light_piece;
import package::common::trace::Lobe;

// Parts of a light along each of its sides.
const LAMP_SIDES = 4u;

// Parts for each unit of solid angle, where a light is seen at a distance along a unit direction.
fn parts_density(light: Light, direction: vec3f, distance: f32) -> f32 {
    let facing = max(abs(dot(direction, light.direction)), 1e-6);
    return f32(LAMP_SIDES * LAMP_SIDES) * distance * distance / (max(light.area, 1e-30) * facing);
}

// Radiance of a light's parts, weighed by a lobe of which `rays` rays, or none, look for the light as well.
fn lamp_parts(light: Light, lobe: Lobe, position: vec3f, rays: u32) -> vec3f {
    var sum = 0.0;
    for (var i = 0u; i < LAMP_SIDES * LAMP_SIDES; i++) {
        let part = area_part(light_piece(light, i, LAMP_SIDES), light, position, vec3f(1.0));
        if (dot(part.direction, lobe.axis) > 0.0) {
            let density = mirror_density(lobe.axis, lobe.view, part.direction, lobe.width);
            sum += part.irradiance.x * density / (parts_density(light, part.direction, part.distance) + f32(rays) * density);
        }
    }
    // The lobe's mean is over what of it is above the surface.
    return light.intensity * (sum / max(share_above(saturate(dot(lobe.axis, lobe.view)), lobe.width), 0.1));
}
