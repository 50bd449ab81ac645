//! A new encoding is WGSL and a description, and every format is stored in it by one word.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use voxlume::{Encoding, Formats, Passes, Registry, Renderer, Request, SceneFacts, Source, plan};
use voxlume_tests::{built_in, gi, gpu, picture};

/// Half floats of radiance over 1024: scenes in physical units may be as bright as 6.7·10⁷.
const BRIGHT: &str = "
import package::common::out_of_range::clamp_to_range;

alias VolumeTarget = texture_storage_3d<rgba16float, write>;
alias SignedVolumeTarget = texture_storage_3d<rgba16float, write>;

const SCALE = vec4f(1024.0, 1024.0, 1024.0, 1.0);

fn encode_texel(value: vec4f) -> vec4f {
    return clamp_to_range(value, 65504.0 * SCALE) / SCALE;
}

fn decode_texel(texel: vec4f) -> vec4f {
    return texel * SCALE;
}

fn encode_radiances(values: vec4f) -> vec4f {
    return clamp_to_range(values, vec4f(65504.0 * 1024.0)) / 1024.0;
}

fn decode_radiances(texel: vec4f) -> vec4f {
    return texel * 1024.0;
}
";

fn registry() -> Registry {
    let mut registry = Registry::builtin();
    let range = 65504.0 * 1024.0;
    let module = "encoding/bright16float";
    registry.encodings.add(Encoding { name: "bright16float", module, range, ..Encoding::RGBA16FLOAT });
    registry.library.insert(module, Source::new("bright16float.wgsl", BRIGHT));
    registry
}

/// The mean of diffuse light in the Cornell box, lit so many times as brightly, over that; and how many texels were out of range.
fn mean(format: &str, encoding: &str, times: f32) -> (f64, u32) {
    let mut scene = built_in("cornell.ron");
    scene.materials.iter_mut().for_each(|material| material.emission *= times);
    let request = Request {
        format: Some(format.into()),
        encoding: Some(encoding.into()),
        // Rays read no volume.
        tracer: Some("cones".into()),
        resolution: Some(32),
        output: Some("diffuse".into()),
        ..Request::image(24, 24)
    };
    let plan = plan(&gi(), &SceneFacts::of(&scene).unwrap(), &registry(), &request).unwrap();
    let mut renderer = Renderer::new(gpu(), plan, &scene).unwrap();
    renderer.render(&scene, &scene.cameras[0], Passes::All).unwrap();
    let out_of_range = renderer.out_of_range().unwrap().map_or(0, |out| out.values);
    let picture = picture(&renderer, "diffuse");
    let sum: f64 = picture.pixels.iter().map(|p| f64::from(p[0] + p[1] + p[2])).sum();
    (sum / picture.pixels.len() as f64 / f64::from(times), out_of_range)
}

#[test]
fn every_format_is_stored_in_it() {
    for format in Formats::builtin().iter() {
        let (half, _) = mean(format.name(), "rgba16float", 1.0);
        let (bright, _) = mean(format.name(), "bright16float", 1.0);
        println!("{}: {half:.5}, {bright:.5}", format.name());
        // Radiance below 0.06 has fewer bits than in `rgba16float`.
        assert!((bright / half - 1.0).abs() < 0.02 && bright != half, "{}: {half}, {bright}", format.name());
        // Light that half floats have to clamp is within its range.
        assert!(mean(format.name(), "rgba16float", 1e6).1 > 0, "{}", format.name());
        assert_eq!(mean(format.name(), "bright16float", 1e6).1, 0, "{}", format.name());
    }
}
