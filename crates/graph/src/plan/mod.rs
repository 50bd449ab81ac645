//! A plan: what a device has to do, as plain data.

use voxlume_fault::Fault;
use voxlume_format::Encoding;
use voxlume_shader::Shader;

mod pass;
mod resource;
mod step;

pub use pass::{ParamSlot, Pass, Sources, Update};
pub use resource::{ImageExtent, ImageTexel, Life, Resource, ResourceKind};
pub use step::{Bind, Groups, Program, Step, Target, Vertices};

use crate::facts::Emission;
use crate::grid::Grid;
use crate::params;
use crate::pipeline::Value;

/// All that an engine needs to carry out a pipeline on a scene. Indices point into the lists beside them.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Word of the storage format, with the options that differ from its defaults.
    pub format: String,
    /// Its texel encoding.
    pub encoding: Encoding,
    /// Name of the tracer of passes that name none.
    pub tracer: String,
    /// The first voxel grid, whose centre is the scene's origin.
    pub grid: Grid,
    /// Width and height of the image in pixels.
    pub screen: [u32; 2],
    /// Triangles to be voxelized and drawn.
    pub triangles: u32,
    /// How what surfaces emit reaches others.
    pub emission: Emission,
    /// Linked and checked WGSL.
    pub shaders: Vec<Shader>,
    /// What passes read and write.
    pub resources: Vec<Resource>,
    /// In the order of execution.
    pub passes: Vec<Pass>,
    /// What the pipeline describes and this scene doesn't need.
    pub left_out: Vec<LeftOut>,
    /// The image that is the result, in `resources`.
    pub output: usize,
    /// Buffers with the runs of each grid's levels, in `resources`: eight words a level, the fifth of which is its number of
    /// occupied cells once a step [`Step::Counted`] is reached.
    pub levels: Vec<usize>,
    /// Buffers of two words each, in `resources`: how many values an encoding could not hold in a pass, and the largest as
    /// a float's bits.
    pub out_of_range: Vec<usize>,
    /// Bytes that it may take on the device; `None` for as many as there are.
    pub memory_budget: Option<u64>,
}

/// Something that was left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// What: a pass, a channel, a branch.
    pub what: String,
    /// Why it isn't needed.
    pub why: String,
    /// Bytes that this saves.
    pub bytes: u64,
}

impl Plan {
    /// The resource called `name`.
    pub fn resource(&self, name: &str) -> Option<usize> {
        self.resources.iter().position(|resource| resource.name == name)
    }

    /// Bytes of all resources but those that the engine supplies.
    pub fn total_bytes(&self, voxels: u64, cells: u64) -> u64 {
        (0..self.resources.len()).filter_map(|index| self.bytes(index, voxels, cells)).sum()
    }

    /// Bytes of a resource, once the number of occupied voxels and of cells of all levels is known; `None` for
    /// what the engine supplies.
    pub fn bytes(&self, resource: usize, voxels: u64, cells: u64) -> Option<u64> {
        let resource = &self.resources[resource];
        let bytes = match &resource.kind {
            ResourceKind::Scene => return None,
            ResourceKind::Uniform(bytes) => bytes.len() as u64,
            ResourceKind::Buffer(bytes) => *bytes,
            ResourceKind::PerVoxel(bytes) => bytes * voxels,
            ResourceKind::PerCell(bytes) => bytes * cells,
            ResourceKind::Volume { size, mips, encoding, numbers } => {
                volume_texels(*size, *mips) * numbers.texel(*encoding).bytes()
            }
            ResourceKind::Image { extent, texel, layers, mips } => {
                let [width, height] = extent.size(self.screen);
                volume_texels([width, height, 1], *mips) * u64::from(*layers) * texel.bytes()
            }
            ResourceKind::Raster { side } => u64::from(*side).pow(2),
        };
        Some(match resource.life {
            Life::Frame | Life::Kept => bytes,
            Life::History => 2 * bytes,
        })
    }

    /// Where a parameter of a pass is kept, and the bytes to write there for a value.
    ///
    /// # Errors
    /// No such pass or parameter, a value that it can't have, or one that needs another plan.
    pub fn parameter(&self, pass: &str, name: &str, value: &Value) -> Result<ParamBytes, Fault> {
        params::rewrite(self, pass, name, value)
    }
}

/// New bytes for a pass's parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct ParamBytes {
    /// The buffer, in [`Plan::resources`].
    pub resource: usize,
    /// Where in it.
    pub offset: u64,
    /// What to write there.
    pub bytes: Vec<u8>,
}

fn volume_texels(size: [u32; 3], mips: u32) -> u64 {
    (0..mips).map(|mip| size.iter().map(|n| u64::from((n >> mip).max(1))).product::<u64>()).sum()
}
