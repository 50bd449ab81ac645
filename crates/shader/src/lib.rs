//! WGSL modules: linked, checked with naga, reflected.
//!
//! A module is a WGSL file that may begin with imports, `import package::common::trace::{Apex, Reach};`,
//! a strict subset of WESL's. Its resource variables have names and no numbers: `var<uniform> frame: Frame;`. [`link`]
//! makes one text of a module and all that it imports, names as written, and gives each resource its `@group` and `@binding`;
//! [`Linked::check`] has naga validate it for a device without optional WebGPU features; the [`Shader`] that
//! results tells what it binds, its overrides, the layout of its structs and the types of its functions. Every
//! fault shows the author's own file, line and column.
//!
//! ```
//! use voxlume_fault::Source;
//! use voxlume_shader::{Library, link};
//!
//! let mut library = Library::empty();
//! library.insert("common/area", Source::new("area.wgsl", "fn area(r: f32) -> f32 { return 3.14 * r * r; }"));
//! let text = "import package::common::area::area;
//! var<storage, read_write> radius: array<f32>;
//! @compute @workgroup_size(64)
//! fn main(@builtin(global_invocation_id) id: vec3u) {
//!     radius[id.x] = area(radius[id.x]);
//! }";
//! library.insert("pass/areas", Source::new("areas.wgsl", text));
//!
//! let shader = link(&library, "pass/areas", &[])?.check()?;
//! assert_eq!(shader.bindings("main")[0].name, "radius");
//! # Ok::<(), voxlume_fault::Faults>(())
//! ```

mod binding;
mod check;
mod check_all;
mod contract;
mod explain;
mod import;
mod layout;
mod library;
mod limits;
mod link;
mod linked;
mod module;
mod mount;
mod reflect;
mod resource;
mod scope;
mod subset;
mod token;
mod words;

pub use binding::{Access, Binding, BindingKind, SampleKind, TextureDim};
pub use check::Shader;
pub use check_all::check_all;
pub use contract::{CONTRACTS, Contract, EFFECT, FORMAT_SAMPLE, Requirement, TRACER};
pub use layout::{Field, StructLayout};
pub use library::Library;
pub use link::link;
pub use linked::Linked;
pub use reflect::{EntryPoint, Override, Signature, Stage};
