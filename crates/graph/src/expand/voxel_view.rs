//! The voxels of a level, seen.

use super::{Binds, Expansion, screen_image, step_params};
use crate::plan::{Groups, ImageTexel, ResourceKind, Step, Target};

/// Bytes of a `ShownVoxel`.
const SHOWN_VOXEL: ResourceKind = ResourceKind::PerCell(16);

/// Channels that show the volume; the others show attributes.
pub(crate) const VOLUME_CHANNELS: [&str; 3] = ["opacity", "radiance", "lit"];

pub(crate) fn voxel_view(e: &mut Expansion<'_, '_>) {
    let kind = e.kind;
    let channel = e.params.word(kind, "channel", &mut e.context.faults);
    let level = e.params.whole(kind, "level", &mut e.context.faults);
    // That there is one has been checked.
    let (Some(channel), Some(level), Some(write)) = (channel, level, e.entry.writes.first()) else { return };
    let coarsest = e.context.grid.levels() - 1;
    if level > coarsest {
        e.params.refuse("level", &format!("this grid's levels are 0 to {coarsest}"), &mut e.context.faults);
        return;
    }
    let index = e.context.resource(&write.value, screen_image(ImageTexel::Rgba16Float, 1));
    let image = Target::Resource(index);
    let shown = Target::Resource(e.context.resource("shown_voxels", SHOWN_VOXEL));
    let targets =
        |level: u32| [("shown_voxels", shown.clone()), ("image", image.clone()), step_params(level)];
    // The normals of coarser levels are means of level 0's, whatever the channel.
    for at in 0..=level {
        let module = if at == 0 { "pass/voxel_channel" } else { "pass/voxel_channel_mean" };
        e.compute_cells(module, &Binds { targets: &targets(at), ..Binds::default() }, at);
    }
    if VOLUME_CHANNELS.contains(&channel) {
        let binds = Binds { targets: &targets(level), ..Binds::default() };
        e.compute_cells("pass/voxel_channel_volume", &binds, level);
    } else {
        // Needed for other channels.
        e.uses("volume");
    }
    let binds = Binds { targets: &targets(level), ..Binds::default() };
    if let Some(program) = e.program("pass/voxel_view", "main", &binds) {
        e.steps.push(Step::Compute { program, groups: Groups::Tiles(index) });
    }
}
