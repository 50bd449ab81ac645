// What the camera sees through a pixel, as every effect gets it.

import package::common::camera::camera;
import package::common::grid::to_voxel;
import package::common::trace::{Apex, Share};

var albedo: texture_2d<f32>;
var normal: texture_2d<f32>;
var geometry: texture_2d<f32>;
var depth: texture_depth_2d;

struct Surface {
    // World units, relative to the grid's centre; and the same in voxels.
    position: vec3f,
    position_voxel: vec3f,
    // Unit, of the shading (normal maps included) and of the triangle; both turned to the camera.
    normal: vec3f,
    normal_geometric: vec3f,
    // Unit, towards the camera.
    view: vec3f,
    // Base colour, linear.
    base_color: vec3f,
    // [0, 1]
    metallic: f32,
    // Perceptual, [0, 1]; GGX α is its square.
    roughness: f32,
    // The texel of the effect's own image that is asked for, that image's size, and the layer.
    pixel: vec2u,
    image_size: vec2u,
    layer: u32,
    // Of the directions that neighbouring pixels share out.
    share: Share,
    // False where nothing is behind the pixel.
    hit: bool,
}

fn surface_apex(surface: Surface) -> Apex {
    return Apex(surface.position_voxel, surface.normal_geometric, surface.share);
}

fn camera_ray(pixel: vec2u) -> vec3f {
    let ndc = (vec2f(pixel) + 0.5) / vec2f(camera.screen) * 2.0 - 1.0;
    return camera.forward + ndc.x * camera.right - ndc.y * camera.up;
}

// The pixel of the screen in the middle of a texel of an image that covers the screen with `size` texels.
fn screen_pixel(texel: vec2u, size: vec2u) -> vec2u {
    return vec2u((vec2f(texel) + 0.5) * vec2f(camera.screen) / vec2f(size));
}

// The texel of an image of `size` texels that a pixel of the screen lies in.
fn image_texel(pixel: vec2u, size: vec2u) -> vec2u {
    return vec2u((vec2f(pixel) + 0.5) * vec2f(size) / vec2f(camera.screen));
}

fn surface_load(pixel: vec2u) -> Surface {
    var s: Surface;
    // Reversed, infinite: 0 is nothing, and near / depth is the distance along the view's axis.
    let d = textureLoad(depth, pixel, 0);
    let ray = camera_ray(pixel);
    s.view = -normalize(ray);
    s.hit = d > 0.0;
    if (!s.hit) {
        return s;
    }
    s.position = camera.eye + ray * (camera.near / d);
    s.position_voxel = to_voxel(s.position);
    let color = textureLoad(albedo, pixel, 0);
    let shading = textureLoad(normal, pixel, 0);
    s.base_color = color.rgb;
    s.metallic = color.a;
    s.normal = normalize(shading.xyz);
    s.roughness = shading.w;
    s.normal_geometric = normalize(textureLoad(geometry, pixel, 0).xyz);
    return s;
}
