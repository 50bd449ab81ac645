//! The table's scenes: files beside the repository, and meshes made here.

use std::f32::consts::TAU;

use glam::{DAffine3, DVec3, Vec3};
use voxlume::scene::{Instance, Material, Mesh};
use voxlume::{Camera, Scene};
use voxlume_benches::shared_scene;
use voxlume_benches::tube::{push, tube};

/// All of them.
pub const NAMES: [&str; 6] = ["triangle", "sponza", "bunny", "dragon", "hairball", "asian"];

/// A scene; `None` if it is a file that isn't there.
pub fn load(name: &str) -> Result<Option<Scene>, String> {
    let mesh = match name {
        "triangle" => triangle(),
        "hairball" => hairball(),
        "asian" => asian(),
        file => {
            let path = shared_scene(file);
            return match path.exists() {
                true => Ok(Some(with_camera(Scene::load(&path).map_err(|faults| faults.to_string())?)?)),
                false => Ok(None),
            };
        }
    };
    let instance = Instance { name: name.into(), mesh: 0, transform: DAffine3::IDENTITY, moving: false };
    let materials = vec![Material { name: "white".into(), ..Material::default() }];
    let scene = Scene {
        name: name.into(),
        materials,
        meshes: vec![mesh],
        instances: vec![instance],
        ..Scene::default()
    };
    with_camera(scene).map(Some)
}

/// Nothing is seen; but a frame needs a camera.
fn with_camera(mut scene: Scene) -> Result<Scene, String> {
    if scene.cameras.is_empty() {
        let camera = Camera::look_at("front", DVec3::Z, DVec3::ZERO, DVec3::Y, 1.0);
        scene.cameras.push(camera.ok_or("no view")?);
    }
    Ok(scene)
}

/// One triangle from corner to corner of the grid.
fn triangle() -> Mesh {
    let mut mesh = Mesh { name: "triangle".into(), ..Mesh::default() };
    for corner in [Vec3::ZERO, Vec3::new(1.0, 1.0, 0.3), Vec3::new(0.0, 1.0, 1.0)] {
        push(&mut mesh, corner, Vec3::Y);
    }
    mesh.triangles.push([0, 1, 2]);
    mesh
}

/// 2,880,000 triangles: 2,000 hairs of 120 segments, each a tube of six sides, curling outwards from a ball.
fn hairball() -> Mesh {
    let (hairs, segments, sides) = (2000, 120, 6);
    let mut mesh = Mesh { name: "hairball".into(), ..Mesh::default() };
    for hair in 0..hairs {
        // Directions by the golden angle.
        let t = (hair as f32 + 0.5) / hairs as f32;
        let (sin, cos) = (hair as f32 * 2.399_963).sin_cos();
        let height = 1.0 - 2.0 * t;
        let radius = (1.0 - height * height).sqrt();
        let out = Vec3::new(radius * cos, height, radius * sin);
        let (u, v) = out.any_orthonormal_pair();
        let twist = 3.0 + 5.0 * (hair as f32 * 0.618_034).fract();
        let centre = |s: f32| {
            let (sin, cos) = (twist * s + hair as f32).sin_cos();
            out * (0.2 + 0.8 * s) + (u * cos + v * sin) * (0.25 * s)
        };
        let first = mesh.positions.len() as u32;
        for ring in 0..=segments {
            let s = ring as f32 / segments as f32;
            for side in 0..sides {
                let (sin, cos) = (TAU * side as f32 / sides as f32).sin_cos();
                let normal = u * cos + v * sin;
                push(&mut mesh, centre(s) + normal * 0.003, normal);
            }
        }
        tube(&mut mesh, first, segments, sides);
    }
    mesh
}

/// 7,200,000 triangles, as many as the Asian Dragon has: a torus knot with a rippled surface.
fn asian() -> Mesh {
    let (rings, sides) = (6000, 600);
    let mut mesh = Mesh { name: "knot".into(), ..Mesh::default() };
    let centre = |t: f32| {
        let radius = 0.6 + 0.25 * (3.0 * t).cos();
        Vec3::new(radius * (2.0 * t).cos(), 0.25 * (3.0 * t).sin(), radius * (2.0 * t).sin())
    };
    for ring in 0..=rings {
        let t = TAU * ring as f32 / rings as f32;
        let along = (centre(t + 1e-3) - centre(t - 1e-3)).normalize();
        let u = along.cross(Vec3::Y).normalize();
        let v = along.cross(u);
        for side in 0..sides {
            let angle = TAU * side as f32 / sides as f32;
            let normal = u * angle.cos() + v * angle.sin();
            let ripple = 0.1 + 0.01 * (12.0 * angle + 40.0 * t).sin();
            push(&mut mesh, centre(t) + normal * ripple, normal);
        }
    }
    tube(&mut mesh, 0, rings, sides);
    mesh
}
