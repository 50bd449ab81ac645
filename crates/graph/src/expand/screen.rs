//! Effects and other passes over the screen's pixels.

use super::{Binds, Expansion};
use crate::plan::{Groups, ImageTexel, ResourceKind, Step, Target};

/// The composite.
pub(crate) fn screen(e: &mut Expansion<'_, '_>) {
    over_pixels(e, "pass/composite", "");
}

/// An effect: `e.entry.run` names its module in the library.
pub(crate) fn effect(e: &mut Expansion<'_, '_>) {
    let module = e.entry.run.value.clone();
    over_pixels(e, "pass/effect", module.trim_end_matches(".wgsl"));
}

fn over_pixels(e: &mut Expansion<'_, '_>, module: &str, effect: &str) {
    // That there is one has been checked, and that the word is `lights`.
    let Some(write) = e.entry.writes.first() else { return };
    let layers = if e.entry.layers.is_some() { e.context.light_count().div_ceil(4).max(1) } else { 1 };
    let kind = ResourceKind::Image { texel: ImageTexel::Rgba16Float, layers };
    let image = [("image", Target::Resource(e.context.resource(&write.value, kind)))];
    if !effect.is_empty() && e.context.effect(effect).is_none() {
        return;
    }
    let Some(program) = e.program(module, "main", &Binds { targets: &image, effect, ..Binds::default() })
    else {
        return;
    };
    let [width, height] = e.context.screen;
    let groups = Groups::Fixed([width.div_ceil(8), height.div_ceil(8), layers]);
    e.steps.push(Step::Compute { program, groups });
}
