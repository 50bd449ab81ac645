//! Effects gathered at a lower resolution and brought up: the image has the screen's size, what is even stays even, surfaces
//! keep apart, and finer normals count.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{Picture, Pipeline, Request, Scene, Source, Value};
use voxlume_tests::{built_in, gi, mean, picture, render, root, scene_from};

/// An odd number of pixels either way.
const SIZE: [u32; 2] = [67, 41];

/// A ball over a floor.
const BALL: &str = r#"(
    materials: { "white": (base_color: 0.8) },
    objects: [
        (name: "floor", material: "white", shape: Box(min: (-2, -1.2, -2), max: (2, -1, 2))),
        (name: "ball", material: "white", shape: Sphere(radius: 1)),
    ],
    cameras: [(name: "front", eye: (0, 1, 4), target: (0, -0.2, 0), fov_deg: 40)],
)"#;

/// An effect that gives 1 everywhere.
const EVEN: &str = "
import package::common::surface::Surface;

struct Params {
    /// [0, 1]; 1 unless given.
    strength: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    return vec4f(1.0);
}
";

/// An effect that shows normals.
const NORMAL: &str = "
import package::common::surface::Surface;

struct Params {
    /// [0, 1]; 1 unless given.
    strength: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    return vec4f(0.5 * surface.normal + 0.5, 1.0);
}
";

/// Irradiance of a single direction, with the vector that says from where it comes, or without.
const LIT: &str = "
import package::common::leaning::leaning;
import package::common::surface::Surface;

struct Params {
    /// [0, 1]; 1 unless given.
    strength: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let light = normalize(vec3f(0.5, 0.8, 1.0));
    leaning = vec4f(light, 0.0);
    return vec4f(vec3f(max(dot(surface.normal, light), 0.0)), 1.0);
}
";

fn shown(scene: &Scene, wgsl: &str, words: &str) -> Picture {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
    let first = "passes: [";
    assert!(text.contains(first));
    let entry = format!("passes: [(run: \"own.wgsl\", reads: [\"surface\"], writes: [\"own\"], {words}),");
    std::fs::write(folder.path().join("own.wgsl"), wgsl).unwrap();
    std::fs::write(folder.path().join("own.ron"), text.replacen(first, &entry, 1)).unwrap();
    let pipeline = Pipeline::load(&folder.path().join("own.ron")).unwrap_or_else(|faults| panic!("{faults}"));
    let request =
        Request { output: Some("own".into()), resolution: Some(32), ..Request::image(SIZE[0], SIZE[1]) };
    picture(&render(&pipeline, scene, &request), "own")
}

fn ball() -> Scene {
    Scene::parse(&Source::new("ball.ron", BALL)).unwrap_or_else(|faults| panic!("{faults}"))
}

/// The share of pixels, of those that show a surface, whose first channels are farther apart than `most`; and the mean distance.
fn apart(a: &Picture, b: &Picture, most: f32) -> (f64, f64) {
    let distances: Vec<f32> = a
        .pixels
        .iter()
        .zip(&b.pixels)
        .filter(|(a, _)| a[3] > 0.0)
        .map(|(a, b)| (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f32::max))
        .collect();
    let count = distances.len() as f64;
    let far = distances.iter().filter(|distance| **distance > most).count() as f64;
    (far / count, distances.iter().map(|distance| f64::from(*distance)).sum::<f64>() / count)
}

#[test]
fn what_is_even_stays_even_at_every_scale() {
    for scene in [ball(), built_in("cornell.ron")] {
        let whole = shown(&scene, EVEN, "");
        for words in
            ["scale: 2", "scale: 4", "scale: 8", "scale: 2, interleave: 4", "scale: 4, interleave: 8"]
        {
            let image = shown(&scene, EVEN, words);
            assert_eq!([image.width, image.height], SIZE, "{words}");
            // The same pixels show a surface, and each has all of the value.
            assert!(image.pixels == whole.pixels, "{words}");
        }
    }
}

/// But for faces of fewer pixels than a texel has, such as the tops of the boxes here, which no texel shows.
#[test]
fn surfaces_keep_apart() {
    let scene = built_in("cornell.ron");
    let whole = shown(&scene, NORMAL, "");
    for (words, most) in [("scale: 2", 0.01), ("scale: 4", 0.045), ("scale: 4, interleave: 4", 0.045)] {
        let (share, _) = apart(&whole, &shown(&scene, NORMAL, words), 0.1);
        println!("{words}: {share}");
        assert!(share <= most, "{words}: {share} of the pixels have another surface's value");
    }
}

#[test]
fn finer_normals_count() {
    let scene = ball();
    let whole = shown(&scene, LIT, "");
    let silent = LIT
        .replace("    leaning = vec4f(light, 0.0);\n", "")
        .replace("import package::common::leaning::leaning;\n", "");
    for (scale, most) in [(2, 0.01), (4, 0.02)] {
        let words = format!("scale: {scale}");
        let [with, without] = [LIT, &silent].map(|wgsl| apart(&whole, &shown(&scene, wgsl, &words), 1.0).1);
        println!("{words}: {with}, without {without}");
        assert!(with < 0.6 * without && with < most, "{words}: {with}, without {without}");
    }
}

/// A dark ball, which gets all of its light from a lamp of many polygons and hardly any from voxels, is as bright at half the size.
#[test]
fn light_of_lamps_is_kept() {
    let scene = scene_from(
        r#"(
            materials: { "dark": (base_color: 0, metallic: 1), "lamp": (base_color: 0, metallic: 1, emission: 20) },
            objects: [
                (name: "ball", material: "dark", shape: Sphere(radius: 1)),
                (name: "tube", material: "lamp", shape: Cylinder(radius: 0.2, height: 3, segments: 64), translate: (2, 0, 1.5)),
            ],
            cameras: [(name: "front", eye: (0, 0.5, 4), target: (0, 0, 0), fov_deg: 30)],
        )"#,
    );
    let shown = |scale: u32| {
        let set = vec![("diffuse".into(), "lamps".into(), Value::Number(16.0))];
        let output = Some("diffuse".into());
        let request = Request {
            output,
            resolution: Some(32),
            scale: Some(scale),
            set,
            ..Request::image(SIZE[0], SIZE[1])
        };
        picture(&render(&gi(), &scene, &request), "diffuse")
    };
    let share = mean(&shown(2))[0] / mean(&shown(1))[0];
    assert!((share - 1.0).abs() < 0.02, "{share}");
}
