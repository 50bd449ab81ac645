//! `voxlume compare` and `voxlume reference`, on whatever device there is.

use serde_json::Value;

use crate::folder::{Folder, Ran};

const CORNELL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/cornell.ron");
const SMALL: &str = "--size 32x32 --resolutions 32 --spp 4 --repeat 1 --formats isotropic";

fn compare(folder: &Folder, more: &str) -> Ran {
    folder.run(&format!("compare {CORNELL} {SMALL} --out out {more}"))
}

fn text(folder: &Folder, name: &str) -> String {
    std::fs::read_to_string(folder.path().join(name)).unwrap()
}

fn rows(folder: &Folder) -> Vec<Value> {
    let results: Value = serde_json::from_str(&text(folder, "out/results.json")).unwrap();
    assert_eq!(results["schema"], 1);
    results["rows"].as_array().unwrap().clone()
}

#[test]
fn a_sweep_is_reported_and_not_run_twice() {
    let folder = Folder::new();
    let ran = compare(&folder, "");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let effects: Vec<Value> = rows(&folder).iter().map(|row| row["effect"].clone()).collect();
    // Nothing is glossy in it.
    assert_eq!(effects, ["soft_shadow", "ambient_occlusion", "diffuse", "final"]);
    for row in rows(&folder) {
        assert!(row["total_ms"].as_f64().unwrap() > 0.0 && row["volume_bytes"].as_u64() == Some(0), "{row}");
        // A first guard against comparing with something else: it is far nearer than black would be.
        assert!(row["error"]["bias_rel"].as_f64().unwrap().abs() < 0.5, "{row}");
    }
    assert_eq!(text(&folder, "out/results.csv").lines().count(), 5);
    assert_eq!(ran.stdout.lines().count(), 5);
    let page = text(&folder, "out/report.html");
    // Image and error of each effect, and a reference for each.
    assert_eq!(page.matches("data:image/png;base64,").count(), 12);

    // The same figures, times included: nothing was measured again.
    let before = text(&folder, "out/results.json");
    assert_eq!(compare(&folder, "").code, Some(0));
    assert_eq!(text(&folder, "out/results.json"), before);

    // Held against itself, nothing has changed.
    let again = compare(&folder, "--baseline out/results.json");
    let changes: Vec<&str> = again.stdout.lines().skip(6).collect();
    assert_eq!(changes[0], "since the baseline:");
    assert!(changes[2..].len() == 4 && changes[2..].iter().all(|line| line.matches(" 1.00 ").count() >= 2));

    // A finished cell that is damaged, or of other settings, is made again.
    let cell = folder.path().join("out/cells/cornell-diffuse-isotropic-rgba16float-rays-32.json");
    std::fs::write(&cell, "{").unwrap();
    assert_eq!(compare(&folder, "--effects diffuse").code, Some(0));
    assert!(std::fs::read_to_string(&cell).unwrap().len() > 100);
    let error = |rows: &[Value]| rows[0]["error"]["reference_se"].as_f64().unwrap();
    let noisy = error(&rows(&folder));
    assert_eq!(compare(&folder, "--effects diffuse --spp 64").code, Some(2));
    let more = folder.run(&format!(
        "compare {CORNELL} --size 32x32 --resolutions 32 --spp 64 --repeat 1 --formats isotropic --effects diffuse --out out"
    ));
    assert_eq!(more.code, Some(0), "{}", more.stderr);
    assert!(error(&rows(&folder)) < 0.6 * noisy);
}

#[test]
fn a_cell_that_fails_leaves_the_others() {
    let folder = Folder::new();
    let pipeline = include_str!("../../../../pipelines/gi.ron");
    // Only what looks at ambient occlusion plans that pass.
    folder.edit("broken.ron", pipeline, "falloff: 4.0", "fallof: 4.0");
    let ran = compare(&folder, "--pipeline broken.ron --effects ambient_occlusion,diffuse");
    assert_eq!(ran.code, Some(1));
    assert!(ran.stderr.ends_with("1 of 2 cells failed; results.json says why\n"), "{}", ran.stderr);
    let rows = rows(&folder);
    assert!(rows[0]["fault"].as_str().unwrap().contains("`fallof`"), "{}", rows[0]);
    assert!(rows[1]["error"]["rmse"].is_f64());
}

#[test]
fn a_baseline_of_another_schema_is_refused_by_name() {
    let folder = Folder::new();
    std::fs::write(folder.path().join("old.json"), r#"{"schema": 7, "rows": "of another form"}"#).unwrap();
    folder.refuses(
        "compare box.ron --baseline old.json --out out",
        "loading\nerror: `old.json`: results of schema 7: this program reads schema 1",
    );
    folder.refuses(
        "compare box.ron --baseline gone.json --out out",
        "loading\nerror: cannot read `gone.json`: No such file or directory (os error 2)",
    );
}

#[test]
fn unknown_words() {
    Folder::new().refuses(
        "compare box.ron --formats sh3 --encodings rgba --resolutions 5 --effects ao --out out",
        "loading
error: unknown storage format `sh3`
 = did you mean `sh2`? one of: isotropic, six_face, sh2, or all

error: unknown encoding `rgba`
 = did you mean `rgba8`? one of: rgba8, rgba16float, rgba32float, or all

error: unknown effect `ao`
 = one of: soft_shadow, ambient_occlusion, diffuse, specular, final, or all

error: a grid of 5 × 5 × 5 voxels
 = 8 to 512 along the longest side",
    );
}

#[test]
fn what_no_cell_can_do_is_refused_at_once() {
    Folder::new().refuses(
        "compare box.ron --size 0x64 --out out",
        "loading\nerror: an image of 0 × 64 pixels\n = each side: 1 to 8192",
    );
}

#[test]
fn a_scene_given_twice() {
    Folder::new()
        .refuses("compare box.ron box.ron --out out", "loading\nerror: scene `box.ron` is given twice");
}

#[test]
fn a_reference_is_written_with_its_error() {
    let folder = Folder::new();
    let ran = folder
        .run(&format!("reference {CORNELL} --effect soft_shadow --size 16x12 --spp 4 -o a.png -o a.exr"));
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(
        ran.stdout.starts_with("soft_shadow of cornell · 16 × 12 pixels, 4 samples each\nmean "),
        "{}",
        ran.stdout
    );
    let png = image::open(folder.path().join("a.png")).unwrap().into_rgb8();
    assert_eq!(png.dimensions(), (16, 12));
    // Light on the floor, and dark beneath the ceiling, which the lamp doesn't face.
    assert!(png.pixels().any(|p| p[0] > 250) && png.pixels().any(|p| p[0] < 5));
    folder.refuses(
        "reference box.ron --effect soft_shadow -o b.png",
        "loading box.ron\nerror: the scene has no light to cast a shadow",
    );
    folder.refuses(
        "reference box.ron --camera top -o b.png",
        "loading box.ron\nerror: unknown camera `top`\n = one of: front, side",
    );
}

/// An effect from outside the repository: how much lies behind a surface.
const THICKNESS: &str = "import package::common::surface::Surface;
import package::common::trace::{Apex, cone_lobe, reach_of};
import package::tracer::trace::trace_opacity;

struct Params {
    /// How far it looks, voxels, (0, 1000].
    depth: f32,
}

fn effect(surface: Surface, params: Params) -> vec4f {
    let inwards = -surface.normal_geometric;
    let apex = Apex(surface.position_voxel, inwards, surface.share);
    return vec4f(vec3f(trace_opacity(apex, cone_lobe(inwards, 0.3), reach_of(params.depth), 0.0)), 1.0);
}
";

fn with_thickness(words: &str) -> Folder {
    let folder = Folder::new();
    folder.file("thickness.wgsl", THICKNESS);
    let entry = format!(
        "passes: [
        (run: \"thickness.wgsl\", name: \"depth_of_wall\", reads: [\"surface\", \"volume\"], writes: [\"thickness\"], {words} params: (depth: 12)),"
    );
    folder.edit("own.ron", include_str!("../../../../pipelines/gi.ron"), "passes: [", &entry);
    folder
}

#[test]
fn an_effect_without_a_reference_is_held_against_itself_at_its_finest() {
    let folder = with_thickness("shows: \"share\",");
    let ran = folder.run(&format!(
        "compare {CORNELL} --size 32x32 --spp 4 --repeat 1 --pipeline own.ron --formats six_face,isotropic --resolutions 48,32 \
         --effects depth_of_wall --out out"
    ));
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let rows = rows(&folder);
    assert_eq!(rows.len(), 4);
    for row in &rows {
        assert_eq!(
            (&row["effect"], &row["held_against"]),
            (&"depth_of_wall".into(), &"six_face rgba16float 48³ rays".into())
        );
        // Rays ask no format.
        let itself = row["resolution"] == 48;
        let [rmse, flip] = ["rmse", "flip"].map(|figure| row["error"][figure].as_f64().unwrap());
        assert_eq!((rmse == 0.0, flip == 0.0), (itself, itself), "{row}");
    }
    assert_eq!(ran.stdout.matches("held against itself").count(), 1, "{}", ran.stdout);
    assert_eq!(ran.stdout.matches("held against six_face rgba16float 48³").count(), 3, "{}", ran.stdout);
    assert!(
        text(&folder, "out/report.html")
            .contains("<p>Held against the same effect in six_face rgba16float 48³ rays:")
    );
    // No path was traced.
    assert!(
        !folder.path().join("out/cache").exists() && !ran.stderr.contains("reference of"),
        "{}",
        ran.stderr
    );
}

#[test]
fn an_entry_says_how_its_image_is_shown_and_what_it_is_held_against() {
    let brightest = |words: &str| {
        let folder = with_thickness(words);
        let size = "--size 32x32 --resolution 32 --pipeline own.ron --output thickness";
        let ran = folder.run(&format!("render {CORNELL} {size} -o a.png -o a.exr"));
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        let png = image::open(folder.path().join("a.png")).unwrap().into_rgb8();
        png.pixels().map(|pixel| pixel[0]).max().unwrap()
    };
    // A share of 1 is white; light of 1 is tone-mapped to 0.53, sRGB 192.
    let [share, light] = [brightest("shows: \"share\","), brightest("")];
    assert!(share > 250 && light < 200, "{share} {light}");

    let folder = with_thickness("shows: \"share\", reference: \"ambient_occlusion\",");
    let more = "--effects depth_of_wall,diffuse --pipeline own.ron";
    let ran = compare(&folder, more);
    assert_eq!(ran.code, Some(1));
    let rows = rows(&folder);
    let fault = rows[0]["fault"].as_str().unwrap();
    assert!(fault.contains("pass `depth_of_wall` has no number `distance` or `falloff`"), "{fault}");
    assert!(fault.contains("own.ron:12:"), "{fault}");
    assert!(rows[1]["error"]["rmse"].is_f64() && rows[1]["held_against"].is_null());

    let folder = with_thickness("shows: \"share\", reference: \"soft_shadow\",");
    let ran = compare(&folder, "--effects depth_of_wall,soft_shadow --pipeline own.ron");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let rows = self::rows(&folder);
    // Both against one picture.
    assert_eq!(rows[0]["error"]["reference_se"], rows[1]["error"]["reference_se"]);
    assert_eq!(ran.stderr.matches("reference of").count(), 1, "{}", ran.stderr);
    folder.refuses(
        "compare box.ron --effects thickness --pipeline own.ron --out out",
        "loading
error: unknown effect `thickness`
 = one of: depth_of_wall, soft_shadow, ambient_occlusion, diffuse, specular, final, or all",
    );
}

#[test]
fn two_images_of_one_name() {
    let folder = with_thickness("");
    folder.edit("two.ron", &text(&folder, "own.ron"), "name: \"depth_of_wall\"", "name: \"final\"");
    folder.refuses(
        "compare box.ron --pipeline two.ron --out out",
        "loading
error: two images would be compared as `final`
   ┌─ two.ron:82:18
   │
82 │             run: \"composite\",
   │                  ^^^^^^^^^^^ the second; give the effect another `name`",
    );
}

/// A coarser image is held against the pixels that its texels shade; with others its error is four times as large. A fifth
/// more is what tiles of other pixels, which share out directions, come to.
#[test]
fn an_image_of_another_size_is_held_against_the_pixels_that_it_shades() {
    let folder = Folder::new();
    let half = "writes: [\"shadow\"],\n            size: \"1/2\",";
    folder.edit("half.ron", include_str!("../../../../pipelines/gi.ron"), "writes: [\"shadow\"],", half);
    let ran = |pipeline: &str| {
        let ran = compare(&folder, &format!("--effects soft_shadow --pipeline {pipeline}"));
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        rows(&folder)[0]["error"]["rmse"].as_f64().unwrap()
    };
    let (full, half) = (ran("gi"), ran("half.ron"));
    assert!((full - half).abs() < 0.3 * full, "{full} {half}");
    let png =
        image::open(folder.path().join("out/images/cornell-soft_shadow-isotropic-rgba16float-rays-32.png"));
    assert_eq!(png.unwrap().into_rgb8().dimensions(), (16, 16));
}

/// Tracers and scales are axes like formats: a row each, a form for each tracer in the plots.
#[test]
fn tracers_and_scales_are_compared() {
    let folder = Folder::new();
    let ran = compare(&folder, "--effects ambient_occlusion --tracers all --scales 1,4");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let rows = rows(&folder);
    let settings: Vec<_> =
        rows.iter().map(|row| (row["tracer"].as_str().unwrap(), row["scale"].as_u64().unwrap())).collect();
    assert_eq!(settings, [("rays", 1), ("rays", 4), ("cones", 1), ("cones", 4)]);
    let page = text(&folder, "out/report.html");
    assert!(page.contains("</svg>rays</li>") && page.contains("isotropic rgba16float 32³ rays 1/4:"));
    for (words, message) in [
        ("--tracers sonar", "error: unknown tracer `sonar`\n = one of: rays, cones, or all"),
        ("--scales 3", "error: effects gathered at 1/3 of the screen\n = one of: 1, 2, 4, 8"),
    ] {
        let ran = compare(&folder, words);
        assert!(ran.code == Some(2) && ran.stderr.ends_with(&format!("{message}\n")), "{}", ran.stderr);
    }
}
