//! What voxels and pixels know of surfaces, against closed forms in `f64`: normals and normal maps under any transform,
//! textures at the level that fits, alpha masks, and the point of a triangle that stands for it in a voxel.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use glam::{DAffine3, DMat3, DQuat, DVec3, EulerRot, UVec3, Vec2, Vec3, Vec4};
use voxlume::scene::{Material, Mesh, Texture, TextureRef};
use voxlume::twin::total_reflectance;
use voxlume::{Camera, Request, Scene};
use voxlume_tests::{Substrate, Surface, gi, picture, place, render, scene_of, soup, span, triangles};

fn voxelize(scene: &Scene) -> Substrate {
    let request = Request { resolution: Some(32), output: Some("diffuse".into()), ..Request::image(8, 8) };
    Substrate::read(&render(&gi(), scene, &request))
}

fn add_texture(
    scene: &mut Scene,
    side: u32,
    srgb: bool,
    texel: impl Fn(u32, u32) -> [u8; 4],
) -> Option<TextureRef> {
    let rgba =
        (0..side).flat_map(|y| (0..side).map(move |x| (x, y))).flat_map(|(x, y)| texel(x, y)).collect();
    let (name, texture) = ("texture".into(), scene.textures.len());
    scene.textures.push(Texture { name, width: side, height: side, rgba, srgb });
    Some(TextureRef { texture })
}

/// Axes along which a square lies in its own space: to the right and up in its texture. Askew to the axes that transforms scale.
const RIGHT: DVec3 = DVec3::new(1.0, 0.0, 0.0);
const UP: DVec3 = DVec3::new(0.0, 0.6, 0.8);

fn square() -> Mesh {
    let corner = |x: f64, y: f64| (x * RIGHT + y * UP).as_vec3();
    let [a, b, c, d] = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    let mut mesh = triangles(&[[a, b, c], [a, c, d]]);
    mesh.tangents = vec![RIGHT.as_vec3().extend(1.0); 6];
    mesh
}

/// Mirrors, uneven scales, turns, a shear, and all at once.
fn transforms() -> Vec<DMat3> {
    let scale = |x, y, z| DMat3::from_diagonal(DVec3::new(x, y, z));
    let turn = DMat3::from_quat(DQuat::from_euler(EulerRot::XYZ, 0.4, -1.1, 2.3));
    let shear = DMat3::from_cols(DVec3::X, DVec3::new(0.5, 1.0, 0.2), DVec3::new(-0.3, 0.0, 1.0));
    let plain = vec![
        DMat3::IDENTITY,
        scale(-1.0, 1.0, 1.0),
        scale(1.0, -1.0, 1.0),
        scale(1.0, 1.0, -1.0),
        scale(-1.0, -1.0, -1.0),
        scale(1.0, 2.0, 0.5),
        scale(-3.0, 0.4, 1.0),
        shear,
        shear * scale(1.0, -2.0, 0.7),
    ];
    plain.iter().map(|matrix| turn * matrix).chain(plain.iter().copied()).collect()
}

/// glTF 2.0 §3.9.3: the map's x goes along the tangent, its y along the bitangent, its z along the normal, which keeps facing
/// where the surface's front is. Tangents lie in the surface and are carried along; what is right-angled to them within it is the bitangent.
fn expected_normal(matrix: DMat3, map: DVec3) -> DVec3 {
    let tangent = (matrix * RIGHT).normalize();
    let bitangent = (matrix * UP).reject_from(tangent).normalize();
    let normal = (matrix.inverse().transpose() * RIGHT.cross(UP)).normalize();
    (map.x * tangent + map.y * bitangent + map.z * normal).normalize()
}

fn map_of([x, y, z, _]: [u8; 4]) -> DVec3 {
    DVec3::new(f64::from(x), f64::from(y), f64::from(z)) / 127.5 - 1.0
}

#[test]
fn normals_follow_every_transform() {
    // A plain surface, and one that leans to its right and down.
    for texel in [None, Some([204, 66, 220, 255])] {
        let map = texel.map_or(DVec3::Z, map_of);
        for (double_sided, matrix) in [false, true].into_iter().cycle().zip(transforms()) {
            let mut scene = scene_of(Vec::new(), 1.0);
            scene.materials[0].double_sided = double_sided;
            scene.materials[0].normal_texture =
                texel.and_then(|t| add_texture(&mut scene, 1, false, |_, _| t));
            place(&mut scene, square(), DAffine3::from_mat3(matrix));
            let expected = expected_normal(matrix, map);
            let substrate = voxelize(&scene);
            assert!(substrate.levels[0].count > 100);
            for surface in substrate.voxels().map(Surface::of) {
                let normal = surface.normal;
                // Vertices have normals and tangents in 2 × 16 bits, tangents less one: 10⁻⁴ each at most.
                assert!(
                    normal.distance(expected) < 3e-4,
                    "{normal} and not {expected} under {matrix} with {map}"
                );
                assert_eq!(surface.double_sided, f64::from(u8::from(double_sided)), "{matrix}");
            }
        }
    }
}

/// What voxels hold, pixels show too; from behind, a double-sided surface with its map is turned round as a whole.
#[test]
fn pixels_show_the_normal_from_either_side() {
    let texel = [204, 66, 220, 255];
    for matrix in transforms() {
        let mut scene = scene_of(Vec::new(), 1.0);
        scene.materials[0].double_sided = true;
        scene.materials[0].normal_texture = add_texture(&mut scene, 1, false, |_, _| texel);
        place(&mut scene, square(), DAffine3::from_mat3(matrix));
        let front = expected_normal(matrix, DVec3::Z);
        for side in [1.0, -1.0] {
            // Straight over the middle, so near that the square fills the image.
            let eye = front * side * 0.2;
            scene.cameras = Camera::look_at("near", eye, DVec3::ZERO, front.any_orthonormal_vector(), 0.5)
                .into_iter()
                .collect();
            let request = Request { output: Some("normal".into()), ..Request::image(4, 4) };
            let shown = picture(&render(&gi(), &scene, &request), "normal");
            let expected = side * expected_normal(matrix, map_of(texel));
            for [x, y, z, _] in shown.pixels {
                // As in voxels, and halves of 11 bits.
                assert!(
                    Vec3::new(x, y, z).as_dvec3().distance(expected) < 1e-3,
                    "{x} {y} {z} and not {expected} from {side} under {matrix}"
                );
            }
        }
    }
}

/// Which cells of the plane below show a texel each: it spans 0 to 8 of 18 voxels along its legs, so that no other edge is near.
const SHOWN: u32 = 8;
const LAYER: u32 = 15;

/// A right-angled triangle through the middle of the cells of a layer, a texture for every `SHOWN` voxels, whose cell (0, 0)
/// has the coordinates `first_cell`.
fn textured_plane() -> (Mesh, UVec3) {
    // 29 of 32 voxels: voxels of size 1, 0 at 1.5; so 4.25 here. At a voxel's centre a texel as large as it has three quarters of
    // the weight along each axis, while on the level below the centre of one of its texels would lie there.
    let at = |x: f32, y: f32| Vec3::new(2.75 + x, 2.75 + y, LAYER as f32 - 1.0);
    let mut mesh = triangles(&[[at(0.0, 0.0), at(18.0, 0.0), at(0.0, 18.0)]]);
    let far = 18.0 / SHOWN as f32;
    mesh.uvs = vec![Vec2::ZERO, Vec2::new(far, 0.0), Vec2::new(0.0, far)];
    (mesh, UVec3::new(4, 4, LAYER))
}

/// A different word of noise for each cell.
fn noise(x: u32, y: u32) -> u32 {
    let mixed = (x * 0x9e37 + y * 0x79b9 + 1).wrapping_mul(0x85eb_ca6b);
    (mixed ^ mixed >> 13).wrapping_mul(0xc2b2_ae35)
}

/// A texture whose texels are finer than voxels by 2^level: for each voxel a chequer of two colours. On the level that fits, a
/// texel is their mean; on the one below the chequer shows.
fn chequered(level: u32) -> impl Fn(u32, u32) -> [u8; 4] {
    move |x, y| {
        let [r, g, b, a] = noise(x >> level, y >> level).to_le_bytes();
        let odd = level > 0 && (x >> (level - 1) ^ y >> (level - 1)) & 1 == 1;
        // The mask is the same over the whole voxel.
        if odd { [r / 2, g / 2, b / 2, 255 * (a & 1)] } else { [r, g, b, 255 * (a & 1)] }
    }
}

/// What a texture that repeats shows at the centre of a voxel, on the level that fits.
fn shown(texel: impl Fn(u32, u32) -> [u8; 4], level: u32, [x, y]: [u32; 2], decode: fn(u8) -> f64) -> DVec3 {
    let value = |x, y| {
        let [r, g, b, _] = texel(x, y).map(decode);
        DVec3::new(r, g, b)
    };
    let mean = |x: u32, y: u32| {
        let texels = (0..1 << level).flat_map(|j| (0..1 << level).map(move |i| (i, j)));
        texels.map(|(i, j)| value((x << level) + i, (y << level) + j)).sum::<DVec3>()
            / f64::from(1 << (2 * level))
    };
    let before = |n: u32| (n + SHOWN - 1) % SHOWN;
    let row = |y: u32| 0.75 * mean(x, y) + 0.25 * mean(before(x), y);
    0.75 * row(y) + 0.25 * row(before(y))
}

/// IEC 61966-2-1.
fn srgb(value: u8) -> f64 {
    let v = f64::from(value) / 255.0;
    if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}

fn linear(value: u8) -> f64 {
    f64::from(value) / 255.0
}

#[test]
fn textures_are_read_where_a_texel_is_as_large_as_a_voxel() {
    for level in [0, 1, 3] {
        let texel = chequered(level);
        let (mesh, first) = textured_plane();
        let mut scene = scene_of(vec![span(29.0), mesh], 29.0);
        let side = SHOWN << level;
        let color = add_texture(&mut scene, side, true, &texel);
        let data = add_texture(&mut scene, side, false, |x, y| texel(y, x));
        scene.materials.push(Material {
            base_color: Vec4::new(0.9, 0.8, 0.7, 1.0),
            base_color_texture: color,
            metallic: 0.6,
            metallic_roughness_texture: data,
            emission: Vec3::new(1.0, 2.0, 4.0),
            emission_texture: color,
            ..Material::default()
        });
        scene.meshes[1].material = 1;
        let substrate = voxelize(&scene);
        for (x, y) in (0..SHOWN).flat_map(|y| (0..SHOWN).map(move |x| (x, y))) {
            let surface = Surface::of(substrate.sums(first + UVec3::new(x, y, 0)).unwrap());
            let light = shown(&texel, level, [x, y], srgb);
            let emission = DVec3::new(0.25, 0.5, 1.0) * light;
            let metallic = 0.6 * shown(&texel, level, [y, x], linear).z;
            let color = DVec3::new(0.9, 0.8, 0.7) * light;
            let roughness = shown(&texel, level, [y, x], linear).y;
            let albedo = total_reflectance(color, metallic, roughness);
            // Coarser levels have 8 bits a channel, rounded on each: half a step of the steepest sRGB, 0.0045, a level. A sampler's
            // weights have 8 bits too, so that a neighbour may come in by 1/256.
            let tolerance = 0.0045 * f64::from(level) + 1.0 / 256.0;
            for (what, is, expected) in
                [("albedo", surface.albedo, albedo), ("emission", surface.emission, emission)]
            {
                assert!(
                    is.abs_diff_eq(expected, tolerance),
                    "{what} of ({x}, {y}), level {level}: {is}, not {expected}"
                );
            }
        }
    }
}

#[test]
fn masks_leave_holes() {
    for level in [0, 2] {
        let texel = chequered(level);
        let (mesh, first) = textured_plane();
        let mut scene = scene_of(vec![span(29.0), mesh], 29.0);
        let color = add_texture(&mut scene, SHOWN << level, true, &texel);
        scene.materials.push(Material {
            base_color_texture: color,
            alpha_cutoff: Some(0.5),
            ..Material::default()
        });
        scene.meshes[1].material = 1;
        let substrate = voxelize(&scene);
        let mut holes = 0;
        for (x, y) in (0..SHOWN).flat_map(|y| (0..SHOWN).map(move |x| (x, y))) {
            let whole = texel(x << level, y << level)[3] == 255;
            // Alpha is interpolated between texels: in the middle of the voxel nine sixteenths of it are its own texel's.
            let middle = substrate.squares(first + UVec3::new(x, y, 0), 2).is_some_and(|squares| squares[12]);
            assert_eq!(middle, whole, "({x}, {y}), level {level}");
            holes += u32::from(!whole);
        }
        assert!(holes > 10 && holes < SHOWN * SHOWN - 10, "{holes} holes");
    }
}

/// The point of a triangle nearest to `p`, as weights of its corners: within it, or the nearest of its three sides.
fn nearest(p: DVec3, [a, b, c]: [DVec3; 3]) -> DVec3 {
    let normal = (b - a).cross(c - a);
    let part = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(normal) / normal.length_squared();
    let weights = DVec3::new(part(b, c), part(c, a), part(a, b));
    if weights.min_element() >= 0.0 {
        return weights;
    }
    let on_side = |from: usize| {
        let corners = [a, b, c];
        let to = (from + 1) % 3;
        let side = corners[to] - corners[from];
        let t = ((p - corners[from]).dot(side) / side.length_squared()).clamp(0.0, 1.0);
        let mut weights = DVec3::ZERO;
        (weights[from], weights[to]) = (1.0 - t, t);
        (weights, p.distance(corners[from].lerp(corners[to], t)))
    };
    let sides = [on_side(0), on_side(1), on_side(2)];
    sides.into_iter().min_by(|(_, x), (_, y)| x.total_cmp(y)).unwrap().0
}

/// RAU §4.1.5 extrapolates to the voxel's centre, which many voxels at a triangle's edges have outside of it.
#[test]
fn a_triangle_shows_its_point_nearest_to_the_voxels_centre() {
    let corners =
        [Vec3::new(1.0, 0.0, 0.2), Vec3::new(-0.3, 1.0, 0.0), Vec3::new(0.1, -0.2, 1.0)].map(Vec3::normalize);
    for (seed, triangle) in (0..).zip(soup(41, 6, 29.0, (8.0, 14.0))) {
        let mut mesh = triangles(&[triangle]);
        mesh.normals = corners.to_vec();
        let scene = scene_of(vec![mesh], 29.0);
        let substrate = voxelize(&scene);
        let [triangle] = substrate.triangles(&scene)[..] else { panic!() };
        let mut outside = 0;
        for (cell, sums) in substrate.listed(0).into_iter().zip(substrate.voxels()) {
            let weights = nearest(cell.as_dvec3() + 0.5, triangle);
            let expected: DVec3 = (0..3).map(|i| weights[i] * corners[i].as_dvec3()).sum();
            let is = Surface::of(sums).normal;
            // Normals of 2 × 16 bits, 10⁻⁴ each; the nearest point in `f32`.
            assert!(is.distance(expected.normalize()) < 3e-4, "{is} at {cell} of {seed}, weights {weights}");
            outside += u32::from(weights.min_element() == 0.0);
        }
        assert!(outside > 20, "only {outside} voxels at the edges");
    }
}
