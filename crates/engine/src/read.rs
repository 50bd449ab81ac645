//! What a renderer made, read back.

use voxlume_graph::ResourceKind;

use crate::image::{self, Picture};
use crate::resources::Object;
use crate::{Error, Renderer};

/// Values that an encoding could not hold and clamped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// How many texels had one.
    pub values: u32,
    /// The largest, without its sign.
    pub worst: f32,
    /// The largest that the encoding holds.
    pub range: f32,
}

impl std::fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let OutOfRange { values, worst, range } = self;
        write!(
            f,
            "{values} texels out of the encoding's range of {range} were clamped; the largest value is {worst}"
        )
    }
}

impl Renderer<'_> {
    /// Reads an image of the plan, linear.
    ///
    /// # Errors
    /// The plan has no such image, or the device is lost.
    pub fn picture(&self, name: &str) -> Result<Picture, Error> {
        let is_image = |index: usize| matches!(self.plan().resources[index].kind, ResourceKind::Image { .. });
        let Some((_, Object::Texture(texture))) = self.session.object(name).filter(|(i, _)| is_image(*i))
        else {
            let images =
                self.plan().resources.iter().filter(|r| matches!(r.kind, ResourceKind::Image { .. }));
            let known = images.map(|resource| resource.name.clone()).collect();
            return Err(Error::NoSuchImage { name: name.to_owned(), known });
        };
        image::read(self.gpu, texture)
    }

    /// As [`Session::texture`](crate::Session::texture).
    pub fn texture(&self, name: &str) -> Option<&wgpu::Texture> {
        self.session.texture(name)
    }

    /// Reads a buffer of the plan, such as `occupancy`.
    ///
    /// # Errors
    /// The device is lost. `None` where the plan has no such buffer.
    pub fn buffer(&self, name: &str) -> Result<Option<Vec<u8>>, Error> {
        match self.session.object(name) {
            Some((_, Object::Buffer(buffer))) => self.read_buffer(buffer).map(Some),
            _ => Ok(None),
        }
    }

    fn read_buffer(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>, Error> {
        let read = self.gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read"),
            size: buffer.size(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &read, 0, buffer.size());
        self.gpu.guarded("reading a buffer", || self.gpu.queue.submit([encoder.finish()]))?;
        self.gpu.read(&read)
    }

    /// What the volume's encoding could not hold in the last frame; `None` where it could hold everything.
    ///
    /// # Errors
    /// The device is lost.
    pub fn out_of_range(&self) -> Result<Option<OutOfRange>, Error> {
        let (mut values, mut worst) = (0, 0.0f32);
        for index in &self.plan().out_of_range {
            let Some(buffer) = self.session.work.resources.buffer(*index) else { continue };
            let bytes = self.read_buffer(buffer)?;
            let word = |at: usize| u32::from_le_bytes(std::array::from_fn(|byte| bytes[at + byte]));
            values += word(0);
            worst = worst.max(f32::from_bits(word(4)));
        }
        let range = self.plan().encoding.range;
        Ok((values > 0).then_some(OutOfRange { values, worst, range }))
    }

    /// Bytes of each of the plan's resources.
    pub fn bytes(&self) -> Vec<(String, u64)> {
        let (voxels, cells) = self.counts();
        let plan = self.plan();
        let size = |index: usize| match self.session.work.resources.newest(index) {
            Object::Buffer(buffer) => Some(buffer.size()),
            Object::Texture(texture) if plan.resources[index].kind == ResourceKind::Scene => {
                Some(image::texture_bytes(texture))
            }
            _ => plan.bytes(index, voxels, cells),
        };
        let resources = plan.resources.iter().enumerate();
        resources.filter_map(|(index, resource)| Some((resource.name.clone(), size(index)?))).collect()
    }
}
