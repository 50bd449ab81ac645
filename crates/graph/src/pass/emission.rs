//! What voxels gather of the sky and of emission.

use super::volume::{SIDE_RADIANCE, fill, gather};
use super::{PassKind, Port, Sort, VOXELS};
use crate::bundle::Bundle;
use crate::expansion::{Expansion, Over};
use crate::plan::Target;

/// See [`PassKind::sentence`].
#[derive(Debug)]
pub(crate) struct Emission;

impl PassKind for Emission {
    fn name(&self) -> &str {
        "emission"
    }

    fn sentence(&self) -> &str {
        "lets every voxel gather what the sky and emissive surfaces send, once"
    }

    fn reads(&self) -> &[Port] {
        &[VOXELS]
    }

    fn writes(&self) -> &[Port] {
        &[
            const { Port::new("emitted", Sort::RADIANCE, "what each voxel reflects of the sky and of emission") },
        ]
    }

    fn traces(&self) -> bool {
        true
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let gathered = pass.resource(&pass.written(), SIDE_RADIANCE);
        pass.makes(Bundle::of("emitted", Target::Resource(gathered)));
        // What passes after this one fill: until then both are free.
        let own = pass.borrowed(Sort::RADIANCE);
        let own = pass.resource(&own, SIDE_RADIANCE);
        let volume = pass.borrowed(Sort::VOLUME);
        let Some(volume) = pass.volume(&volume) else { return };
        pass.run("pass/emission").writes("direct", Target::Resource(own)).over(Over::Cells(0));
        let sampled = pass.tracer().samples;
        fill(pass, &volume, (&Target::Resource(own), None), sampled, false);
        gather(pass, &volume, gathered);
    }
}
