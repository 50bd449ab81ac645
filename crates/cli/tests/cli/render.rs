//! `voxlume render`, on whatever device there is.

use serde_json::Value;

use crate::folder::Folder;

/// The keys of an object, sorted.
fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

#[test]
fn cornell_as_png_exr_and_json() {
    let folder = Folder::new();
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.ron");
    folder.file("out.png", "to be replaced");
    let ran = folder.run(&format!(
        "render {scene} --resolution 32 --size 64x48 --repeat 2 -o out.png -o out.exr --json out.json"
    ));
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let files: Vec<String> = folder.contents().into_keys().collect();
    assert_eq!(files, ["box.ron", "out.exr", "out.json", "out.png", "pipe.ron", "tint.wgsl"]);

    let png = image::open(folder.path().join("out.png")).unwrap().into_rgb8();
    assert_eq!(png.dimensions(), (64, 48));

    let exr = exr::prelude::read_first_rgba_layer_from_file(
        folder.path().join("out.exr"),
        |size, _| vec![[0.0f32; 4]; size.area()],
        |pixels, at, (r, g, b, a): (f32, f32, f32, f32)| pixels[at.y() * 64 + at.x()] = [r, g, b, a],
    );
    let pixels = exr.unwrap().layer_data.channel_data.pixels;
    assert_eq!(pixels.len(), 64 * 48);
    assert!(pixels.iter().flatten().all(|value| value.is_finite() && *value >= 0.0));
    // Red to the left, green to the right, and a light brighter than a PNG holds.
    let mean = |x: std::ops::Range<usize>, channel: usize| {
        let count = (x.len() * 48) as f32;
        x.flat_map(|x| (0..48).map(move |y| y * 64 + x)).map(|at| pixels[at][channel]).sum::<f32>() / count
    };
    assert!(mean(9..16, 0) > 1.3 * mean(9..16, 1), "{} {}", mean(9..16, 0), mean(9..16, 1));
    assert!(mean(48..55, 1) > 1.3 * mean(48..55, 0), "{} {}", mean(48..55, 1), mean(48..55, 0));
    assert!(pixels.iter().any(|pixel| pixel[0] > 5.0));
}

#[test]
fn json_has_its_schema() {
    let folder = Folder::new();
    let ran = folder.run(
        "render box.ron --camera side --pipeline pipe.ron --size 16x16 --repeat 3 -o tint.exr --json t.json",
    );
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let text = std::fs::read_to_string(folder.path().join("t.json")).unwrap();
    let json: Value = serde_json::from_str(&text).unwrap();
    let top = [
        "device",
        "encoding",
        "format",
        "occupied_voxels",
        "passes",
        "resolution",
        "resources",
        "scene",
        "schema",
        "total_ms",
    ];
    assert_eq!(keys(&json), top);
    assert_eq!(keys(&json["device"]), ["driver", "name", "type"]);
    assert_eq!((&json["schema"], &json["scene"]), (&1.into(), &"box".into()));
    assert_eq!(
        (&json["format"], &json["encoding"], &json["resolution"]),
        (&"isotropic".into(), &"rgba16float".into(), &32.into())
    );
    let passes = json["passes"].as_array().unwrap();
    let names: Vec<_> = passes.iter().map(|pass| pass["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["gbuffer", "tint"]);
    for pass in passes {
        assert_eq!(keys(pass), ["clock", "median_ms", "name", "spread_ms"]);
        assert!(pass["median_ms"].as_f64().unwrap() > 0.0 && pass["spread_ms"].as_f64().unwrap() >= 0.0);
        assert!(["gpu", "wall"].contains(&pass["clock"].as_str().unwrap()));
    }
    let sum: f64 = passes.iter().map(|pass| pass["median_ms"].as_f64().unwrap()).sum();
    assert!(json["total_ms"].as_f64().unwrap() > sum / 2.0);
    let resources = json["resources"].as_array().unwrap();
    let tint = resources.iter().find(|resource| resource["name"] == "tint").unwrap();
    assert_eq!((keys(tint), &tint["bytes"]), (vec!["bytes", "name"], &2048.into()));

    // The table says the same, and by which clock.
    let row = ran.stdout.lines().any(|line| line.split_whitespace().eq(["tint", "2048"]));
    assert!(row, "{}", ran.stdout);
    assert!(
        ran.stdout.contains("times of 3 frames (spread: interquartile range) after one of warm-up, by the ")
    );
}

#[test]
fn unknown_adapter() {
    let ran = Folder::new().run("render box.ron --pipeline pipe.ron --adapter no-such-thing -o out.png");
    assert_eq!(ran.code, Some(2));
    assert!(
        ran.stderr.contains("error: no graphics device is called `no-such-thing`; there is: "),
        "{}",
        ran.stderr
    );
}

#[test]
fn what_the_encoding_clamps_is_told() {
    let folder = Folder::new();
    let told = |encoding: &str| {
        let cornell = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.ron");
        let ran = folder.run(&format!(
            "render {cornell} --tracer cones --encoding {encoding} --resolution 16 --size 16x16 -o a.png --json t.json"
        ));
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        let text = std::fs::read_to_string(folder.path().join("t.json")).unwrap();
        let json: Value = serde_json::from_str(&text).unwrap();
        (ran.stdout.contains("were clamped"), json["out_of_range"]["texels"].as_u64())
    };
    let (note, texels) = told("rgba8:range=0.01");
    assert!(note && texels.unwrap() > 0);
    assert_eq!(told("rgba16float"), (false, None));
}
