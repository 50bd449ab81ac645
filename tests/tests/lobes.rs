//! The directions of rays against integrals in `f64`: each lobe is covered as its weight says, and more rays come nearer.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::f64::consts::PI;

use glam::DVec3;
use voxlume::{Library, Passes, Pipeline, RAYS, Renderer, Request, Source, Value};
use voxlume_tests::{built_in, gpu, picture, plan_for, root, run_kernel_of};

/// Directions of each lobe: the sets of 64 neighbours, of 64 rays each.
const COUNT: usize = 64 * 64;

const KERNEL: &str = "
import package::common::trace::{Lobe, Share};
import package::tracer::lobe::lobe_direction;

struct Case {
    axis: vec3f,
    shape: u32,
    view: vec3f,
    width: f32,
}

var<storage, read> cases: array<Case>;
var<storage, read_write> out: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) lane: u32) {
    for (var c = 0u; c < arrayLength(&cases); c++) {
        let lobe = Lobe(cases[c].shape, cases[c].axis, cases[c].view, cases[c].width);
        for (var i = 0u; i < 64; i++) {
            let direction = lobe_direction(lobe, i, Share(lane, 64));
            for (var k = 0u; k < 3; k++) {
                out[3 * ((c * 64 + lane) * 64 + i) + k] = direction[k];
            }
        }
    }
}
";

/// A function of the direction that is averaged over a lobe, with its name.
type Moment = (&'static str, fn(DVec3) -> f64);

/// A lobe as wgsl/common/trace.wgsl numbers them.
#[derive(Clone, Copy, Debug)]
enum Lobe {
    Cone(f64),
    Hemisphere,
    /// Perceptual roughness, and the angle of the view with the normal.
    Ggx(f64, f64),
}

/// The view of a lobe about +z.
fn view(lobe: Lobe) -> DVec3 {
    match lobe {
        Lobe::Ggx(_, angle) => DVec3::new(angle.sin(), 0.0, angle.cos()),
        _ => DVec3::Z,
    }
}

/// Mean over the lobe about +z, by a fine product grid over the sphere.
fn integral(lobe: Lobe, value: impl Fn(DVec3) -> f64) -> f64 {
    let (rings, sectors) = (2000, 720);
    let (mut sum, mut weight) = (0.0, 0.0);
    for ring in 0..rings {
        // Denser about the axis, where narrow lobes are.
        let angle = PI / 2.0 * ((f64::from(ring) + 0.5) / f64::from(rings)).powi(2);
        let band = angle.sin() * 2.0 * (angle * PI / 2.0).sqrt();
        for sector in 0..sectors {
            let azimuth = 2.0 * PI * (f64::from(sector) + 0.5) / f64::from(sectors);
            let m = DVec3::new(angle.sin() * azimuth.cos(), angle.sin() * azimuth.sin(), angle.cos());
            let (direction, density) = match lobe {
                Lobe::Cone(sine) => (m, f64::from(angle.sin() <= sine)),
                Lobe::Hemisphere => (m, m.z),
                Lobe::Ggx(roughness, _) => {
                    // Normals that the viewer sees (Heitz 2018, eq. 1 to 3), but for factors that all share.
                    let (v, a) = (view(lobe), roughness * roughness);
                    let d = (m.x * m.x / (a * a) + m.y * m.y / (a * a) + m.z * m.z).powi(-2);
                    (2.0 * v.dot(m) * m - v, d * v.dot(m).max(0.0))
                }
            };
            sum += band * density * value(direction);
            weight += band * density;
        }
    }
    sum / weight
}

#[test]
fn directions_cover_their_lobes() {
    let lobes = [
        Lobe::Cone(0.05),
        Lobe::Cone(0.5),
        Lobe::Cone(0.9),
        Lobe::Hemisphere,
        Lobe::Ggx(0.3, 0.2),
        Lobe::Ggx(0.5, 1.2),
        Lobe::Ggx(0.9, 0.7),
        Lobe::Ggx(1.0, 1.5),
    ];
    let cases: Vec<u8> = lobes
        .iter()
        .flat_map(|lobe| {
            let (shape, width) = match *lobe {
                Lobe::Cone(sine) => (0u32, sine),
                Lobe::Hemisphere => (1, 1.0),
                Lobe::Ggx(roughness, _) => (2, roughness),
            };
            let v = view(*lobe).as_vec3();
            [0.0, 0.0, 1.0, f32::from_bits(shape), v.x, v.y, v.z, width as f32]
        })
        .flat_map(f32::to_le_bytes)
        .collect();
    let params: Vec<u8> = [64u32, 0, 0, 0].iter().flat_map(|word| word.to_le_bytes()).collect();
    let inputs: [(&str, &[u8]); 2] = [("cases", &cases), ("trace_params", &params)];
    let mounts = [("tracer", RAYS.modules)];
    let values =
        run_kernel_of(&Library::builtin(), KERNEL, &mounts, &[], (None, &inputs), 3 * COUNT * lobes.len());
    for (lobe, values) in lobes.iter().zip(values.chunks(3 * COUNT)) {
        let directions: Vec<DVec3> =
            values.chunks_exact(3).map(|v| DVec3::new(v[0].into(), v[1].into(), v[2].into())).collect();
        assert!(directions.iter().all(|direction| (direction.length() - 1.0).abs() < 1e-4), "{lobe:?}");
        let moments: [Moment; 5] = [
            ("x", |d| d.x),
            ("y", |d| d.y),
            ("z", |d| d.z),
            ("z²", |d| d.z * d.z),
            ("x² − y²", |d| d.x * d.x - d.y * d.y),
        ];
        for (name, moment) in moments {
            let mean = directions.iter().map(|direction| moment(*direction)).sum::<f64>() / COUNT as f64;
            let expected = integral(*lobe, moment);
            // 4096 directions of a sequence: far less than the 0.016 of as many random ones.
            assert!((mean - expected).abs() < 0.003, "{lobe:?}: mean {name} is {mean:.4}, not {expected:.4}");
        }
    }
}

/// With four times as many rays, an image is at least 1.8 times as near to that of very many.
#[test]
fn more_rays_come_nearer() {
    let scene = built_in("cornell.ron");
    let image = |rays: u32| {
        let text = std::fs::read_to_string(root().join("pipelines/gi.ron")).unwrap();
        let text = text.replace("interleave: 4,", "").replace("interleave: 8,", "");
        let pipeline = Pipeline::parse(&Source::new("gi.ron", text)).unwrap();
        let request = Request {
            resolution: Some(32),
            output: Some("ao".into()),
            set: vec![("ambient_occlusion".into(), "rays".into(), Value::Number(rays.into()))],
            ..Request::image(24, 24)
        };
        let mut renderer = Renderer::new(gpu(), plan_for(&pipeline, &scene, &request), &scene).unwrap();
        renderer.render(&scene, &scene.cameras[0], Passes::All).unwrap();
        picture(&renderer, "ao").pixels
    };
    let very_many = image(256);
    let distance = |rays: u32| {
        let squares = image(rays).into_iter().zip(&very_many).map(|(a, b)| f64::from(a[0] - b[0]).powi(2));
        (squares.sum::<f64>() / very_many.len() as f64).sqrt()
    };
    let distances = [1, 4, 16, 64].map(distance);
    println!("{distances:?}");
    assert!(distances.windows(2).all(|pair| pair[0] > 1.8 * pair[1]), "{distances:?}");
}
