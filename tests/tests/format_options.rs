//! What formats' options do, where it is known on paper.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{Request, Value};
use voxlume_tests::{built_in, gi, gpu, noise_volume, picture, render, run_kernel};

const OUT: &str = "var<storage, read_write> out: array<f32>;\n";

fn kernel(imports: &str, body: &str) -> String {
    format!(
        "{imports}\n{OUT}@compute @workgroup_size(256)\nfn main(@builtin(local_invocation_index) i: u32) {{ {body} }}"
    )
}

fn mounts(format: &str) -> [(&str, &str); 3] {
    [("format", format), ("encoding", "encoding/rgba16float"), ("filter", "filter/hardware")]
}

/// Sixteen loads give what the sampler gives, between texels and between levels.
#[test]
fn filtering_by_hand_is_filtering() {
    if !gpu().filters_float32() {
        println!("skipped: the device doesn't filter 32-bit floats");
        return;
    }
    let text = kernel(
        "import package::common::volume::sample_volume;\nvar volume: texture_3d<f32>;",
        "let r = fract(f32(i) * vec4f(0.7548777, 0.5698403, 0.3819660, 0.2360680));
        out[i] = sample_volume(volume, r.xyz * 1.2 - 0.1, r.w * 5.0 - 0.5).x;",
    );
    let volume = noise_volume(8);
    let mounts = |filter| [("encoding", "encoding/rgba32float"), ("filter", filter)];
    let sample = |filter| run_kernel(&text, &mounts(filter), &[], Some(&volume), 256);
    let (device, by_hand) = (sample("filter/hardware"), sample("filter/by_hand"));
    for (i, (a, b)) in device.iter().zip(&by_hand).enumerate() {
        // Filters have 8 bits for the place between texels or levels, of values in [0, 1].
        assert!((a - b).abs() < 4.0 / 256.0, "{i}: {a} {b}");
    }
    assert!(device.iter().any(|value| (value - device[0]).abs() > 0.2));
}

/// Of eight equal children, the projection keeps band 0 and 2/3 of band 1 (RAU eq. 5.9 over π); of one alone, what it
/// sends through faces at a slant becomes band 1 of the parent.
#[test]
fn projection_shrinks_band_one_by_a_third() {
    let text = kernel(
        "import package::format::cell::Cell;\nimport package::format::project::project_child;",
        "var sum: array<vec3f, 4>;
        if (i > 0) { return; }
        var c = Cell();
        c.band0 = vec3f(1.0, 0.0, 1.0);
        c.band1 = mat3x3f(vec3f(0.0, 1.0, 0.5), vec3f(0.0, 0.0, 0.25), vec3f(0.0));
        for (var child = 0u; child < 8; child++) {
            let offset = vec3u(child & 1, (child >> 1) & 1, child >> 2);
            let sent = project_child(c, 1.0 - 2.0 * vec3f(offset));
            sum[0] += sent.band0 / 8.0;
            for (var k = 0; k < 3; k++) { sum[k + 1] += sent.band1[k] / 8.0; }
            if (child == 0) {
                out[12] = sent.band0.x;
                for (var k = 0; k < 3; k++) { out[13 + k] = sent.band1[k].x; }
            }
        }
        for (var k = 0; k < 12; k++) { out[k] = sum[k / 3][k % 3]; }",
    );
    let out = run_kernel(&text, &mounts("format/sh2"), &[], None, 16);
    // Band 0, then x, y, z; of each the three channels: band 0 alone, x alone, 1, ½ and ¼ together.
    let expected = [1.0, 0.0, 1.0, 0.0, 2.0 / 3.0, 1.0 / 3.0, 0.0, 0.0, 1.0 / 6.0, 0.0, 0.0, 0.0];
    for (got, expected) in out.iter().zip(expected) {
        // RAU gives the solid angles to 7 digits.
        assert!((got - expected).abs() < 1e-6, "{out:?}");
    }
    let alone = &out[12..];
    // By hand: (near·(−1 + 1 + 1)/√3 + far·(3 + 1 + 1)/√11) · 2/3 / π, away from the child.
    assert!(
        (alone[0] - 1.0).abs() < 1e-6 && alone[1..].iter().all(|x| (x - 0.725_36).abs() < 1e-5),
        "{out:?}"
    );
}

/// A one-sided emitter's bands are 0.5 and 0.75: 2/3 of band 1 leaves 1 ahead and 0 behind.
#[test]
fn the_window_is_two_thirds_of_a_lobe() {
    let text = kernel(
        "import package::format::bands::window;",
        "let share = window(vec3f(0.5, 0.5, 0.0), vec3f(0.75, 0.25, 0.5));
        out[0] = share.x; out[1] = share.y; out[2] = share.z;",
    );
    let of = |word: f64| run_kernel(&text, &mounts("format/sh2"), &[("NEGATIVES", word)], None, 3);
    assert_eq!(of(1.0), [2.0 / 3.0, 1.0, 0.0]);
    assert_eq!(of(0.0), [1.0; 3]);
}

/// Weights of the six faces for a normal.
fn face_weights(base: f64, normal: &str) -> Vec<f32> {
    let body = format!("if (i < 6) {{ out[i] = face_weight({normal}, i); }}");
    let text = kernel("import package::format::store::face_weight;", &body);
    run_kernel(&text, &mounts("format/six_face"), &[("BASE", base)], None, 6)
}

#[test]
fn faces_get_their_share_of_a_normal() {
    // Faces +x, −x, +y, −y, +z, −z.
    let slanted = "vec3f(0.6, -0.8, 0.0)";
    let near = |got: Vec<f32>, expected: [f32; 6]| {
        // 0.6 and 0.8 are no binary fractions.
        assert!(got.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6), "{got:?}");
    };
    near(face_weights(1.0, slanted), [0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    near(face_weights(2.0, slanted), [0.36, 0.0, 0.0, 0.64, 0.0, 0.0]);
    near(face_weights(3.0, slanted), [0.6, 0.0, 0.0, 0.8, 0.0, 0.0]);
    // Opposite surfaces cancel: both sides show.
    for base in [1.0, 2.0, 3.0] {
        near(face_weights(base, "vec3f(0.0)"), [1.0; 6]);
    }
    // Of equals the first.
    near(face_weights(1.0, "vec3f(0.577, 0.577, 0.577)"), [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
}

/// Levels over occupied voxels alone are those over all cells.
#[test]
fn active_cells_are_enough() {
    for format in ["isotropic", "six_face", "sh2"] {
        let of = |cells: &str| {
            let request = Request {
                format: Some(format.into()),
                resolution: Some(32),
                output: Some("diffuse".into()),
                set: vec![("filter".into(), "cells".into(), Value::Word(cells.into()))],
                ..Request::image(16, 16)
            };
            picture(&render(&gi(), &built_in("cornell.ron"), &request), "diffuse")
        };
        assert_eq!(of("active"), of("all"), "{format}");
    }
}
