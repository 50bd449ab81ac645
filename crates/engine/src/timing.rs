//! Times of passes.

use crate::{Error, Gpu};

/// Which clock took a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// Timestamps of the device.
    Gpu,
    /// The host's clock from submission to completion.
    Wall,
}

/// How long a pass took.
#[derive(Clone, Debug)]
pub struct PassTime {
    /// In the plan's passes.
    pub pass: usize,
    /// The pass's name.
    pub name: String,
    /// How long.
    pub milliseconds: f64,
    /// By which clock.
    pub clock: Clock,
}

/// Two timestamps a pass.
#[derive(Debug)]
pub(crate) struct Queries {
    set: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    read: wgpu::Buffer,
    count: u32,
}

impl Queries {
    pub fn new(gpu: &Gpu, passes: u32) -> Queries {
        let count = (2 * passes).max(2);
        let set = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
            label: Some("pass times"),
            ty: wgpu::QueryType::Timestamp,
            count,
        });
        let buffer = |usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("pass times"),
                size: u64::from(count) * 8,
                usage,
                mapped_at_creation: false,
            })
        };
        let resolved = buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC);
        let read = buffer(wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ);
        Queries { set, resolved, read, count }
    }

    /// For how many passes there are timestamps.
    pub fn passes(&self) -> u32 {
        self.count / 2
    }

    /// Timestamps of an encoder's pass; `ends` says whether it begins and ends the plan's pass.
    pub fn compute(&self, pass: u32, ends: (bool, bool)) -> Option<wgpu::ComputePassTimestampWrites<'_>> {
        (ends.0 || ends.1).then(|| wgpu::ComputePassTimestampWrites {
            query_set: &self.set,
            beginning_of_pass_write_index: ends.0.then_some(2 * pass),
            end_of_pass_write_index: ends.1.then_some(2 * pass + 1),
        })
    }

    /// As [`Queries::compute`].
    pub fn render(&self, pass: u32, ends: (bool, bool)) -> Option<wgpu::RenderPassTimestampWrites<'_>> {
        (ends.0 || ends.1).then(|| wgpu::RenderPassTimestampWrites {
            query_set: &self.set,
            beginning_of_pass_write_index: ends.0.then_some(2 * pass),
            end_of_pass_write_index: ends.1.then_some(2 * pass + 1),
        })
    }

    pub fn resolve(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.resolve_query_set(&self.set, 0..self.count, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.read, 0, self.resolved.size());
    }

    /// Milliseconds of each pass.
    pub fn read(&self, gpu: &Gpu) -> Result<Vec<f64>, Error> {
        let bytes = gpu.read(&self.read)?;
        let ticks: Vec<u64> =
            bytes.chunks_exact(8).map(|b| b.iter().rev().fold(0, |n, b| n << 8 | u64::from(*b))).collect();
        let period = f64::from(gpu.queue.get_timestamp_period());
        Ok(ticks.chunks_exact(2).map(|pair| pair[1].saturating_sub(pair[0]) as f64 * period * 1e-6).collect())
    }
}
