//! Further bounces.

use super::volume::{gather, store_and_mipmap};
use super::{Idle, ParamWords, PassKind, Port, RADIANCE, VOLUME, VOXELS, Values};
use crate::expansion::Expansion;
use crate::pass::light::VOXEL_RADIANCE;
use crate::pipeline::{PassEntry, Value};
use crate::plan::Target;

/// See [`PassKind::sentence`].
#[derive(Debug)]
pub(crate) struct Bounce;

impl PassKind for Bounce {
    fn name(&self) -> &str {
        "bounce"
    }

    fn sentence(&self) -> &str {
        "lets every voxel gather the volume, adds what it reflects and filters again, so many times"
    }

    fn reads(&self) -> &[Port] {
        const PORTS: &[Port] = &[VOXELS, RADIANCE];
        PORTS
    }

    fn writes(&self) -> &[Port] {
        &[]
    }

    fn updates(&self) -> &[Port] {
        &[VOLUME]
    }

    fn words(&self) -> &[ParamWords] {
        &[ParamWords { name: "bounces", sentence: "how many times", values: Values::Whole(0, 16) }]
    }

    fn idle(&self, entry: &PassEntry) -> Option<Idle> {
        let none = entry.param("bounces") == Some(&Value::Number(0.0));
        none.then_some(Idle { why: "`bounces` is 0", unless: ("bounces", 1.0) })
    }

    fn bounces(&self, entry: &PassEntry) -> u32 {
        match entry.param("bounces") {
            Some(Value::Number(bounces)) => *bounces as u32,
            _ => 0,
        }
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let bounces = pass.whole("bounces");
        let radiance = pass.input("radiance");
        let name = pass.updated();
        let Some((volume, radiance)) = pass.volume(&name).zip(radiance) else { return };
        let Some(Target::Resource(direct)) = radiance.part("direct") else { return };
        // Where the number is at fault, one has the other parameters checked.
        for _ in 0..bounces.unwrap_or(1) {
            let bounced = pass.resource("bounced", VOXEL_RADIANCE);
            gather(pass, &volume, *direct, bounced, true);
            store_and_mipmap(pass, &volume, bounced, None, false);
        }
    }
}
