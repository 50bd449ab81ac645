//! Scenes made in memory.
#![allow(clippy::panic, clippy::expect_used)]

use glam::{DAffine3, DVec3, Vec2, Vec3};
use voxlume::scene::{Instance, Material, Mesh};
use voxlume::{Camera, Scene, Source};

use crate::{Random, root};

/// A scene of meshes, each placed once where it is, in one white material. The camera looks at the middle of
/// a cube of side `side` from just outside its front.
///
/// # Panics
/// `side` is zero or not finite.
pub fn scene_of(meshes: Vec<Mesh>, side: f64) -> Scene {
    let middle = DVec3::splat(side / 2.0);
    let eye = middle + DVec3::new(0.3, 0.2, 1.2) * side;
    let camera = Camera::look_at("front", eye, middle, DVec3::Y, 1.0).expect("a view");
    let mut scene = Scene {
        name: "test".into(),
        materials: vec![Material { name: "white".into(), ..Material::default() }],
        cameras: vec![camera],
        ..Scene::default()
    };
    meshes.into_iter().for_each(|mesh| add(&mut scene, mesh));
    scene
}

/// Adds a mesh, placed once where it is.
pub fn add(scene: &mut Scene, mesh: Mesh) {
    place(scene, mesh, DAffine3::IDENTITY);
}

/// Adds a mesh, placed by a transform.
pub fn place(scene: &mut Scene, mesh: Mesh, transform: DAffine3) {
    scene.instances.push(Instance {
        name: mesh.name.clone(),
        mesh: scene.meshes.len(),
        transform,
        moving: false,
    });
    scene.meshes.push(mesh);
}

/// A mesh of triangles with flat normals; triangles without area face up.
pub fn triangles(corners: &[[Vec3; 3]]) -> Mesh {
    let mut mesh = Mesh { name: "triangles".into(), ..Mesh::default() };
    for triangle in corners {
        let normal = (triangle[1] - triangle[0]).as_dvec3().cross((triangle[2] - triangle[0]).as_dvec3());
        let normal = normal.normalize_or(DVec3::Y).as_vec3();
        let first = mesh.positions.len() as u32;
        for corner in triangle {
            mesh.positions.push(*corner);
            mesh.normals.push(normal);
            mesh.tangents.push(normal.any_orthonormal_vector().extend(1.0));
            mesh.uvs.push(Vec2::ZERO);
        }
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    mesh
}

/// A mesh of one triangle.
pub fn triangle(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> Mesh {
    triangles(&[[a.into(), b.into(), c.into()]])
}

/// Two small triangles that make the scene's bounds the cube from 0 to `side`.
pub fn span(side: f32) -> Mesh {
    let low = [Vec3::ZERO, Vec3::new(0.2, 0.1, 0.0), Vec3::new(0.0, 0.2, 0.1)];
    triangles(&[low, low.map(|p| Vec3::splat(side) - p)])
}

/// Random triangles inside the cube from 0 to `side`, whose corners are up to `sizes` from their middle, as many of
/// each order of magnitude.
pub fn soup(seed: u64, count: usize, side: f64, sizes: (f64, f64)) -> Vec<[Vec3; 3]> {
    let mut random = Random::new(seed);
    let mut list = Vec::new();
    while list.len() < count {
        let size = random.between(sizes.0.ln(), sizes.1.ln()).exp();
        let middle = random.point(0.0, side);
        let corners = [(); 3].map(|()| middle + random.point(-size, size));
        if corners.iter().all(|p| p.min_element() >= 0.0 && p.max_element() <= side) {
            list.push(corners.map(|p| p.as_vec3()));
        }
    }
    list
}

/// A scene of the repository's `scenes` folder.
///
/// # Panics
/// The file is at fault.
pub fn built_in(file: &str) -> Scene {
    Scene::load(&root().join("scenes").join(file)).unwrap_or_else(|faults| panic!("{faults}"))
}

/// A scene from the text of a `.ron` file.
///
/// # Panics
/// The text is at fault.
pub fn scene_from(text: &str) -> Scene {
    Scene::parse(&Source::new("scene.ron", text)).unwrap_or_else(|faults| panic!("{faults}"))
}

/// One of the large sample scenes, which lie beside the repository if anywhere; says so if it isn't there.
///
/// # Panics
/// The file is at fault.
pub fn sample(file: &str) -> Option<Scene> {
    let path = root().join("../shared/scenes").join(file);
    if !path.exists() {
        println!("skipped: there is no {}", path.display());
        return None;
    }
    Some(Scene::load(&path).unwrap_or_else(|faults| panic!("{faults}")))
}
