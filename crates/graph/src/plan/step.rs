//! Steps of a pass, and the programs that they run.

use voxlume_shader::BindingKind;

/// One dispatch, draw or clear.
#[derive(Clone, Debug)]
pub enum Step {
    /// Fills a buffer with zeroes.
    Clear(usize),
    /// Copies the beginning of a buffer to that of another, as much as both hold.
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
    /// In [`Plan::shaders`](super::Plan::shaders).
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
    /// The last value of a resource whose life is [`Life::History`](super::Life::History).
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
    /// One for each 8 × 8 threads over an image.
    Tiles {
        /// The image.
        image: usize,
        /// A thread for each quad of texels that lie between the same four of an image of half the size: one more along each side than
        /// that has. Otherwise one for each texel.
        quads: bool,
        /// Of its layers the first so many; unless given, all.
        layers: Option<u32>,
    },
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
