//! The device of a session, and what the session has had it do.

use crate::{Error, Gpu};

/// What a session has had its device do since it was made. A test, or a program that must not stall, compares two of
/// them. Reading back is not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Shader modules made.
    pub modules: u64,
    /// Pipelines compiled.
    pub pipelines: u64,
    /// Bind groups made.
    pub bind_groups: u64,
    /// Buffers made.
    pub buffers: u64,
    /// Textures made.
    pub textures: u64,
    /// Writes to buffers and textures.
    pub uploads: u64,
    /// Bytes of these.
    pub uploaded_bytes: u64,
    /// Passes recorded.
    pub passes: u64,
}

impl std::ops::Sub for Counters {
    type Output = Counters;

    /// What was done since `earlier`.
    fn sub(self, earlier: Counters) -> Counters {
        Counters {
            modules: self.modules - earlier.modules,
            pipelines: self.pipelines - earlier.pipelines,
            bind_groups: self.bind_groups - earlier.bind_groups,
            buffers: self.buffers - earlier.buffers,
            textures: self.textures - earlier.textures,
            uploads: self.uploads - earlier.uploads,
            uploaded_bytes: self.uploaded_bytes - earlier.uploaded_bytes,
            passes: self.passes - earlier.passes,
        }
    }
}

/// A device that is counted on.
#[derive(Debug)]
pub(crate) struct Host {
    pub gpu: Gpu,
    pub counters: Counters,
}

impl Host {
    pub fn new(gpu: &Gpu) -> Host {
        Host { gpu: gpu.clone(), counters: Counters::default() }
    }

    pub fn buffer(
        &mut self,
        label: &str,
        size: u64,
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, Error> {
        let descriptor =
            wgpu::BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false };
        self.counters.buffers += 1;
        self.gpu.guarded(label, || self.gpu.device.create_buffer(&descriptor))
    }

    /// A buffer with these bytes, at least one element's worth of zeroes.
    pub fn buffer_with(
        &mut self,
        label: &str,
        bytes: &[u8],
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, Error> {
        let nothing = [0; 256];
        let contents = if bytes.is_empty() { &nothing } else { bytes };
        // `create_buffer_init` would panic if the device is lost.
        let buffer = self.buffer(label, contents.len() as u64, usage | wgpu::BufferUsages::COPY_DST)?;
        self.write(&buffer, 0, contents);
        Ok(buffer)
    }

    pub fn write(&mut self, buffer: &wgpu::Buffer, offset: u64, bytes: &[u8]) {
        self.counters.uploads += 1;
        self.counters.uploaded_bytes += bytes.len() as u64;
        self.gpu.queue.write_buffer(buffer, offset, bytes);
    }

    pub fn texture(&mut self, descriptor: &wgpu::TextureDescriptor<'_>) -> Result<wgpu::Texture, Error> {
        self.counters.textures += 1;
        let label = descriptor.label.unwrap_or_default();
        self.gpu.guarded(label, || self.gpu.device.create_texture(descriptor))
    }

    pub fn write_texture(
        &mut self,
        to: wgpu::TexelCopyTextureInfo<'_>,
        bytes: &[u8],
        layout: wgpu::TexelCopyBufferLayout,
        size: wgpu::Extent3d,
    ) {
        self.counters.uploads += 1;
        self.counters.uploaded_bytes += bytes.len() as u64;
        self.gpu.queue.write_texture(to, bytes, layout, size);
    }
}

/// A buffer, and what it holds.
#[derive(Debug)]
pub(crate) struct Written {
    pub buffer: wgpu::Buffer,
    pub bytes: Vec<u8>,
}

impl Written {
    pub fn new(
        host: &mut Host,
        label: &str,
        bytes: &[u8],
        usage: wgpu::BufferUsages,
    ) -> Result<Written, Error> {
        Ok(Written { buffer: host.buffer_with(label, bytes, usage)?, bytes: bytes.to_vec() })
    }

    /// Writes the first bytes, if they differ; whether they do. At most as many as there were.
    pub fn write(&mut self, host: &mut Host, bytes: &[u8]) -> bool {
        let known = &mut self.bytes[..bytes.len()];
        let differs = known != bytes;
        if differs {
            host.write(&self.buffer, 0, bytes);
            known.copy_from_slice(bytes);
        }
        differs
    }
}
