//! RON read with its places.
//!
//! `ron` checks the syntax of the whole text once and reads the leaves; between them, [`Node`] keeps
//! the bytes of every value, so that a fault can point at it and a reader can go on to the next one.
//!
//! ```
//! use voxlume_fault::{Faults, Source, ron::{Document, Fields}};
//!
//! let source = Source::new("ball.ron", "Ball(radius: 2, centre: (0, 1, 0))");
//! let document = Document::parse(&source)?;
//! let mut faults = Faults::default();
//! let mut fields = Fields::of(document.root())?;
//! let radius: Option<f64> = fields.required("radius", &mut faults);
//! let centre: Option<[f64; 3]> = fields.required("centre", &mut faults);
//! let segments: Option<u32> = fields.optional("segments", &mut faults);
//! fields.finish(&mut faults);
//! faults.into_result(())?;
//! assert_eq!((radius, centre, segments), (Some(2.0), Some([0.0, 1.0, 0.0]), None));
//! # Ok::<(), Faults>(())
//! ```

mod document;
mod fields;
mod lexer;
mod node;
mod read;

pub use document::Document;
pub use fields::Fields;
pub use node::{Field, Node};
pub use read::FromRon;
