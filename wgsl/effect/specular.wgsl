// Glossy reflection (RAU §6.5): the radiance that the lit scene, its area lights and the sky send along the mirrored view,
// W·m⁻²·sr⁻¹, averaged over the surface's GGX lobe. Alpha is the mean opacity met.

import package::common::environment::environment;
import package::common::grid::longest_side;
import package::common::lamp::lamp_parts;
import package::common::alone::stands_alone;
import package::common::light::{HAS_AREA, LIGHT_AREA, lights};
import package::common::surface::{Surface, image_texel, screen_pixel, surface_apex};
import package::common::trace::{WHOLE, ggx_lobe, reach_of};
import package::tracer::trace::trace_gather;

// Smoother surfaces have lobes less than ten times as wide as four pixels of a picture a few hundred pixels wide.
const SHARP = 0.2;

struct Params {
    /// Farthest surface that sends light, as a share of the grid's longest side; beyond it is the sky; 1000 unless given.
    distance: f32,
}

// How much of each light arrives: see effect/soft_shadow.wgsl.
var shadow: texture_2d_array<f32>;
override HAS_SHADOW: bool = false;

fn effect(surface: Surface, params: Params) -> vec4f {
    let lobe = ggx_lobe(surface.normal, surface.view, surface.roughness);
    var apex = surface_apex(surface);
    // A mean over neighbours would blur a sharp reflection.
    let alone = surface.share.count > 1 && surface.roughness < SHARP;
    if (alone) {
        apex.share = WHOLE;
    }
    let found = trace_gather(apex, lobe, reach_of(params.distance * longest_side()));
    var radiance = found.radiance;
    if (HAS_AREA && HAS_SHADOW) {
        let texel = image_texel(screen_pixel(surface.pixel, surface.image_size), textureDimensions(shadow));
        for (var i = 0u; i < environment.light_count; i++) {
            let visibility = textureLoad(shadow, texel, i / 4, 0)[i % 4];
            if (lights[i].kind == LIGHT_AREA && visibility > 0.0) {
                radiance += visibility * lamp_parts(lights[i], lobe, surface.position, found.met_lamps);
            }
        }
    }
    let value = vec4f(radiance, found.opacity);
    return select(value, stands_alone(value), alone);
}
