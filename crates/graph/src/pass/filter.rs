//! A volume from the voxels' radiance.

use super::volume::fill;
use super::{ParamWords, PassKind, Port, RADIANCE, VOLUME, VOXELS, Values};
use crate::expansion::Expansion;

/// See [`PassKind::sentence`].
#[derive(Debug)]
pub(crate) struct Filter;

impl PassKind for Filter {
    fn name(&self) -> &str {
        "filter"
    }

    fn sentence(&self) -> &str {
        "stores the voxels' radiance in the storage format and makes its coarser levels"
    }

    fn reads(&self) -> &[Port] {
        const PORTS: &[Port] = &[VOXELS, RADIANCE];
        PORTS
    }

    fn writes(&self) -> &[Port] {
        &[VOLUME]
    }

    fn words(&self) -> &[ParamWords] {
        const WORDS: &[ParamWords] = &[
            ParamWords {
                name: "cells",
                sentence: "parents made: those of occupied voxels, or all, which only costs more; `active` unless given",
                values: Values::Words(&["active", "all"]),
            },
            ParamWords {
                name: "format",
                sentence: "storage format of this volume; the pipeline's unless given",
                values: Values::Variant,
            },
            ParamWords {
                name: "encoding",
                sentence: "texel encoding of this volume; the pipeline's unless given",
                values: Values::Variant,
            },
        ];
        WORDS
    }

    fn expand(&self, pass: &mut Expansion<'_, '_>) {
        let cells = pass.word_or("cells", "active");
        // Read where the volume is made, which other passes may do first.
        pass.gives("format");
        pass.gives("encoding");
        let (name, radiance) = (pass.written(), pass.input("radiance"));
        let Some((volume, radiance)) = pass.volume(&name).zip(radiance) else { return };
        pass.makes(volume.bundle.clone());
        let Some(direct) = radiance.part("direct") else { return };
        let sampled = pass.is_sampled(&name);
        fill(pass, &volume, (direct, radiance.part("emitted")), sampled, cells == Some("all"));
        if !sampled {
            pass.leaves_out(
                &format!("textures of `{name}`"),
                "every tracer that reads it asks the voxels' sides",
                volume.texture_bytes,
            );
        }
    }
}
