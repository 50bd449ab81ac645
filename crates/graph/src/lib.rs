//! Pass graphs: RON in, a checked plan out. No GPU.
//!
//! A [`Pipeline`] is a RON file; [`plan`] checks it against the shaders and storage formats, leaves out what the
//! scene doesn't need, and gives a [`Plan`] that an engine carries out.

mod builtin;
mod bundle;
mod entries;
mod expansion;
mod explain;
mod facts;
mod flow;
mod grid;
mod limits;
mod live;
mod order;
mod params;
mod pass;
mod pipeline;
mod plan;
mod planner;
mod probe;
mod prune;
mod registry;
mod shown;
mod storage;
mod tracer;
mod variant;

pub use builtin::PIPELINES;
pub use bundle::Bundle;
pub use expansion::{Expansion, Over, Run, screen_image};
pub use explain::explain;
pub use facts::{AREA_LIGHT_LIMIT, EMITTER_LIMIT, Emission, SceneFacts};
pub use flow::Touch;
pub use grid::{Extent, Grid, fixed_point_scale};
pub use pass::{DEFAULT_METHOD, Idle, Kinds, ParamWords, PassKind, Port, Sort, Unread, Values};
pub use pipeline::{ImageWords, Located, Param, PassEntry, Pipeline, SCALES, Value};
pub use plan::{
    Bind, Groups, ImageExtent, ImageTexel, LeftOut, Life, ParamBytes, ParamSlot, Pass, Plan, Program,
    Resource, ResourceKind, Sources, Step, Target, Update, Vertices,
};
pub use planner::{Request, plan};
pub use probe::{ProbeSize, probe};
pub use registry::Registry;
pub use shown::{Reference, Shows};
pub use tracer::{CONES, RAYS, Tracer, Tracers};
pub use variant::check_variant;
