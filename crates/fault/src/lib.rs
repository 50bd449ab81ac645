//! Faults: what is wrong, where, and what would be valid; and RON read with its places.
//!
//! ```
//! use voxlume_fault::{Fault, Source, one_of};
//!
//! let source = Source::new("pipelines/gi.ron", "(\n    format: \"sixface\",\n)\n");
//! let fault = Fault::new("unknown storage format `sixface`")
//!     .at(&source, 14..23, one_of(["isotropic", "six_face", "sh2"]));
//! assert_eq!(
//!     fault.to_string(),
//!     "error: unknown storage format `sixface`
//!   ┌─ pipelines/gi.ron:2:13
//!   │
//! 2 │     format: \"sixface\",
//!   │             ^^^^^^^^^ one of: isotropic, six_face, sh2"
//! );
//! ```

mod choice;
mod fault;
pub mod ron;
mod source;

pub use choice::{nearest, one_of, suggest};
pub use fault::{Fault, Faults, Place};
pub use source::{SOURCE_LIMIT, Source};
