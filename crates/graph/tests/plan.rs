//! Plans: their order, and what they leave out.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod common;

use std::path::Path;

use common::{PIPELINE, plan, request, rich};
use insta::assert_snapshot;
use voxlume_format::Formats;
use voxlume_graph::{Pipeline, Plan, Request, SceneFacts, Step, Value, explain};
use voxlume_scene::Scene;

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

fn gi() -> Pipeline {
    Pipeline::load(&root().join("pipelines/gi.ron")).unwrap()
}

fn names(plan: &Plan) -> Vec<&str> {
    plan.passes.iter().map(|pass| pass.name.as_str()).collect()
}

fn gi_for(facts: &SceneFacts, request: &Request) -> Plan {
    plan(&gi(), facts, request).unwrap_or_else(|faults| panic!("{faults}"))
}

/// Why a pass was left out.
fn why<'p>(plan: &'p Plan, pass: &str) -> &'p str {
    let what = format!("pass `{pass}`");
    plan.left_out.iter().find(|item| item.what == what).map_or("it was not left out", |item| &item.why)
}

/// Every pass comes after those that make what it reads.
fn is_in_order(plan: &Plan) {
    for (index, pass) in plan.passes.iter().enumerate() {
        for read in &pass.reads {
            let last =
                plan.passes.iter().rposition(|other| other.name != pass.name && other.writes.contains(read));
            assert!(
                last.is_none_or(|last| last < index || pass.writes.contains(read)),
                "{} reads {read}",
                pass.name
            );
        }
    }
}

#[test]
fn order_follows_from_reads_and_writes() {
    let mut pipeline = common::pipeline(PIPELINE);
    let expected = plan(&pipeline, &rich(), &request()).unwrap();
    assert_eq!(
        names(&expected),
        [
            "voxelize static",
            "voxelize",
            "shadow_maps",
            "light",
            "filter",
            "bounce",
            "gbuffer",
            "diffuse",
            "specular",
            "composite"
        ]
    );
    let count = pipeline.passes.len();
    // Every rotation, forwards and backwards.
    for turn in 0..2 * count {
        pipeline.passes.rotate_left(1);
        if turn == count {
            pipeline.passes.reverse();
        }
        let shuffled = plan(&pipeline, &rich(), &request()).unwrap();
        is_in_order(&shuffled);
        let sorted = |plan: &Plan| {
            let mut passes: Vec<_> =
                plan.passes.iter().map(|pass| (pass.name.clone(), pass.steps.len(), pass.sources)).collect();
            passes.sort_by(|a, b| a.0.cmp(&b.0));
            passes
        };
        assert_eq!(sorted(&shuffled), sorted(&expected), "turned by {turn}");
        let position = |name: &str| names(&shuffled).iter().position(|other| *other == name).unwrap();
        // An update comes between the pass that makes a thing and those that read it.
        assert!(position("filter") < position("bounce") && position("bounce") < position("diffuse"));
    }
}

#[test]
fn everything_is_planned_where_everything_is_needed() {
    // Rays take no shadow maps.
    let mut request = Request { tracer: Some("cones".into()), ..request() };
    request.set = vec![
        ("bounce".into(), "bounces".into(), Value::Number(2.0)),
        ("composite".into(), "ao_weight".into(), Value::Number(1.0)),
    ];
    for format in Formats::builtin().iter() {
        request.format = Some(format.name().into());
        for resolution in [16, 64, 512] {
            request.resolution = Some(resolution);
            let lit_by_polygons = gi_for(&SceneFacts { sky: false, ..rich() }, &request);
            is_in_order(&lit_by_polygons);
            let pipeline = gi();
            let mut all: Vec<&str> = pipeline.passes.iter().map(|pass| pass.name.as_str()).collect();
            all.retain(|name| !["emission", "voxel_view"].contains(name));
            all.push("voxelize static");
            all.sort_unstable();
            let mut planned = names(&lit_by_polygons);
            planned.sort_unstable();
            assert_eq!(planned, all, "{}", format.name());
            let emission = SceneFacts { polygons: None, emitters: None, sky: false, ..rich() };
            for facts in [emission, rich()] {
                let gathered = gi_for(&facts, &request);
                is_in_order(&gathered);
                // All but the view of the voxels, and voxelization in two parts.
                assert_eq!(gathered.passes.len(), pipeline.passes.len(), "{}", format.name());
            }
        }
    }
}

#[test]
fn without_lights_no_shadows() {
    let dark = SceneFacts { directional: 0, point: 0, spot: 0, polygons: Some(0), emissive: false, ..rich() };
    let plan = gi_for(&dark, &request());
    assert!(!names(&plan).contains(&"soft_shadow") && !names(&plan).contains(&"shadow_maps"));
    assert_eq!(why(&plan, "soft_shadow"), "the scene has no light");
    assert_eq!(why(&plan, "shadow_maps"), "the scene has no directional, spot or point light");
}

#[test]
fn without_gloss_no_specular() {
    let plan = gi_for(&SceneFacts { glossy: false, ..rich() }, &request());
    assert!(!names(&plan).contains(&"specular"));
    assert_eq!(why(&plan, "specular"), "no material is glossy");
    assert!(gi_for(&rich(), &request()).resource("specular").is_some());
    assert!(plan.resource("specular").is_none());
}

#[test]
fn what_nobody_asks_for_is_left_out() {
    let plan = gi_for(&rich(), &Request { output: Some("normal".into()), ..request() });
    assert_eq!(names(&plan), ["gbuffer"]);
    assert_eq!(why(&plan, "voxelize"), "nobody reads what it makes");
    let images: Vec<&str> = plan.resources.iter().map(|r| r.name.as_str()).collect();
    for image in ["albedo", "geometry", "emission", "occupancy", "volume"] {
        assert!(!images.contains(&image), "{image} in {images:?}");
    }
}

#[test]
fn parameters_of_zero_leave_passes_out() {
    let set = |pass: &str, name: &str, value: f64| Request {
        set: vec![(pass.into(), name.into(), Value::Number(value))],
        ..request()
    };
    let none = gi_for(&rich(), &set("composite", "ao_weight", 0.0));
    assert_eq!(
        (names(&none).contains(&"ambient_occlusion"), why(&none, "ambient_occlusion")),
        (false, "`ao_weight` is 0")
    );
    assert!(names(&gi_for(&rich(), &set("composite", "ao_weight", 0.5))).contains(&"ambient_occlusion"));
    let none = gi_for(&rich(), &set("bounce", "bounces", 0.0));
    assert_eq!((names(&none).contains(&"bounce"), why(&none, "bounce")), (false, "`bounces` is 0"));
    assert!(names(&gi_for(&rich(), &set("bounce", "bounces", 1.0))).contains(&"bounce"));
    // It may still be asked for by itself.
    let ao = gi_for(&rich(), &Request { output: Some("ao".into()), ..set("composite", "ao_weight", 0.0) });
    assert!(names(&ao).contains(&"ambient_occlusion"));
}

#[test]
fn what_nothing_moves_runs_once() {
    let voxelized = |moving_triangles| {
        let cones = Request { tracer: Some("cones".into()), ..request() };
        let plan = gi_for(&SceneFacts { moving_triangles, ..rich() }, &cones);
        let passes = plan.passes.iter().filter(|pass| pass.name.starts_with("voxelize"));
        let resources = ["static_occupancy", "static_ranks", "static_attributes", "volume.stored"];
        let own = resources.map(|name| plan.resource(name).is_some());
        let filter = plan.passes.iter().find(|pass| pass.name == "filter").unwrap();
        // Beside those that make one radiance of the voxels' sides.
        let vacates = filter.steps.len() - 2;
        let left_out = plan.left_out.into_iter().find(|item| item.what.starts_with("voxelizing"));
        let passes: Vec<_> = passes.map(|pass| (pass.name.clone(), !pass.sources.geometry)).collect();
        (passes, own, vacates, left_out.map(|item| format!("{}: {}", item.what, item.why)))
    };
    let whole = |once| vec![("voxelize".to_owned(), once)];
    let why = |text: &str| Some(text.to_owned());
    let (passes, own, steps, left_out) = voxelized(0);
    assert_eq!(
        (passes, own, left_out),
        (whole(true), [false; 4], why("voxelizing every frame: nothing moves"))
    );
    // Everything moves: nothing is kept, but what was left has to be emptied.
    assert_eq!(voxelized(1000), (whole(false), [false, false, false, true], 2 * steps, None));
    let parts = vec![("voxelize static".to_owned(), true), ("voxelize".to_owned(), false)];
    let still = why("voxelizing 900 triangles every frame: they never move");
    assert_eq!(voxelized(100), (parts, [true; 4], 2 * steps, still));
}

#[test]
fn voxel_rays_need_no_shadow_maps() {
    let set = vec![("light".into(), "occlusion".into(), Value::Word("voxel_ray".into()))];
    // The picture's own shadows ask for them.
    let plan = gi_for(&rich(), &Request { set, output: Some("diffuse".into()), ..request() });
    assert_eq!(
        (names(&plan).contains(&"shadow_maps"), why(&plan, "shadow_maps")),
        (false, "occlusion is by voxel ray")
    );
}

/// Opacities of `sh2` are bytes in every encoding, and said to be.
#[test]
fn bytes_are_called_bytes() {
    let scene = Scene::load(&root().join("scenes/cornell.ron")).unwrap();
    for (encoding, signed) in
        [("rgba8", "rgba8snorm"), ("rgba16float", "rgba16float"), ("rgba32float", "rgba32float")]
    {
        let request = Request {
            format: Some("sh2".into()),
            encoding: Some(encoding.into()),
            tracer: Some("cones".into()),
            resolution: Some(64),
            ..Request::image(64, 64)
        };
        let explained = explain(&gi_for(&SceneFacts::of(&scene).unwrap(), &request));
        let texel = |volume: &str| {
            let line = explained.lines().find(|line| line.trim_start().starts_with(volume)).unwrap();
            line.split_once(',').unwrap().0.rsplit(' ').next().unwrap().to_owned()
        };
        assert_eq!([texel("harmonics"), texel("coverage")], [signed, "rgba8unorm"]);
    }
}

#[test]
fn the_cornell_box_explained() {
    let scene = Scene::load(&root().join("scenes/cornell.ron")).unwrap();
    let request = Request { resolution: Some(128), ..Request::image(512, 512) };
    let plan = gi_for(&SceneFacts::of(&scene).unwrap(), &request);
    assert_snapshot!(explain(&plan), @r"
    isotropic rgba16float, traced by rays · grid 128 × 128 × 128, voxels of 0.0447 · 512 × 512 pixels · 46 triangles

    passes
      voxelize           nothing → voxels
                           runs once
                           21 dispatches, 3 indirect dispatches
      light              voxels → radiance
                           runs when these change: lights, parameters, voxels
                           1 indirect dispatch
      filter             voxels, radiance → volume
                           runs when these change: voxels, radiance
                           1 indirect dispatch
      gbuffer            nothing → surface
                           runs when these change: camera
                           1 dispatch, 1 draw
      traced_shadow      surface, voxels, volume → traced_shadow
                           runs when these change: lights, camera, parameters, surface, voxels
                           2 dispatches
      soft_shadow        surface, traced_shadow → shadow
                           runs when these change: lights, camera, parameters, surface, traced_shadow
                           1 dispatch
      diffuse            surface, voxels, volume → diffuse
                           runs when these change: lights, camera, parameters, surface, voxels, volume
                           3 dispatches
      composite          surface, shadow, diffuse → final
                           runs when these change: lights, camera, parameters, surface, shadow, diffuse
                           1 dispatch

    resources
      occupancy          buffer                                    356.6 KiB
      ranks              buffer                                    292.6 KiB
      levels             buffer                                    256 B
      scan_runs          buffer                                    4.6 KiB
      cells              buffer                                    4 B × occupied cells of all levels
      attributes         buffer                                    44 B × occupied voxels
      fronts             buffer                                    120 B × occupied voxels
      sheets             buffer                                    72 B × occupied voxels
      item_ranks         buffer                                    188 B
      item_groups        buffer                                    16 B
      radiance           buffer                                    24 B × occupied voxels
      side_radiance      buffer                                    24 B × occupied voxels
      albedo             512 × 512 rgba8srgb, 1 layer              1.00 MiB
      normal             512 × 512 rgba16float, 1 layer            2.00 MiB
      geometry           512 × 512 rgba16float, 1 layer            2.00 MiB
      emission           512 × 512 rgba16float, 1 layer            2.00 MiB
      depth              512 × 512 depth32float, 1 layer           1.00 MiB
      guide              512 × 512 rgba32float, 1 layer            4.00 MiB
      traced_shadow      512 × 512 rgba16float, 1 layer            2.00 MiB
      interleaved_1      512 × 512 rgba16float, 1 layer            2.00 MiB
      shadow             512 × 512 rgba16float, 1 layer            2.00 MiB
      diffuse            512 × 512 rgba16float, 1 layer            2.00 MiB
      final              512 × 512 rgba16float, 1 layer            2.00 MiB

    left out
      pass `shadow_maps`                     the scene has no directional, spot or point light
      pass `emission`                        no sky, and no emission but that of lights
      pass `bounce`                          `bounces` is 0
      pass `ambient_occlusion`               `ao_weight` is 0 (saves 2.00 MiB)
      pass `specular`                        no material is glossy (saves 2.00 MiB)
      pass `voxel_view`                      nobody reads what it makes (saves 2.00 MiB)
      emission in voxels (12 bytes each)     what emits is lit as area lights
      voxelizing every frame                 nothing moves
      textures of `volume`                   every tracer that reads it asks the voxels' sides (saves 18.29 MiB)
      alpha tests                            no material has an alpha mask
      texture look-ups                       no material has a texture
      directional lights' branch             the scene has none
      point lights' branch                   the scene has none
      spot lights' branch                    the scene has none
    ");
}

#[test]
fn an_output_that_the_scene_leaves_out_is_a_fault_with_its_reason() {
    let facts = SceneFacts { glossy: false, ..rich() };
    let request = Request { output: Some("specular".into()), ..request() };
    let faults =
        voxlume_graph::plan(&gi(), &facts, &voxlume_graph::Registry::builtin(), &request).unwrap_err();
    assert_eq!(faults.to_string(), "error: this scene has no `specular`\n = no material is glossy");
}

/// Interleaved, an effect's image is the mean over the pixels that share out its directions: a program more for 4 × 4, and two
/// for 8 × 8.
#[test]
fn interleaving() {
    let gi = include_str!("../../../pipelines/gi.ron");
    let steps = |text: &str| {
        let plan = plan(&common::pipeline(text), &rich(), &request()).unwrap();
        let pass = plan.passes.iter().find(|pass| pass.name == "diffuse").unwrap();
        let turned = |step: &Step| match step {
            Step::Compute { program, .. } => {
                program.constants.iter().any(|(name, side)| name == "INTERLEAVE" && *side > 1.0)
            }
            _ => false,
        };
        (pass.steps.len(), pass.steps.iter().filter(|step| turned(step)).count())
    };
    assert_eq!(steps(gi), (3, 1));
    assert_eq!(steps(&gi.replace("interleave: 8,", "interleave: true,")), (2, 1));
    assert_eq!(steps(&gi.replace("interleave: 8,", "")), (1, 0));
}

/// Reflections are gathered at half the size unless a material is polished; a scale that is asked for holds for all.
#[test]
fn polished_materials_are_reflected_at_full_size() {
    let scale = |polished: bool, asked: Option<u32>| {
        let facts = SceneFacts { polished, ..rich() };
        let plan = gi_for(&facts, &Request { scale: asked, ..request() });
        let pass = plan.passes.iter().find(|pass| pass.name == "specular").unwrap();
        pass.steps.iter().find_map(|step| match step {
            Step::Compute { program, .. } => {
                program.constants.iter().find(|(name, _)| name == "SEEN_SCALE").map(|(_, scale)| *scale)
            }
            _ => None,
        })
    };
    assert_eq!([scale(false, None), scale(true, None)], [Some(2.0), None]);
    assert_eq!([scale(false, Some(1)), scale(true, Some(4))], [None, Some(4.0)]);
}

/// A scene whose triangles are all too small to be shared out pays nothing for sharing.
#[test]
fn fine_triangles_leave_no_bands() {
    let voxel_size = f64::from(gi_for(&rich(), &request()).grid.voxel_size);
    let plan_of =
        |voxels: f64| gi_for(&SceneFacts { longest_edge: voxels * voxel_size, ..rich() }, &request());
    let noted = |plan: &Plan| plan.left_out.iter().any(|item| item.what == "bands of large triangles");
    let (fine, coarse) = (plan_of(9.4), plan_of(9.6));
    assert!(noted(&fine) && fine.resource("item_ranks").is_none());
    assert!(!noted(&coarse) && coarse.resource("item_ranks").is_some());
}

/// What is left of the volume's cells from frame to frame ties no pass to another: each leaves it right for the next.
#[test]
fn passes_that_store_a_volume_depend_on_each_other_by_the_volume_alone() {
    let set = vec![("bounce".to_owned(), "bounces".to_owned(), Value::Number(1.0))];
    let request = Request { set, tracer: Some("cones".into()), ..request() };
    let plan = gi_for(&SceneFacts { polygons: None, emitters: None, ..rich() }, &request);
    let stored = plan.resource("volume.stored").unwrap();
    for name in ["emission", "filter", "bounce"] {
        let pass = plan.passes.iter().find(|pass| pass.name == name).unwrap();
        let touches = pass.steps.iter().flat_map(Step::touches).any(|touch| touch.resource == stored);
        assert!(touches && !pass.inputs.contains(&stored) && !pass.outputs.contains(&stored), "{name}");
    }
}
