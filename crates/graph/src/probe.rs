//! A plan without a scene: given voxels are stored, filtered and sampled.

use glam::DVec3;
use voxlume_fault::{Faults, Source};
use voxlume_format::{Choices, Encoding, StorageFormat};
use voxlume_scene::Scene;
use voxlume_shader::Library;

use crate::expand::voxelize::LEVEL_RUN_BYTES;
use crate::expand::{Binds, Context, Expansion, Storage, groups_for};
use crate::facts::SceneFacts;
use crate::grid::Grid;
use crate::kind::{KINDS, Kind};
use crate::pipeline::Pipeline;
use crate::plan::{Pass, Plan, ResourceKind, Target};
use crate::tracer::Tracers;

/// How much a [`probe`] holds.
#[derive(Clone, Copy, Debug)]
pub struct ProbeSize {
    /// Voxels along each side of the grid, a power of two.
    pub side: u32,
    /// Most occupied voxels.
    pub voxels: u64,
    /// Most occupied cells of all levels.
    pub cells: u64,
    /// Samples.
    pub samples: u32,
    /// Whether the device filters textures of 32-bit floats.
    pub filters_float32: bool,
}

const PROBE_BYTES: u64 = 32;

const PIPELINE: &str = r#"(
    format: "given", encoding: "given", resolution: 16, separability: "conservative", output: "probed",
    passes: [
        (run: "filter", reads: ["voxels", "radiance"], writes: ["volume"]),
        (run: "probe", reads: ["volume"], writes: ["probed"]),
    ],
)"#;

static PROBE: Kind =
    Kind { name: "probe", sentence: "", reads: &[], writes: &[], updates: &[], words: &[], expand: sample };

/// Plans what `filter` does for voxels that whoever carries out the plan writes into `occupancy`, `ranks`, `cells`,
/// `levels`, `attributes` (12 words a voxel, the last its opacity) and `radiance`, and then samples the volume as
/// `probes` says into `probed`: 32 bytes (uvw, level, direction of travel, padding) and 16 bytes (`voxel_sample`) a sample.
///
/// # Errors
/// Every fault of the format's shaders.
pub fn probe(
    format: &dyn StorageFormat,
    choices: &Choices,
    encoding: Encoding,
    library: &Library,
    size: ProbeSize,
) -> Result<Plan, Faults> {
    let pipeline = Pipeline::parse(&Source::new("probe", PIPELINE))?;
    let facts = SceneFacts::of(&Scene::default())?;
    let grid = Grid { size: [size.side; 3], centre: DVec3::ZERO, voxel_size: 1.0 };
    let storage = Storage::new(format, choices.clone(), encoding, size.filters_float32);
    let (levels, words) = (u64::from(grid.levels()), u64::from(grid.word_offsets().1));
    let tracers = Tracers::builtin();
    let mut context = Context::new(&pipeline, &facts, storage, grid, [1, 1], library.clone(), &tracers);
    // Opacity as it comes.
    context.coverage = true;
    let stride = u64::from(context.attribute_stride());
    let samples = u64::from(size.samples);
    for (name, bytes) in [
        ("occupancy", words * 4),
        ("ranks", (words + 1) * 4),
        ("cells", size.cells * 4),
        ("levels", levels * LEVEL_RUN_BYTES),
        ("attributes", size.voxels * stride * 4),
        ("radiance", size.voxels * 16),
        ("probes", samples * PROBE_BYTES),
        ("probed", samples * 16),
    ] {
        context.resource(name, ResourceKind::Buffer(bytes));
    }
    let named = |name: &str, context: &Context<'_>| {
        context.resources.iter().position(|resource| resource.name == name).unwrap_or_default()
    };
    context.first = named("radiance", &context);
    let output = named("probed", &context);
    let mut passes = Vec::new();
    for entry in &pipeline.passes {
        let kind = KINDS.iter().find(|kind| kind.name == entry.name).unwrap_or(&PROBE);
        let mut expansion = Expansion::new(&mut context, entry, kind);
        (kind.expand)(&mut expansion);
        // Neither kind has anything to do only once.
        let (_, steps) = expansion.finish();
        passes.push(Pass { name: entry.name.clone(), once: false, reads: vec![], writes: vec![], steps });
    }
    let Context { shaders, resources, faults, grid, .. } = context;
    faults.into_result(Plan {
        format: format.name().to_owned(),
        encoding,
        tracer: pipeline.tracer.value.clone(),
        grid,
        screen: [1, 1],
        triangles: 0,
        area_lights: false,
        shaders,
        resources,
        passes,
        left_out: Vec::new(),
        output,
        memory_budget: None,
    })
}

fn sample(e: &mut Expansion<'_, '_>) {
    let [probes, probed] = ["probes", "probed"].map(|name| e.context.resource(name, ResourceKind::Buffer(0)));
    let targets = [("probes", Target::Resource(probes)), ("probed", Target::Resource(probed))];
    let samples = match e.context.resources[probes].kind {
        ResourceKind::Buffer(bytes) => bytes / PROBE_BYTES,
        _ => 0,
    };
    let binds = Binds { targets: &targets, ..Binds::default() };
    e.compute("pass/probe", "main", &binds, groups_for(samples as u32, 64));
}
