//! Voxelization: occupancy, ranks, the list of cells, attributes.

use super::{Binds, Expansion, groups_for, step_params};
use crate::plan::{Groups, ResourceKind, Step, Target};

/// Bytes of a `LevelRun`.
pub(crate) const LEVEL_RUN_BYTES: u64 = 32;

pub(crate) fn voxelize(e: &mut Expansion<'_, '_>) {
    let triangles = e.context.facts.triangles;
    let (offsets, words) = e.context.grid.word_offsets();
    let stride = u64::from(e.context.attribute_stride());
    let runs = u64::from((words + 1).max(triangles + 1).div_ceil(64));
    let buffer = |words: u64| ResourceKind::Buffer(words * 4);
    let occupancy = e.context.resource("occupancy", buffer(words.into()));
    let ranks = e.context.resource("ranks", buffer(u64::from(words) + 1));
    let level_bytes = e.context.grid.levels() as u64 * LEVEL_RUN_BYTES;
    e.context.resource("levels", ResourceKind::Buffer(level_bytes));
    let tile_ranks = e.context.resource("tile_ranks", buffer(u64::from(triangles) + 1));
    let tile_groups = e.context.resource("tile_groups", buffer(4));
    e.context.resource("scan_runs", buffer(runs));
    e.context.resource("cells", ResourceKind::PerCell(4));
    let attributes = e.context.resource("attributes", ResourceKind::PerVoxel(stride * 4));
    let tiles = Groups::Indirect { resource: tile_groups, offset: 0 };

    e.steps.push(Step::Clear(occupancy));
    e.compute("pass/voxelize_count", "main", &Binds::default(), groups_for(triangles + 1, 64));
    scan(e, tile_ranks, triangles + 1);
    e.compute("pass/tile_dispatch", "main", &Binds::default(), [1, 1, 1]);
    e.compute_groups("pass/voxelize_occupancy", "main", &Binds::default(), tiles);
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
    e.compute_groups("pass/voxelize_attributes", "main", &Binds::default(), tiles);
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
