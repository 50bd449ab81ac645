//! Further bounces.

use super::volume::{SIDE_RADIANCE, fill, gather};
use super::{Idle, ParamWords, PassKind, Port, RADIANCE, VOLUME, VOXELS, Values};
use crate::expansion::Expansion;
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

    fn traces(&self) -> bool {
        true
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let bounces = pass.whole("bounces");
        let radiance = pass.input("radiance");
        let name = pass.updated();
        let Some((volume, radiance)) = pass.volume(&name).zip(radiance) else { return };
        let Some(direct) = radiance.part("direct") else { return };
        let bounced = pass.resource("bounced", SIDE_RADIANCE);
        // Where the number is at fault, one has the other parameters checked.
        let bounces = bounces.unwrap_or(1);
        for bounce in 1..=bounces {
            gather(pass, &volume, bounced);
            let sampled = if bounce == bounces { pass.is_sampled(&name) } else { pass.tracer().samples };
            fill(pass, &volume, (direct, Some(&Target::Resource(bounced))), sampled, false);
        }
    }
}
