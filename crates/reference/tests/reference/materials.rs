//! Textures, masks, normal maps and sides.

use glam::{Vec3, Vec4};
use voxlume_reference::{Gather, Quantity, Request};
use voxlume_scene::{Camera, LightKind, Material, Scene};

use crate::stage::*;

/// A unit quad at y = 0 facing up, uv u along x and v along −z from z = 0.
fn tile(material: Material, y: f32) -> Scene {
    let mut scene = Scene::default();
    let at = |x: f32, z: f32| Vec3::new(x, y, z);
    add_quads(&mut scene, material, &[[at(0.0, 0.0), at(1.0, 0.0), at(1.0, -1.0), at(0.0, -1.0)]]);
    scene
}

fn above(u: f32, v: f32) -> Camera {
    look(Vec3::new(u, 2.0, -v), Vec3::new(u, 0.0, -v))
}

fn final_image(camera: Camera) -> Request {
    lambert(camera, Quantity::Final { bounces: 0 }, 2)
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 2e-3, "{a} {b}");
}

#[test]
fn base_colour_and_emission_textures_multiply_their_factors() {
    let mut scene = tile(grey(0.5), 0.0);
    scene.sky = Vec3::ONE;
    let texels = [[255, 0, 0, 255], [0, 0, 0, 255], [0, 0, 0, 255], [128, 0, 0, 255]];
    scene.materials[0].base_color_texture = add_texture(&mut scene, 2, true, &texels);
    close(measure(&scene, &final_image(above(0.25, 0.25))).0, 0.5);
    close(measure(&scene, &final_image(above(0.5, 0.25))).0, 0.25);
    close(measure(&scene, &final_image(above(0.75, 0.75))).0, 0.5 * 0.21586);
    let mut scene = tile(emissive(3.0), 0.0);
    scene.materials[0].emission_texture = add_texture(&mut scene, 2, true, &texels);
    close(measure(&scene, &final_image(above(0.25, 0.25))).0, 3.0);
    close(measure(&scene, &final_image(above(0.75, 0.75))).0, 3.0 * 0.21586);
}

/// Emission that varies over a triangle must come out the same whichever way it is sampled.
#[test]
fn a_textured_emitter_lights_by_its_mean() {
    let mut scene = tile(Material { emission: Vec3::splat(4.0), ..grey(0.0) }, 5.0);
    // Facing down.
    for mesh in &mut scene.meshes {
        mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        mesh.normals.fill(Vec3::NEG_Y);
    }
    let columns: Vec<[u8; 4]> = (0..4).map(|i| if i == 1 { [255; 4] } else { [0, 0, 0, 255] }).collect();
    scene.materials[0].emission_texture = add_texture(&mut scene, 4, false, &columns);
    let ground = floor(grey(0.5));
    let mut mesh = ground.meshes[0].clone();
    mesh.material = 1;
    scene.materials.push(grey(0.5));
    add_mesh(&mut scene, mesh);
    let camera = look(Vec3::new(0.5, 1.0, 1.0), Vec3::new(0.5, 0.0, -0.5));
    let (mean, error) = measure(&scene, &lambert(camera, Quantity::Final { bounces: 0 }, 500));
    // A quarter of the tile emits; seen from 5 units away, cos⁴ and the texel's place matter by 1 %.
    let expected = 0.5 / PI * 4.0 * 0.25 / 25.0;
    assert!((mean - expected).abs() < 3.0 * error + 0.015 * expected, "{mean} {error} {expected}");
    assert!(error < 0.01 * expected);
}

#[test]
fn metallic_and_roughness_come_from_blue_and_green() {
    let mut textured = tile(Material { metallic: 1.0, roughness: 1.0, ..grey(0.7) }, 0.0);
    textured.materials[0].metallic_roughness_texture =
        add_texture(&mut textured, 1, false, &[[9, 102, 204, 77]]);
    let mut plain = tile(Material { metallic: 0.8, roughness: 0.4, ..grey(0.7) }, 0.0);
    let camera = look(Vec3::new(0.5, 1.0, 0.5), Vec3::new(0.5, 0.0, -0.5));
    let request = request(camera, Quantity::Final { bounces: 0 }, 50);
    for scene in [&mut textured, &mut plain] {
        let direction = Vec3::new(0.0, -0.7, 0.7).normalize();
        add_light(scene, LightKind::Directional { direction, angular_diameter: 0.1 }, 1.0);
    }
    let (a, b) = (measure(&textured, &request).0, measure(&plain, &request).0);
    assert!((a - b).abs() < 1e-4 * b, "{a} {b}");
}

/// A map that leans the normal by 30° towards +u, lit from that side and from the other; the scale
/// and the tangent's sign turn it.
#[test]
fn normal_maps_lean_along_the_tangent() {
    // (0.5, 0, 0.866) · 127.5 + 127.5
    let map = [[191, 128, 238, 255]];
    let lit = |u: f32, v: f32, scale: f32, sign: f32| {
        let mut scene = tile(Material { normal_scale: scale, ..grey(1.0) }, 0.0);
        scene.materials[0].normal_texture = add_texture(&mut scene, 1, false, &map);
        scene.meshes[0].tangents.fill(Vec4::new(u, 0.0, -v, sign));
        let direction = Vec3::new(-1.0, -1.0, 0.0).normalize();
        add_light(&mut scene, LightKind::Directional { direction, angular_diameter: 0.0 }, PI as f32);
        measure(&scene, &final_image(above(0.5, 0.5))).0
    };
    let cos = |degrees: f64| degrees.to_radians().cos();
    // The texel is rounded to 8 bits.
    let near = |a: f64, b: f64| assert!((a - b).abs() < 6e-3, "{a} {b}");
    near(lit(1.0, 0.0, 1.0, 1.0), cos(15.0));
    near(lit(-1.0, 0.0, 1.0, 1.0), cos(75.0));
    near(lit(1.0, 0.0, 0.0, 1.0), cos(45.0));
    near(lit(0.0, 1.0, 1.0, 1.0), cos(30.0) * cos(45.0));
    // The bitangent, normal × tangent, is −z = +v for the tangent +x: texels lean it by their green.
    let mut scene = tile(grey(1.0), 0.0);
    scene.materials[0].normal_texture = add_texture(&mut scene, 1, false, &[[128, 191, 238, 255]]);
    let direction = Vec3::new(0.0, -1.0, 1.0).normalize();
    add_light(&mut scene, LightKind::Directional { direction, angular_diameter: 0.0 }, PI as f32);
    near(measure(&scene, &final_image(above(0.5, 0.5))).0, cos(15.0));
    scene.meshes[0].tangents.fill(Vec4::new(1.0, 0.0, 0.0, -1.0));
    near(measure(&scene, &final_image(above(0.5, 0.5))).0, cos(75.0));
}

/// A tile above the floor, its half at u < ½ cut away by its mask.
fn masked() -> Scene {
    let mut scene = tile(grey(0.5), 1.0);
    scene.materials[0].alpha_cutoff = Some(0.5);
    scene.materials[0].base_color_texture =
        add_texture(&mut scene, 2, true, &[[255, 255, 255, 0], [255, 255, 255, 255]]);
    let mut ground = floor(Material { emission: Vec3::splat(7.0), ..grey(0.5) }).meshes.remove(0);
    ground.material = 1;
    scene.materials.push(Material { emission: Vec3::splat(7.0), ..grey(0.0) });
    add_mesh(&mut scene, ground);
    scene
}

#[test]
fn holes_of_a_mask_let_sight_and_light_through() {
    let mut scene = masked();
    add_light(&mut scene, LightKind::Directional { direction: Vec3::NEG_Y, angular_diameter: 0.0 }, 1.0);
    // From above, the glowing floor shows through the hole.
    close(measure(&scene, &final_image(above(0.25, 0.5))).0, 7.0);
    assert!(measure(&scene, &final_image(above(0.75, 0.5))).0 < 3.0);
    // From the side, below the tile.
    for (u, visible) in [(0.25, 1.0), (0.75, 0.0)] {
        let target = Vec3::new(u, 0.0, -0.5);
        let camera = look(target + Vec3::new(0.0, 0.5, 0.5), target);
        let shadow = request(camera, Quantity::SoftShadow { light: 0 }, 2);
        assert_eq!(measure(&scene, &shadow), (visible, 0.0));
    }
    // Without the cutoff, the texture's alpha makes no hole.
    scene.materials[0].alpha_cutoff = None;
    assert!(measure(&scene, &final_image(above(0.25, 0.5))).0 < 3.0);
}

#[test]
fn the_camera_looks_through_backs_but_light_does_not() {
    for double_sided in [false, true] {
        // The tile faces up; the camera is below it, and another tile far above faces down.
        let mut scene = tile(Material { double_sided, ..grey(0.5) }, 1.0);
        scene.sky = Vec3::splat(2.0);
        let target = Vec3::new(0.5, 1.0, -0.5);
        let camera = look(target - Vec3::Y, target);
        // The back of a two-sided tile reflects the sky below it, with its normal turned down.
        let expected = if double_sided { 1.0 } else { 2.0 };
        expect(&scene, &final_image(camera), expected);
        // Light from above doesn't pass.
        let mut scene = floor(grey(0.5));
        let at = |x: f32, z: f32| Vec3::new(x, 1.0, z);
        let roof = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
        add_quads(&mut scene, Material { double_sided, ..grey(0.5) }, &[roof]);
        add_light(&mut scene, LightKind::Directional { direction: Vec3::NEG_Y, angular_diameter: 0.0 }, 1.0);
        let shadow =
            request(look(Vec3::new(0.0, 0.5, 0.5), Vec3::ZERO), Quantity::SoftShadow { light: 0 }, 2);
        assert_eq!(measure(&scene, &shadow), (0.0, 0.0));
    }
}

/// Normals interpolate over a triangle and are turned to the eye.
#[test]
fn shading_normals_interpolate() {
    let mut scene = tile(Material { double_sided: true, ..grey(1.0) }, 0.0);
    let lean = |degrees: f32| Vec3::new(degrees.to_radians().sin(), degrees.to_radians().cos(), 0.0);
    scene.meshes[0].normals = vec![lean(-40.0), lean(40.0), lean(40.0), lean(-40.0)];
    let sun = |down: f32| LightKind::Directional { direction: Vec3::Y * down, angular_diameter: 0.0 };
    add_light(&mut scene, sun(-1.0), PI as f32);
    let normal = lean(-40.0).lerp(lean(40.0), 0.75).normalize();
    close(measure(&scene, &final_image(above(0.75, 0.4))).0, f64::from(normal.y));
    scene.lights[0].kind = sun(1.0);
    let target = Vec3::new(0.75, 0.0, -0.4);
    close(measure(&scene, &final_image(look(target - Vec3::Y, target))).0, f64::from(normal.y));
}

/// The diffuse quantity of a metal is its surroundings' irradiance; what metals reflect of it is not
/// asked.
#[test]
fn irradiance_does_not_depend_on_the_surface_itself() {
    let mut scene = floor(Material { metallic: 1.0, roughness: 0.1, ..grey(0.1) });
    scene.sky = Vec3::ONE;
    let gather = Gather { bounces: 0, sky: true, emission: false };
    let camera = look(Vec3::new(0.0, 1.0, 0.5), Vec3::ZERO);
    expect(&scene, &request(camera, Quantity::Diffuse(gather), 2), PI);
}
