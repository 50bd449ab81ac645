//! Voxelization: occupancy, ranks, the list of cells, attributes.

use std::ops::Range;

use super::{Binds, Expansion, groups_for, step_params};
use crate::grid::Grid;
use crate::plan::{Groups, LeftOut, ResourceKind, Step, Target, Vertices};

/// Bytes of a `LevelRun`.
pub(crate) const LEVEL_RUN_BYTES: u64 = 32;

/// Voxel² of projected area up to which `hybrid` has a thread walk a triangle.
const CUTOFF: f64 = 4.0;

/// Rows of the largest grid: a band has at least one.
const MOST_BANDS: u32 = *Grid::RESOLUTIONS.end();

/// Words of the bitmask that a thread of wgsl/pass/list.wgsl looks at.
const LISTED_WORDS: u32 = 16;

/// Voxels. A triangle with shorter edges is less than 39.1 voxel² large and 11.5 voxels wide and high: together less than
/// 64 columns, the least for two bands in wgsl/common/bands.wgsl.
const EDGE_OF_TWO_BANDS: f64 = 9.5;

/// The word for the method of a pass that doesn't say.
pub const DEFAULT_METHOD: &str = "balanced";

/// Which thread walks which voxels: RAU §4.1.1 to §4.1.3, and bands of rows of columns as everybody's work.
#[derive(Clone, Copy, PartialEq)]
enum Method {
    /// A thread a triangle.
    Triangle,
    /// A fragment a column.
    Fragment,
    /// A thread a triangle up to so many voxel² of projected area, fragments for the rest.
    Hybrid(f64),
    /// A thread a triangle of one band, a thread a band for the rest.
    Balanced,
}

fn method(e: &mut Expansion<'_, '_>) -> Option<Method> {
    let (kind, faults) = (e.kind, &mut e.context.faults);
    let word = e.params.word_or(kind, "method", DEFAULT_METHOD, faults);
    let cutoff = e.params.number_or(kind, "cutoff", CUTOFF, faults)?;
    Some(match word? {
        "triangle" => Method::Triangle,
        "fragment" => Method::Fragment,
        "hybrid" => Method::Hybrid(cutoff),
        _ if is_fine(e) => Method::Triangle,
        _ => Method::Balanced,
    })
}

/// Whether no triangle has two bands.
fn is_fine(e: &mut Expansion<'_, '_>) -> bool {
    let longest = e.context.facts.longest_edge / f64::from(e.context.grid.voxel_size);
    let fine = longest < EDGE_OF_TWO_BANDS;
    if fine {
        e.context.left_out.push(LeftOut {
            what: "bands of large triangles".into(),
            why: format!("no edge is longer than {longest:.1} voxels"),
            bytes: u64::from(e.context.facts.triangles + 1) * 4,
        });
    }
    fine
}

/// Triangles, and how and into what they are voxelized.
struct Part {
    method: Method,
    triangles: Range<u32>,
    /// What stands for `occupancy`, `ranks` and `attributes`, where it isn't the scene's own.
    targets: Vec<(&'static str, Target)>,
}

/// A buffer of so many words.
fn words(count: u32) -> ResourceKind {
    ResourceKind::Buffer(u64::from(count) * 4)
}

pub(crate) fn voxelize(e: &mut Expansion<'_, '_>) {
    let coverage = e.params.word_or(e.kind, "coverage", "binary", &mut e.context.faults);
    e.context.coverage = coverage == Some("area");
    let conflict = e.params.word_or(e.kind, "conflict", "sum", &mut e.context.faults);
    e.context.conflict = conflict.unwrap_or_default();
    let Some(method) = method(e) else { return };
    let triangles = e.context.facts.triangles;
    let moving = e.context.facts.moving_triangles;
    let still = triangles - moving;
    let divided = moving > 0 && still > 0;
    let (offsets, all) = e.context.grid.word_offsets();
    let stride = u64::from(e.context.attribute_stride());
    let occupancy = e.context.resource("occupancy", words(all));
    let ranks = e.context.resource("ranks", words(all + 1));
    let level_bytes = e.context.grid.levels() as u64 * LEVEL_RUN_BYTES;
    e.context.resource("levels", ResourceKind::Buffer(level_bytes));
    e.context.resource("scan_runs", words((all + 1).max(triangles + 1).div_ceil(64)));
    e.context.resource("cells", ResourceKind::PerCell(4));
    let attributes = e.context.resource("attributes", ResourceKind::PerVoxel(stride * 4));

    if divided {
        static_voxels(e, method, stride);
    }
    if moving > 0 {
        // Tells the volume which cells were left.
        let before = e.context.resource("occupancy_before", words(all));
        e.steps.push(Step::Copy { from: occupancy, to: before });
    }
    match e.context.known("static_occupancy") {
        Some(from) => e.steps.push(Step::Copy { from, to: occupancy }),
        None => e.steps.push(Step::Clear(occupancy)),
    }
    let first = if divided { still } else { 0 };
    let part = Part { method, triangles: first..triangles, targets: Vec::new() };
    visit(e, &part, "visitor/occupancy", true);
    for level in 1..offsets.len() as u32 {
        let binds = Binds { targets: &[step_params(level)], ..Binds::default() };
        let groups = groups_for(e.context.grid.level_words(level), 64);
        e.compute("pass/hierarchy", "main", &binds, groups);
    }
    scan(e, &[], ranks, all + 1, true);
    e.compute("pass/level_runs", "main", &Binds::default(), [1, 1, 1]);
    e.steps.push(Step::Counted);
    let listed = [("WORDS", f64::from(LISTED_WORDS))];
    let binds = Binds { constants: &listed, ..Binds::default() };
    e.compute("pass/list", "main", &binds, groups_for(all, 64 * LISTED_WORDS));
    if divided {
        e.compute_cells("pass/static_sums", &Binds::default(), 0);
    } else {
        e.steps.push(Step::Clear(attributes));
    }
    visit(e, &part, "visitor/attributes", false);
}

/// Voxelizes what never moves by itself, once (DVS §1.2). Sums are integers: adding what moves to these gives the same
/// bits as adding everything anew.
fn static_voxels(e: &mut Expansion<'_, '_>, method: Method, stride: u64) {
    let finest = e.context.grid.level_words(0);
    let occupancy = e.context.resource("static_occupancy", words(finest));
    let ranks = e.context.resource("static_ranks", words(finest + 1));
    // At most as many voxels as there are in all.
    let attributes = e.context.resource("static_attributes", ResourceKind::PerVoxel(stride * 4));
    let targets = [("occupancy", occupancy), ("ranks", ranks), ("attributes", attributes)];
    let targets = targets.map(|(name, resource)| (name, Target::Resource(resource))).to_vec();
    let still = e.context.facts.triangles - e.context.facts.moving_triangles;
    let part = Part { method, triangles: 0..still, targets };
    e.steps.push(Step::Clear(occupancy));
    visit(e, &part, "visitor/occupancy", true);
    scan(e, &part.targets, ranks, finest + 1, true);
    e.steps.push(Step::Counted);
    e.steps.push(Step::Clear(attributes));
    visit(e, &part, "visitor/attributes", false);
    e.once = std::mem::take(&mut e.steps);
}

/// Triangles of a part, with an alpha mask or without.
struct Class {
    triangles: Range<u32>,
    /// Buffer that says how much its triangles leave to others.
    items: usize,
    targets: Vec<(&'static str, Target)>,
    constants: [(&'static str, f64); 7],
}

/// Shows every overlapped voxel to a visitor; `first` counts what triangles leave to others. Triangles with an alpha mask
/// come last, and apart, so that the others need not look for one.
fn visit(e: &mut Expansion<'_, '_>, part: &Part, visitor: &'static str, first: bool) {
    let Range { start, end } = part.triangles;
    let split = end - e.context.facts.masked_in(&part.triangles);
    let mount = Some(("visitor", visitor));
    let deferred = matches!(part.method, Method::Hybrid(_) | Method::Balanced);
    // As many as either the triangles that never move or those that may.
    let all = e.context.facts.triangles;
    let ranks = deferred.then(|| e.context.resource("item_ranks", words(all + 1)));
    let classes: Vec<Class> =
        [(start..split, false, "item_groups"), (split..end, true, "masked_item_groups")]
            .into_iter()
            .filter(|(triangles, ..)| !triangles.is_empty())
            .map(|(triangles, masked, groups)| {
                let items = e.context.resource(groups, ResourceKind::Buffer(16));
                let mut targets = part.targets.clone();
                let ranks = ranks.map_or(Target::Nothing, Target::Resource);
                targets.extend([("item_ranks", ranks.clone()), ("item_counts", ranks)]);
                targets.push(("item_groups", Target::Resource(items)));
                targets.push(("triangle_range", triangle_range(&triangles, triangles.start - start)));
                let constants = constants(part.method, all, masked, first);
                Class { triangles, items, targets, constants }
            })
            .collect();
    if part.method != Method::Fragment {
        for class in &classes {
            let binds = class.binds(mount);
            let groups = groups_for(class.triangles.end - class.triangles.start + 1, 64);
            e.compute("pass/voxelize_triangles", "main", &binds, groups);
        }
    }
    if let (true, Some(ranks)) = (first, ranks) {
        scan(e, &[], ranks, end - start + 1, false);
        for class in &classes {
            e.compute("pass/item_dispatch", "main", &class.binds(None), [1, 1, 1]);
        }
    }
    for class in &classes {
        let binds = class.binds(mount);
        let (resource, offset) = (class.items, 0);
        match part.method {
            Method::Triangle => {}
            Method::Balanced => {
                e.compute_groups(
                    "pass/voxelize_bands",
                    "main",
                    &binds,
                    Groups::Indirect { resource, offset },
                );
            }
            Method::Hybrid(_) => draw(e, &binds, Vertices::Indirect { resource, offset }),
            Method::Fragment => {
                let count = class.triangles.end - class.triangles.start;
                draw(e, &binds, Vertices::Fixed(3 * count));
            }
        }
    }
}

fn constants(method: Method, triangles: u32, masked: bool, first: bool) -> [(&'static str, f64); 7] {
    let flag = |on: bool| f64::from(u8::from(on));
    let (defer, cutoff) = match method {
        Method::Triangle | Method::Fragment => (0.0, CUTOFF),
        Method::Balanced => (1.0, CUTOFF),
        Method::Hybrid(cutoff) => (2.0, cutoff),
    };
    [
        ("HAS_ALPHA_MASK", flag(masked)),
        ("MOST_BANDS", f64::from(most_bands(triangles))),
        ("DEFER", defer),
        ("CUTOFF", cutoff),
        ("COUNTS", flag(first)),
        ("DRAWN", flag(method != Method::Balanced)),
        ("DEFERRED", flag(defer != 0.0)),
    ]
}

impl Class {
    fn binds(&self, mount: Option<(&'static str, &'static str)>) -> Binds<'_> {
        Binds { targets: &self.targets, constants: &self.constants, mount }
    }
}

/// `TriangleRange` in wgsl/common/mesh.wgsl.
fn triangle_range(triangles: &Range<u32>, item_first: u32) -> Target {
    let words = [triangles.start, triangles.end - triangles.start, item_first, 0];
    Target::Uniform(words.iter().flat_map(|word| word.to_le_bytes()).collect())
}

fn draw(e: &mut Expansion<'_, '_>, binds: &Binds<'_>, vertices: Vertices) {
    let side = e.context.grid.size.into_iter().max().unwrap_or(1);
    let target = e.context.resource("columns", ResourceKind::Raster { side });
    if let Some(program) = e.program_of("pass/voxelize_fragments", &["vertex_main", "fragment_main"], binds) {
        e.steps.push(Step::Raster { program, target, vertices });
    }
}

/// So few bands of a triangle that those of all triangles can be counted in 32 bits.
fn most_bands(triangles: u32) -> u32 {
    (u32::MAX / triangles.max(1)).clamp(1, MOST_BANDS)
}

/// Exclusive prefix sum over so many values in place, or of the bitmask's words.
fn scan(e: &mut Expansion<'_, '_>, targets: &[(&str, Target)], values: usize, count: u32, bits: bool) {
    let values = [("scan_values", Target::Resource(values))];
    let occupancy = if bits { &[] } else { &[("occupancy", Target::Nothing)][..] };
    let targets = [&values[..], occupancy, targets].concat();
    let constants = [("COUNTS_BITS", f64::from(u8::from(bits)))];
    let binds = Binds { targets: &targets, constants: &constants, mount: None };
    let runs = groups_for(count.div_ceil(64), 64);
    e.compute("pass/scan", "reduce", &binds, runs);
    e.compute("pass/scan", "runs", &binds, [1, 1, 1]);
    e.compute("pass/scan", "apply", &binds, runs);
}

impl Expansion<'_, '_> {
    /// Adds a dispatch of a fixed number of workgroups.
    pub(crate) fn compute(&mut self, module: &str, entry: &'static str, binds: &Binds<'_>, groups: [u32; 3]) {
        self.compute_groups(module, entry, binds, Groups::Fixed(groups));
    }

    /// Adds a dispatch.
    pub(crate) fn compute_groups(
        &mut self,
        module: &str,
        entry: &'static str,
        binds: &Binds<'_>,
        groups: Groups,
    ) {
        if let Some(program) = self.program(module, entry, binds) {
            self.steps.push(Step::Compute { program, groups });
        }
    }

    /// Adds a dispatch with a thread for each occupied cell of a level.
    pub(crate) fn compute_cells(&mut self, module: &str, binds: &Binds<'_>, level: u32) {
        // Missing only where nothing voxelizes, which is a fault of its own.
        let Some(levels) = self.context.known("levels") else { return };
        let groups = Groups::Indirect { resource: levels, offset: u64::from(level) * LEVEL_RUN_BYTES };
        self.compute_groups(module, "main", binds, groups);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_count_of_bands_overflows() {
        assert_eq!(most_bands(262_267), MOST_BANDS);
        for triangles in [1, 1_048_575, 8_388_608, 11_000_000, u32::MAX] {
            assert!(
                u64::from(most_bands(triangles)) * u64::from(triangles) <= u64::from(u32::MAX),
                "{triangles}"
            );
        }
    }
}
