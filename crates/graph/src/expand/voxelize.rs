//! Voxelization: occupancy, ranks, the list of cells, attributes.

use super::{Binds, Expansion, groups_for, step_params};
use crate::plan::{Groups, ResourceKind, Step, Target, Vertices};

/// Bytes of a `LevelRun`.
pub(crate) const LEVEL_RUN_BYTES: u64 = 32;

/// Voxel² of projected area up to which `hybrid` has a thread walk a triangle.
const CUTOFF: f64 = 4.0;

/// Least side of a tile in columns.
const TILE: u32 = 8;

/// Which thread walks which voxels: RAU §4.1.1 to §4.1.3, and tiles of columns as everybody's work.
#[derive(Clone, Copy, PartialEq)]
enum Method {
    /// A thread a triangle.
    Triangle,
    /// A fragment a column.
    Fragment,
    /// A thread a triangle up to so many voxel² of projected area, fragments for the rest.
    Hybrid(f64),
    /// A thread a triangle of one tile, a thread a tile for the rest.
    Balanced,
}

fn method(e: &mut Expansion<'_, '_>) -> Option<Method> {
    let (kind, faults) = (e.kind, &mut e.context.faults);
    let word = e.params.word_or(kind, "method", "balanced", faults);
    let cutoff = e.params.number_or(kind, "cutoff", CUTOFF, faults)?;
    Some(match word? {
        "triangle" => Method::Triangle,
        "fragment" => Method::Fragment,
        "hybrid" => Method::Hybrid(cutoff),
        _ => Method::Balanced,
    })
}

pub(crate) fn voxelize(e: &mut Expansion<'_, '_>) {
    let coverage = e.params.word_or(e.kind, "coverage", "binary", &mut e.context.faults);
    e.context.coverage = coverage == Some("area");
    let Some(method) = method(e) else { return };
    let triangles = e.context.facts.triangles;
    let (offsets, words) = e.context.grid.word_offsets();
    let stride = u64::from(e.context.attribute_stride());
    let runs = u64::from((words + 1).max(triangles + 1).div_ceil(64));
    let buffer = |words: u64| ResourceKind::Buffer(words * 4);
    let occupancy = e.context.resource("occupancy", buffer(words.into()));
    let ranks = e.context.resource("ranks", buffer(u64::from(words) + 1));
    let level_bytes = e.context.grid.levels() as u64 * LEVEL_RUN_BYTES;
    e.context.resource("levels", ResourceKind::Buffer(level_bytes));
    e.context.resource("scan_runs", buffer(runs));
    e.context.resource("cells", ResourceKind::PerCell(4));
    let attributes = e.context.resource("attributes", ResourceKind::PerVoxel(stride * 4));

    e.steps.push(Step::Clear(occupancy));
    visit(e, method, "visitor/occupancy", true);
    for level in 1..offsets.len() as u32 {
        let binds = Binds { targets: &[step_params(level)], ..Binds::default() };
        let groups = groups_for(e.context.grid.level_words(level), 64);
        e.compute("pass/hierarchy", "main", &binds, groups);
    }
    e.compute("pass/rank_count", "main", &Binds::default(), groups_for(words + 1, 64));
    scan(e, ranks, words + 1);
    e.compute("pass/level_runs", "main", &Binds::default(), [1, 1, 1]);
    e.steps.push(Step::Counted);
    e.compute("pass/list", "main", &Binds::default(), groups_for(words, 64));
    e.steps.push(Step::Clear(attributes));
    visit(e, method, "visitor/attributes", false);
}

/// Shows every overlapped voxel to a visitor; `first` counts what triangles leave to others.
fn visit(e: &mut Expansion<'_, '_>, method: Method, visitor: &str, first: bool) {
    let triangles = e.context.facts.triangles;
    let mount = Some(("visitor", visitor));
    let (defer, cutoff) = match method {
        Method::Fragment => return draw(e, visitor, Vertices::Fixed(3 * triangles), false),
        Method::Triangle => (0.0, CUTOFF),
        Method::Balanced => (1.0, CUTOFF),
        Method::Hybrid(cutoff) => (2.0, cutoff),
    };
    let tile = ("TILE", f64::from(tile_side(triangles, e.context.grid.size)));
    let mut constants =
        vec![("DEFER", defer), ("CUTOFF", cutoff), ("COUNTS", f64::from(u8::from(first))), tile];
    let mut targets = Vec::new();
    if method != Method::Triangle {
        let ranks = ResourceKind::Buffer((u64::from(triangles) + 1) * 4);
        let ranks = e.context.resource("tile_ranks", ranks);
        targets.push(("item_counts", Target::Resource(ranks)));
    } else {
        targets.push(("item_counts", Target::Nothing));
    }
    let binds = Binds { targets: &targets, constants: &constants, mount };
    e.compute("pass/voxelize_triangles", "main", &binds, groups_for(triangles + 1, 64));
    if method == Method::Triangle {
        return;
    }
    let groups = e.context.resource("item_groups", ResourceKind::Buffer(16));
    let drawn = method != Method::Balanced;
    if first {
        let ranks = e.context.resource("tile_ranks", ResourceKind::Buffer(0));
        scan(e, ranks, triangles + 1);
        constants.push(("DRAWN", f64::from(u8::from(drawn))));
        let binds = Binds { constants: &constants, ..Binds::default() };
        e.compute("pass/item_dispatch", "main", &binds, [1, 1, 1]);
    }
    if drawn {
        return draw(e, visitor, Vertices::Indirect { resource: groups, offset: 0 }, true);
    }
    let binds = Binds { constants: &constants, mount, ..Binds::default() };
    let groups = Groups::Indirect { resource: groups, offset: 0 };
    e.compute_groups("pass/voxelize_tiles", "main", &binds, groups);
}

fn draw(e: &mut Expansion<'_, '_>, visitor: &str, vertices: Vertices, deferred: bool) {
    let side = e.context.grid.size.into_iter().max().unwrap_or(1);
    let target = e.context.resource("columns", ResourceKind::Raster { side });
    let constants = [("DEFERRED", f64::from(u8::from(deferred)))];
    let binds = Binds { constants: &constants, mount: Some(("visitor", visitor)), ..Binds::default() };
    if let Some(program) = e.program_of("pass/voxelize_fragments", &["vertex_main", "fragment_main"], &binds)
    {
        e.steps.push(Step::Raster { program, target, vertices });
    }
}

/// So large that the tiles of all triangles can be counted in 32 bits, were each as large as the grid.
fn tile_side(triangles: u32, grid: [u32; 3]) -> u32 {
    let tiles = |side: u32| grid.iter().map(|n| u64::from(n.div_ceil(side)).pow(2)).max().unwrap_or(1);
    let fits = |side: &u32| tiles(*side) * u64::from(triangles) <= u64::from(u32::MAX);
    (TILE.ilog2()..16).map(|power| 1 << power).find(fits).unwrap_or(1 << 16)
}

fn scan(e: &mut Expansion<'_, '_>, values: usize, count: u32) {
    let targets = [("scan_values", Target::Resource(values))];
    let binds = Binds { targets: &targets, ..Binds::default() };
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
    fn no_count_of_tiles_overflows() {
        assert_eq!(tile_side(262_267, [512; 3]), TILE);
        for triangles in [1, 1_048_575, 1_048_576, 7_000_000, 11_000_000, u32::MAX] {
            let side = tile_side(triangles, [512; 3]);
            let tiles = u64::from(512_u32.div_ceil(side)).pow(2);
            assert!(tiles * u64::from(triangles) <= u64::from(u32::MAX), "{triangles}");
        }
    }
}
