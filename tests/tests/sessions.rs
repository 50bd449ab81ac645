//! Sessions: what frames cost that differ from the one before in this or that, and that they show what a session made anew
//! would.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use glam::{DQuat, DVec3, Vec3};
use voxlume::scene::{Key, Moved, Path};
use voxlume::{
    Camera, Counters, Error, Frame, ImageExtent, Passes, Pipeline, Plan, Renderer, Request, ResourceKind,
    Scene, Value,
};
use voxlume_tests::{built_in, gi, gpu, picture, plan_for, render, root};

fn request(format: &str) -> Request {
    // Cones, with which there is a volume and there are shadow maps.
    let (format, tracer) = (Some(format.into()), Some("cones".into()));
    Request { format, tracer, resolution: Some(32), ..Request::image(24, 16) }
}

/// Lamps of all kinds, and a ball that moves.
fn scene() -> Scene {
    let mut scene = built_in("lights.ron");
    let index = scene.instances.iter().position(|instance| instance.moving).unwrap();
    let key = |time: f64| {
        let translation = DVec3::new(0.4 * time, 0.2 * time, 0.0);
        Key { time, scale: DVec3::ONE, rotation: DQuat::from_rotation_y(time), translation }
    };
    let (rest, path) = (scene.instances[index].transform, Path { keys: vec![key(0.0), key(2.0)] });
    scene.animation.instances.push(Moved { index, rest, path });
    scene.set_time(0.0);
    scene
}

/// A frame recorded into an encoder of ours: the names of its passes, and what it cost.
fn frame(renderer: &mut Renderer<'_>, camera: &Camera) -> (Vec<String>, Counters) {
    let before = renderer.session().counters();
    let mut encoder = gpu().device.create_command_encoder(&Default::default());
    let passes = renderer.session_mut().encode(&mut encoder, &Frame::of(camera)).unwrap();
    gpu().guarded("a frame", || gpu().queue.submit([encoder.finish()])).unwrap();
    let passes = passes.into_iter().map(|pass| renderer.plan().passes[pass].name.clone()).collect();
    (passes, renderer.session().counters() - before)
}

/// What a renderer that is made for it shows of a scene.
fn is_as_anew(renderer: &Renderer<'_>, scene: &Scene, camera: &Camera, request: &Request) {
    let mut fresh = Renderer::new(gpu(), plan_for(&gi(), scene, request), scene).unwrap();
    fresh.render(scene, camera, Passes::All).unwrap();
    assert!(picture(renderer, "final") == picture(&fresh, "final"), "{request:?}");
}

fn screen_images(plan: &Plan) -> u64 {
    let is_of_screen =
        |kind: &ResourceKind| matches!(kind, ResourceKind::Image { extent: ImageExtent::Screen { .. }, .. });
    plan.resources.iter().filter(|resource| is_of_screen(&resource.kind)).count() as u64
}

/// What is done to a session between two frames.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Change {
    Nothing,
    Camera,
    Size,
    Parameter,
    /// A parameter of a pass that goes on from what another one left.
    Bounce,
    Lamp,
    Sky,
    Ball,
}

const CHANGES: [Change; 10] = [
    Change::Camera,
    Change::Parameter,
    Change::Lamp,
    Change::Bounce,
    Change::Camera,
    Change::Ball,
    Change::Nothing,
    Change::Size,
    Change::Sky,
    Change::Camera,
];

#[test]
fn a_hundred_frames_compile_nothing_and_upload_what_has_changed() {
    let (mut scene, mut request) = (scene(), request("isotropic"));
    scene.sky = Vec3::splat(0.1);
    request.set = vec![("bounce".into(), "bounces".into(), Value::Number(1.0))];
    let mut camera = scene.cameras[0].clone();
    let mut renderer = Renderer::new(gpu(), plan_for(&gi(), &scene, &request), &scene).unwrap();
    let (passes, _) = frame(&mut renderer, &camera);
    assert_eq!(passes.len(), renderer.plan().passes.len());
    for number in 0..100_u32 {
        let change = CHANGES[number as usize % CHANGES.len()];
        let before = renderer.session().counters();
        match change {
            Change::Nothing => {}
            Change::Camera => camera.eye.x += 0.01,
            Change::Size => {
                request.screen = [20 + number % 7, 12 + number % 5];
                renderer.session_mut().resize(request.screen[0], request.screen[1]).unwrap();
            }
            Change::Parameter | Change::Bounce => {
                let pass = if change == Change::Bounce { "bounce" } else { "diffuse" };
                let value = Value::Number(1.0 - f64::from(number) / 200.0);
                renderer.session_mut().set(pass, "step", &value).unwrap();
                request.set.retain(|(of, name, _)| (of.as_str(), name.as_str()) != (pass, "step"));
                request.set.push((pass.into(), "step".into(), value));
            }
            Change::Lamp => scene.lights[1].intensity *= 1.01,
            Change::Sky => scene.sky *= 1.01,
            Change::Ball => scene.set_time(f64::from(number) / 50.0),
        }
        renderer.update(&scene).unwrap();
        let (passes, _) = frame(&mut renderer, &camera);
        let cost = renderer.session().counters() - before;
        assert_eq!(cost.passes, passes.len() as u64);
        costs_what_it_must(change, &passes, cost, renderer.plan());
        if number % 9 == 8 || number == 99 {
            is_as_anew(&renderer, &scene, &camera, &request);
        }
    }
}

fn costs_what_it_must(change: Change, passes: &[String], cost: Counters, plan: &Plan) {
    let what = format!("{change:?}: {passes:?} {cost:?}");
    let ran = |name: &str| passes.iter().any(|pass| pass == name);
    assert_eq!((cost.modules, cost.pipelines, cost.buffers), (0, 0, 0), "{what}");
    assert!(!ran("voxelize static"), "{what}");
    assert_eq!(ran("voxelize"), change == Change::Ball, "{what}");
    let lit = matches!(change, Change::Ball | Change::Lamp | Change::Sky);
    assert_eq!(ran("light"), lit, "{what}");
    assert_eq!(ran("composite"), change != Change::Nothing, "{what}");
    if change == Change::Size {
        // The camera's uniform has the screen's size.
        assert_eq!((cost.textures, cost.uploads), (screen_images(plan), 1), "{what}");
        assert!(cost.bind_groups > 0, "{what}");
        return;
    }
    assert_eq!((cost.textures, cost.bind_groups), (0, 0), "{what}");
    let (uploads, bytes) = match change {
        Change::Nothing => (0, 0),
        Change::Camera => (1, 144),
        Change::Parameter | Change::Bounce => (1, 4),
        Change::Lamp => (1, 3 * 128),
        Change::Sky => (1, 16),
        // Vertices and triangles of the ball.
        Change::Ball => (2, cost.uploaded_bytes),
        Change::Size => unreachable!(),
    };
    assert_eq!((cost.uploads, cost.uploaded_bytes), (uploads, bytes), "{what}");
    match change {
        Change::Nothing => assert!(passes.is_empty(), "{what}"),
        Change::Parameter => assert_eq!(passes, ["diffuse", "composite"], "{what}"),
        Change::Bounce => assert!(ran("filter") && ran("bounce") && !ran("gbuffer"), "{what}"),
        _ => {}
    }
}

#[test]
fn another_plan_compiles_what_no_plan_before_had() {
    let (scene, camera) = (scene(), scene().cameras[0].clone());
    let plan = |format: &str| plan_for(&gi(), &scene, &request(format));
    let mut renderer = Renderer::new(gpu(), plan("isotropic"), &scene).unwrap();
    frame(&mut renderer, &camera);
    let all = renderer.session().counters();
    let mut replanned = |request: &Request| {
        let before = renderer.session().counters();
        renderer.session_mut().replan(plan_for(&gi(), &scene, request), &scene).unwrap();
        let (passes, _) = frame(&mut renderer, &camera);
        assert_eq!(passes.len(), renderer.plan().passes.len());
        is_as_anew(&renderer, &scene, &camera, request);
        renderer.session().counters() - before
    };
    let six = replanned(&request("six_face"));
    assert!(six.pipelines > 0 && six.pipelines < all.pipelines, "{six:?} of {all:?}");
    let coarse = replanned(&Request { resolution: Some(16), ..request("six_face") });
    let back = replanned(&request("isotropic"));
    assert_eq!((coarse.modules, back.modules, back.pipelines), (0, 0, 0), "{coarse:?} {back:?}");
    // Nothing of the scene but what is relative to the grid's centre, which stays here.
    let vertices = scene.meshes.iter().map(|mesh| mesh.positions.len() as u64 * 32).sum::<u64>();
    assert!(back.uploaded_bytes < vertices / 10, "{back:?}, vertices {vertices}");
}

/// What a session refuses, and that it goes on as if it had not been asked.
fn refuses(renderer: &mut Renderer<'_>, what: impl FnOnce(&mut Renderer<'_>) -> Error, message: &str) {
    let scene = scene();
    let before = picture(renderer, "final");
    let error = what(renderer);
    assert_eq!(error.to_string(), message);
    renderer.render(&scene, &scene.cameras[0], Passes::All).unwrap();
    assert!(picture(renderer, "final") == before, "{message}");
}

#[test]
fn what_cannot_be_is_refused_and_nothing_is_half_done() {
    let scene = scene();
    let mut renderer = render(&gi(), &scene, &request("isotropic"));
    let limit = gpu().device.limits().max_texture_dimension_2d;
    for [width, height] in [[0, 16], [24, 0], [limit + 1, 16], [24, u32::MAX]] {
        let message = format!("an image of {width} × {height} pixels: each side must be from 1 to {limit}");
        refuses(&mut renderer, |r| r.session_mut().resize(width, height).unwrap_err(), &message);
    }
    let (voxels, cells) = renderer.counts();
    let mut plan = renderer.plan().clone();
    let room = plan.total_bytes(voxels + voxels / 4 + 256, cells + cells / 4 + 256);
    plan.memory_budget = Some(room);
    renderer.session_mut().replan(plan, &scene).unwrap();
    renderer.render(&scene, &scene.cameras[0], Passes::Changed).unwrap();
    let before = picture(&renderer, "final");
    let error = renderer.session_mut().resize(100, 100).unwrap_err();
    assert!(matches!(error, Error::OverBudget { budget, .. } if budget == room), "{error}");
    renderer.render(&scene, &scene.cameras[0], Passes::All).unwrap();
    assert!(picture(&renderer, "final") == before);
    let set = |pass: &'static str, name: &'static str, value: Value| {
        move |r: &mut Renderer<'_>| r.session_mut().set(pass, name, &value).unwrap_err()
    };
    let number = Value::Number(1.0);
    refuses(
        &mut renderer,
        set("difuse", "step", number.clone()),
        "error: no pass of the plan is called `difuse`
 = did you mean `diffuse`? one of: voxelize static, voxelize, shadow_maps, light, filter, gbuffer, traced_shadow, soft_shadow, diffuse, specular, composite",
    );
    for (pass, name, value) in [
        ("diffuse", "stepp", number.clone()),
        ("diffuse", "step", Value::Number(-1.0)),
        ("diffuse", "step", Value::Number(f64::NAN)),
        ("diffuse", "step", Value::Word("long".into())),
        ("composite", "ao_weight", number),
    ] {
        let before = picture(&renderer, "final");
        assert!(
            matches!(renderer.session_mut().set(pass, name, &value), Err(Error::Fault(_))),
            "{pass}.{name}"
        );
        renderer.render(&scene, &scene.cameras[0], Passes::All).unwrap();
        assert!(picture(&renderer, "final") == before, "{pass}.{name}");
    }
}

#[test]
fn another_scene_is_refused() {
    let good = scene();
    let mut renderer = render(&gi(), &good, &request("isotropic"));
    let ball = good.instances.iter().position(|instance| instance.moving).unwrap();
    let mut cases: Vec<(Scene, &str)> = Vec::new();
    let mut case = |change: &dyn Fn(&mut Scene), message| {
        let mut scene = good.clone();
        change(&mut scene);
        cases.push((scene, message));
    };
    let other = "this is another scene than the one that was planned for: ";
    case(&|s| s.lights.truncate(2), "it has 2 lights instead of 3");
    case(&|s| s.lights[1] = s.lights[2].clone(), "it has 0 point lights instead of 1");
    case(&|s| s.instances.truncate(3), "it has 6 triangles instead of 8210");
    case(&|s| s.instances[0].transform.translation.y = 1.0, "`floor` has moved and is not marked as moving");
    case(&|s| s.sky = Vec3::ONE, "its sky shines, and was dark");
    case(
        &|s| s.instances[ball].transform.translation.x = f64::NAN,
        "error: instance 3, `ball`: its transform is not finite",
    );
    case(&|s| s.instances[0].mesh = 99, "error: instance 0, `floor`: it names mesh 99 of 7");
    case(&|s| s.instances[ball].transform.translation.x = 1e16, "error: `ball` reaches beyond 1e15 units");
    for (scene, message) in cases {
        let message = if message.starts_with("error") { message.into() } else { other.to_owned() + message };
        refuses(&mut renderer, |r| r.update(&scene).unwrap_err(), &message);
        let plan = plan_for(&gi(), &good, &request("six_face"));
        refuses(&mut renderer, |r| r.session_mut().replan(plan, &scene).unwrap_err(), &message);
    }
}

#[test]
fn frames_that_cannot_be_are_refused() {
    let scene = scene();
    let mut renderer = render(&gi(), &scene, &request("isotropic"));
    let encode = |camera: Camera, demanded: &'static [&'static str]| {
        move |r: &mut Renderer<'_>| {
            let mut encoder = gpu().device.create_command_encoder(&Default::default());
            let frame = Frame { demanded, ..Frame::of(&camera) };
            r.session_mut().encode(&mut encoder, &frame).unwrap_err()
        }
    };
    let camera = scene.cameras[0].clone();
    let blind = Camera { forward: Vec3::NAN, ..camera.clone() };
    let message = "error: camera `front`: `forward` must be of length 1";
    refuses(&mut renderer, encode(blind, &[]), message);
    let timeless = |r: &mut Renderer<'_>| {
        r.frame(&Frame { seconds: f32::NAN, ..Frame::of(&scene.cameras[0]) }).unwrap_err()
    };
    refuses(&mut renderer, timeless, "error: a frame at NaN seconds\n = a finite time");
    let names: Vec<String> = renderer.plan().passes.iter().map(|pass| pass.name.clone()).collect();
    let message = format!("no pass is called `lights`; there is: {}", names.join(", "));
    refuses(&mut renderer, encode(camera, &["lights"]), &message);
    // More than a plan may take, known once its voxels are counted.
    let plan = plan_for(&gi(), &scene, &request("six_face"));
    let bytes = plan.total_bytes(0, 0);
    let plan = Plan { memory_budget: Some(bytes + 1000), ..plan };
    let before = picture(&renderer, "final");
    let error = renderer.session_mut().replan(plan, &scene).unwrap_err();
    assert!(matches!(error, Error::OverBudget { .. }), "{error}");
    let budget = Plan { memory_budget: Some(bytes + 1000), ..renderer.plan().clone() };
    assert!(Renderer::new(gpu(), budget, &scene).is_err());
    renderer.render(&scene, &scene.cameras[0], Passes::Changed).unwrap();
    assert!(picture(&renderer, "final") == before);
}

#[test]
fn voxels_outgrow_their_memory_without_anybody_waiting() {
    let mut scene = scene();
    let keys = [(0.0, 0.01), (1.0, 3.0)].map(|(time, scale)| Key {
        time,
        scale: DVec3::splat(scale),
        rotation: DQuat::IDENTITY,
        translation: DVec3::ZERO,
    });
    scene.animation.instances[0].path = Path { keys: keys.to_vec() };
    scene.set_time(0.0);
    let (request, camera) = (request("isotropic"), scene.cameras[0].clone());
    let mut renderer = Renderer::new(gpu(), plan_for(&gi(), &scene, &request), &scene).unwrap();
    frame(&mut renderer, &camera);
    gpu().wait().unwrap();
    let few = renderer.counts();
    scene.set_time(1.0);
    renderer.update(&scene).unwrap();
    frame(&mut renderer, &camera);
    gpu().wait().unwrap();
    let (passes, cost) = frame(&mut renderer, &camera);
    assert!(renderer.counts().0 > few.0 + few.0 / 4 + 256, "{few:?} {:?}", renderer.counts());
    assert_eq!(passes.len(), renderer.plan().passes.len());
    assert_eq!((cost.modules, cost.pipelines), (0, 0));
    is_as_anew(&renderer, &scene, &camera, &request);
    gpu().wait().unwrap();
    assert!(frame(&mut renderer, &camera).0.is_empty());
}

#[test]
fn a_frame_that_was_never_submitted() {
    let (mut scene, request) = (scene(), request("isotropic"));
    let camera = scene.cameras[0].clone();
    let mut renderer = Renderer::new(gpu(), plan_for(&gi(), &scene, &request), &scene).unwrap();
    frame(&mut renderer, &camera);
    scene.set_time(1.5);
    renderer.update(&scene).unwrap();
    let mut encoder = gpu().device.create_command_encoder(&Default::default());
    renderer.session_mut().encode(&mut encoder, &Frame::of(&camera)).unwrap();
    drop(encoder);
    renderer.session_mut().forget();
    let (passes, _) = frame(&mut renderer, &camera);
    assert_eq!(passes.len(), renderer.plan().passes.len());
    is_as_anew(&renderer, &scene, &camera, &request);
}

/// `pipelines/gi.ron` with one text in place of another, and an effect beside it.
fn gi_with(folder: &std::path::Path, from: &str, to: &str) -> Pipeline {
    let text = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
    assert!(text.contains(from), "{from}");
    std::fs::write(folder.join("sum.wgsl"), SUM).unwrap();
    let path = folder.join("pipeline.ron");
    std::fs::write(&path, text.replacen(from, to, 1)).unwrap();
    Pipeline::load(&path).unwrap_or_else(|faults| panic!("{faults}"))
}

#[test]
fn a_pass_runs_as_seldom_as_its_entry_says() {
    let mut scene = scene();
    let camera = scene.cameras[0].clone();
    let folder = tempfile::tempdir().unwrap();
    for (update, often) in [("(every: 3)", vec![2, 5, 8]), ("on_demand", vec![4])] {
        let pipeline =
            gi_with(folder.path(), "run: \"light\",", &format!("run: \"light\", update: {update},"));
        let plan = plan_for(&pipeline, &scene, &request("isotropic"));
        let mut renderer = Renderer::new(gpu(), plan, &scene).unwrap();
        renderer.render(&scene, &camera, Passes::Changed).unwrap();
        let mut ran = Vec::new();
        for number in 0..10 {
            scene.lights[1].intensity *= 1.1;
            renderer.update(&scene).unwrap();
            let demanded: &[&str] = if number == 4 { &["light"] } else { &[] };
            let times = renderer.frame(&Frame { demanded, ..Frame::of(&camera) }).unwrap();
            let is_run = |name: &str| times.iter().any(|time| time.name == name);
            assert_eq!(is_run("filter"), is_run("light"), "{update}, frame {number}");
            assert!(is_run("soft_shadow") && !is_run("voxelize"), "{update}, frame {number}");
            ran.extend(is_run("light").then_some(number));
        }
        assert_eq!(ran, often, "{update}");
    }
}

/// The sum of a parameter over all frames, and the frame's number.
const SUM: &str = "import package::common::clock::clock;
import package::common::surface::Surface;

struct Params {
    /// What each frame adds, [0, 10].
    each: f32,
}

var sum_last: texture_2d_array<f32>;

fn effect(surface: Surface, params: Params) -> vec4f {
    return vec4f(textureLoad(sum_last, surface.pixel, 0, 0).r + params.each, f32(clock.frame), clock.seconds, 0.0);
}
";

#[test]
fn last_values_begin_anew_with_another_size() {
    let entry = "passes: [(run: \"sum.wgsl\", reads: [\"surface\", \"sum.last\"], writes: [\"sum\"], texel: \"rgba32float\", params: (each: 1)),";
    let folder = tempfile::tempdir().unwrap();
    let (scene, pipeline) = (scene(), gi_with(folder.path(), "passes: [", entry));
    let camera = &scene.cameras[0];
    let plan = |output: &str| {
        plan_for(&pipeline, &scene, &Request { output: Some(output.into()), ..request("isotropic") })
    };
    let mut renderer = Renderer::new(gpu(), plan("sum"), &scene).unwrap();
    let sums = |renderer: &mut Renderer<'_>, frames: u32| {
        for number in 1..=frames {
            let seconds = 0.25 * number as f32;
            renderer.frame(&Frame { seconds, ..Frame::of(camera) }).unwrap();
            let image = picture(renderer, "sum");
            let most = image.pixels.iter().map(|pixel| pixel[0]).fold(0.0, f32::max);
            let seen = image.pixels.iter().find(|pixel| pixel[0] > 0.0).unwrap();
            assert_eq!((most, &seen[1..3]), (number as f32, &[number as f32 - 1.0, seconds][..]));
        }
    };
    sums(&mut renderer, 3);
    renderer.session_mut().resize(20, 20).unwrap();
    sums(&mut renderer, 2);
    renderer.session_mut().resize(20, 20).unwrap();
    let before = renderer.session().counters();
    renderer.frame(&Frame::of(camera)).unwrap();
    renderer.frame(&Frame::of(camera)).unwrap();
    let cost = renderer.session().counters() - before;
    // Both sets of bind groups are there.
    assert_eq!((cost.bind_groups, cost.textures, cost.passes), (0, 0, 2), "{cost:?}");
    renderer.session_mut().replan(plan("sum"), &scene).unwrap();
    sums(&mut renderer, 3);
}
