// What the camera sees through a pixel, as every effect gets it.

import package::common::frame::{frame, to_voxel};

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
    // Which layer of its image the effect is asked for.
    layer: u32,
    // [0, 1): which of the sets of directions that neighbouring pixels share out this one traces.
    turn: f32,
    // False where nothing is behind the pixel.
    hit: bool,
}

fn camera_ray(pixel: vec2u) -> vec3f {
    let ndc = (vec2f(pixel) + 0.5) / vec2f(frame.screen) * 2.0 - 1.0;
    return frame.forward + ndc.x * frame.right - ndc.y * frame.up;
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
    s.position = frame.eye + ray * (frame.near / d);
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
