//! Scenes made in memory, and measurements at one point of them.

use std::sync::atomic::AtomicBool;

use glam::{DAffine3, DVec3, Vec2, Vec3, Vec4};
use voxlume_reference::{Picture, PixelSampling, Quantity, Reflection, Request, Tracer};
use voxlume_scene::{Camera, Instance, Light, LightKind, Material, Mesh, Scene, Texture, TextureRef};

pub const PI: f64 = std::f64::consts::PI;

/// Half the side of planes that stand for infinite ones.
pub const WIDE: f32 = 3000.0;

pub fn grey(albedo: f32) -> Material {
    Material { base_color: Vec4::new(albedo, albedo, albedo, 1.0), ..Material::default() }
}

pub fn emissive(radiance: f32) -> Material {
    Material { emission: Vec3::splat(radiance), ..grey(0.0) }
}

/// Adds a mesh of quads (counter-clockwise from the front), each with uv from (0,0) to (1,1).
pub fn add_quads(scene: &mut Scene, material: Material, quads: &[[Vec3; 4]]) {
    let mut mesh = Mesh { material: scene.materials.len(), ..Mesh::default() };
    for &[a, b, c, d] in quads {
        let first = mesh.positions.len() as u32;
        let normal = (b - a).cross(c - a).normalize();
        let tangent = (b - a).normalize();
        mesh.positions.extend([a, b, c, d]);
        mesh.normals.extend([normal; 4]);
        mesh.tangents.extend([tangent.extend(1.0); 4]);
        mesh.uvs.extend([Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y]);
        mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    scene.materials.push(material);
    add_mesh(scene, mesh);
}

pub fn add_mesh(scene: &mut Scene, mesh: Mesh) {
    let transform = DAffine3::IDENTITY;
    scene.instances.push(Instance { name: "i".into(), mesh: scene.meshes.len(), transform, moving: false });
    scene.meshes.push(mesh);
}

/// The plane y = 0 facing up.
pub fn floor(material: Material) -> Scene {
    let mut scene = Scene::default();
    let corner = |x: f32, z: f32| Vec3::new(x * WIDE, 0.0, z * WIDE);
    let quad = [corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0), corner(-1.0, -1.0)];
    add_quads(&mut scene, material, &[quad]);
    scene
}

/// The six sides of a box, facing inwards.
pub fn room(low: Vec3, high: Vec3) -> Vec<[Vec3; 4]> {
    let corner = |i: usize| {
        Vec3::new(
            if i & 1 == 0 { low.x } else { high.x },
            if i & 2 == 0 { low.y } else { high.y },
            if i & 4 == 0 { low.z } else { high.z },
        )
    };
    [[0, 4, 5, 1], [2, 3, 7, 6], [0, 1, 3, 2], [4, 6, 7, 5], [0, 2, 6, 4], [1, 5, 7, 3]]
        .map(|side| side.map(corner))
        .to_vec()
}

/// A regular polygon of 256 corners around `centre`, as good as a disc, facing down or up.
pub fn add_disc(scene: &mut Scene, material: Material, centre: Vec3, radius: f32, facing_up: bool) {
    let sides = 256;
    let mut mesh = Mesh { material: scene.materials.len(), ..Mesh::default() };
    mesh.positions.push(centre);
    for i in 0..sides {
        let (sin, cos) = (i as f32 / sides as f32 * std::f32::consts::TAU).sin_cos();
        mesh.positions.push(centre + Vec3::new(radius * cos, 0.0, radius * sin));
        let (a, b) = (i + 1, (i + 1) % sides + 1);
        mesh.triangles.push(if facing_up { [0, b, a] } else { [0, a, b] });
    }
    let count = mesh.positions.len();
    mesh.normals = vec![if facing_up { Vec3::Y } else { Vec3::NEG_Y }; count];
    mesh.tangents = vec![Vec4::new(1.0, 0.0, 0.0, 1.0); count];
    mesh.uvs = vec![Vec2::ZERO; count];
    scene.materials.push(material);
    add_mesh(scene, mesh);
}

pub fn add_texture(scene: &mut Scene, width: u32, srgb: bool, rgba: &[[u8; 4]]) -> Option<TextureRef> {
    let height = rgba.len() as u32 / width;
    scene.textures.push(Texture { name: "t".into(), width, height, rgba: rgba.concat(), srgb });
    Some(TextureRef { texture: scene.textures.len() - 1 })
}

pub fn add_light(scene: &mut Scene, kind: LightKind, intensity: f32) {
    let name = format!("light {}", scene.lights.len());
    scene.lights.push(Light { name, kind, intensity: Vec3::splat(intensity) });
}

/// A camera that sees nothing but `target`: its view is a ten-thousandth of a radian wide.
pub fn look(eye: Vec3, target: Vec3) -> Camera {
    let forward = (target - eye).normalize();
    let up = forward.any_orthonormal_vector();
    Camera { name: "c".into(), eye: eye.as_dvec3(), forward, up, vertical_fov: 1e-4 }
}

/// A request for 16 × 16 pixels with glTF's reflection.
pub fn request(camera: Camera, quantity: Quantity, samples: u32) -> Request {
    Request {
        camera,
        width: 16,
        height: 16,
        samples,
        seed: 1,
        sampling: PixelSampling::Centre,
        quantity,
        reflection: Reflection::Gltf,
    }
}

pub fn lambert(camera: Camera, quantity: Quantity, samples: u32) -> Request {
    Request { reflection: Reflection::Lambert, ..request(camera, quantity, samples) }
}

pub fn render(scene: &Scene, request: &Request) -> Picture {
    Tracer::new(scene).unwrap().render(request, &|_| (), &AtomicBool::new(false)).unwrap()
}

/// Mean of the first channel over all pixels, and its standard error.
pub fn measure(scene: &Scene, request: &Request) -> (f64, f64) {
    let picture = render(scene, request);
    let count = picture.mean.len() as f64;
    let mean = picture.mean.iter().map(|p| f64::from(p[0])).sum::<f64>() / count;
    let variance = picture.standard_error.iter().map(|p| f64::from(p[0]).powi(2)).sum::<f64>();
    (mean, variance.sqrt() / count)
}

/// Checks a measurement to three standard errors, which must themselves be below half a percent.
/// What is left for rounding is 5·10⁻⁵: rays leave a floor of size [`WIDE`] 2·10⁻⁴ above it.
#[track_caller]
pub fn expect(scene: &Scene, request: &Request, expected: f64) {
    let (mean, error) = measure(scene, request);
    assert!(error <= 0.005 * expected, "too noisy to tell: {mean} ± {error}, expected {expected}");
    assert!(
        (mean - expected).abs() <= 3.0 * error + 5e-5 * expected,
        "{mean} ± {error}, expected {expected}: off by {:.2} % and {:.1} standard errors",
        100.0 * (mean / expected - 1.0),
        (mean - expected).abs() / error,
    );
}

/// ∫₀¹ f by Simpson's rule.
pub fn simpson(f: impl Fn(f64) -> f64) -> f64 {
    let n = 2000;
    let weight = |i: i32| if i == 0 || i == n { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
    (0..=n).map(|i| weight(i) * f(f64::from(i) / f64::from(n))).sum::<f64>() / (3.0 * f64::from(n))
}

pub fn dvec3(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}
