//! How many voxels and cells are occupied: their buffers are sized by it, and it is learnt without waiting.

use std::sync::mpsc::{Receiver, TryRecvError, channel};

use voxlume_graph::{Pass, Plan, ResourceKind, Step};

use crate::host::Host;
use crate::resources::Resources;
use crate::{Error, Gpu};

/// Occupied voxels, and occupied cells of all levels. Of several grids, each is the largest of any.
pub(crate) type Count = (u64, u64);

/// What is known of a plan's voxels.
#[derive(Debug)]
pub(crate) struct Counts {
    /// As voxelization last left them, as far as is known.
    pub occupied: Count,
    /// What the buffers that depend on them were made for.
    pub room: Count,
    /// Buffers with the runs of levels.
    levels: Vec<usize>,
    /// Passes that count voxels anew when triangles have moved.
    counting: Vec<usize>,
    /// Copies of `levels`, on their way to the host or idle.
    copies: Option<Copies>,
    /// Whether voxels were counted since they were last copied.
    behind: bool,
}

#[derive(Debug)]
struct Copies {
    buffer: wgpu::Buffer,
    /// One message for a copy that has arrived; none any more for one that was never submitted.
    arrival: Option<Receiver<Result<(), wgpu::BufferAsyncError>>>,
}

impl Counts {
    pub fn new(plan: &Plan) -> Counts {
        let levels = plan.levels.clone();
        let passes = plan.passes.iter().enumerate();
        let counting = passes.filter(|(_, pass)| pass.sources.geometry && counted(pass).is_some());
        let counting = counting.map(|(index, _)| index).collect();
        Counts { occupied: (0, 0), room: (0, 0), levels, counting, copies: None, behind: false }
    }

    /// Takes in what the runs of levels say.
    fn take(&mut self, bytes: &[u8], plan: &Plan) {
        self.occupied = (0, 0);
        let mut rest = bytes;
        for index in &self.levels {
            let (of_grid, others) = rest.split_at(level_bytes(plan, *index) as usize);
            rest = others;
            // A `LevelRun` is eight words: three of workgroups, the first cell, the count.
            let counts = of_grid
                .chunks_exact(32)
                .map(|run| u64::from(u32::from_le_bytes([run[16], run[17], run[18], run[19]])));
            let counts: Vec<u64> = counts.collect();
            let (voxels, cells) = self.occupied;
            let finest = counts.first().copied().unwrap_or(0);
            self.occupied = (voxels.max(finest), cells.max(counts.iter().sum()));
        }
    }

    /// What buffers are to be made for: the counts, with a quarter more where they change from frame to frame, if the
    /// plan's budget has room for them.
    pub fn roomy(&self, plan: &Plan) -> Result<Count, Error> {
        let more = |count: u64| if self.counting.is_empty() { count } else { count + count / 4 + 256 };
        let (voxels, cells) = (more(self.occupied.0), more(self.occupied.1));
        let bytes = plan.total_bytes(voxels, cells);
        match plan.memory_budget {
            Some(budget) if bytes > budget => Err(Error::OverBudget { bytes, voxels, budget }),
            _ => Ok((voxels, cells)),
        }
    }

    pub fn outgrown(&self) -> bool {
        self.occupied.0 > self.room.0 || self.occupied.1 > self.room.1
    }

    /// Waits for the counts.
    pub fn read(&mut self, host: &mut Host, plan: &Plan, resources: &Resources) -> Result<(), Error> {
        let mut encoder = host.gpu.device.create_command_encoder(&Default::default());
        self.behind = true;
        self.copy(host, &mut encoder, plan, resources)?;
        host.gpu.guarded("counting voxels", || host.gpu.queue.submit([encoder.finish()]))?;
        host.gpu.wait()?;
        self.arrived(&host.gpu, plan).map(|_| ())
    }

    /// Sends the counts on their way, if one of these passes has counted anew and the ones before have arrived.
    pub fn follow(
        &mut self,
        host: &mut Host,
        encoder: &mut wgpu::CommandEncoder,
        plan: &Plan,
        resources: &Resources,
        ran: &[usize],
    ) -> Result<(), Error> {
        self.behind |= ran.iter().any(|pass| self.counting.contains(pass));
        self.copy(host, encoder, plan, resources)
    }

    fn copy(
        &mut self,
        host: &mut Host,
        encoder: &mut wgpu::CommandEncoder,
        plan: &Plan,
        resources: &Resources,
    ) -> Result<(), Error> {
        let size = self.levels.iter().map(|index| level_bytes(plan, *index)).sum();
        let is_away = self.copies.as_ref().is_some_and(|copies| copies.arrival.is_some());
        if !self.behind || size == 0 || is_away {
            return Ok(());
        }
        let copies = match &mut self.copies {
            Some(copies) => copies,
            none => {
                let usage = wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ;
                let buffer = host.buffer("counts of voxels", size, usage)?;
                none.insert(Copies { buffer, arrival: None })
            }
        };
        let mut offset = 0;
        for index in &self.levels {
            let bytes = level_bytes(plan, *index);
            if let Some(levels) = resources.buffer(*index) {
                encoder.copy_buffer_to_buffer(levels, 0, &copies.buffer, offset, bytes);
            }
            offset += bytes;
        }
        let (sender, receiver) = channel();
        encoder.map_buffer_on_submit(&copies.buffer, wgpu::MapMode::Read, .., move |mapped| {
            // Nobody waits for it once the session is gone.
            let _ = sender.send(mapped);
        });
        copies.arrival = Some(receiver);
        self.behind = false;
        Ok(())
    }

    /// Takes in counts that have arrived; whether there were any.
    pub fn arrived(&mut self, gpu: &Gpu, plan: &Plan) -> Result<bool, Error> {
        let Some(Copies { buffer, arrival }) = &mut self.copies else { return Ok(false) };
        let Some(receiver) = arrival else { return Ok(false) };
        let lost = |error: String| Error::Lost(error);
        gpu.device.poll(wgpu::PollType::Poll).map_err(|error| lost(error.to_string()))?;
        match receiver.try_recv() {
            Err(TryRecvError::Empty) => return Ok(false),
            Err(TryRecvError::Disconnected) => {
                *arrival = None;
                self.behind = true;
                return Ok(false);
            }
            Ok(mapped) => mapped.map_err(|error| lost(error.to_string()))?,
        }
        *arrival = None;
        let range = buffer.slice(..).get_mapped_range().map_err(|error| lost(error.to_string()))?;
        let bytes = range.to_vec();
        drop(range);
        buffer.unmap();
        self.take(&bytes, plan);
        Ok(true)
    }
}

fn level_bytes(plan: &Plan, index: usize) -> u64 {
    match plan.resources[index].kind {
        ResourceKind::Buffer(bytes) => bytes,
        _ => 0,
    }
}

/// Where in a pass's steps the voxels are counted.
pub(crate) fn counted(pass: &Pass) -> Option<usize> {
    pass.steps.iter().position(|step| matches!(step, Step::Counted))
}
