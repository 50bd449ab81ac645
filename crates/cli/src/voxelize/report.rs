//! What voxelization found and cost, as a table and as JSON.

use serde::Serialize;
use voxlume::{Gpu, Pipeline, Renderer, ResourceKind, Scene};
use voxlume_measure::{Frames, describe};
use voxlume_report::{Device, Pass};

use super::cells::{bytes, words};
use crate::failure::Failure;
use crate::table::Table;
use crate::timing::Resource;

/// Its JSON is version 1 of `voxelize --json`.
#[derive(Debug, Serialize)]
pub struct Report {
    schema: u32,
    device: Device,
    scene: String,
    triangles: u32,
    method: String,
    separability: String,
    /// Voxels along x, y, z.
    grid: [u32; 3],
    /// World units.
    voxel_size: f32,
    /// Voxels that a triangle touches.
    occupied: u64,
    /// Occupied cells of all levels.
    cells: u64,
    /// Voxels with opposite sides, front and back of a surface or two walls back to back.
    two_sided: u64,
    /// BLAKE3 of the words of level 0's bitmask, little endian.
    occupancy_hash: String,
    /// BLAKE3 of the attribute sums of all occupied voxels, little endian.
    attribute_hash: String,
    /// Of voxelization, over the runs.
    median_ms: f64,
    spread_ms: f64,
    clock: String,
    runs: usize,
    /// Of all resources.
    bytes: u64,
    resources: Vec<Resource>,
}

impl Report {
    /// Reads hashes back from the device; `frames` has the times of voxelization alone.
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        (pipeline, method): (&Pipeline, String),
        renderer: &Renderer<'_>,
        frames: &Frames,
    ) -> Result<Report, Failure> {
        let plan = renderer.plan();
        let (occupied, cells) = renderer.counts();
        let occupancy = bytes(renderer, "occupancy")?;
        let attributes = bytes(renderer, "attributes")?;
        let of = |name: &str| plan.resource(name).map(|index| &plan.resources[index].kind);
        let two_sided = match of("sheets") {
            Some(ResourceKind::PerVoxel(stride)) => two_sided(&words(renderer, "sheets")?, *stride, occupied),
            _ => 0,
        };
        let Some(ResourceKind::PerVoxel(stride)) = of("attributes") else {
            return Err(Failure::work("the plan has no attributes"));
        };
        let (words, sums) = (plan.grid.level_words(0) as usize, (occupied * stride) as usize);
        let resources: Vec<Resource> =
            renderer.bytes().into_iter().map(|(name, bytes)| Resource { name, bytes }).collect();
        let clock = frames.passes().first().map(|pass: &Pass| pass.clock.clone()).unwrap_or_default();
        let (median_ms, spread_ms) = frames.total();
        Ok(Report {
            schema: 1,
            device: describe(&gpu.info),
            scene: scene.name.clone(),
            triangles: plan.triangles,
            method,
            separability: pipeline.separability.value.clone(),
            grid: plan.grid.size,
            voxel_size: plan.grid.voxel_size,
            occupied,
            cells,
            two_sided,
            occupancy_hash: hash(&occupancy[..4 * words]),
            attribute_hash: hash(&attributes[..sums]),
            median_ms,
            spread_ms,
            clock,
            runs: frames.count(),
            bytes: resources.iter().map(|resource| resource.bytes).sum(),
            resources,
        })
    }

    /// What `voxelize` prints.
    pub fn tables(&self) -> String {
        let Device { name, kind, driver } = &self.device;
        let [x, y, z] = self.grid;
        let mut table = Table::new(["voxels", ""]).numbers_from(1);
        let mut row = |what: &str, value: String| table.row([what.to_owned(), value]);
        row("triangles", self.triangles.to_string());
        row("occupied voxels", self.occupied.to_string());
        row("occupied cells of all levels", self.cells.to_string());
        row("voxels of opposite sides", self.two_sided.to_string());
        row("median ms", format!("{:.2}", self.median_ms));
        row("spread ms", if self.runs > 1 { format!("{:.2}", self.spread_ms) } else { "-".to_owned() });
        row("bytes of all resources", self.bytes.to_string());
        let clock = match self.clock.as_str() {
            "gpu" => "the device's timestamps",
            _ => "the host's clock, as the device has no timestamps to rely on",
        };
        let runs = match self.runs {
            1 => "one run".to_owned(),
            runs => format!("{runs} runs (spread: interquartile range)"),
        };
        format!(
            "{name} · {kind} · {driver}\n\
             {} · {x} × {y} × {z} {} voxels, each {:.4} wide · {}\n\n\
             times of {runs} after one of warm-up, by {clock}\n{table}\n\
             occupancy   {}\nattributes  {}\n",
            self.scene,
            self.separability,
            self.voxel_size,
            self.method,
            self.occupancy_hash,
            self.attribute_hash,
        )
    }
}

/// Of voxels of `bytes` each, as many as have opposite sides: see wgsl/common/sheet.wgsl.
fn two_sided(sheets: &[u32], bytes: u64, voxels: u64) -> u64 {
    const SHEETS: usize = 6;
    const HAS_BACK: u32 = 1 << 29;
    const THERE: u32 = 1 << 31;
    // One after another the first sheets of all voxels, their second ones and so on, two words each.
    let entries = (bytes / 8) as usize;
    let capacity = sheets.len() / 2 / entries.max(1);
    let of_voxel = |slot: usize| {
        let words = (0..SHEETS).filter_map(|i| sheets.get(2 * (slot + i * capacity) + 1).copied());
        let words: Vec<u32> = words.filter(|word| word & THERE != 0).collect();
        // Sheets come by axis.
        words.iter().any(|word| word & HAS_BACK != 0)
            || words.windows(2).any(|pair| (pair[0] ^ pair[1]) >> 25 & 3 == 0)
    };
    (0..voxels as usize).filter(|slot| of_voxel(*slot)).count() as u64
}

fn hash(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}
