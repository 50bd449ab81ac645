//! Effects and other passes over the screen's pixels.

use super::{Binds, Expansion};
use crate::plan::{ImageTexel, ResourceKind, Target};

/// The composite.
pub(crate) fn screen(e: &mut Expansion<'_, '_>) {
    over_pixels(e, "pass/composite", None);
}

/// An effect: `e.entry.run` names its module in the library.
pub(crate) fn effect(e: &mut Expansion<'_, '_>) {
    let module = e.entry.run.value.clone();
    over_pixels(e, "pass/effect", Some(module.trim_end_matches(".wgsl")));
}

fn over_pixels(e: &mut Expansion<'_, '_>, module: &str, effect: Option<&str>) {
    // That there is one has been checked, and that the word is `lights`.
    let Some(write) = e.entry.writes.first() else { return };
    let layers = if e.entry.layers.is_some() { e.context.light_count().div_ceil(4).max(1) } else { 1 };
    let kind = ResourceKind::Image { texel: ImageTexel::Rgba16Float, layers };
    if effect.is_some_and(|effect| e.context.effect(effect, e.tracer).is_none()) {
        return;
    }
    let mount = effect.map(|effect| ("effect", effect));
    let image = Target::Resource(e.context.resource(&write.value, kind.clone()));
    let [width, height] = e.context.screen;
    let groups = [width.div_ceil(8), height.div_ceil(8), layers];
    let constants = [("INTERLEAVE", f64::from(u8::from(e.entry.interleave)))];
    if !e.entry.interleave {
        let binds = Binds { targets: &[("image", image)], constants: &constants, mount };
        e.compute(module, "main", &binds, groups);
        return;
    }
    // Shared by all: each is read right after it is written.
    let name = format!("interleaved_{layers}");
    let interleaved = Target::Resource(e.context.resource(&name, kind));
    let binds = Binds { targets: &[("image", interleaved.clone())], constants: &constants, mount };
    e.compute(module, "main", &binds, groups);
    let targets = [("image", image), ("interleaved", interleaved)];
    e.compute("pass/interleave", "main", &Binds { targets: &targets, ..Binds::default() }, groups);
}
