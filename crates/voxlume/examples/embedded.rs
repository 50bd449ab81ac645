//! A program with a device, frames and a target of its own draws ten frames with Voxlume's image inside, and writes the last
//! one as a PNG. It needs no window: `cargo run --release -p voxlume --example embedded -- scenes/cornell.ron out.png`

use std::path::Path;

use voxlume::{Frame, Gpu, Pipeline, Registry, Request, Scene, SceneFacts, Session, Value, plan, wgpu};

/// The program's own target: Voxlume's image fills the middle of it, in the program's own colours.
const TARGET: [u32; 2] = [640, 480];
const TARGET_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;

/// A quad over the middle of the target with the image on it, tone-mapped (Reinhard et al. 2002, eq. 3).
const QUAD: &str = "
@group(0) @binding(0) var image: texture_2d<f32>;
@group(0) @binding(1) var image_sampler: sampler;

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) uv: vec2f,
}

@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> Corner {
    let uv = vec2f(vec2u(index & 1, index >> 1));
    return Corner(vec4f((uv * 2.0 - 1.0) * 0.8, 0.0, 1.0), vec2f(uv.x, 1.0 - uv.y));
}

@fragment
fn fragment_main(corner: Corner) -> @location(0) vec4f {
    let radiance = textureSample(image, image_sampler, corner.uv).rgb;
    return vec4f(radiance / (1.0 + radiance), 1.0);
}
";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let scene_path = arguments.next().unwrap_or_else(|| "scenes/cornell.ron".into());
    let out = arguments.next().unwrap_or_else(|| "embedded.png".into());

    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor::default()))?;
    let program = Program::new(&device);

    let gpu = Gpu::new(device.clone(), queue.clone());
    let scene = Scene::load(Path::new(&scene_path))?;
    let (facts, request) = (SceneFacts::of(&scene)?, Request::image(256, 192));
    let plan = plan(&Pipeline::builtin("gi")?, &facts, &Registry::builtin(), &request)?;
    let mut session = Session::new(&gpu, plan, &scene)?;

    let mut camera = scene.cameras[0].clone();
    for number in 0..10_u8 {
        let before = session.counters();
        match number {
            3 => session.resize(512, 384)?,
            6 => session.set("diffuse", "step", &Value::Number(0.5))?,
            // Still, as nothing has changed.
            8 => {}
            _ => camera.eye.x += 0.02,
        }
        // One encoder holds both programs' work; the session neither submits nor waits.
        let mut encoder = device.create_command_encoder(&Default::default());
        let frame = Frame { seconds: f32::from(number) / 60.0, ..Frame::of(&camera) };
        let passes = session.encode(&mut encoder, &frame)?;
        let image = session.texture("final").ok_or("the pipeline makes no `final`")?;
        program.draw(&device, &mut encoder, image);
        queue.submit([encoder.finish()]);

        let names: Vec<&str> = passes.iter().map(|pass| session.plan().passes[*pass].name.as_str()).collect();
        let cost = session.counters() - before;
        println!(
            "frame {number}: {} bytes uploaded, {} pipelines compiled, ran {}",
            cost.uploaded_bytes,
            cost.pipelines,
            if names.is_empty() { "nothing".to_owned() } else { names.join(", ") },
        );
    }
    let pixels = program.read(&gpu)?;
    image::save_buffer(&out, &pixels, TARGET[0], TARGET[1], image::ColorType::Rgba8)?;
    println!("{out}");
    Ok(())
}

/// What the program draws itself.
struct Program {
    target: wgpu::Texture,
    sampler: wgpu::Sampler,
    pipeline: wgpu::RenderPipeline,
}

impl Program {
    fn new(device: &wgpu::Device) -> Program {
        let target = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("target"),
            size: wgpu::Extent3d { width: TARGET[0], height: TARGET[1], depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: TARGET_FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("quad"),
            source: wgpu::ShaderSource::Wgsl(QUAD.into()),
        });
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("quad"),
            layout: None,
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: None,
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState {
                topology: wgpu::PrimitiveTopology::TriangleStrip,
                ..Default::default()
            },
            depth_stencil: None,
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: None,
                compilation_options: Default::default(),
                targets: &[Some(TARGET_FORMAT.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let linear = wgpu::SamplerDescriptor {
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..Default::default()
        };
        Program { target, sampler: device.create_sampler(&linear), pipeline }
    }

    /// Clears the target and draws an image onto the middle of it.
    fn draw(&self, device: &wgpu::Device, encoder: &mut wgpu::CommandEncoder, image: &wgpu::Texture) {
        // The plan's images are arrays, here of one layer.
        let image = image.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2),
            ..Default::default()
        });
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("quad"),
            layout: &self.pipeline.get_bind_group_layout(0),
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&image) },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&self.sampler) },
            ],
        });
        let target = self.target.create_view(&Default::default());
        let grey = wgpu::Color { r: 0.02, g: 0.02, b: 0.03, a: 1.0 };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("the program's own pass"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(grey), store: wgpu::StoreOp::Store },
            })],
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &bind_group, &[]);
        pass.draw(0..4, 0..1);
    }

    /// The target's bytes. Its rows are as long as copies need them to be.
    fn read(&self, gpu: &Gpu) -> Result<Vec<u8>, voxlume::Error> {
        let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("target"),
            size: u64::from(TARGET[0] * TARGET[1] * 4),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(TARGET[0] * 4),
            rows_per_image: None,
        };
        let to = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
        encoder.copy_texture_to_buffer(self.target.as_image_copy(), to, self.target.size());
        gpu.queue.submit([encoder.finish()]);
        gpu.read(&buffer)
    }
}
