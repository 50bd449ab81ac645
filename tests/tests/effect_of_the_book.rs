//! The book's effect, its files as they stand, from a folder outside the repository.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use glam::{Vec3, vec3};
use voxlume::{Formats, Pipeline, Registry, Request, Scene, SceneFacts};
use voxlume_tests::{picture, render, root, scene_of, triangles};

fn pipeline() -> (tempfile::TempDir, Pipeline) {
    let folder = tempfile::tempdir().unwrap();
    for file in ["bent_normal.wgsl", "bent_normal.ron"] {
        std::fs::copy(root().join("book/src/write-an-effect").join(file), folder.path().join(file)).unwrap();
    }
    let pipeline = Pipeline::load(&folder.path().join("bent_normal.ron")).unwrap();
    (folder, pipeline)
}

/// A floor of 10 × 10 that looks up, and perhaps a wall at x = 0 that looks along x.
fn scene(wall: bool) -> Scene {
    let (a, b, c, d) = (Vec3::ZERO, vec3(0.0, 0.0, 10.0), vec3(10.0, 0.0, 10.0), vec3(10.0, 0.0, 0.0));
    let (e, f) = (vec3(0.0, 10.0, 0.0), vec3(0.0, 10.0, 10.0));
    let mut list = vec![[a, b, c], [a, c, d]];
    if wall {
        list.extend([[a, e, f], [a, f, b]]);
    }
    scene_of(vec![triangles(&list)], 10.0)
}

/// Bent normals and openness of the floor's pixels.
fn floor(pipeline: &Pipeline, scene: &Scene, format: &str) -> Vec<(Vec3, f32)> {
    let request = Request { format: Some(format.into()), resolution: Some(32), ..Request::image(48, 48) };
    let renderer = render(pipeline, scene, &request);
    let (bent, normal) = (picture(&renderer, "bent_normal"), picture(&renderer, "normal"));
    assert!(bent.pixels.iter().flatten().all(|value| value.is_finite()), "{format}");
    let pixels = bent.pixels.iter().zip(&normal.pixels).filter(|(_, normal)| normal[1] > 0.9);
    pixels.map(|(b, _)| (vec3(b[0], b[1], b[2]), b[3])).collect()
}

#[test]
fn a_bent_normal_is_the_normal_in_the_open_and_leans_away_from_a_wall() {
    let (_folder, pipeline) = pipeline();
    for format in Formats::builtin().iter().map(|format| format.name()) {
        let open = floor(&pipeline, &scene(false), format);
        assert!(open.len() > 100, "{format}: {} pixels of floor", open.len());
        for (bent, openness) in &open {
            // Stored in half floats; six cones' weighted directions sum to the axis within 1e-6.
            assert!(bent.distance(Vec3::Y) < 4e-3 && *openness > 0.99, "{format}: {bent}, {openness}");
        }
        let beside = floor(&pipeline, &scene(true), format);
        let leaning = beside.iter().filter(|(bent, _)| bent.x > 0.05).count();
        let closed = beside.iter().filter(|(_, openness)| *openness < 0.95).count();
        println!("{format}: {leaning} of {} pixels lean away, {closed} are less open", beside.len());
        // The wall is a quarter of the grid away at most for a quarter of the floor.
        assert!(leaning * 10 > beside.len() && closed * 10 > beside.len(), "{format}: {leaning}, {closed}");
        assert!(beside.iter().all(|(bent, _)| bent.x > -0.01), "{format}: one leans into the wall");
    }
}

/// The page's message is the one that its reader sees.
#[test]
fn the_page_shows_the_fault_as_it_is() {
    let (folder, _) = pipeline();
    let file = folder.path().join("bent_normal.ron");
    let text = std::fs::read_to_string(&file).unwrap().replace("distance: 0.25", "distance: 3.0");
    std::fs::write(&file, text).unwrap();
    let facts = SceneFacts::of(&scene(false)).unwrap();
    let (pipeline, request) = (Pipeline::load(&file).unwrap(), Request::image(8, 8));
    let faults = voxlume::plan(&pipeline, &facts, &Registry::builtin(), &request);
    let told = faults.unwrap_err().to_string().replace(folder.path().to_str().unwrap(), "write-an-effect");
    let page = std::fs::read_to_string(root().join("book/src/write-an-effect/fault.txt")).unwrap();
    assert_eq!(told.trim(), page.trim());
}
