//! The scenes of the repository, and the sample scenes where they are.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use common::root;
use glam::{DVec3, Vec3};
use voxlume_scene::{Geometry, LightKind, Scene};

fn load(name: &str) -> Scene {
    Scene::load(&root().join("scenes").join(name)).unwrap_or_else(|faults| panic!("{faults}"))
}

/// `None`, said aloud, where the samples are not.
fn sample(name: &str) -> Option<Scene> {
    let path = root().join("../shared/scenes").join(name);
    if !path.exists() {
        println!("skipped: the sample scene {} is not here", path.display());
        return None;
    }
    Some(Scene::load(&path).unwrap_or_else(|faults| panic!("{faults}")))
}

fn triangles(scene: &Scene) -> usize {
    scene.instances.iter().map(|instance| scene.meshes[instance.mesh].triangles.len()).sum()
}

#[test]
fn cornell_is_the_published_box() {
    let scene = load("cornell.ron");
    assert_eq!((triangles(&scene), scene.materials.len(), scene.instances.len()), (46, 4, 16));
    let (low, high) = scene.bounds().unwrap();
    assert!(low.abs_diff_eq(DVec3::ZERO, 1e-6), "{low}");
    assert!(high.abs_diff_eq(DVec3::new(5.56, 5.488, 5.592), 1e-6), "{high}");
    assert_eq!((scene.name.as_str(), scene.sky), ("cornell", Vec3::ZERO));

    // Red is to the camera's left, green to its right, and every wall faces the middle.
    let camera = &scene.cameras[0];
    let right = camera.forward.cross(camera.up);
    let geometry = Geometry::new(&scene, DVec3::ZERO);
    let middle = Vec3::new(2.78, 2.73, 2.8);
    for instance in &scene.instances[..6] {
        let mesh = &scene.meshes[instance.mesh];
        let centre = mesh.positions.iter().sum::<Vec3>() / mesh.positions.len() as f32;
        assert!(
            mesh.normals.iter().all(|n| n.dot(middle - centre) > 0.0),
            "{} faces outwards",
            instance.name
        );
        let side = (centre - middle).dot(right);
        match instance.name.as_str() {
            "left" => assert!(side < -2.0 && scene.materials[mesh.material].name == "red"),
            "right" => assert!(side > 2.0 && scene.materials[mesh.material].name == "green"),
            _ => assert!(side.abs() < 0.1),
        }
    }
    // The blocks' fronts face away from their own middles.
    for (name, centre) in [("short", Vec3::new(1.86, 0.8, 1.69)), ("tall", Vec3::new(3.685, 1.6, 3.51))] {
        for instance in scene.instances.iter().filter(|i| i.name.starts_with(name)) {
            let mesh = &scene.meshes[instance.mesh];
            assert!(mesh.normals[0].dot(mesh.positions[0] - centre) > 0.0, "{}", instance.name);
        }
    }
    assert_eq!(geometry.triangles.len(), 46);
    let lights = scene.emissive_polygons(DVec3::ZERO, 8).unwrap();
    assert_eq!((lights.len(), lights[0].corners.len(), lights[0].double_sided), (1, 4, false));
}

#[test]
fn cornell_is_the_sample_box() {
    let Some(sample) = sample("cornell.glb") else { return };
    let scene = load("cornell.ron");
    // Triangles by their material's colour, whatever their order.
    let list = |scene: &Scene| {
        let geometry = Geometry::new(scene, DVec3::ZERO);
        let mut list: Vec<_> = geometry
            .triangles
            .iter()
            .map(|t| {
                let material = &scene.materials[geometry.materials[t[0] as usize] as usize];
                let mut corners =
                    t.map(|i| (geometry.positions[i as usize] * 1000.0).round().as_ivec3().to_array());
                let first = (0..3).min_by_key(|i| corners[*i]).unwrap();
                corners.rotate_left(first);
                let colour = [material.base_color.truncate(), material.emission];
                (corners, colour.map(|c| (c * 1000.0).round().as_ivec3().to_array()))
            })
            .collect();
        list.sort();
        list
    };
    assert_eq!(list(&scene), list(&sample));
    let (ours, theirs) = (&scene.cameras[0], &sample.cameras[0]);
    assert!((ours.eye - theirs.eye).length() < 1e-6);
    assert!(ours.forward.abs_diff_eq(theirs.forward, 1e-6) && ours.up.abs_diff_eq(theirs.up, 1e-6));
    assert!((ours.vertical_fov - theirs.vertical_fov).abs() < 1e-6);
}

#[test]
fn own_scenes_load() {
    let furnace = load("furnace.ron");
    assert_eq!(triangles(&furnace), 12);
    let polygons = furnace.emissive_polygons(DVec3::ZERO, 6).unwrap();
    let centre = Vec3::splat(0.5);
    assert_eq!(polygons.len(), 6);
    assert!(
        furnace.meshes[0]
            .normals
            .iter()
            .zip(&furnace.meshes[0].positions)
            .all(|(n, p)| n.dot(centre - p) > 0.0)
    );

    let lights = load("lights.ron");
    let kinds: Vec<_> = lights.lights.iter().map(|l| std::mem::discriminant(&l.kind)).collect();
    assert_eq!(kinds.len(), 3);
    assert!(kinds[0] != kinds[1] && kinds[1] != kinds[2] && kinds[0] != kinds[2]);
    assert_eq!(lights.instances.iter().filter(|i| i.moving).count(), 1);

    let columns = load("sunlit_columns.ron");
    assert!(
        matches!(columns.lights[0].kind, LightKind::Directional { angular_diameter, .. } if angular_diameter > 0.009)
    );
    assert!(columns.sky.min_element() > 0.0);
    assert_eq!(columns.cameras.len(), 2);
}

#[test]
fn samples_load_with_their_triangles() {
    let counts = [
        ("sponza.glb", 262_267, 69, 3),
        ("sponza_lite.glb", 262_267, 25, 3),
        ("sibenik.glb", 75_274, 2, 1),
        ("bunny.glb", 69_451, 0, 1),
        ("dragon.glb", 202_520, 0, 1),
        ("cornell.glb", 46, 0, 1),
        ("cornell_grey_light.glb", 46, 0, 1),
    ];
    for (name, expected, textures, cameras) in counts {
        let start = std::time::Instant::now();
        let Some(scene) = sample(name) else { continue };
        println!("{name}: {:?}, {} textures", start.elapsed(), scene.textures.len());
        assert_eq!((triangles(&scene), scene.cameras.len()), (expected, cameras), "{name}");
        assert_eq!(scene.textures.len(), textures, "{name}");
        check(&scene);
    }
}

/// What [`Scene`] and [`Geometry`] promise.
fn check(scene: &Scene) {
    let (low, high) = scene.bounds().unwrap();
    let origin = low.midpoint(high);
    let start = std::time::Instant::now();
    let geometry = Geometry::new(scene, origin);
    println!("    flattened in {:?}, bounds {low} {high}", start.elapsed());
    let count = geometry.positions.len();
    assert!(
        [geometry.normals.len(), geometry.tangents.len(), geometry.uvs.len(), geometry.materials.len()]
            == [count; 4]
    );
    assert!(geometry.positions.iter().all(|p| p.is_finite()) && geometry.uvs.iter().all(|uv| uv.is_finite()));
    assert!(geometry.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-5));
    assert!(geometry.tangents.iter().all(|t| (t.truncate().length() - 1.0).abs() < 1e-5 && t.w.abs() == 1.0));
    assert!(geometry.triangles.iter().flatten().all(|i| (*i as usize) < count));
    assert!(geometry.materials.iter().all(|m| (*m as usize) < scene.materials.len()));
    let (least, most) = geometry
        .triangles
        .iter()
        .flatten()
        .map(|i| geometry.positions[*i as usize].as_dvec3() + origin)
        .fold((high, low), |(l, h), p| (l.min(p), h.max(p)));
    let tolerance = (high - low).length() * 1e-6;
    assert!(least.abs_diff_eq(low, tolerance) && most.abs_diff_eq(high, tolerance));
    for texture in &scene.textures {
        assert_eq!(texture.rgba.len(), texture.width as usize * texture.height as usize * 4);
    }
    // A lone model is lit by a sky, and nothing else is.
    assert_eq!(
        scene.sky == Vec3::ONE,
        scene.lights.is_empty() && scene.materials.iter().all(|m| m.emission == Vec3::ZERO)
    );
}
