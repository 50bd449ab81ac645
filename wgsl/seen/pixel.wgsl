// What an effect's texel stands for: the screen's pixel in its middle.

import package::common::surface::{Surface, screen_pixel, surface_load};

fn surface_seen(texel: vec2u, size: vec2u) -> Surface {
    return surface_load(screen_pixel(texel, size));
}
