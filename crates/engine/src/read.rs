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
        let found = self.plan.resource(name).and_then(|index| match &self.objects[index] {
            Object::Texture(texture)
                if matches!(self.plan.resources[index].kind, ResourceKind::Image { .. }) =>
            {
                Some(texture)
            }
            _ => None,
        });
        let Some(texture) = found else {
            let images = self.plan.resources.iter().filter(|r| matches!(r.kind, ResourceKind::Image { .. }));
            let known = images.map(|resource| resource.name.clone()).collect();
            return Err(Error::NoSuchImage { name: name.to_owned(), known });
        };
        image::read(self.gpu, texture)
    }

    /// The texture of an image of the plan.
    pub fn texture(&self, name: &str) -> Option<&wgpu::Texture> {
        match &self.objects[self.plan.resource(name)?] {
            Object::Texture(texture) => Some(texture),
            _ => None,
        }
    }

    /// Reads a buffer of the plan, such as `occupancy`.
    ///
    /// # Errors
    /// The device is lost. `None` where the plan has no such buffer.
    pub fn buffer(&self, name: &str) -> Result<Option<Vec<u8>>, Error> {
        let Some(Object::Buffer(buffer)) = self.plan.resource(name).map(|index| &self.objects[index]) else {
            return Ok(None);
        };
        let read = self.gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read"),
            size: buffer.size(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &read, 0, buffer.size());
        self.gpu.guarded("reading a buffer", || self.gpu.queue.submit([encoder.finish()]))?;
        self.gpu.read(&read).map(Some)
    }

    /// What the volume's encoding could not hold in the last frame; `None` where it could hold everything.
    ///
    /// # Errors
    /// The device is lost.
    pub fn out_of_range(&self) -> Result<Option<OutOfRange>, Error> {
        let Some(bytes) = self.buffer("out_of_range")? else { return Ok(None) };
        let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        let (values, worst) = (word(0), f32::from_bits(word(4)));
        Ok((values > 0).then_some(OutOfRange { values, worst, range: self.plan.encoding.range }))
    }

    /// Bytes of each of the plan's resources.
    pub fn bytes(&self) -> Vec<(String, u64)> {
        let (voxels, cells) = self.counts;
        let size = |index: usize| match &self.objects[index] {
            Object::Buffer(buffer) => Some(buffer.size()),
            Object::Texture(texture) if self.plan.resources[index].kind == ResourceKind::Scene => {
                Some(image::texture_bytes(texture))
            }
            _ => self.plan.bytes(index, voxels, cells),
        };
        let resources = self.plan.resources.iter().enumerate();
        resources.filter_map(|(index, resource)| Some((resource.name.clone(), size(index)?))).collect()
    }
}
