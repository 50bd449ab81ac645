//! A plan: what a device has to do, as plain data.

use voxlume_fault::Fault;
use voxlume_format::{Encoding, Numbers};
use voxlume_shader::{BindingKind, SampleKind, Shader};

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
    /// Buffers with the runs of each grid's levels, in `resources`: eight words a level, the fifth of which is its number of
    /// occupied cells once a step [`Step::Counted`] is reached.
    pub levels: Vec<usize>,
    /// Buffers of two words each, in `resources`: how many values an encoding could not hold in a pass, and the largest as
    /// a float's bits.
    pub out_of_range: Vec<usize>,
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
    /// How long its value is kept.
    pub life: Life,
}

/// How long a resource's value is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Life {
    /// Until a pass writes it again.
    Frame,
    /// A pass also reads the value before the last writing: there are two of it, which change places when a pass
    /// writes.
    History,
    /// Whoever writes it leaves it right for whoever comes next, in this frame or a later one: no pass depends on another
    /// one through it.
    Kept,
}

/// What a resource is.
#[derive(Clone, Debug, PartialEq)]
pub enum ResourceKind {
    /// Part of the scene or the frame, supplied by the engine under this name.
    Scene,
    /// A uniform buffer that begins with these bytes: a grid's values, or a pass's parameters.
    Uniform(Vec<u8>),
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
    /// A 2D texture.
    Image {
        /// Texels along x and y.
        extent: ImageExtent,
        /// Its texels.
        texel: ImageTexel,
        /// Array layers.
        layers: u32,
        /// Mip levels.
        mips: u32,
    },
    /// A target that nothing is drawn on, which gives rasterization its extent: a square of one byte a texel.
    Raster {
        /// Side in texels.
        side: u32,
    },
}

/// The size of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageExtent {
    /// The screen's size over a whole number, rounded up.
    Screen {
        /// 1 for the screen's own size.
        divisor: u32,
    },
    /// So many texels along x and y, whatever the screen.
    Fixed([u32; 2]),
}

impl ImageExtent {
    /// The screen's own size.
    pub const SCREEN: ImageExtent = ImageExtent::Screen { divisor: 1 };

    /// Texels along x and y on a screen of this size.
    pub fn size(self, screen: [u32; 2]) -> [u32; 2] {
        match self {
            ImageExtent::Screen { divisor } => screen.map(|side| side.div_ceil(divisor.max(1))),
            ImageExtent::Fixed(size) => size,
        }
    }
}

/// Texels of images.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageTexel {
    /// Four half floats.
    Rgba16Float,
    /// Four floats.
    Rgba32Float,
    /// Two floats.
    Rg32Float,
    /// One float.
    R32Float,
    /// One whole number.
    R32Uint,
    /// Four shares of 1, 8 bits each.
    Rgba8Unorm,
    /// sRGB colour, linear alpha, 8 bits each; only drawn, never written by a compute shader.
    Rgba8Srgb,
    /// 32-bit float depth; only drawn.
    Depth32,
}

impl ImageTexel {
    /// Those that an effect can write: WebGPU guarantees each as a storage texture.
    pub const WRITABLE: [ImageTexel; 6] = [
        ImageTexel::Rgba16Float,
        ImageTexel::Rgba32Float,
        ImageTexel::Rg32Float,
        ImageTexel::R32Float,
        ImageTexel::R32Uint,
        ImageTexel::Rgba8Unorm,
    ];

    /// The word in RON, which is WGSL's for a storage texture of such texels.
    pub fn name(self) -> &'static str {
        match self {
            ImageTexel::Rgba16Float => "rgba16float",
            ImageTexel::Rgba32Float => "rgba32float",
            ImageTexel::Rg32Float => "rg32float",
            ImageTexel::R32Float => "r32float",
            ImageTexel::R32Uint => "r32uint",
            ImageTexel::Rgba8Unorm => "rgba8unorm",
            ImageTexel::Rgba8Srgb => "rgba8srgb",
            ImageTexel::Depth32 => "depth32float",
        }
    }

    /// What a shader's variable wants instead, where it can't be bound to an image of such texels.
    pub(crate) fn misfit(self, variable: &BindingKind) -> Option<String> {
        match variable {
            BindingKind::StorageTexture { format, .. } => {
                (format != self.name()).then(|| format!("a storage texture of {format}"))
            }
            BindingKind::Texture { sample, filterable, .. } => {
                let own = match self {
                    ImageTexel::Depth32 => SampleKind::Depth,
                    ImageTexel::R32Uint => SampleKind::Uint,
                    _ => SampleKind::Float,
                };
                let filters =
                    matches!(self, ImageTexel::Rgba16Float | ImageTexel::Rgba8Unorm | ImageTexel::Rgba8Srgb);
                let what = match sample {
                    SampleKind::Float => "floats",
                    SampleKind::Depth => "depths",
                    SampleKind::Uint => "whole numbers, not negative",
                    SampleKind::Sint => "whole numbers",
                };
                if own != *sample {
                    return Some(format!("a texture of {what}"));
                }
                (own == SampleKind::Float && *filterable && !filters)
                    .then(|| "texels that a sampler filters; `textureLoad` reads these".to_owned())
            }
            _ => Some("no texture".to_owned()),
        }
    }

    /// Bytes of a texel.
    pub fn bytes(self) -> u64 {
        match self {
            ImageTexel::Rgba32Float => 16,
            ImageTexel::Rgba16Float | ImageTexel::Rg32Float => 8,
            ImageTexel::R32Float
            | ImageTexel::R32Uint
            | ImageTexel::Rgba8Unorm
            | ImageTexel::Rgba8Srgb
            | ImageTexel::Depth32 => 4,
        }
    }
}

/// One pass of the pipeline: it runs whole or not at all.
#[derive(Clone, Debug)]
pub struct Pass {
    /// The name in the pipeline.
    pub name: String,
    /// Names of the graph's resources that it reads, for `explain`.
    pub reads: Vec<String>,
    /// Names of those that it writes or updates.
    pub writes: Vec<String>,
    /// What to do, in order.
    pub steps: Vec<Step>,
    /// What it depends on beside `inputs`.
    pub sources: Sources,
    /// Resources, in [`Plan::resources`], of which it uses what earlier passes, or it in an earlier frame, left there.
    pub inputs: Vec<usize>,
    /// Names in the graph of what is in `inputs`, for `explain`.
    pub waits_for: Vec<String>,
    /// Resources that it writes and that some pass, or the reader of the output, may find there.
    pub outputs: Vec<usize>,
    /// When it runs.
    pub update: Update,
    /// Its parameters that can be changed without planning again.
    pub params: Vec<ParamSlot>,
}

/// What a pass depends on beside the resources that other passes make.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sources {
    /// Where triangles are.
    pub geometry: bool,
    /// Lights and sky.
    pub lights: bool,
    /// The camera, and the screen's size.
    pub camera: bool,
    /// The pass's own parameters.
    pub parameters: bool,
    /// The frame's number and time: it runs in every frame.
    pub time: bool,
}

/// When a pass runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Update {
    /// In each frame in which something that it depends on has changed.
    Changed,
    /// Likewise, but at most once in so many frames (DVS, "Optimizations").
    Every(u32),
    /// In the first frame, and then in those for which it is asked by name.
    OnDemand,
}

/// A parameter's place in its pass's uniform buffer.
#[derive(Clone, Debug, PartialEq)]
pub struct ParamSlot {
    /// The name in WGSL.
    pub name: String,
    /// The buffer, in [`Plan::resources`].
    pub resource: usize,
    /// The shader that says what it takes, in [`Plan::shaders`], and its struct: `Params` or `TraceParams`.
    pub shader: (usize, &'static str),
    /// Whether the plan left something out for its value: another value needs another plan.
    pub fixed: bool,
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
    /// The `@group` that the linker gave it.
    pub group: u32,
    /// The `@binding` that the linker gave it.
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
    /// The last value of a resource whose life is [`Life::History`].
    Last(usize),
    /// A uniform buffer with these bytes, which never change.
    Uniform(Vec<u8>),
    /// A texture of one texel of zeroes: what would be here was left out.
    Nothing,
}

/// Workgroups of a dispatch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Groups {
    /// This many.
    Fixed([u32; 3]),
    /// One for each 8 × 8 texels of an image, and each of its layers.
    Tiles(usize),
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
