//! A plan without a scene: given voxels are stored, filtered and sampled.

use glam::DVec3;
use voxlume_fault::{Faults, Source};
use voxlume_format::{Choices, Encoding, Encodings, Formats, StorageFormat};
use voxlume_scene::Scene;
use voxlume_shader::Library;

use crate::bundle::Bundle;
use crate::expansion::context::Given;
use crate::expansion::{Context, Expanded, Expansion, LEVEL_RUN_BYTES, Over, groups_for};
use crate::facts::{Emission, SceneFacts};
use crate::flow::Flow;
use crate::grid::Grid;
use crate::pass::{Kinds, PassKind, Port, Sort, attribute_stride, store_and_mipmap};
use crate::pipeline::Pipeline;
use crate::plan::{Pass, Plan, ResourceKind, Target, Update};
use crate::storage::Storage;
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
        (run: "stored", reads: ["voxels"], writes: ["volume"]),
        (run: "probe", reads: ["volume"], writes: ["probed"]),
    ],
)"#;

/// Stores one given radiance for each voxel.
#[derive(Debug)]
struct Stored {
    voxels: u64,
}

impl PassKind for Stored {
    fn name(&self) -> &str {
        "stored"
    }

    fn sentence(&self) -> &str {
        "stores given radiance in the storage format and makes its coarser levels"
    }

    fn reads(&self) -> &[Port] {
        &[const { Port::new("voxels", Sort::VOXELS, "given voxels") }]
    }

    fn writes(&self) -> &[Port] {
        &[const { Port::new("volume", Sort::VOLUME, "filtered radiance and opacity") }]
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let radiance = pass.resource("radiance", ResourceKind::Buffer(self.voxels * 16));
        let Some(volume) = pass.volume(&pass.written()) else { return };
        pass.makes(volume.bundle.clone());
        store_and_mipmap(pass, &volume, radiance, false);
    }
}

/// Samples the volume at given places.
#[derive(Debug)]
struct Probe {
    samples: u32,
}

impl PassKind for Probe {
    fn name(&self) -> &str {
        "probe"
    }

    fn sentence(&self) -> &str {
        "samples the volume at given places"
    }

    fn reads(&self) -> &[Port] {
        &[const { Port::new("volume", Sort::VOLUME, "filtered radiance and opacity") }]
    }

    fn writes(&self) -> &[Port] {
        &[const { Port::new("probed", Sort::new("samples"), "what was found") }]
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let [probes, probed] = ["probes", "probed"].map(|name| pass.resource(name, ResourceKind::Buffer(0)));
        pass.run("pass/probe")
            .reads("probes", Target::Resource(probes))
            .writes("probed", Target::Resource(probed))
            .over(Over::Groups(groups_for(self.samples, 64)));
    }
}

/// Plans what `filter` does with each voxel's radiance, for voxels that whoever carries out the plan writes into `occupancy`, `ranks`, `cells`,
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
    let mut kinds = Kinds::builtin();
    kinds.add(Stored { voxels: size.voxels });
    kinds.add(Probe { samples: size.samples });
    let tracers = Tracers::builtin();
    let encodings = Encodings::builtin();
    let (formats, filters_float32) = (Formats::builtin(), size.filters_float32);
    let given = Given {
        pipeline: &pipeline,
        facts: &facts,
        kinds: &kinds,
        formats: &formats,
        encodings: &encodings,
        tracers: &tracers,
        library,
        screen: [1, 1],
        filters_float32,
    };
    let mut context = Context::new(given, storage, grid, Emission::Gathered);
    // Opacity as it comes.
    let stride = attribute_stride(context.voxel_emission(), true);
    let samples = u64::from(size.samples);
    let mut voxels = Bundle::of("grid", Target::Resource(context.grid_resource(0)));
    voxels.set_grid(0);
    voxels.with("HAS_COVERAGE", 1.0);
    voxels.with("ATTRIBUTE_STRIDE", f64::from(stride));
    for (name, bytes) in [
        ("occupancy", words * 4),
        ("ranks", (words + 1) * 4),
        ("cells", size.cells * 4),
        ("levels", levels * LEVEL_RUN_BYTES),
        ("attributes", size.voxels * u64::from(stride) * 4),
    ] {
        voxels.add(name, Target::Resource(context.resource(name, ResourceKind::Buffer(bytes))));
    }
    let mut buffer = |name, bytes| context.resource(name, ResourceKind::Buffer(bytes));
    buffer("probes", samples * PROBE_BYTES);
    let output = buffer("probed", samples * 16);
    context.bundles.insert("voxels".into(), voxels);
    let mut passes = Vec::new();
    for entry in &pipeline.passes {
        let mut expansion = Expansion::new(&mut context, entry);
        kinds.of(entry).expand(&mut expansion);
        let Expanded { steps, params, .. } = expansion.finish();
        let Flow { sources, inputs, outputs } =
            Flow::of(&steps, &context.shaders, &context.resources, &params);
        let (name, update) = (entry.name.clone(), Update::Changed);
        passes.push(Pass {
            name,
            reads: vec![],
            writes: vec![],
            steps,
            sources,
            inputs,
            waits_for: vec![],
            outputs,
            update,
            params,
        });
    }
    let Context { shaders, resources, faults, mut grids, out_of_range, .. } = context;
    faults.into_result(Plan {
        format: format.name().to_owned(),
        encoding,
        tracer: pipeline.tracer.value.clone(),
        grid: grids.swap_remove(0),
        screen: [1, 1],
        triangles: 0,
        emission: Emission::Gathered,
        shaders,
        resources,
        passes,
        left_out: Vec::new(),
        output,
        levels: Vec::new(),
        out_of_range,
        memory_budget: None,
    })
}
