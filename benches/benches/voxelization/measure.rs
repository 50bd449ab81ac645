//! Times of the voxelization alone.

use std::collections::BTreeSet;
use std::path::Path;

use voxlume::{
    Gpu, Passes, Pipeline, Plan, Registry, Renderer, Request, ResourceKind, Scene, SceneFacts, Step, Value,
    plan,
};

use crate::arguments::Arguments;

/// One measured cell of the table.
#[derive(Debug)]
pub struct Cell {
    pub milliseconds: f64,
    /// Bytes of the voxels' buffers.
    pub bytes: u64,
}

/// Voxelizes a scene some times.
pub fn cell(
    gpu: &Gpu,
    scene: &Scene,
    resolution: u32,
    separability: &str,
    attributes: bool,
    method: &str,
    repeat: usize,
) -> Result<Cell, String> {
    timed(gpu, scene, voxelization(scene, resolution, separability, attributes, method, None)?, repeat)
}

fn timed(gpu: &Gpu, scene: &Scene, plan: Plan, repeat: usize) -> Result<Cell, String> {
    let mut renderer = Renderer::new(gpu, plan, scene).map_err(|error| error.to_string())?;
    let mut times = Vec::new();
    // The first warms up.
    for _ in 0..=repeat {
        let frame = renderer.render(scene, &scene.cameras[0], Passes::All);
        times.extend(frame.map_err(|error| error.to_string())?.first().map(|pass| pass.milliseconds));
    }
    times.remove(0);
    times.sort_by(f64::total_cmp);
    let plan = renderer.plan();
    let own = |name: &str| {
        plan.resource(name).is_some_and(|index| plan.resources[index].kind != ResourceKind::Scene)
    };
    let bytes = renderer.bytes().into_iter().filter(|(name, _)| own(name));
    Ok(Cell { milliseconds: times[times.len() / 2], bytes: bytes.map(|(_, bytes)| bytes).sum() })
}

/// The plan of the voxelization pass alone; without attributes, only up to the bitmask's finest level.
fn voxelization(
    scene: &Scene,
    resolution: u32,
    separability: &str,
    attributes: bool,
    method: &str,
    cutoff: Option<f64>,
) -> Result<Plan, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../pipelines/gi.ron");
    let mut pipeline = Pipeline::load(&path).map_err(|faults| faults.to_string())?;
    pipeline.separability.value = separability.to_owned();
    let set = |name: &str, value: Value| ("voxelize".to_owned(), name.to_owned(), value);
    let method = set("method", Value::Word(method.to_owned()));
    let cutoff = cutoff.map(|cutoff| set("cutoff", Value::Number(cutoff)));
    let request = Request {
        resolution: Some(resolution),
        set: [method].into_iter().chain(cutoff).collect(),
        ..Request::image(1, 1)
    };
    let facts = SceneFacts::of(scene).map_err(|faults| faults.to_string())?;
    let mut plan =
        plan(&pipeline, &facts, &Registry::builtin(), &request).map_err(|faults| faults.to_string())?;
    plan.passes.retain(|pass| pass.name == "voxelize");
    let hierarchy = |step: &Step| match step {
        Step::Compute { program, .. } => program.binds.iter().any(|bind| bind.name == "step_params"),
        _ => false,
    };
    let steps = &mut plan.passes[0].steps;
    if let Some(first) = steps.iter().position(hierarchy)
        && !attributes
    {
        steps.truncate(first);
    }
    // What other passes make is not allocated.
    let used: BTreeSet<usize> = steps.iter().flat_map(Step::touches).map(|touch| touch.resource).collect();
    for (index, resource) in plan.resources.iter_mut().enumerate() {
        if resource.kind != ResourceKind::Scene && !used.contains(&index) {
            resource.kind = ResourceKind::Buffer(0);
        }
    }
    Ok(plan)
}

/// Brackets the cutoff that makes `hybrid` fastest, by powers of two and then by golden sections.
pub fn search_cutoff(gpu: &Gpu, scene: &Scene, arguments: &Arguments) -> Result<(), String> {
    for resolution in &arguments.resolutions {
        for separability in &arguments.separabilities {
            let time = |power: f64| {
                let plan =
                    voxelization(scene, *resolution, separability, false, "hybrid", Some(power.exp2()))?;
                timed(gpu, scene, plan, arguments.repeat).map(|cell| cell.milliseconds)
            };
            let best = bracket(time)?;
            println!(
                "{resolution}³ {separability}: hybrid is fastest with a cutoff of {:.1} voxel²",
                best.exp2()
            );
        }
    }
    Ok(())
}

/// The least of a function of one variable (Press et al., Numerical Recipes, §10.2).
fn bracket(mut at: impl FnMut(f64) -> Result<f64, String>) -> Result<f64, String> {
    let coarse: Vec<f64> = (-2..=12).map(|power| at(f64::from(power))).collect::<Result<_, _>>()?;
    let least = coarse.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(index, _)| index);
    let (mut low, mut high) = (least as f64 - 3.0, least as f64 - 1.0);
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    let (mut a, mut b) = (high - golden * (high - low), low + golden * (high - low));
    let (mut time_a, mut time_b) = (at(a)?, at(b)?);
    while high - low > 0.25 {
        if time_a < time_b {
            (high, b, time_b) = (b, a, time_a);
            a = high - golden * (high - low);
            time_a = at(a)?;
        } else {
            (low, a, time_a) = (a, b, time_b);
            b = low + golden * (high - low);
            time_b = at(b)?;
        }
    }
    Ok((low + high) / 2.0)
}
