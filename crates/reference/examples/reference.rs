//! Computes one reference picture and writes it as PNG (clamped, sRGB) or linear EXR.
//!
//! ```text
//! cargo run --release -p voxlume-reference --example reference -- SCENE QUANTITY OUT.(png|exr)
//!     [--size 256 | --size 512x288] [--spp 64] [--bounces 1] [--seed 0] [--camera NAME] [--light 0]
//!     [--distance 1] [--falloff 0] [--lambert] [--area]
//! ```
//!
//! QUANTITY is one of `soft_shadow ambient_occlusion diffuse specular final`.

use std::collections::HashMap;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use voxlume_reference::{Gather, Picture, PixelSampling, Quantity, Reflection, Request, Tracer};
use voxlume_scene::Scene;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let (words, options) = arguments();
    let [scene, quantity, out] = words.as_slice() else {
        return Err("usage: reference SCENE QUANTITY OUT.(png|exr) [options]".into());
    };
    let scene = Scene::load(Path::new(scene)).map_err(|faults| format!("{faults:?}"))?;
    let request = request(&scene, quantity, &options)?;

    let start = Instant::now();
    let tracer = Tracer::new(&scene)?;
    println!("made ready in {:.2} s", start.elapsed().as_secs_f32());
    let start = Instant::now();
    let picture = tracer.render(&request, &|_| (), &AtomicBool::new(false))?;
    println!("traced in {:.2} s", start.elapsed().as_secs_f32());

    let mean = |pixels: &[[f32; 3]]| {
        let sum = pixels.iter().fold([0.0f64; 3], |s, p| std::array::from_fn(|c| s[c] + f64::from(p[c])));
        sum.map(|s| s / pixels.len() as f64)
    };
    println!(
        "mean {:.5?}, standard error of a pixel {:.5?}",
        mean(&picture.mean),
        mean(&picture.standard_error)
    );
    write(Path::new(out), &picture)
}

/// Plain words, and options with their values (none for a switch).
fn arguments() -> (Vec<String>, HashMap<String, String>) {
    let mut words = Vec::new();
    let mut options = HashMap::new();
    let mut rest = std::env::args().skip(1);
    while let Some(word) = rest.next() {
        match word.strip_prefix("--") {
            Some(switch @ ("lambert" | "area")) => drop(options.insert(switch.into(), String::new())),
            Some(option) => drop(options.insert(option.into(), rest.next().unwrap_or_default())),
            None => words.push(word),
        }
    }
    (words, options)
}

fn request(scene: &Scene, quantity: &str, options: &HashMap<String, String>) -> Result<Request, Failure> {
    let text = |name: &str, default: &str| options.get(name).cloned().unwrap_or_else(|| default.into());
    let size = text("size", "256");
    let (width, height) = size.split_once('x').unwrap_or((&size, &size));
    let gather = Gather { bounces: text("bounces", "1").parse()?, sky: true, emission: false };
    let quantity = match quantity {
        "soft_shadow" => Quantity::SoftShadow { light: text("light", "0").parse()? },
        "ambient_occlusion" => Quantity::AmbientOcclusion {
            distance: text("distance", "1").parse()?,
            falloff: text("falloff", "0").parse()?,
        },
        "diffuse" => Quantity::Diffuse(gather),
        "specular" => Quantity::Specular(Gather { emission: true, ..gather }),
        "final" => Quantity::Final { bounces: gather.bounces },
        _ => return Err("quantity: one of soft_shadow ambient_occlusion diffuse specular final".into()),
    };
    let name = text("camera", "");
    let camera = scene.cameras.iter().find(|camera| name.is_empty() || camera.name == name);
    let switch = |name: &str| options.contains_key(name);
    Ok(Request {
        camera: camera.ok_or("no such camera")?.clone(),
        width: width.parse()?,
        height: height.parse()?,
        samples: text("spp", "64").parse()?,
        seed: text("seed", "0").parse()?,
        sampling: if switch("area") { PixelSampling::Area } else { PixelSampling::Centre },
        quantity,
        reflection: if switch("lambert") { Reflection::Lambert } else { Reflection::Gltf },
    })
}

fn write(out: &Path, picture: &Picture) -> Result<(), Failure> {
    let (width, height) = (picture.width, picture.height);
    if out.extension().is_some_and(|extension| extension == "exr") {
        let pixel = |x: usize, y: usize| picture.mean[y * width as usize + x].into();
        return Ok(exr::prelude::write_rgb_file(
            out,
            width as usize,
            height as usize,
            |x, y| -> (f32, f32, f32) { pixel(x, y) },
        )?);
    }
    let encode = |value: f32| {
        let value = value.clamp(0.0, 1.0);
        let srgb = if value <= 0.003_130_8 { 12.92 * value } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 };
        (srgb * 255.0).round() as u8
    };
    let bytes: Vec<u8> = picture.mean.iter().flatten().map(|&value| encode(value)).collect();
    Ok(image::save_buffer(out, &bytes, width, height, image::ColorType::Rgb8)?)
}
