//! Which reflectance a voxel gets where triangles of two colours lie on each other.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use glam::DVec3;
use voxlume::scene::Material;
use voxlume::twin::total_reflectance;
use voxlume::{Request, Scene, Value};
use voxlume_tests::{Substrate, gi, render, scene_of, span, triangle};

/// Reflectance of pure red, rough as materials are: of red, and of the rest.
fn red() -> [f64; 2] {
    let of_red = total_reflectance(DVec3::X, 0.0, 1.0);
    [of_red.x, of_red.y]
}

/// A red and a green triangle in one place.
fn scene() -> Scene {
    let side = 29.0;
    let mut scene = scene_of(vec![span(side as f32)], side);
    for (name, color) in [("red", [1.0, 0.0, 0.0, 1.0]), ("green", [0.0, 1.0, 0.0, 1.0])] {
        let mut mesh = triangle([5.0, 15.0, 5.0], [25.0, 15.0, 5.0], [5.0, 15.0, 25.0]);
        mesh.material = scene.materials.len();
        scene.materials.push(Material { name: name.into(), base_color: color.into(), ..Material::default() });
        voxlume_tests::add(&mut scene, mesh);
    }
    scene
}

/// Attributes of the voxels in which both triangles lie alone.
fn voxels(conflict: Option<&str>) -> Vec<Vec<u32>> {
    let set = conflict.map(|word| ("voxelize".into(), "conflict".into(), Value::Word(word.into())));
    let request = Request {
        resolution: Some(32),
        output: Some("diffuse".into()),
        set: set.into_iter().collect(),
        ..Request::image(8, 8)
    };
    let substrate = Substrate::read(&render(&gi(), &scene(), &request));
    // Their normals are ±y; those of the span's triangles are not.
    let both = |words: &&[u32]| words[5] == 0 && words[7] == 0 && words[8] == 0 && words[10] == 0;
    let list: Vec<Vec<u32>> = substrate.voxels().filter(both).map(<[u32]>::to_vec).collect();
    assert!(list.len() > 100, "{}", list.len());
    list
}

fn bytes(word: u32) -> [u32; 4] {
    [24, 16, 8, 0].map(|shift| word >> shift & 255)
}

#[test]
fn sums_give_the_mean() {
    assert_eq!(voxels(None), voxels(Some("sum")));
    for words in voxels(None) {
        let mean = [2, 3, 4].map(|i| f64::from(words[i]) / f64::from(words[0]));
        let [own, rest] = red();
        // Of sums of units of 2⁻²⁰ and more, and of polynomials in `f32`.
        for (got, expected) in mean.iter().zip([(own + rest) / 2.0, (own + rest) / 2.0, rest]) {
            assert!((got - expected).abs() < 1e-4, "{mean:?}");
        }
    }
}

#[test]
fn the_maximum_takes_the_redder_one_whole() {
    for words in voxels(Some("max")) {
        let [alpha, color @ ..] = bytes(words[2]);
        // Bytes cut it off.
        let [own, rest] = red().map(|share| (share * 255.0) as u32);
        assert_eq!((alpha, color, words[3], words[4]), (255, [own, rest, rest], 0, 0));
    }
}

#[test]
fn the_running_average_counts_and_cuts_off() {
    for words in voxels(Some("running_average")) {
        let [count, color @ ..] = bytes(words[2]);
        assert_eq!((count, words[3], words[4]), (2, 0, 0));
        let [own, rest] = red().map(|share| share * 255.0);
        // Cut off once or twice.
        for (got, expected) in color.iter().zip([(own + rest) / 2.0, (own + rest) / 2.0, rest]) {
            assert!(f64::from(*got) <= expected && f64::from(*got) > expected - 2.0, "{color:?}");
        }
    }
}
