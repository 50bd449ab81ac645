//! Several grids and volumes in one pipeline.

use insta::assert_snapshot;

use crate::common::message;

/// The message when a second grid with these parameters, and a second volume with those, feed the specular effect.
fn second(grid: &str, volume: &str) -> String {
    let entries = format!(
        "(run: \"voxelize\", name: \"fine\", writes: [\"fine\"], params: ({grid})),
        (run: \"light\", name: \"fine_light\", reads: [\"fine\", \"shadow_maps\"], writes: [\"fine_radiance\"],
         params: (occlusion: \"shadow_map\", emission: \"area_lights\", bias: 1.5, parts: 2)),
        (run: \"filter\", name: \"fine_filter\", reads: [\"fine\", \"fine_radiance\"], writes: [\"fine_volume\"],
         params: ({volume})),
        (run: \"gbuffer\""
    );
    message(&[
        ("(run: \"gbuffer\"", &entries),
        (
            "reads: [\"surface\", \"volume\"],\n            writes: [\"specular\"]",
            "reads: [\"surface\", \"fine_volume\"],\n            writes: [\"specular\"]",
        ),
    ])
}

#[test]
fn a_finer_grid_of_a_part_in_another_format() {
    assert_eq!(second("", ""), "no fault");
    assert_eq!(second("resolution: 32", "format: \"isotropic\""), "no fault");
    let corners = "resolution: 96, min: (1, 0, 0), max: (2, 3, 1)";
    assert_eq!(second(corners, "format: \"sh2\", encoding: \"rgba8:range=8\""), "no fault");
}

#[test]
fn grids_that_are_none() {
    assert_snapshot!(second("resolution: 4", ""), @r#"
    error: parameter `resolution` of pass `fine` can't be 4
       ┌─ p.ron:26:80
       │
    26 │         (run: "voxelize", name: "fine", writes: ["fine"], params: (resolution: 4)),
       │                                                                                ^ a whole number from 8 to 512
    "#);
    assert_snapshot!(second("resolution: 32, min: (0, 0, 0)", ""), @r#"
    error: parameter `min` of pass `fine` can't be (0, 0, 0)
       ┌─ p.ron:26:89
       │
    26 │         (run: "voxelize", name: "fine", writes: ["fine"], params: (resolution: 32, min: (0, 0, 0))),
       │                                                                                         ^^^^^^^^^ a corner needs the other one, below it in x, y and z, and `resolution`
    "#);
    assert_snapshot!(second("resolution: 32, min: (0, 0, 0), max: (1, 0, 1)", ""), @r#"
    error: parameter `max` of pass `fine` can't be (1, 0, 1)
       ┌─ p.ron:26:105
       │
    26 │         (run: "voxelize", name: "fine", writes: ["fine"], params: (resolution: 32, min: (0, 0, 0), max: (1, 0, 1))),
       │                                                                                                         ^^^^^^^^^ a corner needs the other one, below it in x, y and z, and `resolution`
    "#);
    assert_snapshot!(second("min: (0, 0, 0), max: (1, 1, 1)", ""), @r#"
    error: parameter `min` of pass `fine` can't be (0, 0, 0)
       ┌─ p.ron:26:73
       │
    26 │         (run: "voxelize", name: "fine", writes: ["fine"], params: (min: (0, 0, 0), max: (1, 1, 1))),
       │                                                                         ^^^^^^^^^ a corner needs the other one, below it in x, y and z, and `resolution`
    "#);
    assert_snapshot!(second("resolution: 32, min: 3, max: (1, 1, 1)", ""), @r#"
    error: parameter `min` of pass `fine` can't be 3
       ┌─ p.ron:26:89
       │
    26 │         (run: "voxelize", name: "fine", writes: ["fine"], params: (resolution: 32, min: 3, max: (1, 1, 1))),
       │                                                                                         ^ three numbers within ±1e15

    error: parameter `max` of pass `fine` can't be (1, 1, 1)
       ┌─ p.ron:26:97
       │
    26 │         (run: "voxelize", name: "fine", writes: ["fine"], params: (resolution: 32, min: 3, max: (1, 1, 1))),
       │                                                                                                 ^^^^^^^^^ a corner needs the other one, below it in x, y and z, and `resolution`
    "#);
}

#[test]
fn formats_that_are_none() {
    assert_snapshot!(second("", "format: \"sixface\""), @r#"
    error: unknown storage format `sixface`
       ┌─ p.ron:30:27
       │
    30 │          params: (format: "sixface")),
       │                           ^^^^^^^^^ did you mean `six_face`? one of: isotropic, six_face, sh2
    "#);
    assert_snapshot!(second("", "encoding: \"rgba9\""), @r#"
    error: unknown encoding `rgba9`
       ┌─ p.ron:30:29
       │
    30 │          params: (encoding: "rgba9")),
       │                             ^^^^^^^ did you mean `rgba8`? one of: rgba8, rgba16float, rgba32float
    "#);
}
