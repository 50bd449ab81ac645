//! Thin things: which squares of a voxel surfaces cover, which of two is in front, and what of light passes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::f64::consts::PI;

use glam::{DAffine3, DVec3, UVec3, Vec3, Vec4};
use voxlume::scene::{Light, LightKind, Material, Mesh, Texture, TextureRef};
use voxlume::{Camera, Request, Scene};
use voxlume_tests::{
    Substrate, add, form_factor, gi, image, mean, place, render, scene_from, scene_of, span, triangles,
};

/// At 32³ such a scene has voxels of size 1, and 0 lies at 1.5 of them.
const SIDE: f32 = 29.0;
const FIRST: f32 = 1.5;

fn voxelize(scene: &Scene) -> Substrate {
    let request = Request { resolution: Some(32), output: Some("diffuse".into()), ..Request::image(8, 8) };
    Substrate::read(&render(&gi(), scene, &request))
}

/// A quadrilateral, counter-clockwise from the front.
fn quad([a, b, c, d]: [Vec3; 4]) -> [[Vec3; 3]; 2] {
    [[a, b, c], [a, c, d]]
}

/// An upward sheet at a height, cut into so many pieces along x and z.
fn sheet(x: [f32; 2], z: [f32; 2], y: f32, pieces: usize) -> Vec<[Vec3; 3]> {
    let at = |ends: [f32; 2], i: usize| ends[0] + (ends[1] - ends[0]) * i as f32 / pieces as f32;
    let cells = (0..pieces).flat_map(|i| (0..pieces).map(move |j| (i, j)));
    cells
        .flat_map(|(i, j)| {
            let [x0, x1, z0, z1] = [at(x, i), at(x, i + 1), at(z, j), at(z, j + 1)];
            quad([[x0, y, z1], [x1, y, z1], [x1, y, z0], [x0, y, z0]].map(Vec3::from))
        })
        .collect()
}

/// Top and bottom of a box, and its sides along x.
fn slab(x: [f32; 2], z: [f32; 2], y: [f32; 2]) -> Vec<[Vec3; 3]> {
    let mut list = sheet(x, z, y[1], 1);
    list.extend(sheet(x, z, y[0], 1).into_iter().map(|[a, b, c]| [a, c, b]));
    let [low, high] = y;
    for (x, z) in [(x[0], z), (x[1], [z[1], z[0]])] {
        list.extend(quad([[x, low, z[0]], [x, low, z[1]], [x, high, z[1]], [x, high, z[0]]].map(Vec3::from)));
    }
    list
}

/// A large triangle covers of a voxel the squares whose middles lie within its edges, no more and no less, wherever the edge is.
#[test]
fn an_edge_covers_its_own_squares() {
    type Wall = fn([f32; 2], [f32; 2], f32) -> Vec<[Vec3; 3]>;
    let walls: [(&str, Wall); 4] = [
        ("one quadrilateral", |x, z, y| sheet(x, z, y, 1)),
        ("many quadrilaterals", |x, z, y| sheet(x, z, y, 5)),
        ("a thin box", |x, z, y| slab(x, z, [y - 0.3, y])),
        ("a thick box", |x, z, y| slab(x, z, [y - 1.6, y])),
    ];
    let z = [3.2, 26.0];
    for (name, wall) in walls {
        // One over the other, each with its right edge a tenth of a voxel further and its left one as much less far.
        let offset = |level: usize| 0.05 + 0.1 * level as f32;
        let height = |level: usize| 2.7 * level as f32 + 2.9;
        let ends = |level: usize| [5.0 - FIRST + offset(level), 20.0 - FIRST + offset(level)];
        let list: Vec<_> = (0..10).flat_map(|level| wall(ends(level), z, height(level))).collect();
        let substrate = voxelize(&scene_of(vec![span(SIDE), triangles(&list)], SIDE.into()));
        for level in 0..10 {
            for (cell_x, is_right) in [(5, false), (20, true)] {
                let cell = UVec3::new(cell_x, (height(level) + FIRST) as u32, 15);
                let covered =
                    substrate.squares(cell, 1).unwrap_or_else(|| panic!("{name}: no sheet in {cell}"));
                for (square, covered) in covered.into_iter().enumerate() {
                    // Rows along x are of one z.
                    let middle = ((square / 5) as f32 + 0.5) / 5.0;
                    let inside = (middle < offset(level)) == is_right;
                    // Where a box's faces meet, what they touch counts.
                    let touched = (middle - offset(level)).abs() < 0.1 && name.contains("box");
                    assert_eq!(
                        covered,
                        inside || touched,
                        "{name}: square {square} of {cell}, edge at {}",
                        offset(level)
                    );
                }
            }
        }
    }
}

/// Of two surfaces of the same facing in one voxel the one in front shows, whichever comes first in the list of triangles.
#[test]
fn the_front_one_of_two_surfaces_shows() {
    let colours = [DVec3::new(0.7, 0.05, 0.1), DVec3::new(0.9, 0.9, 0.9)];
    let x = [4.0, 25.0];
    for carpet_first in [true, false] {
        let mut scene = scene_of(vec![span(SIDE)], SIDE.into());
        for (name, colour) in ["carpet", "floor"].into_iter().zip(colours) {
            let base_color = colour.as_vec3().extend(1.0);
            scene.materials.push(Material { name: name.into(), base_color, ..Material::default() });
        }
        let gaps = [0.02, 0.1, 0.3, 0.6];
        for (level, gap) in gaps.into_iter().enumerate() {
            // Within a voxel, the floor at 0.15 of it.
            let floor = 6.0 * level as f32 + 3.0 - FIRST + 0.15;
            let mut pair = [(1, floor + gap), (2, floor)];
            if !carpet_first {
                pair.reverse();
            }
            for (material, y) in pair {
                add(&mut scene, Mesh { material, ..triangles(&sheet(x, x, y, 1)) });
            }
        }
        let substrate = voxelize(&scene);
        for (level, gap) in gaps.into_iter().enumerate() {
            let cell = UVec3::new(15, 6 * level as u32 + 3, 15);
            let up = substrate.side_colors(cell).unwrap()[2];
            // Its square root has 9, 9 and 8 bits.
            assert!(up.distance(colours[0]) < 0.003, "{gap} over the floor: {up}, expected {}", colours[0]);
        }
    }
}

/// A room whose walls and roof are sheets that face outwards, with a post on its floor, under sky and sun: the backs stop all of it,
/// for pixels and for the light of the voxels that the post sees.
#[test]
fn a_sheet_stops_light_from_both_sides() {
    for inside_out in [false, true] {
        let scene = scene_from(&format!(
            r#"(
                materials: {{"matte": (base_color: 0.7)}},
                objects: [
                    (name: "shell", material: "matte", shape: Box(min: (-1.3, 0, -1), max: (1.3, 1.6, 1)), inside_out: {inside_out}),
                    (name: "floor", material: "matte", shape: Grid(size: (2.6, 2))),
                    (name: "post", material: "matte", shape: Box(min: (-0.2, 0, -0.3), max: (0.3, 1.1, 0.1))),
                ],
                lights: [Directional(name: "sun", direction: (0.4, -1, -0.3), irradiance: 9)],
                sky: 2,
                cameras: [(name: "post", eye: (0.9, 0.6, 0.8), target: (0, 0.4, 0), fov_deg: 12)],
            )"#
        ));
        for output in ["diffuse", "shadow", "final"] {
            let image = image(&scene, output, 64, &[("diffuse", "rays", 64.0)]);
            assert!(
                output != "diffuse" || image.pixels.iter().all(|pixel| pixel[3] > 0.0),
                "the post fills the image"
            );
            // Seen from behind, the corners of sheets let in 0.0015 of what is outside: a fifth more is the ceiling.
            let outside = 2.0 * std::f64::consts::PI + 9.0;
            assert!(
                mean(&image)[0] < 0.0018 * outside,
                "{output}, inside out: {inside_out}: {:?}",
                mean(&image)
            );
        }
    }
}

/// A fence that lies over a floor, of so many bars of which a share is solid: a texture with holes, or boxes.
fn fenced(solid: f64, masked: bool) -> Scene {
    let (bars, half, height) = (100, 2.0, 0.5);
    let mut scene = scene_of(Vec::new(), 1.0);
    let floor = sheet([-2.0, 2.0], [-2.0, 2.0], 0.0, 1);
    scene.materials[0].base_color = Vec4::new(0.0, 0.0, 0.0, 1.0);
    add(&mut scene, triangles(&floor));
    if masked {
        let texels = 16;
        let rgba =
            (0..texels).flat_map(|x| [255, 255, 255, if f64::from(x) < 16.0 * solid { 255 } else { 0 }]);
        let texture =
            Texture { name: "bars".into(), width: texels, height: 1, rgba: rgba.collect(), srgb: true };
        scene.textures.push(texture);
        let base_color_texture = Some(TextureRef { texture: 0 });
        scene.materials.push(Material { base_color_texture, alpha_cutoff: Some(0.5), ..Material::default() });
        let mut mesh = triangles(&sheet([-2.0, 2.0], [-2.0, 2.0], height, 1));
        mesh.uvs =
            mesh.positions.iter().map(|p| glam::Vec2::new((p.x / 4.0 + 0.5) * bars as f32, 0.5)).collect();
        add(&mut scene, Mesh { material: 1, ..mesh });
    } else {
        let pitch = 2.0 * half / f64::from(bars);
        for bar in 0..bars {
            let x = -half + pitch * f64::from(bar);
            let ends = [x as f32, (x + pitch * solid) as f32];
            place(
                &mut scene,
                triangles(&slab(ends, [-2.0, 2.0], [height, height + 0.01])),
                DAffine3::IDENTITY,
            );
        }
    }
    let eye = DVec3::new(0.0, 0.4, 0.1);
    scene.cameras = vec![Camera::look_at("floor", eye, DVec3::ZERO, DVec3::Y, 0.6).unwrap()];
    scene
}

/// A sun straight above passes as much of a fence as it has holes, though its bars are 4 cm from each other and a voxel is 6.6 cm.
#[test]
fn a_fence_finer_than_a_voxel_shades_by_its_share() {
    for (solid, masked) in [(0.25, false), (0.5, false), (0.5, true), (0.75, true)] {
        let mut scene = fenced(solid, masked);
        let kind = LightKind::Directional { direction: Vec3::NEG_Y, angular_diameter: 0.0 };
        scene.lights.push(Light { name: "sun".into(), kind, intensity: Vec3::ONE });
        let found = mean(&image(&scene, "shadow", 64, &[]))[0];
        println!("{solid}, mask {masked}: {found:.3}");
        assert!((found - (1.0 - solid)).abs() < 0.03, "{solid}, mask {masked}: {found}");
    }
}

/// The share of the sky's light that a fence lets through, of the light that comes from where the fence is: of a direction, a bar hides
/// its width, and its height times the slope.
fn passes(solid: f64, height_over_pitch: f64, half: f64, distance: f64) -> f64 {
    let steps = 400;
    let (mut passed, mut all) = (0.0, 0.0);
    for i in 0..steps {
        for j in 0..steps {
            let [x, z] = [i, j].map(|i| half * ((f64::from(i) + 0.5) / f64::from(steps) * 2.0 - 1.0));
            let weight = (x * x + z * z + distance * distance).powi(-2);
            passed += weight * (1.0 - solid - height_over_pitch * x.abs() / distance).max(0.0);
            all += weight;
        }
    }
    passed / all
}

/// The sky's light through the same fences. A square of a voxel's face is a fifth of it, and the narrowest bars are three quarters of
/// that: what squares and mean planes of a bar's sides leave is within 0.07.
#[test]
fn a_fence_lets_through_its_share_of_the_sky() {
    let around = 1.0 - form_factor::of_rectangle([-2.0, 2.0], [-2.0, 2.0], 0.5);
    for (solid, masked) in [(0.25, false), (0.5, false), (0.5, true), (0.75, true)] {
        let mut scene = fenced(solid, masked);
        scene.sky = Vec3::ONE;
        let found = mean(&image(&scene, "diffuse", 64, &[("diffuse", "rays", 16.0)]))[0] / PI;
        let passed = (found - around) / (1.0 - around);
        let right = passes(solid, if masked { 0.0 } else { 0.25 }, 2.0, 0.5);
        println!("{solid}, mask {masked}: {passed:.3} passes, {right:.3} is right");
        assert!(
            (passed - right).abs() < 0.07,
            "{solid}, mask {masked}: {passed:.3} passes, {right:.3} is right"
        );
    }
}
