//! Volumes stored, filtered and gathered: what `emission`, `filter` and `bounce` share.

use voxlume_format::Volume;

use crate::bundle::Bundle;
use crate::expansion::{Expansion, Over, groups_for, step_params};
use crate::plan::{ResourceKind, Target};

/// A storage format's volumes of a grid.
#[derive(Clone, Debug)]
pub struct VolumeSet {
    /// What the volume's name stands for.
    pub bundle: Bundle,
    name: String,
    parts: Vec<(Volume, usize)>,
    /// What every side of a voxel sends: what the volume is made of.
    sides: usize,
    /// Bytes of its textures.
    pub(crate) texture_bytes: u64,
}

impl Expansion<'_, '_> {
    /// The volumes that a name of the graph stands for, of the grid whose voxels this pass reads: in the format and the
    /// encoding that the pass which writes the name says, or else the pipeline. Made at their first use.
    pub fn volume(&mut self, name: &str) -> Option<VolumeSet> {
        let storage = self.storage_of(name)?;
        let (grid, grid_bundle) = (self.grid().size, self.grid_bundle());
        let mut bundle = Bundle::default();
        storage.mounts().iter().for_each(|(name, folder)| bundle.mount(name, folder));
        bundle.with("ENCODING_RANGE", f64::from(storage.encoding.range));
        storage.words().for_each(|(option, word)| bundle.with_word(&option, word));
        bundle.join(&grid_bundle);
        if let Some(index) = grid_bundle.grid() {
            bundle.set_grid(index);
        }
        let encoding = storage.encoding;
        let texture_bytes = storage.volumes().iter().map(|volume| volume.bytes(grid, encoding)).sum();
        let parts = storage.volumes().into_iter().map(|volume| {
            let (size, mips, numbers) = (volume.size(grid), volume.mip_levels(grid), volume.numbers);
            let kind = ResourceKind::Volume { size, mips, encoding, numbers };
            let resource = self.part_of(name, "volume", volume.name, kind);
            bundle.add(volume.name, Target::Resource(resource));
            (volume, resource)
        });
        let parts = parts.collect();
        let sides = self.part_of(name, "volume", "side_radiance", SIDE_RADIANCE);
        bundle.add("side_radiance", Target::Resource(sides));
        Some(VolumeSet { bundle, name: name.to_owned(), parts, sides, texture_bytes })
    }
}

/// What every side of a voxel sends: see wgsl/common/radiance.wgsl.
pub(crate) const SIDE_RADIANCE: ResourceKind = ResourceKind::PerVoxel(6 * 4);

/// The count of values that a pass's encoding can't hold; cleared when the pass begins.
fn out_of_range(pass: &mut Expansion<'_, '_>) -> usize {
    let name = format!("{}.out_of_range", pass.entry().name);
    match pass.known(&name) {
        Some(known) => known,
        None => {
            let resource = pass.resource(&name, ResourceKind::Buffer(8));
            pass.clear(resource);
            pass.counts_out_of_range(resource);
            resource
        }
    }
}

/// A volume of what every side of a voxel sends by itself, with what is gathered beside it if there is any. Where `sampled`, its
/// textures are made as well: the parents of occupied cells, or all.
pub(crate) fn fill(
    pass: &mut Expansion<'_, '_>,
    volume: &VolumeSet,
    (direct, gathered): (&Target, Option<&Target>),
    sampled: bool,
    all_cells: bool,
) {
    pass.run("pass/sum_sides")
        .using(&volume.bundle)
        .reads("direct", direct.clone())
        .reads("gathered", gathered.cloned().unwrap_or(Target::Nothing))
        .with("HAS_GATHERED", gathered.is_some())
        .writes("side_radiance", Target::Resource(volume.sides))
        .over(Over::Cells(0));
    if sampled {
        let mean = pass.resource("slot_radiance", ResourceKind::PerVoxel(16));
        pass.run("pass/mean_radiance")
            .using(&volume.bundle)
            .writes("slot_radiance", Target::Resource(mean))
            .over(Over::Cells(0));
        store_and_mipmap(pass, volume, mean, all_cells);
    }
}

/// Level 0 from every voxel's radiance, and the levels over it: the parents of occupied cells, or all.
pub(crate) fn store_and_mipmap(
    pass: &mut Expansion<'_, '_>,
    volume: &VolumeSet,
    radiance: usize,
    all_cells: bool,
) {
    let out_of_range = Target::Resource(out_of_range(pass));
    let level0 = volume.parts.iter().filter(|(volume, _)| volume.first_level() == 0);
    let level0: Vec<(String, Target)> = level0
        .map(|(volume, resource)| {
            (format!("{}_level0", volume.name), Target::Mip { resource: *resource, mip: 0 })
        })
        .collect();
    pass.run("pass/store")
        .using(&volume.bundle)
        .reads("slot_radiance", Target::Resource(radiance))
        .writes("out_of_range", out_of_range.clone())
        .writes_all(&level0)
        .over(Over::Cells(0));

    // Cells that were stored before and are empty now. Only what moves leaves any.
    let moving = pass.facts().moving_triangles > 0;
    let grid = pass.grid().clone();
    let stored = moving.then(|| {
        let words = ResourceKind::Buffer(u64::from(grid.word_offsets().1) * 4);
        let name = format!("{}.stored", volume.name);
        pass.kept(&name, words)
    });
    if let Some(stored) = stored {
        pass.run("pass/vacate")
            .using(&volume.bundle)
            .reads("occupancy_before", Target::Resource(stored))
            .writes("out_of_range", out_of_range.clone())
            .writes_all(&level0)
            .over(Over::Groups(groups_for(grid.level_words(0), 64)));
    }
    for level in 1..grid.levels() {
        let mut mips = Vec::new();
        for (volume, resource) in &volume.parts {
            let view = |level: u32| match volume.has_level(level, grid.size) {
                true => Target::Mip { resource: *resource, mip: level - volume.first_level() },
                false => Target::Nothing,
            };
            mips.push((format!("{}_source", volume.name), view(level - 1)));
            mips.push((format!("{}_target", volume.name), view(level)));
        }
        let (module, over) = match all_cells {
            true => ("pass/mipmap_dense", Over::Groups(grid.size.map(|n| (n >> level).max(1).div_ceil(4)))),
            false => ("pass/mipmap", Over::Cells(level)),
        };
        pass.run(module)
            .using(&volume.bundle)
            .reads("step_params", step_params(level))
            .writes("out_of_range", out_of_range.clone())
            .writes_all(&mips)
            .over(over);
        if let Some(stored) = stored.filter(|_| !all_cells) {
            pass.run("pass/vacate_mipmap")
                .using(&volume.bundle)
                .reads("occupancy_before", Target::Resource(stored))
                .reads("step_params", step_params(level))
                .writes("out_of_range", out_of_range.clone())
                .writes_all(&mips)
                .over(Over::Groups(groups_for(grid.level_words(level), 64)));
        }
    }
    if let Some((stored, Target::Resource(occupancy))) = stored.zip(pass.variable("occupancy")) {
        pass.copy(occupancy, stored);
    }
}

/// What every side of a voxel reflects of the volume.
pub(crate) fn gather(pass: &mut Expansion<'_, '_>, volume: &VolumeSet, bounced: usize) {
    pass.run("pass/bounce")
        .using(&volume.bundle)
        .writes("bounced", Target::Resource(bounced))
        .over(Over::Cells(0));
}
