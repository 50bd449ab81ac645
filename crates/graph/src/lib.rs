//! Pass graphs: RON in, a checked plan out. No GPU.
//!
//! A [`Pipeline`] is a RON file; [`plan`] checks it against the shaders and storage formats, leaves out what the
//! scene doesn't need, and gives a [`Plan`] that an engine carries out.

mod entries;
mod expand;
mod explain;
mod facts;
mod grid;
mod kind;
mod limits;
mod live;
mod order;
mod params;
mod pipeline;
mod plan;
mod planner;
mod probe;
mod registry;
mod tracer;
mod variant;

pub use expand::voxelize::DEFAULT_METHOD;
pub use explain::explain;
pub use facts::{AREA_LIGHT_LIMIT, SceneFacts};
pub use grid::{Extent, Grid, fixed_point_scale};
pub use kind::{KINDS, Kind, ParamWords, Port, SURFACE_IMAGES, Values};
pub use pipeline::{Located, Param, PassEntry, Pipeline, Value};
pub use plan::{
    Bind, Groups, ImageTexel, LeftOut, Pass, Plan, Program, Resource, ResourceKind, Step, Target, Vertices,
};
pub use planner::{Request, plan};
pub use probe::{ProbeSize, probe};
pub use registry::Registry;
pub use tracer::{CONES, Tracer, Tracers};
pub use variant::check_variant;
