//! Resources that an entry point uses.

use naga::TypeInner;
use naga::common::wgsl::ToWgsl;
use naga::valid::FunctionInfo;
use naga::{AddressSpace, GlobalVariable, Handle, ImageClass, ImageDimension, ScalarKind, StorageAccess};

use crate::check::Shader;
use crate::layout::{size_of, uniform_size};

/// A resource variable and the number that the linker gave it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Binding {
    /// `@group`
    pub group: u32,
    /// `@binding`
    pub binding: u32,
    /// The variable's name.
    pub name: String,
    /// The path of the module that declares it.
    pub module: String,
    /// What is bound there.
    pub kind: BindingKind,
}

/// The kind of a resource.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum BindingKind {
    /// `var<uniform>`
    Uniform {
        /// Bytes, rounded up to 16.
        size: u64,
    },
    /// `var<storage>`
    Storage {
        /// Whether it is only read.
        read_only: bool,
        /// Bytes; of an array without a length, those of one element.
        min_size: u64,
    },
    /// `texture_2d<f32>` and the like.
    Texture {
        /// Its shape.
        dim: TextureDim,
        /// What reading it gives.
        sample: SampleKind,
        /// Whether it has several samples a pixel.
        multisampled: bool,
        /// Whether the entry point reads it through a sampler that may filter.
        filterable: bool,
    },
    /// `texture_storage_2d<rgba16float, write>` and the like.
    StorageTexture {
        /// Its shape.
        dim: TextureDim,
        /// The format as WGSL writes it: `rgba16float`.
        format: String,
        /// Whether it is read or written.
        access: Access,
    },
    /// `sampler` or `sampler_comparison`
    Sampler {
        /// Whether it compares depths.
        comparison: bool,
    },
}

/// The shape of a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "each is the end of its WGSL word: texture_2d_array")]
pub enum TextureDim {
    D1,
    D2,
    D2Array,
    D3,
    Cube,
    CubeArray,
}

/// What a texture holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SampleKind {
    /// Colours, as `f32`.
    Float,
    /// Depths.
    Depth,
    /// `u32`
    Uint,
    /// `i32`
    Sint,
}

/// How a storage texture is accessed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// `read`
    ReadOnly,
    /// `write`
    WriteOnly,
    /// `read_write`
    ReadWrite,
}

/// The binding that a variable is, if it is one that WebGPU has without an optional feature.
pub(crate) fn binding(
    shader: &Shader,
    info: &FunctionInfo,
    handle: Handle<GlobalVariable>,
) -> Option<Binding> {
    let module = &shader.module;
    let variable = &module.global_variables[handle];
    let at = variable.binding?;
    let kind = match variable.space {
        AddressSpace::Uniform => BindingKind::Uniform { size: uniform_size(size_of(module, variable.ty)) },
        AddressSpace::Storage { access } => BindingKind::Storage {
            read_only: !access.contains(StorageAccess::STORE),
            min_size: size_of(module, variable.ty),
        },
        AddressSpace::Handle => match module.types[variable.ty].inner {
            TypeInner::Sampler { comparison } => BindingKind::Sampler { comparison },
            TypeInner::Image { dim, arrayed, class } => {
                let is_sampled = info.sampling_set.iter().any(|pair| pair.image == handle);
                texture(dimension(dim, arrayed), class, is_sampled)?
            }
            _ => return None,
        },
        _ => return None,
    };
    let name = variable.name.clone()?;
    let module = shader.modules.iter().find(|module| module.declaration(&name).is_some())?;
    Some(Binding { group: at.group, binding: at.binding, name, module: module.path.clone(), kind })
}

fn texture(dim: TextureDim, class: ImageClass, is_sampled: bool) -> Option<BindingKind> {
    let (sample, multisampled) = match class {
        ImageClass::Sampled { kind, multi } => (sample_kind(kind)?, multi),
        ImageClass::Depth { multi } => (SampleKind::Depth, multi),
        ImageClass::Storage { format, access } => {
            let access = match (access.contains(StorageAccess::LOAD), access.contains(StorageAccess::STORE)) {
                (true, false) => Access::ReadOnly,
                (false, _) => Access::WriteOnly,
                (true, true) => Access::ReadWrite,
            };
            return Some(BindingKind::StorageTexture { dim, format: format.to_wgsl().to_owned(), access });
        }
        ImageClass::External => return None,
    };
    // Comparing samplers go with depths only, so that this one may filter.
    let filterable = sample == SampleKind::Float && is_sampled;
    Some(BindingKind::Texture { dim, sample, multisampled, filterable })
}

fn sample_kind(kind: ScalarKind) -> Option<SampleKind> {
    match kind {
        ScalarKind::Float => Some(SampleKind::Float),
        ScalarKind::Uint => Some(SampleKind::Uint),
        ScalarKind::Sint => Some(SampleKind::Sint),
        _ => None,
    }
}

fn dimension(dim: ImageDimension, arrayed: bool) -> TextureDim {
    match (dim, arrayed) {
        (ImageDimension::D1, _) => TextureDim::D1,
        (ImageDimension::D2, false) => TextureDim::D2,
        (ImageDimension::D2, true) => TextureDim::D2Array,
        (ImageDimension::D3, _) => TextureDim::D3,
        (ImageDimension::Cube, false) => TextureDim::Cube,
        (ImageDimension::Cube, true) => TextureDim::CubeArray,
    }
}
