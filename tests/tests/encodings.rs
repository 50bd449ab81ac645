//! Encodings and options of storage formats, on the device.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{Encodings, Formats, Renderer, Request, ResourceKind, Scene, Value};
use voxlume_tests::{built_in, gi, gpu, picture, plan_for, render};

/// Every word of a format: its defaults, and each other word of each of its options.
fn words(formats: &Formats) -> Vec<String> {
    let of = |format: &dyn voxlume::StorageFormat| {
        let options = format.options().iter().flat_map(|option| {
            option.words[1..].iter().map(|word| format!("{}:{}={word}", format.name(), option.name))
        });
        std::iter::once(format.name().to_owned()).chain(options).collect::<Vec<_>>()
    };
    formats.iter().flat_map(of).collect()
}

fn request(format: &str, encoding: &str, resolution: u32) -> Request {
    Request {
        format: Some(format.into()),
        encoding: Some(encoding.into()),
        // Rays read no volume.
        tracer: Some("cones".into()),
        resolution: Some(resolution),
        output: Some("diffuse".into()),
        ..Request::image(24, 24)
    }
}

/// What the device holds is what the format says and what the plan says.
#[test]
fn bytes_are_those_that_are_said() {
    let scene = built_in("cornell.ron");
    let words = ["isotropic", "six_face", "six_face:base=cosine", "sh2", "sh2:base=lobe"];
    for resolution in [16, 32] {
        for word in words {
            for encoding in Encodings::builtin().iter() {
                let plan = plan_for(&gi(), &scene, &request(word, &encoding.to_string(), resolution));
                let renderer = Renderer::new(gpu(), plan, &scene).unwrap();
                let plan = renderer.plan();
                let is_volume = |(index, _): &(usize, &voxlume::Resource)| {
                    matches!(plan.resources[*index].kind, ResourceKind::Volume { .. })
                };
                let planned: Vec<(String, u64)> = (plan.resources.iter().enumerate().filter(is_volume))
                    .map(|(index, resource)| (resource.name.clone(), plan.bytes(index, 0, 0).unwrap()))
                    .collect();
                let held: Vec<(String, u64)> = planned
                    .iter()
                    .map(|(name, _)| {
                        let texture = renderer.texture(name).unwrap();
                        let texels = (0..texture.mip_level_count()).map(|mip| {
                            let size = texture.size().mip_level_size(mip, texture.dimension());
                            u64::from(size.width)
                                * u64::from(size.height)
                                * u64::from(size.depth_or_array_layers)
                        });
                        let texel = u64::from(texture.format().block_copy_size(None).unwrap());
                        (name.clone(), texels.sum::<u64>() * texel)
                    })
                    .collect();
                assert_eq!(held, planned, "{word} {encoding} {resolution}");
                let told: Vec<_> = renderer
                    .bytes()
                    .into_iter()
                    .filter(|(name, _)| held.iter().any(|h| h.0 == *name))
                    .collect();
                assert_eq!(told, planned, "{word} {encoding} {resolution}");
            }
        }
    }
}

fn means(scene: &Scene, request: &Request) -> [f64; 3] {
    let picture = picture(&render(&gi(), scene, request), "diffuse");
    assert!(picture.pixels.iter().flatten().all(|value| value.is_finite()));
    let mean = |i: usize| picture.pixels.iter().map(|p| f64::from(p[i])).sum::<f64>();
    [0, 1, 2].map(|i| mean(i) / picture.pixels.len() as f64)
}

/// Encodings differ by their rounding; filtering in hardware and by hand differ by the filter's.
#[test]
fn encodings_agree_up_to_their_rounding() {
    let scene = built_in("cornell.ron");
    for word in words(&Formats::builtin()) {
        let filters_float32 = gpu().filters_float32();
        let of = |encoding: &str, filters_float32: bool| {
            means(&scene, &Request { filters_float32, ..request(&word, encoding, 32) })
        };
        let exact = of("rgba32float", filters_float32);
        let differs = |other: [f64; 3]| {
            exact.iter().zip(other).map(|(a, b)| (b - a).abs() / exact[0]).fold(0.0, f64::max)
        };
        // Half floats round by 2⁻¹¹ of each of a few values that add up.
        let half = differs(of("rgba16float", false));
        assert!(half < 2e-3, "{word}: {half}");
        // Steps of range/255, of range/127 in the two bands: figures measured (0.025 and 0.065), to notice a change for
        // the worse.
        let bytes = differs(of("rgba8:range=1.5", false));
        assert!(bytes < if word.starts_with("sh2") { 0.08 } else { 0.03 }, "{word}: {bytes}");
        // A filter's weights have 8 bits at least; where the device has more, as here, nothing is left.
        let by_hand = if word.contains(':') { 0.0 } else { differs(of("rgba32float", false)) };
        assert!(by_hand < 4e-3, "{word}: {by_hand}");
        println!("{word}: half {half:.5}, bytes {bytes:.4}, by hand {by_hand:.6}");
    }
}

/// What is beyond the range is clamped and counted, never wrapped; what is within is not counted.
#[test]
fn out_of_range_is_counted() {
    let scene = built_in("cornell.ron");
    let out_of_range = |encoding: &str| {
        let renderer = render(&gi(), &scene, &request("isotropic", encoding, 32));
        renderer.out_of_range().unwrap()
    };
    assert_eq!(out_of_range("rgba8:range=4"), None);
    assert_eq!(out_of_range("rgba16float"), None);
    let few = out_of_range("rgba8:range=0.5").expect("the wall beside the light is brighter");
    let many = out_of_range("rgba8:range=0.1").expect("most walls are brighter");
    assert!(many.values > few.values && few.values > 0, "{many} {few}");
    assert_eq!(few.worst, many.worst);
    assert!(few.worst > 0.5 && few.worst < 4.0, "{few}");
}

/// Radiance beyond half floats ends at the largest of them, and is counted.
#[test]
fn half_floats_never_hold_infinity() {
    let scene = built_in("furnace.ron");
    let mut bright = scene.clone();
    bright.materials.iter_mut().for_each(|material| material.emission *= 1e6);
    let mut request = request("isotropic", "rgba16float", 16);
    request.set = vec![("light".into(), "emission".into(), Value::Word("gather".into()))];
    let renderer = render(&gi(), &bright, &request);
    assert!(renderer.out_of_range().unwrap().unwrap().worst >= 1e6);
    let picture = picture(&renderer, "diffuse");
    assert!(picture.pixels.iter().flatten().all(|value| !value.is_nan()));
}
