//! Error metrics, tables and the report.
//!
//! [`Comparison::errors`] holds an image against its reference, [`Results`] are what many comparisons gave, as JSON,
//! CSV, text and one HTML page ([`page()`]).

mod axis;
mod baseline;
mod comparison;
mod csv;
mod date;
mod flip;
mod label;
mod metric;
mod number;
mod overview;
mod page;
mod pareto;
mod picture;
mod plot;
mod results;
mod stability;
mod table;
mod text;

pub use baseline::against;
pub use comparison::{Comparison, ComparisonError, Shown};
pub use csv::csv;
pub use date::utc_now;
pub use metric::{Errors, Note};
pub use overview::{Bound, Overview};
pub use page::{Strip, overview_plot, page, stability_page};
pub use pareto::pareto_front;
pub use picture::{PictureError, png, signed_error};
pub use results::{Device, OutOfRange, Outcome, Pass, Results, ResultsError, Row, SCHEMA, setting_words};
pub use stability::{Stability, StabilityRow};
pub use table::table;
