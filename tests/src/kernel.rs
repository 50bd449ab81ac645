//! Small WGSL programs over the repository's modules, run for what they write.
#![allow(clippy::panic)]

use std::time::Instant;

use voxlume::{Library, Source, link, wgpu};
use wgpu::util::DeviceExt;

use crate::gpu;

/// What a kernel finds under a variable's name: the bytes of a buffer.
pub type Input<'a> = (&'a str, &'a [u8]);

/// Links a WGSL text, whose entry point `main` takes one workgroup and writes `var<storage, read_write> out:
/// array<f32>`, and runs it. Besides it may use the modules' `volume_sampler`, and one texture, which is `texture`.
///
/// # Panics
/// The text is at fault, or the device.
pub fn run_kernel(
    text: &str,
    mounts: &[(&str, &str)],
    constants: &[(&str, f64)],
    texture: Option<&wgpu::Texture>,
    count: usize,
) -> Vec<f32> {
    run_kernel_of(&Library::builtin(), text, mounts, constants, (texture, &[]), count)
}

/// The same over other modules, and with buffers.
///
/// # Panics
/// The text is at fault, or the device.
pub fn run_kernel_of(
    library: &Library,
    text: &str,
    mounts: &[(&str, &str)],
    constants: &[(&str, f64)],
    given: (Option<&wgpu::Texture>, &[Input<'_>]),
    count: usize,
) -> Vec<f32> {
    let kernel = Kernel::new(library, text, mounts, constants, given, count);
    kernel.run(1);
    kernel.values()
}

/// A program ready to run.
pub struct Kernel {
    pipeline: wgpu::ComputePipeline,
    bind_group: wgpu::BindGroup,
    out: wgpu::Buffer,
}

impl Kernel {
    /// See [`run_kernel_of`].
    ///
    /// # Panics
    /// The text is at fault, or the device.
    pub fn new(
        library: &Library,
        text: &str,
        mounts: &[(&str, &str)],
        constants: &[(&str, f64)],
        (texture, inputs): (Option<&wgpu::Texture>, &[Input<'_>]),
        count: usize,
    ) -> Kernel {
        let mut library = library.clone();
        library.insert("kernel", Source::new("kernel.wgsl", text));
        let shader = link(&library, "kernel", mounts).and_then(voxlume::Linked::check);
        let shader = shader.unwrap_or_else(|faults| panic!("{faults}"));
        let device = &gpu().device;
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(shader.wgsl.as_str().into()),
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: None,
            layout: None,
            module: &module,
            entry_point: Some("main"),
            compilation_options: wgpu::PipelineCompilationOptions { constants, ..Default::default() },
            cache: None,
        });
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let contents = vec![0; count * 4];
        let out = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: None,
            contents: &contents,
            usage,
        });
        let inputs: Vec<(&str, wgpu::Buffer)> = inputs
            .iter()
            .map(|(name, contents)| {
                let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::UNIFORM;
                let descriptor = wgpu::util::BufferInitDescriptor { label: None, contents, usage };
                (*name, device.create_buffer_init(&descriptor))
            })
            .collect();
        let view = texture.map(|texture| texture.create_view(&Default::default()));
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: wgpu::MipmapFilterMode::Linear,
            ..Default::default()
        });
        let input = |name: &str| inputs.iter().find(|(known, _)| *known == name).map(|(_, buffer)| buffer);
        let resource = |name: &str| match (name, &view) {
            (name, _) if input(name).is_some() => {
                input(name).map(wgpu::Buffer::as_entire_binding).unwrap_or_else(|| panic!("`{name}`"))
            }
            ("volume_sampler", _) => wgpu::BindingResource::Sampler(&sampler),
            ("out", _) => out.as_entire_binding(),
            (_, Some(view)) => wgpu::BindingResource::TextureView(view),
            (name, None) => panic!("nothing for `{name}`"),
        };
        let bindings = shader.bindings("main");
        let entries: Vec<_> = bindings
            .iter()
            .map(|binding| wgpu::BindGroupEntry {
                binding: binding.binding,
                resource: resource(&binding.name),
            })
            .collect();
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &entries,
        });
        Kernel { pipeline, bind_group, out }
    }

    /// Runs so many workgroups, and waits for them: the seconds that took.
    ///
    /// # Panics
    /// The device is at fault.
    pub fn run(&self, groups: u32) -> f64 {
        let mut encoder = gpu().device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &self.bind_group, &[]);
            pass.dispatch_workgroups(groups, 1, 1);
        }
        let commands = encoder.finish();
        let begun = Instant::now();
        gpu()
            .guarded("a kernel", || {
                gpu().queue.submit([commands]);
                gpu().device.poll(wgpu::PollType::wait_indefinitely())
            })
            .unwrap_or_else(|error| panic!("{error}"))
            .unwrap_or_else(|error| panic!("{error}"));
        begun.elapsed().as_secs_f64()
    }

    /// What is in `out`.
    ///
    /// # Panics
    /// The device is at fault.
    pub fn values(&self) -> Vec<f32> {
        let out = &self.out;
        let read = gpu().device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: out.size(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = gpu().device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(out, 0, &read, 0, out.size());
        gpu()
            .guarded("a kernel", || gpu().queue.submit([encoder.finish()]))
            .unwrap_or_else(|error| panic!("{error}"));
        let bytes = gpu().read(&read).unwrap_or_else(|error| panic!("{error}"));
        bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
    }
}

/// A 3D texture of 32-bit floats with all its levels, filled with noise.
pub fn noise_volume(side: u32) -> wgpu::Texture {
    let device = &gpu().device;
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: side, height: side, depth_or_array_layers: side },
        mip_level_count: side.ilog2() + 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D3,
        format: wgpu::TextureFormat::Rgba32Float,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let mut random = crate::Random::new(5);
    for mip in 0..texture.mip_level_count() {
        let size = texture.size().mip_level_size(mip, wgpu::TextureDimension::D3);
        let texels = size.width * size.height * size.depth_or_array_layers;
        let bytes: Vec<u8> =
            (0..4 * texels).flat_map(|_| (random.between(0.0, 1.0) as f32).to_le_bytes()).collect();
        gpu().queue.write_texture(
            wgpu::TexelCopyTextureInfo { mip_level: mip, ..texture.as_image_copy() },
            &bytes,
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(16 * size.width),
                rows_per_image: Some(size.height),
            },
            size,
        );
    }
    texture
}
