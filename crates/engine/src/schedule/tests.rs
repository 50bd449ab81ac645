#![allow(clippy::unwrap_used, clippy::panic)]

use std::path::Path;

use voxlume_graph::{Life, Pipeline, Registry, Request, SceneFacts, Sources, plan};
use voxlume_scene::Scene;

use super::*;

const NOTHING: Sources =
    Sources { geometry: false, lights: false, camera: false, parameters: false, time: false };

/// A pass that reads and writes these resources.
fn pass(sources: Sources, inputs: &[usize], outputs: &[usize]) -> Pass {
    Pass {
        name: String::new(),
        reads: vec![],
        writes: vec![],
        steps: vec![],
        sources,
        inputs: inputs.to_vec(),
        waits_for: vec![],
        outputs: outputs.to_vec(),
        update: Update::Changed,
        params: vec![],
    }
}

/// Of passes over `count` resources, the last being the result; after a first frame.
fn schedule(passes: &[Pass], count: usize) -> Schedule {
    let resource =
        |index: usize| Resource { name: index.to_string(), kind: ResourceKind::Buffer(4), life: Life::Frame };
    let resources: Vec<Resource> = (0..count).map(resource).collect();
    let mut schedule = Schedule::of(passes, &resources, &[], count - 1);
    assert_eq!(frame(&mut schedule), (0..passes.len()).collect::<Vec<_>>(), "the first frame runs all");
    schedule
}

fn frame(schedule: &mut Schedule) -> Vec<usize> {
    demand(schedule, &[])
}

fn demand(schedule: &mut Schedule, demanded: &[usize]) -> Vec<usize> {
    let chosen = schedule.begin(false, demanded);
    chosen.iter().for_each(|pass| schedule.ran(*pass));
    chosen
}

/// As the default pipeline has them: a pass gathers emission by way of scratch that lighting then uses, one lights, one
/// stores a volume, one updates it, and one looks at it.
fn lighting() -> Schedule {
    let [scratch, emitted, volume, image] = [0, 1, 2, 3];
    let passes = [
        pass(Sources { geometry: true, ..NOTHING }, &[], &[scratch, volume, emitted]),
        pass(Sources { lights: true, ..NOTHING }, &[emitted], &[scratch]),
        pass(NOTHING, &[scratch], &[volume]),
        pass(NOTHING, &[volume, scratch], &[volume]),
        pass(Sources { camera: true, ..NOTHING }, &[volume], &[image]),
    ];
    schedule(&passes, 4)
}

#[test]
fn nothing_runs_twice_without_a_reason() {
    let mut schedule = lighting();
    assert!(frame(&mut schedule).is_empty());
    assert!(frame(&mut schedule).is_empty());
}

#[test]
fn what_changes_runs_and_what_is_made_of_it() {
    let mut schedule = lighting();
    schedule.versions.camera += 1;
    assert_eq!(frame(&mut schedule), [4]);
    schedule.versions.lights += 1;
    assert_eq!(frame(&mut schedule), [1, 2, 3, 4]);
    schedule.versions.geometry += 1;
    assert_eq!(frame(&mut schedule), [0, 1, 2, 3, 4]);
    assert!(frame(&mut schedule).is_empty());
}

/// What passes 0 and 1 read from outside.
fn updating(update: Update) -> Schedule {
    let [from_0, from_1, stored, image] = [0, 1, 2, 3];
    let mut passes = [
        pass(NOTHING, &[from_0], &[stored]),
        pass(NOTHING, &[from_1, stored], &[stored]),
        pass(Sources { camera: true, ..NOTHING }, &[stored], &[image]),
    ];
    passes[0].update = update;
    schedule(&passes, 4)
}

#[test]
fn what_was_written_over_is_made_again_for_who_reads_it() {
    let mut schedule = updating(Update::Changed);
    // The second pass begins with what the first one stored, and has itself written over it.
    schedule.touch(1);
    assert_eq!(frame(&mut schedule), [0, 1, 2]);
    schedule.versions.camera += 1;
    assert_eq!(frame(&mut schedule), [2]);
}

#[test]
fn what_an_earlier_pass_writes_over_is_made_again() {
    let [shared, own, image, result] = [0, 1, 2, 3];
    for update in [Update::Changed, Update::Every(100), Update::OnDemand] {
        let mut passes = [
            pass(Sources { geometry: true, ..NOTHING }, &[], &[shared, own]),
            pass(Sources { lights: true, ..NOTHING }, &[], &[shared]),
            pass(NOTHING, &[shared], &[image]),
            pass(NOTHING, &[own], &[result]),
        ];
        passes[1].update = update;
        let mut schedule = schedule(&passes, 4);
        schedule.versions.geometry += 1;
        assert_eq!(frame(&mut schedule), [0, 1, 2, 3], "{update:?}");
    }
}

#[test]
fn a_chain_needs_its_maker_however_seldom_it_is_updated() {
    for update in [Update::Every(100), Update::OnDemand] {
        let mut schedule = updating(update);
        schedule.touch(0);
        assert!(frame(&mut schedule).is_empty(), "{update:?}");
        schedule.touch(1);
        assert_eq!(frame(&mut schedule), [0, 1, 2], "{update:?}");
    }
}

#[test]
fn a_pass_that_goes_on_from_its_own_value_has_no_reason_in_it() {
    let mut schedule = schedule(&[pass(NOTHING, &[0], &[0])], 1);
    assert!(frame(&mut schedule).is_empty());
    schedule.touch(0);
    assert_eq!(frame(&mut schedule), [0]);
}

#[test]
fn shared_scratch_is_nobodys_value() {
    let [first, second] = [0, 1].map(|image| pass(Sources { camera: true, ..NOTHING }, &[], &[2, image]));
    let end = pass(NOTHING, &[0, 1], &[3]);
    let mut schedule = schedule(&[Pass { inputs: vec![4], ..first }, second, end], 5);
    schedule.touch(4);
    assert_eq!(frame(&mut schedule), [0, 2]);
}

#[test]
fn time_runs_in_every_frame() {
    let mut schedule = schedule(&[pass(Sources { time: true, ..NOTHING }, &[], &[0])], 1);
    assert_eq!([frame(&mut schedule), frame(&mut schedule)], [[0], [0]]);
}

#[test]
fn an_interval_keeps_what_is_pending() {
    let mut passes = [pass(Sources { lights: true, ..NOTHING }, &[], &[0]), pass(NOTHING, &[0], &[1])];
    passes[0].update = Update::Every(3);
    let mut schedule = schedule(&passes, 2);
    schedule.versions.lights += 1;
    let frames: Vec<_> = (0..5).map(|_| frame(&mut schedule)).collect();
    assert_eq!(frames, [vec![], vec![], vec![0, 1], vec![], vec![]]);
}

/// A value for each voxel is in the order of voxels: whoever keeps one makes it anew when they have moved, however seldom it
/// is updated.
#[test]
fn what_is_kept_for_each_voxel_follows_the_voxels() {
    let [levels, lit, image] = [0, 1, 2];
    let kinds = [ResourceKind::Buffer(32), ResourceKind::PerVoxel(16), ResourceKind::Buffer(4)];
    let resource = |kind: ResourceKind| Resource { name: String::new(), kind, life: Life::Frame };
    for update in [Update::Every(100), Update::OnDemand] {
        let mut passes = [
            pass(Sources { geometry: true, ..NOTHING }, &[], &[levels]),
            pass(Sources { lights: true, ..NOTHING }, &[levels], &[lit]),
            pass(NOTHING, &[lit], &[image]),
        ];
        passes[1].update = update;
        let mut schedule = Schedule::of(&passes, &kinds.clone().map(resource), &[levels], image);
        frame(&mut schedule);
        schedule.versions.lights += 1;
        assert!(frame(&mut schedule).is_empty(), "{update:?}");
        schedule.versions.geometry += 1;
        assert_eq!(frame(&mut schedule), [0, 1, 2], "{update:?}");
    }
}

#[test]
fn what_is_on_demand_waits_for_it() {
    let mut passes = [pass(Sources { lights: true, ..NOTHING }, &[], &[0]), pass(NOTHING, &[0], &[1])];
    passes[0].update = Update::OnDemand;
    let mut schedule = schedule(&passes, 2);
    schedule.versions.lights += 1;
    assert!(frame(&mut schedule).is_empty());
    assert_eq!(demand(&mut schedule, &[0]), [0, 1]);
}

#[test]
fn what_is_lost_is_made_again() {
    let mut schedule = lighting();
    schedule.forget(3);
    assert_eq!(frame(&mut schedule), [4]);
    // Two passes write the volume, and lighting uses the scratch that the first of them goes through.
    schedule.forget(2);
    assert_eq!(frame(&mut schedule), [0, 1, 2, 3, 4]);
    schedule.forget_all();
    assert_eq!(frame(&mut schedule).len(), 5);
    assert_eq!(schedule.begin(true, &[]).len(), 5);
}

/// Names of the passes of `pipelines/gi.ron` that a scene's frames run, after the first, once something has changed.
fn of_scene(scene: &str, change: impl Fn(&mut Schedule)) -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let scene = Scene::load(&root.join("scenes").join(scene)).unwrap();
    let pipeline = Pipeline::load(&root.join("pipelines/gi.ron")).unwrap();
    let facts = SceneFacts::of(&scene).unwrap();
    let request = Request { resolution: Some(32), ..Request::image(8, 8) };
    let plan = plan(&pipeline, &facts, &Registry::builtin(), &request);
    let plan = plan.unwrap_or_else(|faults| panic!("{faults}"));
    let mut schedule = Schedule::new(&plan);
    assert_eq!(frame(&mut schedule).len(), plan.passes.len());
    assert!(frame(&mut schedule).is_empty());
    change(&mut schedule);
    frame(&mut schedule).into_iter().map(|index| plan.passes[index].name.clone()).collect()
}

#[test]
fn a_camera_that_moves_costs_what_depends_on_it() {
    for scene in ["cornell.ron", "lights.ron", "furnace.ron"] {
        let passes = of_scene(scene, |schedule| schedule.versions.camera += 1);
        let known = [
            "gbuffer",
            "traced_shadow",
            "soft_shadow",
            "ambient_occlusion",
            "diffuse",
            "specular",
            "composite",
            "voxel_view",
        ];
        assert!(passes.contains(&"gbuffer".to_owned()), "{scene}: {passes:?}");
        assert!(passes.iter().all(|pass| known.contains(&pass.as_str())), "{scene}: {passes:?}");
    }
}

#[test]
fn a_lamp_that_moves_voxelizes_nothing() {
    for scene in ["cornell.ron", "lights.ron", "moving.ron", "sunlit_columns.ron"] {
        let passes = of_scene(scene, |schedule| schedule.versions.lights += 1);
        assert!(passes.contains(&"light".to_owned()), "{scene}: {passes:?}");
        let kept = |pass: &String| pass.contains("voxelize") || pass == "gbuffer";
        assert!(!passes.iter().any(kept), "{scene}: {passes:?}");
    }
}

#[test]
fn a_thing_that_moves_leaves_still_voxels_alone() {
    let passes = of_scene("moving.ron", |schedule| schedule.versions.geometry += 1);
    assert!(passes.contains(&"voxelize".to_owned()), "{passes:?}");
    assert!(!passes.contains(&"voxelize static".to_owned()), "{passes:?}");
}
