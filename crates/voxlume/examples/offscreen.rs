//! Renders a scene with a device of the program's own and writes a PNG:
//! `cargo run --release -p voxlume --example offscreen -- scenes/cornell.ron out.png [format]`

use std::path::Path;

use voxlume::wgpu;
use voxlume::{Gpu, Passes, Pipeline, Registry, Renderer, Request, Scene, SceneFacts, plan};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let scene_path = arguments.next().unwrap_or_else(|| "scenes/cornell.ron".into());
    let out = arguments.next().unwrap_or_else(|| "out.png".into());
    let format = arguments.next();

    // The program's own device; WebGPU's default limits are enough.
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))?;
    let gpu = Gpu::new(device, queue);

    // Scene and pipeline are data; the plan is what this pipeline does for this scene.
    let scene = Scene::load(Path::new(&scene_path))?;
    let pipeline = Pipeline::builtin("gi")?;
    let request = Request { format, ..Request::image(512, 512) };
    let plan = plan(&pipeline, &SceneFacts::of(&scene)?, &Registry::builtin(), &request)?;

    let mut renderer = Renderer::new(&gpu, plan, &scene)?;
    renderer.render(&scene, &scene.cameras[0], Passes::Changed)?;

    // `renderer.texture("final")` is the wgpu texture; a picture is its copy in memory, linear.
    let picture = renderer.picture("final")?;
    let bytes: Vec<u8> = picture
        .pixels
        .iter()
        .flat_map(|pixel| [pixel[0], pixel[1], pixel[2]])
        .map(|light| (light.clamp(0.0, 1.0).powf(1.0 / 2.2) * 255.0).round() as u8)
        .collect();
    image::save_buffer(&out, &bytes, picture.width, picture.height, image::ColorType::Rgb8)?;
    println!("{out}: {} occupied voxels", renderer.counts().0);
    Ok(())
}
