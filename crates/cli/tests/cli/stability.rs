//! `voxlume stability`: a selection of the hard cases. The whole list is `cargo run --release -p voxlume-cli -- stability`.

use serde_json::Value;

use crate::folder::Folder;

/// Those that take the least time, of every kind of figure; small.
const SELECTION: &str = "leak leak_sun leak_level_0 grazing back_to_back paper energy furnace border radiance shuffled odd_sizes empty \
                         against_the_light no_size_light emissive_sliver uneven slivers tiny not_a_number infinity";

#[test]
fn a_selection_is_within_its_bounds() {
    let folder = Folder::new();
    let ran = folder
        .run(&format!("stability {SELECTION} --resolutions 32 --size 16x16 --json out.json --html out.html"));
    assert_eq!(ran.code, Some(0), "{}\n{}", ran.stdout, ran.stderr);
    let json: Value =
        serde_json::from_str(&std::fs::read_to_string(folder.path().join("out.json")).unwrap()).unwrap();
    assert_eq!(json["schema"], 1);
    let rows = json["rows"].as_array().unwrap();
    for case in SELECTION.split_whitespace() {
        assert!(rows.iter().any(|row| row["case"] == case), "{case}");
    }
    let mut keys: Vec<&str> = rows[0].as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    assert_eq!(
        keys,
        ["bound", "case", "encoding", "figure", "format", "pass", "resolution", "tracer", "value"]
    );
    assert!(json["device"]["name"].is_string() && json.as_object().unwrap().len() == 3);
    let misses = rows.iter().filter(|row| row["pass"] == false).count();
    assert_eq!(ran.stdout.matches("known miss").count(), misses, "{}", ran.stdout);
    assert_eq!(ran.stdout.lines().count(), rows.len() + 1);
    let html = std::fs::read_to_string(folder.path().join("out.html")).unwrap();
    assert!(html.contains("wall, voxels") && html.matches("class=\"curve").count() >= 6);
}

/// A command that can't fail would prove nothing: a wall that is no wall, by a shader that sees no opacity.
#[test]
fn a_figure_out_of_its_bound_fails() {
    let folder = Folder::new();
    let shader = include_str!("../../../../wgsl/effect/shadow.wgsl");
    let from = "fn effect(surface: Surface, params: Params) -> vec4f {";
    assert!(shader.contains(from));
    std::fs::create_dir_all(folder.path().join("wgsl/effect")).unwrap();
    let to = format!("{from}\n    if (surface.hit) {{ return vec4f(1.0); }}");
    folder.file("wgsl/effect/shadow.wgsl", shader.replace(from, &to));
    let ran = folder.run("stability paper --resolutions 32 --size 16x16 --formats six_face --wgsl wgsl");
    assert_eq!(ran.code, Some(1), "{}\n{}", ran.stdout, ran.stderr);
    assert!(ran.stderr.ends_with("error: 1 of 1 figures are out of their bounds\n"), "{}", ran.stderr);
    assert!(ran.stdout.contains("FAIL"), "{}", ran.stdout);
}

/// Each scene made for this is run, and says what should hold in it: as a property, or case by case.
#[test]
fn every_hard_scene_is_a_case_and_says_what_should_hold() {
    let listed = Folder::new().run("stability --list").stdout;
    let scenes = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let mut files: Vec<_> =
        std::fs::read_dir(scenes.join("hard")).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.push(scenes.join("furnace.ron"));
    assert!(files.len() > 20);
    for file in files {
        let name = file.file_name().unwrap().to_str().unwrap();
        let line = |line: &&str| line.trim_end().ends_with(&format!("/{name}"));
        let cases: Vec<&str> =
            listed.lines().filter(line).map(|line| line.split_whitespace().next().unwrap()).collect();
        assert!(!cases.is_empty(), "{name} is no case");
        let text = std::fs::read_to_string(&file).unwrap();
        let head = text.split("\n(").next().unwrap();
        let stated =
            head.contains("Property") || cases.iter().all(|case| head.contains(&format!("`{case}`")));
        assert!(stated, "{name} doesn't say what should hold of {cases:?}");
    }
}

#[test]
fn unknown_words() {
    Folder::new().refuses(
        "stability leek --formats sh3 --resolutions 4",
        "error: unknown case `leek`
 = did you mean `leak`? one of: leak, leak_black, leak_askew, leak_sun, leak_lit, leak_level_0, grazing_wall, slit, slit_thick, lone_cube, lone_ball, carpet, grazing, back_to_back, paper, brightness, offset, energy, energy_askew, furnace, border, feedback, narrow_gap, radiance, origin, scale, mirrored, turned, runs, shuffled, aperture, roughness, odd_sizes, slivers, across, million, far_away, tiny, huge, uneven, no_size_light, against_the_light, camera_inside, coplanar, emissive_sliver, flat, empty, not_a_number, infinity

error: unknown storage format `sh3`
 = did you mean `sh2`? one of: isotropic, six_face, sh2, or all

error: a grid of 4 × 4 × 4 voxels
 = 8 to 512 along the longest side",
    );
}

/// Every known miss stands in the book with its reason.
#[test]
fn the_book_lists_the_known_misses() {
    let code = include_str!("../../../measure/src/stability/misses.rs");
    let book =
        include_str!("../../../../book/src/stability.md").split_whitespace().collect::<Vec<_>>().join(" ");
    let mut listed = 0;
    for line in code.lines().filter(|line| line.contains("case: \"")) {
        let case = line.split('"').nth(1).unwrap();
        assert!(book.contains(&format!("| `{case}`")), "{case}");
        listed += 1;
    }
    assert!(listed > 5);
    for reason in code.split("&str =").skip(1) {
        let reason = reason.trim().trim_start_matches('"').split("\";").next().unwrap().replace("\\\n", " ");
        let reason = reason.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(book.contains(&reason), "{reason}");
    }
}
