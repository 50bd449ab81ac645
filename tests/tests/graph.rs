//! What a graph can say: images of other sizes and texels, effects between effects, two volumes, two grids, last values.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::path::Path;

use voxlume::{Passes, Picture, Pipeline, Request, Value};
use voxlume_tests::{built_in, picture, render, root};

const SIZE: [u32; 2] = [37, 21];

fn request(output: &str) -> Request {
    // Cones, by which formats and grids differ the most.
    let (output, tracer) = (Some(output.into()), Some("cones".into()));
    Request { output, tracer, resolution: Some(32), ..Request::image(SIZE[0], SIZE[1]) }
}

/// `pipelines/gi.ron` in a folder with WGSL files, with each first text, which must be there, replaced by the second.
fn changed(folder: &Path, changes: &[(&str, &str)], files: &[(&str, &str)]) -> Pipeline {
    let mut text = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    for (name, text) in files {
        std::fs::write(folder.join(name), text).unwrap();
    }
    std::fs::write(folder.join("changed.ron"), text).unwrap();
    Pipeline::load(&folder.join("changed.ron")).unwrap_or_else(|faults| panic!("{faults}"))
}

/// The picture of an image of `pipelines/gi.ron`, changed.
fn shown(scene: &str, changes: &[(&str, &str)], files: &[(&str, &str)], request: &Request) -> Picture {
    let folder = tempfile::tempdir().unwrap();
    let pipeline = changed(folder.path(), changes, files);
    let output = request.output.clone().unwrap();
    picture(&render(&pipeline, &built_in(scene), request), &output)
}

/// An effect that says where its texel is.
const PLACE: &str = "import package::common::surface::Surface;

struct Params {
    /// [0, 100]
    scale: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    return params.scale * vec4f(vec2f(surface.pixel), vec2f(surface.image_size));
}
";

const FIRST: &str = "passes: [";

#[test]
fn an_effect_knows_its_texel_and_its_image_has_a_size_and_texels_of_its_own() {
    for (words, size, texel) in [
        ("", SIZE, "rgba16float"),
        ("size: \"1/2\",", [19, 11], "rgba16float"),
        ("size: \"1/5\", texel: \"rgba32float\",", [8, 5], "rgba32float"),
        ("size: (9, 4), texel: \"rg32float\",", [9, 4], "rg32float"),
        ("texel: \"r32float\",", SIZE, "r32float"),
        ("size: \"1/3\", texel: \"r32uint\",", [13, 7], "r32uint"),
        ("size: (3, 2), texel: \"rgba8unorm\",", [3, 2], "rgba8unorm"),
    ] {
        let scale = if texel == "rgba8unorm" { 0.125 } else { 1.0 };
        let entry = format!(
            "passes: [(run: \"place.wgsl\", reads: [\"surface\"], writes: [\"place\"], {words} params: (scale: {scale})),"
        );
        let image = shown("cornell.ron", &[(FIRST, &entry)], &[("place.wgsl", PLACE)], &request("place"));
        assert_eq!([image.width, image.height], size, "{words}");
        let [width, height] = size;
        let channels = match texel {
            "r32float" | "r32uint" => 1,
            "rg32float" => 2,
            _ => 4,
        };
        for y in 0..height {
            for x in 0..width {
                let expected = [x, y, width, height].map(|n| n as f32 * scale as f32);
                let got = image.pixels[(y * width + x) as usize];
                // Where the camera sees nothing an effect is not run.
                if got.iter().take(channels).all(|value| *value == 0.0) {
                    continue;
                }
                for channel in 0..channels {
                    let error = (got[channel] - expected[channel]).abs();
                    assert!(error <= scale as f32 / 30.0, "{words} ({x}, {y}): {got:?}, {expected:?}");
                }
            }
        }
    }
}

/// The mean of an image around each of its texels.
const SOFT: &str = include_str!("../../book/src/write-an-effect/soft.wgsl");

/// Diffuse light made softer twice, by the same file under two names.
fn softened(first: u32, second: u32) -> Picture {
    let entries = format!(
        "(run: \"soft.wgsl\", name: \"once\", reads: [\"surface\", \"diffuse as source\"], writes: [\"soft\"], params: (radius: {first})),
        (run: \"soft.wgsl\", name: \"twice\", reads: [\"surface\", \"soft as source\"], writes: [\"softer\"], params: (radius: {second})),
        (
            run: \"composite\",
            reads: [\"surface\", \"shadow\", \"ao\", \"softer as diffuse\", \"specular\"],"
    );
    let composite = "(\n            run: \"composite\",\n            reads: [\"surface\", \"shadow\", \"ao\", \"diffuse\", \"specular\"],";
    shown("cornell.ron", &[(composite, &entries)], &[("soft.wgsl", SOFT)], &request("final"))
}

#[test]
fn an_effect_stands_between_another_and_the_composite() {
    let plain = shown("cornell.ron", &[], &[], &request("final"));
    assert_eq!(softened(0, 0), plain);
    let (once, twice) = (softened(2, 0), softened(0, 2));
    assert_ne!(once, plain);
    // Where pixels have a surface all around, the order does not matter; where not, what is outside is 0 in both.
    assert_eq!(once, twice);
    assert_ne!(softened(1, 2), once);
}

#[test]
fn two_volumes_in_two_formats_are_what_each_is_alone() {
    let filter = "(run: \"filter\", reads: [\"voxels\", \"radiance\"], writes: [\"volume\"]),";
    let second = "(run: \"filter\", name: \"other\", reads: [\"voxels\", \"radiance\"], writes: [\"others\"], params: (format: \"six_face\")),";
    let both = format!("{filter} {second}");
    let ao = "reads: [\"surface\", \"volume\"],\n            writes: [\"ao\"]";
    let changes =
        [(filter, both.as_str()), (ao, "reads: [\"surface\", \"others\"],\n            writes: [\"ao\"]")];
    let alone = |format: &str, output: &str| {
        shown("cornell.ron", &[], &[], &Request { format: Some(format.into()), ..request(output) })
    };
    let weight = ("composite".into(), "ao_weight".into(), Value::Number(0.5));
    for (output, format) in [("ao", "six_face"), ("diffuse", "isotropic")] {
        let set = vec![weight.clone()];
        let together = shown("cornell.ron", &changes, &[], &Request { set, ..request(output) });
        assert_eq!(together, alone(format, output), "{output}");
    }
    assert_ne!(alone("isotropic", "ao"), alone("six_face", "ao"));
}

#[test]
fn a_second_grid_is_what_it_is_alone() {
    let first = "(run: \"voxelize\", writes: [\"voxels\"]),";
    let second = "(run: \"voxelize\", writes: [\"voxels\"]),
        (run: \"voxelize\", name: \"fine\", writes: [\"fine\"], params: (resolution: 64)),
        (run: \"light\", name: \"fine_light\", reads: [\"fine\", \"shadow_maps\"], writes: [\"fine_radiance\"],
         params: (occlusion: \"shadow_map\", emission: \"area_lights\", bias: 1.5, parts: 2)),
        (run: \"filter\", name: \"fine_filter\", reads: [\"fine\", \"fine_radiance\"], writes: [\"fine_volume\"]),";
    let diffuse = "reads: [\"surface\", \"volume\"],\n            writes: [\"diffuse\"]";
    let from_fine = "reads: [\"surface\", \"fine_volume\"],\n            writes: [\"diffuse\"]";
    let together = shown("cornell.ron", &[(first, second), (diffuse, from_fine)], &[], &request("diffuse"));
    let alone = |resolution| {
        shown("cornell.ron", &[], &[], &Request { resolution: Some(resolution), ..request("diffuse") })
    };
    let difference = |a: &Picture, b: &Picture| {
        let pairs = a.pixels.iter().flatten().zip(b.pixels.iter().flatten());
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
    };
    // The camera's near plane follows the first grid: depths differ in their last bits.
    assert!(difference(&together, &alone(64)) < 0.02, "{}", difference(&together, &alone(64)));
    assert!(difference(&together, &alone(32)) > 0.1);
}

#[test]
fn a_grid_of_a_part_sees_that_part() {
    let first = "(run: \"voxelize\", writes: [\"voxels\"]),";
    let part = "(run: \"voxelize\", writes: [\"voxels\"], params: (resolution: 32, min: (-1, -1, -1), max: (1, 1, 1))),";
    let scene = built_in("cornell.ron");
    let folder = tempfile::tempdir().unwrap();
    let voxels = |changes: &[(&str, &str)]| {
        let renderer = render(&changed(folder.path(), changes, &[]), &scene, &request("final"));
        renderer.counts().0
    };
    let (whole, part) = (voxels(&[]), voxels(&[(first, part)]));
    assert!(part > 0 && part != whole, "{part} of {whole}");
}

/// The mean over all frames so far: the value of the last frame goes on.
const MEAN: &str = "import package::common::clock::clock;
import package::common::surface::Surface;

struct Params {
    /// What each frame adds, [0, 10].
    each: f32,
}

var sum_last: texture_2d_array<f32>;

fn effect(surface: Surface, params: Params) -> vec4f {
    return textureLoad(sum_last, surface.pixel, 0, 0) + vec4f(params.each, f32(clock.frame), 0.0, 0.0);
}
";

#[test]
fn a_pass_goes_on_from_its_value_of_the_last_frame() {
    let entry = "passes: [(run: \"sum.wgsl\", reads: [\"surface\", \"sum.last\"], writes: [\"sum\"], texel: \"rgba32float\", params: (each: 2.0)),";
    let folder = tempfile::tempdir().unwrap();
    let pipeline = changed(folder.path(), &[(FIRST, entry)], &[("sum.wgsl", MEAN)]);
    let scene = built_in("cornell.ron");
    let mut renderer = render(&pipeline, &scene, &request("sum"));
    for frames in 1..5_u32 {
        let image = picture(&renderer, "sum");
        let most = image.pixels.iter().fold([0.0, 0.0], |most, p| [p[0].max(most[0]), p[1].max(most[1])]);
        // Frames count from 0.
        assert_eq!(most, [2.0 * frames as f32, (frames * (frames - 1) / 2) as f32]);
        renderer.render(&scene, &scene.cameras[0], Passes::Changed).unwrap();
    }
}
