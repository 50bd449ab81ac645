//! Lighting of voxels, filtering, bounces.

use voxlume_format::Volume;

use super::{Binds, Expansion, groups_for, step_params};
use crate::plan::{ResourceKind, Step, Target};

/// Bytes of a voxel's radiance: four floats.
const RADIANCE: ResourceKind = ResourceKind::PerVoxel(16);

pub(crate) fn light(e: &mut Expansion<'_, '_>) {
    let kind = e.kind;
    let occlusion = e.params.word(kind, "occlusion", &mut e.context.faults);
    // Read already, when the lights were chosen.
    e.params.word(kind, "emission", &mut e.context.faults);
    e.context.radiance = e.context.resource("radiance", RADIANCE);
    e.context.first = match e.reads("emitted") && e.context.available.contains("emitted") {
        true => e.context.resource("emitted", RADIANCE),
        false => e.context.radiance,
    };
    e.uses("emitted");
    e.uses("shadow_maps");
    let maps = occlusion == Some("shadow_map") && e.context.available.contains("shadow_maps");
    let direct = [("direct", Target::Resource(e.context.radiance))];
    let constants = [("USE_SHADOW_MAP", f64::from(maps))];
    e.compute_cells("pass/light", &Binds { targets: &direct, constants: &constants, mount: None }, 0);
}

pub(crate) fn filter(e: &mut Expansion<'_, '_>) {
    e.uses("radiance");
    let first = e.context.first;
    let cells = e.params.word_or(e.kind, "cells", "active", &mut e.context.faults);
    store_and_mipmap(e, first, cells == Some("all"));
}

pub(crate) fn bounce(e: &mut Expansion<'_, '_>) {
    let kind = e.kind;
    let bounces = e.params.whole(kind, "bounces", &mut e.context.faults);
    e.uses("radiance");
    let direct = e.context.radiance;
    // Where the number is at fault, one has the other parameters checked.
    for _ in 0..bounces.unwrap_or(1) {
        let bounced = e.context.resource("bounced", RADIANCE);
        gather(e, direct, bounced, true);
        store_and_mipmap(e, bounced, false);
    }
}

pub(crate) fn emission(e: &mut Expansion<'_, '_>) {
    // Held for as long as it takes, where the direct light comes after.
    let own = e.context.resource("radiance", RADIANCE);
    let gathered = e.context.resource("emitted", RADIANCE);
    let targets = [("direct", Target::Resource(own))];
    e.compute_cells("pass/emission", &Binds { targets: &targets, ..Binds::default() }, 0);
    store_and_mipmap(e, own, false);
    gather(e, own, gathered, false);
}

/// What every voxel reflects of the volume, with its own light or without.
fn gather(e: &mut Expansion<'_, '_>, direct: usize, bounced: usize, add_direct: bool) {
    let targets = [("direct", Target::Resource(direct)), ("bounced", Target::Resource(bounced))];
    let volumes = volume_targets(e);
    let all: Vec<_> =
        targets.into_iter().chain(volumes.iter().map(|(n, t)| (n.as_str(), t.clone()))).collect();
    let constants = [("ADD_DIRECT", f64::from(add_direct))];
    e.compute_cells("pass/bounce", &Binds { targets: &all, constants: &constants, mount: None }, 0);
}

/// The format's volumes, made at their first use.
fn volumes(e: &mut Expansion<'_, '_>) -> Vec<(Volume, usize)> {
    let grid = e.context.grid.size;
    let encoding = e.context.storage.encoding;
    let volumes = e.context.storage.volumes();
    volumes
        .into_iter()
        .map(|volume| {
            let (size, mips, numbers) = (volume.size(grid), volume.mip_levels(grid), volume.numbers);
            let kind = ResourceKind::Volume { size, mips, encoding, numbers };
            (volume, e.context.resource(volume.name, kind))
        })
        .collect()
}

fn volume_targets(e: &mut Expansion<'_, '_>) -> Vec<(String, Target)> {
    volumes(e)
        .into_iter()
        .map(|(volume, resource)| (volume.name.to_owned(), Target::Resource(resource)))
        .collect()
}

/// The count of values that the encoding can't hold; the first pass of a frame that stores any clears it.
fn out_of_range(e: &mut Expansion<'_, '_>) -> usize {
    let known = e.context.known("out_of_range");
    known.unwrap_or_else(|| {
        let resource = e.context.resource("out_of_range", ResourceKind::Buffer(8));
        e.steps.push(Step::Clear(resource));
        resource
    })
}

/// Level 0 from every voxel's radiance, and the levels over it: the parents of occupied cells, or all.
fn store_and_mipmap(e: &mut Expansion<'_, '_>, radiance: usize, all_cells: bool) {
    let volumes = volumes(e);
    e.uses("volume");
    let out_of_range = out_of_range(e);
    let mut targets = vec![("slot_radiance".to_owned(), Target::Resource(radiance))];
    targets.push(("out_of_range".to_owned(), Target::Resource(out_of_range)));
    targets.extend(volumes.iter().filter(|(volume, _)| volume.first_level() == 0).map(
        |(volume, resource)| (format!("{}_level0", volume.name), Target::Mip { resource: *resource, mip: 0 }),
    ));
    let named: Vec<_> = targets.iter().map(|(name, target)| (name.as_str(), target.clone())).collect();
    e.compute_cells("pass/store", &Binds { targets: &named, ..Binds::default() }, 0);
    let moving = e.context.facts.moving_triangles > 0;
    if moving {
        let groups = groups_for(e.context.grid.level_words(0), 64);
        e.compute("pass/vacate", "main", &Binds { targets: &named, ..Binds::default() }, groups);
    }

    let grid = e.context.grid.size;
    for level in 1..e.context.grid.levels() {
        let mut targets = vec![("out_of_range".to_owned(), Target::Resource(out_of_range))];
        for (volume, resource) in &volumes {
            let view = |level: u32| {
                if volume.has_level(level, grid) {
                    Target::Mip { resource: *resource, mip: level - volume.first_level() }
                } else {
                    Target::Nothing
                }
            };
            targets.push((format!("{}_source", volume.name), view(level - 1)));
            targets.push((format!("{}_target", volume.name), view(level)));
        }
        let mut named: Vec<_> =
            targets.iter().map(|(name, target)| (name.as_str(), target.clone())).collect();
        named.push(step_params(level));
        let binds = Binds { targets: &named, ..Binds::default() };
        if all_cells {
            let groups = grid.map(|n| (n >> level).max(1).div_ceil(4));
            e.compute("pass/mipmap_dense", "main", &binds, groups);
            continue;
        }
        e.compute_cells("pass/mipmap", &binds, level);
        if moving {
            let groups = groups_for(e.context.grid.level_words(level), 64);
            e.compute("pass/vacate_mipmap", "main", &binds, groups);
        }
    }
}
