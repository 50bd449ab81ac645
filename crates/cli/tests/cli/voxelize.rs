//! `voxlume voxelize`, on whatever device there is.

use serde_json::Value;

use crate::folder::{Folder, SCENE};

fn report(folder: &Folder, words: &str) -> Value {
    let ran = folder.run(&format!("voxelize box.ron --resolution 32 --json v.json {words}"));
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    serde_json::from_str(&std::fs::read_to_string(folder.path().join("v.json")).unwrap()).unwrap()
}

#[test]
fn counts_and_hashes() {
    let folder = Folder::new();
    let conservative = report(&folder, "--repeat 2");
    let mut keys: Vec<&str> = conservative.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    let expected = [
        "attribute_hash",
        "bytes",
        "cells",
        "clock",
        "device",
        "grid",
        "median_ms",
        "method",
        "occupancy_hash",
        "occupied",
        "resources",
        "runs",
        "scene",
        "schema",
        "separability",
        "spread_ms",
        "triangles",
        "two_sided",
        "voxel_size",
    ];
    assert_eq!(keys, expected);
    // The square spans 29 voxels from the middle of one to the middle of another.
    assert_eq!(conservative["occupied"], 30 * 30);
    assert_eq!(conservative["grid"], serde_json::json!([32, 32, 32]));
    assert_eq!((&conservative["runs"], &conservative["triangles"]), (&2.into(), &2.into()));
    let bytes = conservative["resources"].as_array().unwrap().iter().map(|r| r["bytes"].as_u64().unwrap());
    assert_eq!(conservative["bytes"].as_u64(), Some(bytes.sum()));

    folder.edit("box.ron", SCENE, "name: \"square\"", "name: \"square\", rotate_deg: (20, 30, 0)");
    let conservative = report(&folder, "");
    let again = report(&folder, "");
    let thin = report(&folder, "--separability thin");
    assert!(thin["occupied"].as_u64() < conservative["occupied"].as_u64());
    for hash in ["occupancy_hash", "attribute_hash"] {
        assert_eq!(conservative[hash].as_str().unwrap().len(), 64);
        assert_eq!(conservative[hash], again[hash]);
        assert_ne!(conservative[hash], thin[hash]);
    }
    assert_eq!((&thin["separability"], &thin["method"]), (&"thin".into(), &"balanced".into()));
    for method in ["triangle", "fragment", "hybrid"] {
        let other = report(&folder, &format!("--separability thin --method {method}"));
        assert_eq!(other["method"], method);
        assert_eq!(other["occupancy_hash"], thin["occupancy_hash"], "{method}");
        assert_eq!(other["attribute_hash"], thin["attribute_hash"], "{method}");
    }
}

#[test]
fn a_picture_points_and_a_model() {
    let folder = Folder::new();
    let words = "--channel normal --level 1 --size 24x16 -o v.png -o v.exr -o v.ply -o v.vox";
    report(&folder, words);
    let image = image::open(folder.path().join("v.png")).unwrap().into_rgb8();
    assert_eq!(image.dimensions(), (24, 16));
    // The square's front in the middle; nothing at the border.
    assert_eq!(image.get_pixel(12, 8).0, [128, 128, 255]);
    assert_eq!(image.get_pixel(0, 0).0, [128, 128, 128]);

    let bytes = std::fs::read(folder.path().join("v.ply")).unwrap();
    let end = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let head = std::str::from_utf8(&bytes[..end]).unwrap();
    // 30 voxels from 1 on are cells 0 to 15 of level 1; layer 16 is cell 8.
    assert!(head.contains("element vertex 256\n"), "{head}");
    assert_eq!(bytes.len() - end, 256 * (3 * 8 + 3 * 4 + 3));
    let number = |at: usize| f64::from_le_bytes(bytes[end + at..end + at + 8].try_into().unwrap());
    let size = 2.0 * 2.0 / 29.0;
    assert!((number(0) - -7.5 * size).abs() < 1e-6 && (number(16) - 0.5 * size).abs() < 1e-6);
    assert_eq!(&bytes[end + 36..end + 39], [128, 128, 255]);

    let model = dot_vox::load(folder.path().join("v.vox").to_str().unwrap()).unwrap();
    assert_eq!((model.models.len(), model.models[0].voxels.len()), (1, 256));
    assert_eq!(model.models[0].size.x, 16);
}

#[test]
fn light_shows_in_the_volumes_channels() {
    let folder = Folder::new();
    folder.edit("box.ron", SCENE, "cameras:", "lights: [Point(position: (0, 0, 3), intensity: 9)], cameras:");
    let mean = |words: &str| {
        report(&folder, &format!("--size 16x16 -o v.png {words}"));
        let image = image::open(folder.path().join("v.png")).unwrap().into_rgb8();
        f64::from(image.get_pixel(8, 8).0[0])
    };
    assert!(mean("--channel lit") > 50.0);
    // The square's front faces +z; from behind it is dark in a format that knows directions.
    assert!(mean("--channel radiance --direction +z --format six_face") > 50.0);
    assert!(mean("--channel radiance --direction -z --format six_face") < 10.0);
    assert_eq!(mean("--channel opacity --direction +z"), 255.0);
    // What has two sides shows what arrives at either, on both.
    let scene = std::fs::read_to_string(folder.path().join("box.ron")).unwrap();
    folder.edit("box.ron", &scene, "base_color: 0.5", "base_color: 0.5, double_sided: true");
    for format in ["isotropic", "six_face", "sh2"] {
        assert!(mean(&format!("--channel radiance --direction -z --format {format}")) > 50.0, "{format}");
    }
}

#[test]
fn an_unknown_extension() {
    Folder::new().refuses(
        "voxelize box.ron -o out.obj",
        "error: `out.obj` is no file of voxels by its extension
 = one of: png, exr, ply, vox",
    );
}

#[test]
fn a_level_that_is_not_there() {
    Folder::new().refuses(
        "voxelize box.ron --resolution 32 --level 7 -o out.png",
        "loading box.ron
planning
error: parameter `level` of pass `voxel_view` can't be 7
 = this grid's levels are 0 to 5",
    );
}

#[test]
fn an_unknown_separability() {
    Folder::new().refuses(
        "voxelize box.ron --separability fat",
        "loading box.ron
planning
error: unknown separability `fat`
 = one of: conservative, thin",
    );
}

#[test]
fn a_pipeline_without_a_view_of_the_voxels() {
    Folder::new().refuses(
        "voxelize box.ron --pipeline pipe.ron",
        "loading box.ron
planning
error: unknown output `voxel_view`
 = one of: tint, albedo, normal, geometry, depth, emission",
    );
}

#[test]
fn an_unknown_channel() {
    Folder::new().refuses(
        "voxelize box.ron --channel colour",
        "error: invalid value 'colour' for '--channel <CHANNEL>'
  [possible values: albedo, normal, occupancy, emission, opacity, radiance, lit]

For more information, try '--help'.",
    );
}
