//! A plan: what a device has to do, as plain data.

use voxlume_format::{Encoding, Numbers};
use voxlume_shader::{BindingKind, Shader};

use crate::grid::Grid;

/// All that an engine needs to carry out a pipeline on a scene. Indices point into the lists beside them.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Word of the storage format, with the options that differ from its defaults.
    pub format: String,
    /// Its texel encoding.
    pub encoding: Encoding,
    /// Name of the tracer of passes that name none.
    pub tracer: String,
    /// The voxel grid.
    pub grid: Grid,
    /// Width and height of the image in pixels.
    pub screen: [u32; 2],
    /// Triangles to be voxelized and drawn.
    pub triangles: u32,
    /// Whether emissive polygons are lights of their own; else voxels hold the emission, if there is any.
    pub area_lights: bool,
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
    /// Bytes that it may take on the device; `None` for as many as there are.
    pub memory_budget: Option<u64>,
}

/// A buffer or texture.
#[derive(Clone, Debug, PartialEq)]
pub struct Resource {
    /// Unique name; for images, the name in the pipeline.
    pub name: String,
    /// What it is.
    pub kind: ResourceKind,
}

/// What a resource is.
#[derive(Clone, Debug, PartialEq)]
pub enum ResourceKind {
    /// Part of the scene or the frame, supplied by the engine under this name.
    Scene,
    /// A storage buffer of a fixed number of bytes.
    Buffer(u64),
    /// A storage buffer with so many bytes for each occupied voxel.
    PerVoxel(u64),
    /// A storage buffer with so many bytes for each occupied cell of all levels.
    PerCell(u64),
    /// A 3D texture.
    Volume {
        /// Texels of mip level 0.
        size: [u32; 3],
        /// Mip levels.
        mips: u32,
        /// Texel encoding.
        encoding: Encoding,
        /// What its texels hold.
        numbers: Numbers,
    },
    /// A texture of the screen's size.
    Image {
        /// Its texels.
        texel: ImageTexel,
        /// Array layers.
        layers: u32,
    },
    /// A square of one byte a texel, which gives rasterization its extent.
    Raster {
        /// Side in texels.
        side: u32,
    },
    /// Depth maps of lights.
    ShadowMaps {
        /// Side in texels.
        size: u32,
        /// One for each directional or spot light, six for each point light.
        layers: u32,
    },
}

/// Texels of images.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageTexel {
    /// Four half floats.
    Rgba16Float,
    /// sRGB colour, linear alpha, 8 bits each.
    Rgba8Srgb,
    /// 32-bit float depth.
    Depth32,
}

impl ImageTexel {
    /// Bytes of a texel.
    pub fn bytes(self) -> u64 {
        match self {
            ImageTexel::Rgba16Float => 8,
            ImageTexel::Rgba8Srgb | ImageTexel::Depth32 => 4,
        }
    }
}

/// One pass of the pipeline.
#[derive(Clone, Debug)]
pub struct Pass {
    /// The name in the pipeline.
    pub name: String,
    /// Whether it has to run only once, as nothing that it depends on changes from frame to frame.
    pub once: bool,
    /// Names of the graph's resources that it reads, for `explain`.
    pub reads: Vec<String>,
    /// Names of those that it writes or updates.
    pub writes: Vec<String>,
    /// What to do, in order.
    pub steps: Vec<Step>,
}

/// One dispatch, draw or clear.
#[derive(Clone, Debug)]
pub enum Step {
    /// Fills a buffer with zeroes.
    Clear(usize),
    /// Copies a buffer to the beginning of another that is at least as large.
    Copy {
        /// From where.
        from: usize,
        /// To where.
        to: usize,
    },
    /// A compute shader.
    Compute {
        /// The program.
        program: Program,
        /// How many workgroups.
        groups: Groups,
    },
    /// All triangles of the scene, drawn.
    Draw {
        /// The program; its entry points are `vertex_main` and `fragment_main`.
        program: Program,
        /// Colour targets by location; `None` for one that nobody reads.
        colors: Vec<Option<usize>>,
        /// Depth target and its layer.
        depth: (usize, u32),
        /// Depth is reversed: 1 is near, 0 infinitely far.
        reversed: bool,
    },
    /// Triangles that the program makes of vertex numbers alone, onto a target that nothing is drawn on: what its
    /// fragments do is write to buffers.
    Raster {
        /// The program; its entry points are `vertex_main` and `fragment_main`.
        program: Program,
        /// The target.
        target: usize,
        /// How many vertices.
        vertices: Vertices,
    },
    /// Buffers sized by the number of occupied cells can be made from here on.
    Counted,
}

/// A shader with everything that it is bound to.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// In [`Plan::shaders`].
    pub shader: usize,
    /// Entry point of a compute program.
    pub entry: &'static str,
    /// Values of the shader's `override` constants.
    pub constants: Vec<(String, f64)>,
    /// What its variables are bound to, by group and binding.
    pub binds: Vec<Bind>,
}

/// One variable of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Bind {
    /// `@group`.
    pub group: u32,
    /// `@binding`.
    pub binding: u32,
    /// The variable's name in WGSL.
    pub name: String,
    /// The variable's type.
    pub kind: BindingKind,
    /// What it is bound to.
    pub target: Target,
}

/// What a variable is bound to.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// A whole resource.
    Resource(usize),
    /// One mip level of a volume.
    Mip {
        /// The volume.
        resource: usize,
        /// The mip level.
        mip: u32,
    },
    /// A uniform buffer with these bytes.
    Uniform(Vec<u8>),
    /// A texture of one texel of zeroes: what would be here was left out.
    Nothing,
}

/// Workgroups of a dispatch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Groups {
    /// This many.
    Fixed([u32; 3]),
    /// As many as a buffer says at an offset in bytes.
    Indirect {
        /// The buffer.
        resource: usize,
        /// Where its three words are.
        offset: u64,
    },
}

/// Vertices of a [`Step::Raster`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Vertices {
    /// This many.
    Fixed(u32),
    /// As many as a buffer says at an offset in bytes.
    Indirect {
        /// The buffer.
        resource: usize,
        /// Where its four words are: vertices, instances, and the first of each.
        offset: u64,
    },
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
        let [width, height] = self.screen.map(u64::from);
        Some(match &self.resources[resource].kind {
            ResourceKind::Scene => return None,
            ResourceKind::Buffer(bytes) => *bytes,
            ResourceKind::PerVoxel(bytes) => bytes * voxels,
            ResourceKind::PerCell(bytes) => bytes * cells,
            ResourceKind::Volume { size, mips, encoding, numbers } => {
                volume_texels(*size, *mips) * numbers.texel(*encoding).bytes()
            }
            ResourceKind::Image { texel, layers } => width * height * u64::from(*layers) * texel.bytes(),
            ResourceKind::Raster { side } => u64::from(*side).pow(2),
            ResourceKind::ShadowMaps { size, layers } => u64::from(*size).pow(2) * u64::from(*layers) * 4,
        })
    }
}

fn volume_texels(size: [u32; 3], mips: u32) -> u64 {
    (0..mips).map(|mip| size.iter().map(|n| u64::from((n >> mip).max(1))).product::<u64>()).sum()
}
